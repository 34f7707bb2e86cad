#include "run/sweep.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "io/work_folder.hpp"
#include "run/internal/chunk_runner.hpp"
#include "run/internal/sweep_result.hpp"
#include "run/internal/sweep_task.hpp"

namespace kinestat {

namespace {

constexpr std::uint64_t kMostJobs = 256;

std::string chunk_name(std::uint64_t chunk) {
  return fmt::format("chunk-{:08}", chunk);
}

// Rows in their order to standard output, or the best of them at the end.
class StreamedSweep {
 public:
  StreamedSweep(const SweepTask& task, const SweepHooks& hooks)
      : task_(task),
        hooks_(hooks),
        best_(task.header.top ? task.header.top->count : 0,
              task.header.top ? task.header.top->order : RankOrder::largest) {}

  RunEnd run(std::uint64_t jobs) {
    std::vector<std::uint64_t> chunks(task_.plan.chunk_count());
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      chunks[i] = i;
    }
    if (!hooks_.write(task_.header.heading)) {
      return RunEnd::refused;
    }
    const ChunkSink sink{.order = ChunkSink::Order::ascending,
                         .take = [this](ChunkResult result) { return take(std::move(result)); }};
    const RunEnd end =
        run_chunks(task_, chunks, jobs, sink, hooks_, {.total = task_.plan.state_count()});
    return end == RunEnd::complete && !write_best() ? RunEnd::refused : end;
  }

  const SweepCounts& counts() const { return counts_; }

 private:
  bool take(ChunkResult result) {
    counts_.add(result.counts);
    if (!task_.key) {
      return hooks_.write(result.body);
    }
    for (RankedRow& row : read_rows(result.body)) {
      best_.add(std::move(row));
    }
    return true;
  }

  bool write_best() {
    std::string text;
    for (const RankedRow& row : best_.take()) {
      text += row.text;
    }
    return hooks_.write(text);
  }

  const SweepTask& task_;
  const SweepHooks& hooks_;
  TopRows best_;
  SweepCounts counts_;
};

// Chunks as files in a work folder, and at the end the result made of them.
class StoredSweep {
 public:
  StoredSweep(const SweepTask& task,
              const SweepOptions& options,
              const SweepHooks& hooks,
              Diagnostics& found)
      : task_(task),
        options_(options),
        hooks_(hooks),
        found_(found),
        shard_(options.shard.value_or(ShardNumber{})),
        chunks_(task.plan.chunk_count()) {}

  // What was there before, and what is asked for, fit together.
  bool prepare() {
    if (!check_output_folder(options_.folder, found_) ||
        !check_places(outputs({}, {}), options_.overwrite, found_)) {
      return false;
    }
    const std::string path = path_in(options_.folder, work_name());
    const bool is_there = is_work_folder(path);
    if (options_.resume && !is_there && is_finished()) {
      was_finished_ = true;
      return true;
    }
    std::optional<WorkFolder> work = WorkFolder::open(path, found_);
    if (!work) {
      return false;
    }
    work_.emplace(*std::move(work));
    return take_stock();
  }

  bool was_finished() const { return was_finished_; }

