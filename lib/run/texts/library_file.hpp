// The published mechanisms of the library, which the program has within it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/outcome.hpp"
#include "io/atomic_file.hpp"

namespace kinestat {

/// A file of the folder mechanisms/.
struct LibraryFile {
  std::string_view name;   ///< "planar/four_bar"
  std::string_view title;  ///< its `name:`
};

std::vector<LibraryFile> library_files();

/// Without a name, or with that of a folder, the list with a line a file; else the file of that
/// name, which may lack its folder where no other file is called so: on standard output or in the
/// file `path`. Its first line names the schema beside it, as that of a starter file does.
Outcome library_file(const std::string& name, const std::string& path, Overwrite overwrite);

}  // namespace kinestat
