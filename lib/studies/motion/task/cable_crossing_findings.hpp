// What there is to say of the cables of a moved position, however it is driven.
#pragma once

#include <span>

#include "cases/case_findings.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// Cables that cross themselves in this configuration with these poses, unless the file says that
/// they are meant to.
void add_crossing_cables(const MechanismDescription& description,
                         const Mechanism& mechanism,
                         const FoundMotion& motion,
                         const Configuration& configuration,
                         std::span<const BodyPose> poses,
                         CaseFindings& found);

}  // namespace kinestat
