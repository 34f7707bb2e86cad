// What the limits of a synthesis task, or the kind of linkage that it asks for, cost.
#pragma once

#include <string>

#include "studies/synthesis/report/plane_text.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// The limits with which a linkage would be usable, so that they can be typed as they are printed:
/// " and takes limits: {link_ratio: 12.4}"; empty where no limit helps, or none is needed.
std::string limits_text(const LinkageCandidate& candidate,
                        const LinkageLimits& limits,
                        const PlaneText& plane);

/// A line on the usable linkages of other kinds than the task asks for; empty without any.
std::string left_out_text(const SynthesisTask& task, const LinkageLimits& limits);

}  // namespace kinestat
