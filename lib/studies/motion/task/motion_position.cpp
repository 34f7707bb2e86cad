#include "studies/motion/task/motion_position.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

#include "cases/case_passes.hpp"
#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "power/transmission_angle.hpp"
#include "studies/motion/contact_rates.hpp"
#include "studies/motion/moved_mechanism.hpp"

namespace kinestat {

namespace {

// False where known rates contradict each other, beyond what the state and rounding leave open.
bool meets(const Case& which, const MotionState& state) {
  return std::ranges::all_of(which.motions, [&](const Primary& known) {
    const auto freedom = static_cast<std::size_t>(known.index);
    const double rate = state.rates[freedom].value_or(known.value);
    const double bound =
        kConsistency * (std::abs(rate) + std::abs(known.value)) + state.bounds.rates[freedom];
    return std::abs(rate - known.value) <= bound;
  });
}

// The body that turns on the ground, or slides there, by this coupling alone.
std::optional<std::size_t> guided_body(const CouplingTopology& coupling) {
  const BodyId ground{0};
  const bool is_guided =
      (coupling.type == CouplingType::revolute || coupling.type == CouplingType::prismatic) &&
      (coupling.tail == ground || coupling.head == ground);
  return is_guided ? std::optional(static_cast<std::size_t>(
                         (coupling.tail == ground ? coupling.head : coupling.tail).value))
                   : std::nullopt;
}

}  // namespace

double worst_closure_error(const MotionSolution& solution) {
  double worst = kMotionClosure;
  for (const double one : solution.closure_errors) {
    worst = std::max(worst, one);
  }
  return worst;
}

MotionPositions::MotionPositions(const Mechanism& mechanism,
                                 const MotionPlan& plan,
                                 const MotionNetwork& network,
                                 std::span<const DrawnCoupling> drawn,
                                 const MotionDetail& detail)
    : mechanism_(mechanism),
      plan_(plan),
      network_(network),
      drawn_(drawn),
      detail_(detail),
      which_(plan.which < 0 ? nullptr : &mechanism.cases[static_cast<std::size_t>(plan.which)]),
      moved_(mechanism),
      states_(network, mechanism) {}

// The case with the speeds and accelerations that the drives have then, be there inertia or not.
Case MotionPositions::case_at(double time) const {
  Case now = mechanism_.cases[static_cast<std::size_t>(plan_.which)];
  now.asks_motions = true;
  now.accelerations = now.accelerations.value_or(std::vector<Primary>());
  const auto set = [&](std::vector<Primary>& list, const PlannedDrive& drive, double value) {
    const auto at = std::ranges::find(list, drive.freedom, &Primary::index);
    if (at != list.end()) {
      at->value = value;
    } else {
      list.push_back(
          {.index = drive.freedom,
           .value = value,
           .given = mechanism_.topology.actuators[static_cast<std::size_t>(drive.actuator)].name,
           .where = drive.where});
    }
  };
  for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
    const DriveInstant instant = plan_.schedule->at(d, time);
    set(now.motions, plan_.drives[d], instant.speed);
    set(*now.accelerations, plan_.drives[d], instant.acceleration);
  }
  return now;
}

MotionPosition MotionPositions::at(const Configuration& configuration,
                                   double share,
                                   std::optional<double> time) {
  MotionPosition position;
  if (plan_.schedule) {
    const double when = time.value_or(plan_.schedule->time_at(share));
    position.time = when * plan_.schedule->duration();
    if (plan_.which >= 0) {
      now_ = case_at(when);
      which_ = &*now_;
    }
  }
  const bool asks_speeds = which_ != nullptr && (detail_.velocity || detail_.acceleration);
  const bool needs_speeds =
      asks_speeds || (detail_.statics && (has_motion_of_state(*which_) || loads_by_speed(*which_)));
  const StateDetail detail =
      detail_.acceleration ? StateDetail::acceleration : StateDetail::velocity;
  CaseSpeeds found{.known = SpeedsKnown::not_by_state, .speeds = {}};
  if (needs_speeds) {
    found = CaseSpeedSolver(network_, drawn_, mechanism_, plan_, *which_, states_)
                .find(configuration, detail);
  }
  position.speeds = found.known;
  const GivenSpeeds rest{.drives = std::vector<DriveSpeed>(plan_.drives.size()), .passive = {}};
  position.state = states_.solve_bounded(
      configuration, found.known == SpeedsKnown::all ? found.speeds : rest, detail);
  if (position.has_speeds() && !position.state.is_singular && !meets(*which_, position.state)) {
    position.speeds = SpeedsKnown::dependent;
  }
  if (position.has_speeds()) {
    add_contact_rates(network_, drawn_, mechanism_, position.state);
    // The spin that a case gives a contact has no part in the state.
    if (!position.state.is_singular && !meets(*which_, position.state)) {
      position.speeds = SpeedsKnown::not_by_state;
    }
  }
  if (has_motion(position)) {
    hold_known(*which_, position.state);
  }
  place(configuration, position);
  // Freewheels are judged by their slips alone, too.
  const bool needs_motion =
      asks_speeds && (!position.has_speeds() || !mechanism_.freewheels.empty());
  const bool has_passes = !position.state.is_singular && (detail_.statics || needs_motion);
  if (detail_.transmission_angle || has_passes) {
    move(configuration, position);
  }
  if (detail_.transmission_angle) {
    const Case& which = mechanism_.cases[static_cast<std::size_t>(plan_.which)];
    position.transmission_angle =
        find_transmission_angle(moved_, which.inputs.front(), which.outputs.front());
  }
  if (has_passes) {
    solve_passes(configuration, found.speeds, position);
  }
  return position;
}

