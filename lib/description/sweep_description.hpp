// The section `sweep`: every combination of some parameters, or a sample of them.
#pragma once

#include <array>
#include <optional>
#include <string_view>
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
  std::optional<Value> step;  ///< empty: anywhere in the range, which only a sample can have
};

enum class SampleMethod { sobol, random, latin };

/// Their words.
inline constexpr std::array<std::string_view, 3> kSampleMethods = {"sobol", "random", "latin"};

inline constexpr int kUsualSeed = 1;

/// Values are drawn instead of all being combined.
struct SampleDescription {
  std::optional<Value> count;
  SampleMethod method = SampleMethod::sobol;
  std::optional<Value> seed;  ///< empty: kUsualSeed
  SourceRange where;
};

/// A condition of a combination, or of a row.
struct Requirement {
  Condition condition;
  SourceRange where;
  int text_column = 0;  ///< as of Value
};

struct SweepDescription {
  std::vector<VariedParameter> vary;
  std::optional<SampleDescription> sample;
  std::vector<Requirement> require;  ///< what combinations must fulfil to be analysed
  std::vector<Name> cases;           ///< labels; empty: all
  std::vector<Name> report;          ///< the quantities that a row holds
  std::vector<Requirement> keep;     ///< what rows must fulfil to be written
  SourceRange where;
};

}  // namespace kinestat
