#include "studies/sweep/task/stored_sweep.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace kinestat {

namespace {

constexpr std::string_view kChunkPrefix = "chunk-";

std::string chunk_name(std::uint64_t chunk) {
  return fmt::format("{}{:08}", kChunkPrefix, chunk);
}

bool is_chunk_name(std::string_view name) {
  return name.starts_with(kChunkPrefix) && name.size() >= chunk_name(0).size() &&
         name.find_first_not_of("0123456789", kChunkPrefix.size()) == std::string_view::npos;
}

}  // namespace

// What was there before, and what is asked for, fit together.
bool StoredSweep::prepare() {
  if (!check_output_folder(options_.folder, found_) ||
      (is_whole_sweep() &&
       !keeps_words(task_.metadata, options_.folder, options_.overwrite, found_)) ||
      !check_places(outputs({}, {}), options_.overwrite, inputs_, found_)) {
    return false;
  }
  const std::string path = path_in(options_.folder, work_name());
  const bool is_there = is_work_folder(path);
  if (options_.resume && !is_there && is_finished()) {
    was_finished_ = true;
    return true;
  }
  std::optional<WorkFolder> work = WorkFolder::open(path, is_chunk_name, found_);
  if (!work) {
    return false;
  }
  work_.emplace(*std::move(work));
  return take_stock();
}

RunEnd StoredSweep::run(std::uint64_t jobs) {
  std::vector<std::uint64_t> missing;
  SweepProgress progress{.total = states_before(shard_.end_chunk(chunks_)) -
                                  states_before(shard_.first_chunk(chunks_))};
  for (std::uint64_t c = shard_.first_chunk(chunks_); c < shard_.end_chunk(chunks_); ++c) {
    if (std::ranges::binary_search(done_, c)) {
      progress.resumed += states_before(c + 1) - states_before(c);
    } else {
      missing.push_back(c);
    }
  }
  progress.states = progress.resumed;
  const ChunkSink sink{.order = ChunkSink::Order::any,
                       .take = [this](ChunkResult result) { return store(std::move(result)); }};
  return run_chunks(task_, missing, jobs, sink, hooks_, progress);
}

// The result out of the chunks; then they are no longer needed.
bool StoredSweep::finish() {
  std::vector<PieceFile> files;
  for (std::uint64_t c = shard_.first_chunk(chunks_); c < shard_.end_chunk(chunks_); ++c) {
    files.push_back({.path = path_in(work_->path(), chunk_name(c))});
  }
  PieceReader reader(files, task_.metadata.plan);
  StoredChunk record;
  while (reader.next(record)) {
    counts_.add(read_counts(record.note).value_or(SweepCounts{}));
  }
  if (!write_files(outputs(files, work_->path()), options_.overwrite, inputs_, found_)) {
    return false;
  }
  work_->remove();
  return true;
}

std::string StoredSweep::shard_name() const {
  return fmt::format("{}.sweep-{}-of-{}.shard", task_.metadata.stem, shard_.number, shard_.count);
}

std::string StoredSweep::work_name() const {
  return is_whole_sweep()
             ? task_.metadata.stem + ".sweep-work"
             : fmt::format(
                   "{}.sweep-{}-of-{}-work", task_.metadata.stem, shard_.number, shard_.count);
}

std::uint64_t StoredSweep::states_before(std::uint64_t chunk) const {
  return std::min(chunk * task_.plan.chunk_size(), task_.plan.state_count());
}

std::vector<OutputFile> StoredSweep::outputs(const std::vector<PieceFile>& files,
                                             const std::string& scratch) const {
  if (is_whole_sweep()) {
    return result_files(task_.metadata, options_.folder, scratch, files, counts_);
  }
  return {{.path = path_in(options_.folder, shard_name()),
           .content = write_shard_header(task_.metadata, shard_),
           .signature = std::string(shard_signature()),
           .next_piece = shard_pieces(files),
           .scratch = scratch}};
}

NextPiece StoredSweep::shard_pieces(const std::vector<PieceFile>& files) const {
  return [reader = std::make_shared<PieceReader>(files, task_.metadata.plan),
          plan = task_.metadata.plan,
          has_end = false](std::string& piece) mutable {
    StoredChunk record;
    if (reader->next(record)) {
      piece = write_record(record, plan);
      return true;
    }
    piece = fmt::format("{}\n", kShardEnd);
    return !std::exchange(has_end, true);
  };
}

// Whether the result is there already and was made by the same plan.
bool StoredSweep::is_finished() const {
  if (is_whole_sweep()) {
    RecordFile rows(path_in(options_.folder, task_.metadata.result_name()));
    return rows.is_open() && read_plan_of_summary(summary_text()) == task_.metadata.plan;
  }
  RecordFile shard(path_in(options_.folder, shard_name()));
  const std::optional<std::string> line = shard.is_open() ? shard.read_line() : std::nullopt;
  const std::optional<ShardHeader> header = line ? read_shard_header(*line) : std::nullopt;
  return header && header->metadata.plan == task_.metadata.plan && header->shard == shard_;
}

std::string StoredSweep::summary_text() const {
  RecordFile file(path_in(options_.folder, summary_name(task_.metadata)));
  std::string text;
  while (file.is_open()) {
    const std::optional<std::string> line = file.read_line();
    if (!line) {
      break;
    }
    text += *line + "\n";
  }
  return text;
}

// Finds the chunks that are finished; what is damaged is made anew.
bool StoredSweep::take_stock() {
  if (options_.overwrite == Overwrite::force && !options_.resume) {
    work_->clear();
    return true;
  }
  const std::vector<std::string> names = work_->files();
  if (!names.empty() && !options_.resume) {
    found_.error("E0908",
                 {},
                 fmt::format("'{}' holds what an interrupted sweep has finished", work_->path()),
                 "give --resume to go on with it, or --force to begin anew");
    return false;
  }
  for (const std::string& name : names) {
    if (!take_stock_of(name)) {
      return false;
    }
  }
  std::ranges::sort(done_);
  return true;
}

bool StoredSweep::take_stock_of(const std::string& name) {
  RecordFile file(path_in(work_->path(), name));
  StoredChunk record;
  const RecordState state = file.read_record(task_.metadata.plan, record);
  if (state == RecordState::foreign) {
    found_.error("E0908",
                 {},
                 fmt::format("'{}' belongs to another sweep: the file, --set, the options or the "
                             "version have changed since",
                             work_->path()),
                 "give --force without --resume to begin anew");
    return false;
  }
  if (state == RecordState::whole && name == chunk_name(record.index) && read_counts(record.note)) {
    done_.push_back(record.index);
  }
  return true;
}

// Syncing every chunk would take longer than writing the rows. What a crash of the system leaves of
// one is found by its hash, and made anew.
bool StoredSweep::store(ChunkResult result) {
  const StoredChunk record{
      .index = result.chunk, .note = write_counts(result.counts), .body = std::move(result.body)};
  const OutputFile file{.path = path_in(work_->path(), chunk_name(record.index)),
                        .content = write_record(record, task_.metadata.plan),
                        .signature = {},
                        .survives_crash = false};
  Diagnostics found;
  if (write_files(std::span(&file, 1), Overwrite::force, {}, found)) {
    return true;
  }
  const std::lock_guard lock(mutex_);
  for (const Diagnostic& one : found.items()) {
    if (!found_.has_errors()) {
      found_.error(one.code, one.where, one.message, one.hint);
    }
  }
  return false;
}

}  // namespace kinestat
