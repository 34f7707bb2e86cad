// The section `sweep`: every combination of some parameters.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"
#include "expression/condition.hpp"

namespace kinestat {

/// A parameter and its values: a list, or from … to in steps, `to` inclusive.
struct VariedParameter {
  Name name;
  std::vector<Value> values;  ///< empty if a range is given
  std::optional<Value> from;
  std::optional<Value> to;
  std::optional<Value> step;
};

/// A condition of a combination, or of a row.
struct Requirement {
  Condition condition;
  SourceRange where;
  int text_column = 0;  ///< as of Value
};

struct SweepDescription {
  std::vector<VariedParameter> vary;
  std::vector<Requirement> require;  ///< what combinations must fulfil to be analysed
  std::vector<Name> cases;           ///< labels; empty: all
  std::vector<Name> report;          ///< the quantities that a row holds
  std::vector<Requirement> keep;     ///< what rows must fulfil to be written
  SourceRange where;
};

}  // namespace kinestat
