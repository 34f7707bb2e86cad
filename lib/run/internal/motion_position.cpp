#include "run/internal/motion_position.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "motion/moved_mechanism.hpp"
#include "power/transmission_angle.hpp"
#include "run/solve_cases.hpp"

namespace kinestat {

namespace {

const Primary* find_primary(const Case& which, int freedom) {
  const auto at = std::ranges::find(which.motions, freedom, &Primary::index);
  return at == which.motions.end() ? nullptr : &*at;
}

// False where known rates contradict each other.
bool meets(const Case& which, const MotionState& state) {
  double fastest = 0.0;
  for (const std::optional<double>& rate : state.rates) {
    fastest = std::max(fastest, std::abs(rate.value_or(0.0)));
  }
  return std::ranges::all_of(which.motions, [&](const Primary& known) {
    const double missed = std::abs(
        state.rates[static_cast<std::size_t>(known.index)].value_or(known.value) - known.value);
    return missed <= kMostVelocityError * std::abs(known.value) + kNoReaction * fastest;
  });
}

}  // namespace

double worst_misclosure(const MotionSolution& solution) {
  double worst = kMotionClosure;
  for (const double one : solution.misclosures) {
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
      moved_(mechanism) {}

MotionPosition MotionPositions::at(const Configuration& configuration) {
  MotionPosition position;
  position.freedoms = freedom_positions(network_, mechanism_, configuration);
  if (mechanism_.space == Space::planar) {
    position.turns = body_turns(network_, configuration);
  }
  const bool needs_speeds = detail_.velocity || detail_.acceleration;
  const auto speeds = needs_speeds ? speeds_of_case(configuration) : std::nullopt;
  const StateDetail detail =
      detail_.acceleration ? StateDetail::acceleration : StateDetail::velocity;
  position.has_speeds = speeds.has_value();
  const GivenSpeeds rest{.drives = std::vector<DriveSpeed>(plan_.drives.size()), .passive = {}};
  position.state =
      solve_state(network_, mechanism_, configuration, speeds ? *speeds : rest, detail);
  if (position.has_speeds && !position.state.is_singular) {
    position.has_speeds = meets(*which_, position.state);
  }
  if (!position.state.is_singular && (detail_.statics || detail_.transmission_angle)) {
    move_mechanism(network_, drawn_, position.state.poses, mechanism_, moved_);
    moved_.misclosure = detail_.misclosure;
    solve_passes(position);
  }
  return position;
}

// The only known motion that is not zero, of those that the drive determines.
const Primary* MotionPositions::find_moving(const Configuration& configuration) const {
  const Primary* result = nullptr;
  for (const Primary& one : which_->motions) {
    if (one.value == 0.0 || is_open(one.index, configuration)) {
      continue;
    }
    if (result != nullptr) {
      return nullptr;
    }
    result = &one;
  }
  return result;
}

// Whether the drive leaves it to itself, so that a case may give it any rate.
bool MotionPositions::is_open(int freedom, const Configuration& configuration) const {
  if (network_.passive_motions.empty()) {
    return false;
  }
  const auto rate_given = [&](double speed) {
    const GivenSpeeds speeds{.drives = {{.speed = 1.0, .acceleration = 0.0}},
                             .passive = {{.freedom = freedom, .speed = speed}}};
    const MotionState state =
        solve_state(network_, mechanism_, configuration, speeds, StateDetail::velocity);
    return state.is_singular ? 0.0 : state.rates[static_cast<std::size_t>(freedom)].value_or(0.0);
  };
  return std::abs(rate_given(1.0) - rate_given(0.0)) > 0.5;
}

// Those that the case gives or, of one drive, that follow from the motion which it gives.
std::optional<GivenSpeeds> MotionPositions::speeds_of_case(const Configuration& configuration) {
  if (which_ == nullptr) {
    return std::nullopt;
  }
  GivenSpeeds speeds;
  for (const PlannedDrive& drive : plan_.drives) {
    if (const Primary* known = find_primary(*which_, drive.freedom)) {
      speeds.drives.push_back({.speed = known->value, .acceleration = 0.0});
    }
  }
  speeds.passive = undriven_speeds();
  if (speeds.drives.size() == plan_.drives.size()) {
    return speeds;
  }
  const Primary* moving = plan_.drives.size() == 1 ? find_moving(configuration) : nullptr;
  if (moving == nullptr) {
    return std::nullopt;
  }
  // With f the given freedom as a function of the drive s: f' s. = given, f' s.. = -f'' s.^2.
  const auto freedom = static_cast<std::size_t>(moving->index);
  std::erase_if(speeds.passive,
                [&](const PassiveSpeed& one) { return one.freedom == moving->index; });
  speeds.drives = {{.speed = 1.0, .acceleration = 0.0}};
  const MotionState state =
      solve_state(network_,
                  mechanism_,
                  configuration,
                  speeds,
                  detail_.acceleration ? StateDetail::acceleration : StateDetail::velocity);
  if (state.is_singular) {
    return std::nullopt;
  }
  double fastest = 0.0;
  for (const std::optional<double>& rate : state.rates) {
    fastest = std::max(fastest, std::abs(rate.value_or(0.0)));
  }
  const double slope = state.rates[freedom].value_or(0.0);
  if (std::abs(slope) <= kNoReaction * fastest) {
    return std::nullopt;
  }
  const double speed = moving->value / slope;
  const double bend = state.rate_rates.empty() ? 0.0 : state.rate_rates[freedom].value_or(0.0);
  speeds.drives = {{.speed = speed, .acceleration = -bend * speed * speed / slope}};
  return speeds;
}

std::vector<PassiveSpeed> MotionPositions::undriven_speeds() const {
  std::vector<PassiveSpeed> speeds;
  for (const Primary& known : which_->motions) {
    if (std::ranges::find(plan_.drives, known.index, &PlannedDrive::freedom) ==
        plan_.drives.end()) {
      speeds.push_back({.freedom = known.index, .speed = known.value});
    }
  }
  return speeds;
}

void MotionPositions::solve_passes(MotionPosition& position) {
  const Case& which = moved_.cases[static_cast<std::size_t>(plan_.which)];
  if (detail_.statics) {
    position.solved = std::move(solve_some_cases(moved_, {&which, 1}).front());
  }
  if (detail_.transmission_angle) {
    position.transmission_angle =
        find_transmission_angle(moved_, which.inputs.front(), which.outputs.front());
  }
}

}  // namespace kinestat
