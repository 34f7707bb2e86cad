// The network of a simulation: which joints its tree holds, and which motions count as idle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/motion/motion_solution.hpp"
#include "studies/simulation/simulation_plan.hpp"

namespace kinestat {

/// The tree holds `first`, then of `more`, in their order, those that close no circuit with what
/// it holds. A motion that no other body feels is idle only if nothing acts on it: if it has
/// inertia, or a spring, a load, friction, a curve or the plan is about it, it is a motion like any
/// other, as far as a joint with a position tells it.
MotionNetwork make_simulation_network(const Mechanism& mechanism,
                                      std::span<const DrawnCoupling> drawn,
                                      const SimulationPlan& plan,
                                      std::vector<int> first,
                                      std::span<const int> more);

/// A body that turns or slides by itself in a motion that stays idle, as no joint tells it,
/// although a spring, a load, friction, a curve or the plan is about it.
std::optional<BodyId> pushed_idle_body(const Mechanism& mechanism,
                                       const SimulationPlan& plan,
                                       const MotionNetwork& network);

/// The freedoms that stick by themselves, and so should be joints of the tree.
std::vector<int> sticking_freedoms(const Mechanism& mechanism);

/// Where a mechanism begins, and with which speeds of all joints.
struct SimulationBegin {
  MotionNetwork network;  ///< the coordinates being its drives
  Configuration configuration = {};
  std::vector<int> coordinates = {};  ///< rates of joints
  VecX rates = {};
};

/// The same position, reached from the drawn one by the drives of `begin`, and the same speeds in a
/// network with another tree; of its coordinates `preferred` come first. Empty where it cannot be
/// followed there.
std::optional<SimulationBegin> begin_in_other_tree(const Mechanism& mechanism,
                                                   const SimulationBegin& begin,
                                                   const MotionNetwork& other,
                                                   std::span<const int> preferred);

}  // namespace kinestat
