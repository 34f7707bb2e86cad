// The finite motion that a description asks for.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// Runs the section `motion` of a description that has been bound to this mechanism. What became of
/// it is added to `found`; empty iff there is nothing to report, with an error.
std::optional<FoundMotion> find_motion(const MechanismDescription& description,
                                       const Mechanism& mechanism,
                                       Diagnostics& found);

}  // namespace kinestat
