// What a mechanism file names, for whoever types the words of a command.
#pragma once

#include <string>
#include <vector>

#include "cases/analysis.hpp"

namespace kinestat {

/// In the order of the file.
struct FileNames {
  std::vector<std::string> parameters;
  std::vector<std::string> curves;
  std::vector<std::string> actuators;
  std::vector<std::string> cases;       ///< those of gears, too
  std::vector<std::string> quantities;  ///< actuators, freedoms and actions, of which reports are
  std::vector<std::string> positions;   ///< of which errors are told
};

FileNames names_of(const Loaded& loaded);

/// All empty for a file that cannot be read or that is wrong.
FileNames names_in_file(const std::string& path);

}  // namespace kinestat
