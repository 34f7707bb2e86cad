// Which motions and actions of a mechanism may be given so that all others follow.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "files/file_options.hpp"

namespace kinestat {

/// What to say of the sets. A name is a freedom, an action, or an actuator, which is both.
struct InputsChoice {
  std::vector<std::string> among;     ///< only these may be given; empty: all
  bool only_actuators = false;        ///< only what actuators drive or bear
  std::vector<std::string> required;  ///< each set has these
  std::vector<std::string> judged;    ///< sets to judge, each a list with commas
  std::size_t listed = 20;            ///< at most so many sets a group
};

/// One report a file on standard output; the check fails if a set to judge is not valid.
Outcome inputs_files(const std::vector<std::string>& paths,
                     const InputsChoice& choice,
                     const AnalyseOptions& options);

}  // namespace kinestat
