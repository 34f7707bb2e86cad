// The result of a sweep, made of pieces that stand in files.
#pragma once

#include <string>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/stored_chunk.hpp"
#include "studies/sweep/best_rows.hpp"
#include "studies/sweep/task/sweep_options.hpp"

namespace kinestat {

/// A file with some of the pieces, in order: a chunk alone, or a shard.
struct PieceFile {
  std::string path;
  bool is_shard = false;  ///< begins with a line that is no piece
  std::uint64_t pieces = 1;
};

/// Goes through the pieces of files that were found to be whole, in their order.
class PieceReader {
 public:
  PieceReader(std::vector<PieceFile> files, std::string plan)
      : files_(std::move(files)), plan_(std::move(plan)) {}

  /// False at the end. A piece that is no longer what it was when it was checked, because another
  /// process has changed its file meanwhile, throws std::runtime_error.
  bool next(StoredChunk& record);

 private:
  std::vector<PieceFile> files_;
  std::string plan_;
  std::size_t file_ = 0;
  std::uint64_t piece_ = 0;
  std::optional<RecordFile> open_;
};

/// Rows one behind the other, as they stand in the result.
struct ChosenRows {
  std::uint64_t count = 0;
  std::string text;
};

/// The best rows of pieces, in whatever order these come.
class BestOfPieces {
 public:
  explicit BestOfPieces(const BestChoice& choice) : best_(choice) {}

  /// Takes the body of a piece, as write_rows has it.
  void add(const std::string& body);

  /// The best first.
  ChosenRows take();

 private:
  BestRows best_;
};

/// The rows as they stand in the result: the heading, then the bodies of all pieces, or the best
/// rows of all of them. `counts` are those of all pieces.
NextPiece result_pieces(const SweepMetadata& metadata,
                        const std::vector<PieceFile>& files,
                        const SweepCounts& counts);

/// Refuses to replace a summary that has the words for the numbers of an array beside it by one
/// without them.
bool keeps_words(const SweepMetadata& metadata,
                 const std::string& folder,
                 Overwrite overwrite,
                 Diagnostics& found);

/// The result and the file beside it, for write_files; `scratch` may be empty.
std::vector<OutputFile> result_files(const SweepMetadata& metadata,
                                     const std::string& folder,
                                     const std::string& scratch,
                                     const std::vector<PieceFile>& files,
                                     const SweepCounts& counts);

/// The path of a file in a folder.
std::string path_in(const std::string& folder, const std::string& name);

/// The name of the file beside the rows, without its folder.
std::string summary_name(const SweepMetadata& metadata);

/// The last line of a shard.
inline constexpr std::string_view kShardEnd = "end";

}  // namespace kinestat
