// The section `duty`: how long a transmission does what.
#pragma once

#include <optional>
#include <vector>

#include "description/shift_description.hpp"
#include "description/value.hpp"

namespace kinestat {

/// For a while, a case with other known magnitudes of its inputs.
struct DutyPointDescription {
  std::optional<Name> case_label;  ///< a case, or a gear of `shift`
  std::vector<InputValue> input_motion;
  std::vector<InputValue> input_action;
  Value duration;
  SourceRange where;
};

struct DutyDescription {
  std::vector<DutyPointDescription> points;
  std::optional<Name> file;            ///< a table with a point a line, beside the mechanism file
  std::optional<Name> case_label;      ///< of points that name none
  std::optional<Value> repetitions;    ///< how often all points follow each other
  std::optional<Value> gear_exponent;  ///< of Miner's rule, for teeth
  std::optional<Value> bearing_exponent;  ///< likewise, for bearings
  SourceRange where;
};

}  // namespace kinestat
