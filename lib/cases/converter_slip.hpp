// The slip of a torque converter that the torques of a case decide.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cases/analysis.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Indices of the known actions of a case, in the order in which they may follow from a converter:
/// those of the inputs before others, and such as have a known speed, too, before all.
std::vector<std::size_t> deciding_actions(const Topology& topology, const Case& which);

/// A case that lacks a motion and has an action more than equilibrium leaves open: the engine of an
/// automatic, with its speed and its torque. The speed ratio at which the converter takes that
/// torque gives the motion.
///
/// The case with the slip as a known motion and without that action, or why there is none; empty
/// where no converter decides it. `solve` is a case with velocities and actions.
std::optional<ConverterSearch> find_converter_slip(
    const Mechanism& mechanism,
    const CoordinateBasis& motions,
    const Case& which,
    const std::function<CaseAnalysis(const Case&)>& solve);

}  // namespace kinestat
