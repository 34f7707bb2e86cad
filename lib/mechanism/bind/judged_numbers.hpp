// The numbers of a description by what decides whether they are right.
#pragma once

#include <vector>

#include "description/mechanism_description.hpp"
#include "mechanism/check/section_context.hpp"

namespace kinestat {

struct JudgedNumbers {
  std::vector<CheckedNumber> by_rule;  ///< each by what it may be, whatever the others are
  std::vector<const Value*> by_more;   ///< of the description: by more than that, or with others
};

/// All that the check of a description evaluates, in whatever parameters it has.
JudgedNumbers find_judged_numbers(const MechanismDescription& description);

}  // namespace kinestat
