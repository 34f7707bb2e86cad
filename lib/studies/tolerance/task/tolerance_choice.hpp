// What a command line asks about tolerances, all as typed.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace kinestat {

struct ToleranceChoice {
  std::vector<std::string> positions = {};  ///< names (watched_positions); empty: the usual ones
  std::string case_label = {};              ///< empty: all cases
  bool along = false;                       ///< at the steps of the section `motion` instead
  std::optional<std::string> place = {};    ///< of all couplings: a length
  std::optional<std::string> angle = {};    ///< likewise: an angle
  std::vector<std::string> each = {};       ///< COUPLING=VALUE or DRIVE=VALUE, instead of these
};

}  // namespace kinestat
