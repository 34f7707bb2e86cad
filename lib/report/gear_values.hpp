// What a report says of one gear beside its case.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/analysis.hpp"
#include "report/in_units.hpp"

namespace kinestat {

/// A coupling and the force that it bears, in the unit of the file.
struct LoadedCoupling {
  std::string name;
  double force = 0.0;
};

/// In the units of the file, in the order of the plan. Empty what the case does not determine.
struct GearValues {
  std::vector<std::optional<double>> ratios;         ///< of each output
  std::vector<std::optional<double>> torque_ratios;  ///< of each output
  std::vector<std::string> reasons;                  ///< why an output has no ratio; else empty
  std::vector<std::optional<double>> torques;        ///< of each element, tail on head
  std::vector<std::optional<double>> slips;          ///< of each element, head minus tail
  std::optional<double> step;
  std::optional<double> recirculation;    ///< γ
  std::optional<LoadedCoupling> bearing;  ///< the one with the largest force
  std::optional<LoadedCoupling> mesh;     ///< likewise
};

/// The case of a state; null for one that is no gear.
const CaseAnalysis* find_gear_case(const Analysis& analysis, const NamedShiftState& state);

/// Of the state with this index, which must be a gear.
GearValues gear_values(const Analysis& analysis, std::size_t state);

}  // namespace kinestat
