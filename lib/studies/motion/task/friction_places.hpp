// Places between the rows of a motion at which frictions slide as at no row beside them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "mechanism/motion_plan.hpp"
#include "studies/motion/task/friction_sliding.hpp"

namespace kinestat {

/// Looks between the rows, at steps.
struct FrictionLooks {
  /// How all frictions slide; empty where no motion is known.
  std::function<std::vector<Vec3>(double step)> speeds;

  /// The same, and what else a row knows; empty where the motion cannot be followed to there.
  std::function<std::optional<FrictionSliding>(double step)> place;
};

/// Adds to the rows of a motion, in order, places between them: where drives of a motion in time
/// stop, and the middles of what they move between two stops with no row in it; and one in each
/// stretch in which a friction slides another way than beside it. These are looked for where it
/// slides slowest, beside its rests and where it turns round.
void add_places_between(const Mechanism& mechanism,
                        const MotionPlan& plan,
                        const FrictionLooks& looks,
                        std::vector<FrictionPlace>& rows);

}  // namespace kinestat
