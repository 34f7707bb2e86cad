// Ratios of a case in the units of the file.
#pragma once

#include <optional>
#include <string>

#include "cases/analysis.hpp"

namespace kinestat {

/// A ratio and its unit; the unit is empty where input and output are of one kind.
struct RatioInUnits {
  std::optional<double> value;
  std::string unit;  ///< for example "rad/s/(mm/s)"
};

struct RatiosInUnits {
  RatioInUnits ratio;         ///< in the rate unit of the input per that of the output
  RatioInUnits torque_ratio;  ///< in the action unit of the input per that of the output
};

/// The two actuators of a ratio.
struct RatioEnds {
  int input = 0;
  int output = 0;
};

RatiosInUnits ratios_in_units(const Ratios& ratios,
                              const RatioEnds& ends,
                              const Mechanism& mechanism,
                              const FileUnits& units);

/// The fraction that the ratio of a case is, " = 52/17"; empty where it is none, whole, or longer
/// than people read.
std::string fraction_behind(const std::optional<Ratios>& ratios);

/// Of the first input and the first output of the case, which must have ratios.
RatiosInUnits ratios_in_units(const CaseAnalysis& one,
                              const Mechanism& mechanism,
                              const FileUnits& units);

}  // namespace kinestat
