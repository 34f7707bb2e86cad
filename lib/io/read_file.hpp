// A file, or standard input, as a value; never more than the limits allow.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/diagnostic.hpp"
#include "core/source.hpp"

namespace kinestat {

/// How much of an input is accepted before it is refused. The defaults are far above any mechanism.
struct ReadLimits {
  std::size_t bytes = std::size_t{1} << 20U;  ///< of the file; also of the text that aliases repeat
  int depth = 64;      ///< nested lists and mappings, the root counted; at most 400
  int nodes = 200000;  ///< values in the tree, expanded aliases counted
  std::size_t scalar = std::size_t{1} << 16U;  ///< bytes of one value

  /// For files of so many bytes, with as many more values.
  static ReadLimits for_size(std::size_t bytes);
};

/// The bytes of a file; "-" is standard input. Only regular files are read: a folder, a pipe or a
/// device is refused without waiting for it (E0151), and so is what is larger than `limits.bytes`
/// (E0201). Standard input is read no further than the limit. Empty iff an error was added.
std::optional<SourceFile> read_file(const std::string& path,
                                    const ReadLimits& limits,
                                    Diagnostics& found);

}  // namespace kinestat