// What the case knows moves and speeds up as it says, by definition, and a body with it; one that
// turns steadily has no angular acceleration.
void MotionPositions::hold_known(const Case& which, MotionState& state) const {
  for (const Primary& known : which.motions) {
    const auto freedom = static_cast<std::size_t>(known.index);
    const bool is_driven =
        std::ranges::find(plan_.drives, known.index, &PlannedDrive::freedom) != plan_.drives.end();
    if (is_driven || freedom >= state.rates.size() || !state.rates[freedom]) {
      continue;
    }
    const auto body =
        guided_body(mechanism_.topology.coupling(mechanism_.topology.freedoms[freedom].coupling));
    if (body && *state.rates[freedom] != 0.0) {
      state.twists[*body] = (known.value / *state.rates[freedom]) * state.twists[*body];
    }
    state.rates[freedom] = known.value;
    state.bounds.rates[freedom] = 0.0;
    if (freedom < state.rate_rates.size() && state.rate_rates[freedom]) {
      state.rate_rates[freedom] = acceleration_of(which, known.index);
      state.bounds.rate_rates[freedom] = 0.0;
      if (body && state.rate_rates[freedom] == 0.0 && *body < state.twist_rates.size()) {
        state.twist_rates[*body].angular = Vec3::Zero();
        state.bounds.bodies[*body].angular_rate = 0.0;
      }
    }
  }
}

// Where freedoms and bodies stand, zero where nothing tells it from that.
void MotionPositions::place(const Configuration& configuration, MotionPosition& position) {
  position.freedoms = states_.freedom_positions(configuration);
  settle_positions(position.state.bounds, position.freedoms);
  if (mechanism_.space == Space::planar) {
    position.turns = body_turns(network_, configuration);
    for (std::size_t b = 0; b < position.turns.size(); ++b) {
      position.turns[b] =
          zero_within_bound(position.turns[b], position.state.bounds.bodies[b].turn);
    }
  }
}

void MotionPositions::move(const Configuration& configuration, MotionPosition& position) {
  move_mechanism(network_, drawn_, configuration, position.state.poses, mechanism_, moved_);
  moved_.closure_error = std::max(detail_.closure_error, position.state.bounds.place);
  if (detail_.statics) {
    for (const ActuatorTopology& actuator : mechanism_.topology.actuators) {
      const auto action = static_cast<std::size_t>(actuator.action);
      position.drive_directions.push_back(moved_.geometry.actions[action].force);
    }
  }
}

// A position that closes by least squares has no exact screws, and so no rank of its own: how the
// mechanism moves is decided where it is closed.
bool MotionPositions::has_own_rank() const {
  return detail_.closure_error <= kLeastCorrection;
}

// What bodies do by themselves is that of the state, too.
bool MotionPositions::has_motion_of_state(const Case& which) const {
  return which.asks_motions && (!has_own_rank() || !network_.passive_motions.empty());
}

// Whether what acts may follow speeds.
bool MotionPositions::loads_by_speed(const Case& which) const {
  return which.asks_motions && (!mechanism_.springs.empty() || which.follows_curves());
}

KinematicSolution MotionPositions::motion_of_state(const MotionPosition& position) const {
  KinematicSolution motion;
  if (!position.has_speeds()) {
    motion.status = position.speeds == SpeedsKnown::dependent ? SolveStatus::dependent
                                                              : SolveStatus::underdetermined;
    return motion;
  }
  const MotionState& state = position.state;
  for (const std::optional<double>& rate : state.rates) {
    motion.rates.push_back(rate.value_or(0.0));
  }
  motion.answer.bounds = state.bounds.rates;
  motion.bodies = state.twists;
  for (const BodyBounds& bounds : state.bounds.bodies) {
    motion.body_bounds.push_back(
        {.angular = Vec3::Constant(bounds.angular), .linear = Vec3::Constant(bounds.linear)});
  }
  for (const CouplingTopology& coupling : mechanism_.topology.couplings) {
    const Twist& tail = state.twists[static_cast<std::size_t>(coupling.tail.value)];
    const Twist& head = state.twists[static_cast<std::size_t>(coupling.head.value)];
    motion.couplings.push_back(
        {.angular = head.angular - tail.angular, .linear = head.linear - tail.linear});
  }
  return motion;
}

