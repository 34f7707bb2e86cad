#include "studies/sweep/task/sweep_result.hpp"

#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace kinestat {

namespace {

// Of all pieces.
ChosenRows best_rows(const SweepMetadata& metadata, const std::vector<PieceFile>& files) {
  BestOfPieces best(*metadata.best);
  PieceReader reader(files, metadata.plan);
  StoredChunk record;
  while (reader.next(record)) {
    best.add(record.body);
  }
  return best.take();
}

bool has_line(const std::string& path, std::string_view sought) {
  RecordFile file(path);
  while (file.is_open()) {
    const std::optional<std::string> line = file.read_line();
    if (!line || *line == sought) {
      return line.has_value();
    }
  }
  return false;
}

}  // namespace

bool PieceReader::next(StoredChunk& record) {
  while (!open_ || piece_ == files_[file_].pieces) {
    file_ += open_ ? 1 : 0;
    open_.reset();
    piece_ = 0;
    if (file_ == files_.size()) {
      return false;
    }
    open_.emplace(files_[file_].path);
    if (files_[file_].is_shard) {
      (void)open_->read_line();
    }
  }
  ++piece_;
  if (open_->read_record(plan_, record) != RecordState::whole) {
    throw std::runtime_error(fmt::format("'{}' has changed while it was read", files_[file_].path));
  }
  return true;
}

void BestOfPieces::add(const std::string& body) {
  for (RankedRow& row : read_rows(body)) {
    best_.add(std::move(row));
  }
}

ChosenRows BestOfPieces::take() {
  ChosenRows rows;
  for (const RankedRow& row : best_.take()) {
    rows.text += row.text;
    ++rows.count;
  }
  return rows;
}

NextPiece result_pieces(const SweepMetadata& metadata,
                        const std::vector<PieceFile>& files,
                        const SweepCounts& counts) {
  // Shared, because a function object must be copyable.
  struct State {
    PieceReader reader;
    StoredChunk record;
    std::string ready;
    bool has_ready = true;
  };

  const auto state = std::make_shared<State>(
      State{.reader = PieceReader(files, metadata.plan), .record = {}, .ready = {}});
  const bool is_choice = metadata.best.has_value();
  if (is_choice) {
    const ChosenRows rows = best_rows(metadata, files);
    state->ready = metadata.heading(rows.count) + rows.text;
  } else {
    state->ready = metadata.heading(counts.kept());
  }
  return [state, is_choice](std::string& piece) {
    if (std::exchange(state->has_ready, false)) {
      piece = std::move(state->ready);
      return true;
    }
    if (is_choice || !state->reader.next(state->record)) {
      return false;
    }
    piece = std::move(state->record.body);
    return true;
  };
}

bool keeps_words(const SweepMetadata& metadata,
                 const std::string& folder,
                 Overwrite overwrite,
                 Diagnostics& found) {
  SweepMetadata of_array = metadata;
  of_array.format = RowFormat::npy;
  const std::string array = path_in(folder, of_array.result_name());
  const std::string summary = path_in(folder, summary_name(metadata));
  if (metadata.format == RowFormat::npy || overwrite == Overwrite::force ||
      !RecordFile(array).is_open() || !has_line(summary, "  \"words\": {")) {
    return true;
  }
  found.error("E0153",
              {},
              fmt::format("'{}' has the words for the numbers of '{}'", summary, array),
              "choose another folder, or give --force to replace it");
  return false;
}

std::vector<OutputFile> result_files(const SweepMetadata& metadata,
                                     const std::string& folder,
                                     const std::string& scratch,
                                     const std::vector<PieceFile>& files,
                                     const SweepCounts& counts) {
  return {{.path = path_in(folder, metadata.result_name()),
           .content = {},
           .signature = metadata.signature(),
           .next_piece = files.empty() ? NextPiece() : result_pieces(metadata, files, counts),
           .scratch = scratch},
          {.path = path_in(folder, summary_name(metadata)),
           .content = write_sweep_summary(metadata, counts),
           .signature = std::string(summary_signature()),
           .next_piece = {},
           .scratch = scratch}};
}

std::string path_in(const std::string& folder, const std::string& name) {
  return fmt::format("{}{}{}", folder, folder.ends_with('/') ? "" : "/", name);
}

std::string summary_name(const SweepMetadata& metadata) {
  return metadata.stem + ".sweep.json";
}

}  // namespace kinestat
