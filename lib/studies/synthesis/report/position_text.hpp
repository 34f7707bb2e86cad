// The positions of a synthesis task for people.
#pragma once

#include <string>

#include "studies/synthesis/report/plane_text.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// What is known of the instant in every position that is prescribed with derivatives: pole,
/// curvature of the path of the origin E, special frame. Empty without such positions.
std::string positions_text(const SynthesisTask& task, const PlaneText& plane);

}  // namespace kinestat