  RunEnd run(std::uint64_t jobs) {
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
  bool finish() {
    std::vector<PieceFile> files;
    for (std::uint64_t c = shard_.first_chunk(chunks_); c < shard_.end_chunk(chunks_); ++c) {
      files.push_back({.path = path_in(work_->path(), chunk_name(c))});
    }
    PieceReader reader(files, task_.header.plan);
    ChunkRecord record;
    while (reader.next(record)) {
      counts_.add(read_counts(record.note).value_or(SweepCounts{}));
    }
    if (!write_files(outputs(files, work_->path()), options_.overwrite, found_)) {
      return false;
    }
    work_->remove();
    return true;
  }

  const SweepCounts& counts() const { return counts_; }

 private:
  bool is_whole_sweep() const { return !options_.shard; }

  std::string shard_name() const {
    return fmt::format("{}.sweep-{}-of-{}.shard", task_.header.stem, shard_.number, shard_.count);
  }

  std::string work_name() const {
    return is_whole_sweep()
               ? task_.header.stem + ".sweep-work"
               : fmt::format(
                     "{}.sweep-{}-of-{}-work", task_.header.stem, shard_.number, shard_.count);
  }

  std::uint64_t states_before(std::uint64_t chunk) const {
    return std::min(chunk * task_.plan.chunk_size(), task_.plan.state_count());
  }

  std::vector<OutputFile> outputs(const std::vector<PieceFile>& files,
                                  const std::string& scratch) const {
    if (is_whole_sweep()) {
      return result_files(task_.header, options_.folder, scratch, files, counts_);
    }
    return {{.path = path_in(options_.folder, shard_name()),
             .content = write_shard_header(task_.header, shard_),
             .signature = std::string(shard_signature()),
             .next_piece = shard_pieces(files),
             .scratch = scratch}};
  }

  NextPiece shard_pieces(const std::vector<PieceFile>& files) const {
    return [reader = std::make_shared<PieceReader>(files, task_.header.plan),
            plan = task_.header.plan,
            has_end = false](std::string& piece) mutable {
      ChunkRecord record;
      if (reader->next(record)) {
        piece = write_record(record, plan);
        return true;
      }
      piece = fmt::format("{}\n", kShardEnd);
      return !std::exchange(has_end, true);
    };
  }

  // Whether the result is there already and was made by the same plan.
  bool is_finished() const {
    if (is_whole_sweep()) {
      RecordFile rows(path_in(options_.folder, task_.header.result_name()));
      return rows.is_open() && read_plan_of_summary(summary_text()) == task_.header.plan;
    }
    RecordFile shard(path_in(options_.folder, shard_name()));
    const std::optional<std::string> line = shard.is_open() ? shard.read_line() : std::nullopt;
    const std::optional<ShardHeader> header = line ? read_shard_header(*line) : std::nullopt;
    return header && header->header.plan == task_.header.plan && header->shard == shard_;
  }

  std::string summary_text() const {
    RecordFile file(path_in(options_.folder, summary_name(task_.header)));
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
  bool take_stock() {
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

  bool take_stock_of(const std::string& name) {
    RecordFile file(path_in(work_->path(), name));
    ChunkRecord record;
    const RecordState state = file.read_record(task_.header.plan, record);
    if (state == RecordState::foreign) {
      found_.error("E0908",
                   {},
                   fmt::format("'{}' belongs to another sweep: the file, --set, the options or the "
                               "version have changed since",
                               work_->path()),
                   "give --force without --resume to begin anew");
      return false;
    }
    if (state == RecordState::whole && name == chunk_name(record.index) &&
        read_counts(record.note)) {
      done_.push_back(record.index);
    }
    return true;
  }

  bool store(ChunkResult result) {
    const ChunkRecord record{
        .index = result.chunk, .note = write_counts(result.counts), .body = std::move(result.body)};
    const OutputFile file{.path = path_in(work_->path(), chunk_name(record.index)),
                          .content = write_record(record, task_.header.plan),
                          .signature = {}};
    Diagnostics found;
    if (write_files(std::span(&file, 1), Overwrite::force, found)) {
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

  const SweepTask& task_;
  const SweepOptions& options_;
  const SweepHooks& hooks_;
  Diagnostics& found_;
  ShardNumber shard_;
  std::uint64_t chunks_ = 0;
  std::optional<WorkFolder> work_;
  std::vector<std::uint64_t> done_;
  bool was_finished_ = false;
  SweepCounts counts_;
  std::mutex mutex_;
};

std::uint64_t thread_count(const SweepOptions& options, Diagnostics& found) {
  if (options.jobs == 0) {
    return std::max(1U, std::thread::hardware_concurrency());
  }
  if (options.jobs > kMostJobs) {
    found.warning("W0101",
                  {},
                  fmt::format("--jobs {} is more than this program uses", options.jobs),
                  fmt::format("{} threads are used; more than the machine has cores do not make "
                              "it faster",
                              kMostJobs));
  }
  return std::min(options.jobs, kMostJobs);
}

void stream(const SweepTask& task,
            const SweepOptions& options,
            const SweepHooks& hooks,
            Diagnostics& found,
            Outcome& outcome) {
  StreamedSweep sweep(task, hooks);
  const RunEnd end = sweep.run(thread_count(options, found));
  if (end == RunEnd::refused) {
    found.error("E0152", {}, "standard output cannot be written");
  } else if (end == RunEnd::complete && !options.is_quiet) {
    outcome.err += sweep_text(task.header, sweep.counts());
  }
}

void store(const SweepTask& task,
           const SweepOptions& options,
           const SweepHooks& hooks,
           Diagnostics& found,
           Outcome& outcome) {
  StoredSweep sweep(task, options, hooks, found);
  if (!sweep.prepare()) {
    return;
  }
  if (sweep.was_finished()) {
    outcome.err += options.is_quiet ? "" : fmt::format("{}: complete\n", task.header.stem);
    return;
  }
  const RunEnd end = sweep.run(thread_count(options, found));
  if (end == RunEnd::stopped && !options.is_quiet) {
    outcome.err += fmt::format("{}: interrupted; --resume goes on with it\n", task.header.stem);
  }
  if (end == RunEnd::complete && sweep.finish() && !options.is_quiet) {
    outcome.err += sweep_text(task.header, sweep.counts());
  }
}

void sweep_into(const std::string& path,
                const SweepOptions& options,
                const SweepHooks& hooks,
                Outcome& outcome) {
  SourceFile source;
  Diagnostics found;
  std::string told;
  if (std::optional<Loaded> loaded = load(path, options.overrides, source, found)) {
    std::optional<SweepTask> task = make_sweep_task(source, *std::move(loaded), options, found);
    if (task) {
      task->tapes = record_tapes(*task);
      Outcome counted;
      options.folder.empty() ? stream(*task, options, hooks, found, counted)
                             : store(*task, options, hooks, found, counted);
      told = std::move(counted.err);
    }
  }
  add_diagnostics(source, found, Strictness::normal, outcome);
  outcome.err += told;
}

}  // namespace

Outcome sweep_file(const std::string& path, const SweepOptions& options, const SweepHooks& hooks) {
  Outcome outcome;
  outcome.form = options.diagnostics;
  try {
    sweep_into(path, options, hooks, outcome);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& bug) {
    add_bug(path, bug.what(), outcome);
  }
  return outcome;
}

}  // namespace kinestat
