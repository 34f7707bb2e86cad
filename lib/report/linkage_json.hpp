// Dyads and linkages of a synthesis task as JSON.
#pragma once

#include "report/plane_json.hpp"
#include "synthesis/synthesis.hpp"

namespace kinestat {

Json dyad_json(const Dyad& dyad, const PlaneJson& plane);

/// A linkage with its class, its cognates and the verdict on each drive.
Json linkage_json(const LinkageCandidate& candidate, const PlaneJson& plane);

}  // namespace kinestat
