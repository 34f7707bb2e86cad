// Which elements of a transmission make which gear.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"

namespace kinestat {

/// Which combinations beside those that a gear needs.
struct ShiftChoice {
  bool one_more = false;
  bool one_fewer = false;
};

/// One report a file on standard output. A file without a section `shift` is an error.
Outcome shift_of_files(const std::vector<std::string>& paths,
                       const ShiftChoice& choice,
                       const AnalyseOptions& options);

}  // namespace kinestat
