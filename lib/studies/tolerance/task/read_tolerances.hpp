// How far parts and drives may deviate, from the words of a command line.
#pragma once

#include <span>
#include <vector>

#include "core/diagnostic.hpp"
#include "expression/file_units.hpp"
#include "studies/tolerance/task/tolerance_choice.hpp"
#include "studies/tolerance/tolerance_stack.hpp"

namespace kinestat {

struct ReadTolerances {
  double place = 0.0;                    ///< of what has none of its own [m]
  double angle = 0.0;                    ///< likewise [rad]
  std::vector<PartTolerances> of_cases;  ///< which hold the drives that may deviate
};

/// Without a meaning where an error, E0101, was added.
ReadTolerances read_tolerances(const Topology& topology,
                               const FileUnits& units,
                               std::span<const Case> cases,
                               const ToleranceChoice& choice,
                               Diagnostics& found);

}  // namespace kinestat
