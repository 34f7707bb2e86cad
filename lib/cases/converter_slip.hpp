// The slip of a torque converter, if the torques of a case decide it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cases/analysis.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Indices of the known actions of a case, in the order in which they are tried as the action that
/// decides the slip: first those of actuators whose speed is known too, then those of inputs, then
/// those of other actuators, then the rest. Actions that follow curves are left out.
std::vector<std::size_t> deciding_actions(const Topology& topology, const Case& which);

/// Solves a case that lacks a known motion and has one known action too many, such as the torque of
/// an engine beside its speed in an automatic transmission: looks for the speed ratio at which the
/// converter takes this torque.
///
/// The result has the case with the slip as a known motion in place of that action, or why there is
/// none. Empty if no converter decides the motion. `solve` must solve velocities and actions.
std::optional<ConverterSearch> find_converter_slip(
    const Mechanism& mechanism,
    const CoordinateBasis& motions,
    const Case& which,
    const std::function<CaseAnalysis(const Case&)>& solve);

}  // namespace kinestat
