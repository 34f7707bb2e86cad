// Dyads and linkages of a synthesis task as JSON.
#pragma once

#include "report/plane_json.hpp"
#include "synthesis/synthesis.hpp"

namespace kinestat {

/// How far a curve is followed, and with how many points.
struct CurveExtent {
  double reach = 1.0;  ///< of a sliding input [length]
  int count = 200;
};

Json dyad_json(const Dyad& dyad, const PlaneJson& task_plane);

/// A linkage with its class, its cognates and the verdict on each drive.
Json linkage_json(const LinkageCandidate& candidate, const PlaneJson& plane);

/// The path of the origin of the moving frame on the circuit that holds `start`.
Json coupler_curve_json(const LinkageCandidate& candidate,
                        const Pose& start,
                        const CurveExtent& extent,
                        const PlaneJson& plane);

}  // namespace kinestat
