// Parts of solutions as JSON, in the units of the file.
#pragma once

#include "core/accuracy.hpp"
#include "math/rank.hpp"
#include "report/in_units.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// Six numbers, angular velocity first.
Json sixfold_of(const Twist& twist, const InUnits& in);

/// Six numbers, the moment first.
Json sixfold_of(const Wrench& wrench, const InUnits& in);

/// Direction, point and pitch; null without an axis. `origin` is the point about which the screw
/// was written [m].
Json screw_json(const std::optional<ScrewAxis>& axis, const Vec3& origin, const InUnits& in);

/// Method, rank, smallest pivot, largest entry dropped, gap.
Json evidence_json(const RankEvidence& rank);

/// The rank with the residual, null where there is no answer, and what is known of the error.
Json evidence_json(const RankEvidence& rank,
                   const std::optional<double>& residual,
                   const AnswerEvidence& answer);

}  // namespace kinestat
