// The numbers of a description, sorted by how they are checked.
#pragma once

#include <vector>

#include "description/mechanism_description.hpp"
#include "mechanism/check/section_context.hpp"

namespace kinestat {

struct JudgedNumbers {
  std::vector<CheckedNumber> by_rule;  ///< each checked by a rule of its own only
  std::vector<const Value*> by_more;   ///< checked by more, such as together with other numbers
};

/// Finds all numbers that the check of a description evaluates.
JudgedNumbers find_judged_numbers(const MechanismDescription& description);

}  // namespace kinestat