void MotionPositions::solve_passes(const Configuration& configuration,
                                   const GivenSpeeds& speeds,
                                   MotionPosition& position) {
  Case& which = moved_.cases[static_cast<std::size_t>(plan_.which)];
  if (now_) {
    which.motions = now_->motions;
    which.accelerations = which.has_inertia() ? now_->accelerations : std::nullopt;
    which.asks_motions = now_->asks_motions;
  }
  Case judged = which;
  judged.asks_actions = which.asks_actions && detail_.statics;
  std::optional<InertialMotion> inertial;
  std::optional<InertiaObstacle> obstacle;
  if (judged.asks_actions && judged.has_inertia() && position.has_speeds()) {
    const InertiaDetail detail =
        detail_.reduced_equation ? InertiaDetail::equation : InertiaDetail::forces;
    auto found = inertial_motion_of(
        position.state, moved_, network_, states_, configuration, speeds, detail);
    if (auto* const motion = std::get_if<InertialMotion>(&found)) {
      inertial = std::move(*motion);
    } else {
      obstacle = std::get<InertiaObstacle>(found);
    }
  }
  judged.asks_actions = judged.asks_actions && (inertial || !judged.has_inertia());
  judged.accelerations = inertial ? judged.accelerations : std::nullopt;
  const bool is_at_rest = !which.asks_motions;
  const std::vector<std::optional<double>> unknown(
      is_at_rest ? 0 : mechanism_.topology.freedoms.size());
  const LoadState place{
      .poses = position.state.poses,
      .twists = position.has_speeds() ? position.state.twists : std::vector<Twist>(),
      .positions = position.freedoms,
      .rates = position.has_speeds() ? position.state.rates : unknown,
      .time = position.time};
  const KnownState known{
      .motion = nullptr, .inertial = inertial ? &*inertial : nullptr, .place = &place};
  if (has_motion_of_state(which)) {
    const KinematicSolution motion = motion_of_state(position);
    position.solved = solve_row(
        moved_, judged, {.motion = &motion, .inertial = known.inertial, .place = known.place});
    // Forces and velocities are of mechanisms that differ by as much.
    std::optional<PowerFlow>& power = position.solved->power;
    if (power && power->balance_residual <= kClosureInActions * detail_.closure_error) {
      power->is_balanced = true;
    }
  } else {
    position.solved = solve_row(moved_, judged, known);
  }
  position.solved->inertia_obstacle = obstacle;
  solve_at_rest(judged, known, position);
}

void MotionPositions::solve_at_rest(const Case& which,
                                    const KnownState& known,
                                    MotionPosition& position) {
  const std::optional<StaticSolution>& action = position.solved->action;
  if (!action || action->status != SolveStatus::at_rest || !has_drive_at_rest(plan_, position)) {
    return;
  }
  const auto rests = [&](const CouplingFriction& friction) {
    return std::ranges::find(action->at_rest, friction.coupling) != action->at_rest.end();
  };
  std::vector<CouplingFriction> frictions = moved_.frictions;
  std::erase_if(moved_.frictions, rests);
  position.without_friction = solve_row(moved_, which, known);
  moved_.frictions = std::move(frictions);
}

MotionPosition MotionPosition::or_without_friction() const {
  MotionPosition result = *this;
  if (without_friction) {
    result.solved = without_friction;
  }
  return result;
}

namespace {

// What is held all the time does not come to rest.
bool ever_moves(const DriveSchedule& schedule, std::size_t drive) {
  double begin = 0.0;
  std::vector<double> ends = schedule.turns();
  ends.push_back(1.0);
  for (const double end : ends) {
    if (schedule.at(drive, std::midpoint(begin, end)).speed != 0.0) {
      return true;
    }
    begin = end;
  }
  return false;
}

}  // namespace

bool has_drive_at_rest(const MotionPlan& plan, const MotionPosition& position) {
  if (!plan.schedule || !position.solved || !position.solved->motion ||
      position.solved->motion->rates.empty()) {
    return false;
  }
  for (std::size_t d = 0; d < plan.drives.size(); ++d) {
    const auto f = static_cast<std::size_t>(plan.drives[d].freedom);
    if (position.solved->motion->rates[f] == 0.0 && ever_moves(*plan.schedule, d)) {
      return true;
    }
  }
  return false;
}

}  // namespace kinestat
