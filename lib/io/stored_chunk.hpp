// Pieces of a long result as they stand in files: each says what it is and whether it is whole.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace kinestat {

/// A number of 64 bits that all bytes of a text decide (XXH3), as 16 hexadecimal digits. It tells
/// damage and mix-ups, not forgery.
std::string hash_of(std::string_view text);

/// One piece. The note is one line about the body.
struct StoredChunk {
  std::uint64_t index = 0;
  std::string note;
  std::string body;
};

/// The piece as text: a line with the plan to which it belongs, its index, its size and its hash,
/// then the body.
std::string write_record(const StoredChunk& record, std::string_view plan);

/// What was found where a piece was expected.
enum class RecordState {
  whole,
  end,        ///< the file ends here
  truncated,  ///< the file ends within the piece
  damaged,    ///< it is not what was written
  foreign     ///< it belongs to another plan
};

/// Reads a file piece by piece, so that its size does not matter.
class RecordFile {
 public:
  explicit RecordFile(const std::string& path);

  bool is_open() const { return file_.is_open(); }

  /// The next line without its end; empty at the end of the file, in a line that is not ended, and
  /// beyond 1 MiB.
  std::optional<std::string> read_line();

  /// The next piece, which must belong to the plan.
  RecordState read_record(std::string_view plan, StoredChunk& record);

 private:
  std::uint64_t bytes_left();

  std::ifstream file_;
  std::uint64_t size_ = 0;
};

}  // namespace kinestat
