// Whether a motion is what flywheels, harmonics and the like are of.
#pragma once

#include <optional>
#include <string>

#include "core/diagnostic.hpp"
#include "studies/motion/task/cycle/cycle_sampler.hpp"

namespace kinestat {

/// Why something cannot be told, and what would help.
struct CycleProblem {
  std::string message;
  std::string hint;
  SourceRange where = {};  ///< of what is to blame; none: of what is asked for
};

/// A motion in time, to its end, of a case with inertia, even if no body has any.
std::optional<CycleProblem> why_no_inertia(const Mechanism& mechanism, const FoundMotion& motion);

/// Bodies with mass, without which there is nothing to balance.
std::optional<CycleProblem> why_no_mass(const Mechanism& mechanism);

/// One drive that runs steadily, and nothing else that the case moves.
std::optional<CycleProblem> why_not_steady(const Mechanism& mechanism, const FoundMotion& motion);

/// Likewise, whole turns, at whose end everything stands as at the begin, but for bodies that turn
/// about an axis of the ground.
std::optional<CycleProblem> why_no_cycle(CycleSampler& sampler);

/// Whether what was found along the motion is at its end what it was at its begin. Where friction
/// turns round there it is not, although everything returns.
std::optional<CycleProblem> why_not_closed(const LegendrePieces& found, const Mechanism& mechanism);

/// Whether a body turns about an axis of the ground; which then is that coupling.
std::optional<CouplingId> ground_axis(const Topology& topology, BodyId body);

/// An actuator whose action the case leaves to be solved and that moves, and its rate over that of
/// the drive.
struct CycleMotor {
  int actuator = 0;
  double ratio = 0.0;
};

/// All of them, with their ratios somewhere on the way.
std::vector<CycleMotor> cycle_motors(CycleSampler& sampler);

}  // namespace kinestat
