#include "studies/motion/task/cycle/cycle_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/motion_tolerance.hpp"

namespace kinestat {

namespace {

// A share of the time at which hardly anything turns back.
constexpr double kSomewhere = 0.381966;

const ActuatorTopology& first_drive(const Mechanism& mechanism, const MotionPlan& plan) {
  return mechanism.topology.actuators[static_cast<std::size_t>(plan.drives.front().actuator)];
}

bool turns(const Mechanism& mechanism, const PlannedDrive& drive) {
  return mechanism.topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
}

// The first that is elsewhere; bodies about axes of the ground look the same at any angle, or show
// in what they do.
std::optional<BodyId> find_displaced(const Mechanism& mechanism,
                                     const std::vector<BodyPose>& begin,
                                     const std::vector<BodyPose>& end) {
  for (std::size_t b = 1; b < begin.size(); ++b) {
    const BodyId body{static_cast<int>(b)};
    const Vec3& reference = mechanism.geometry.references[b];
    const double turned = (end[b].rotation - begin[b].rotation).norm();
    const double shifted = (end[b].point(reference) - begin[b].point(reference)).norm();
    const bool is_there =
        turned <= kCycleReturns && shifted <= kCycleReturns * mechanism.geometry.length;
    if (!is_there && !ground_axis(mechanism.topology, body)) {
      return body;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> find_wound_spring(const CaseAnalysis& begin, const CaseAnalysis& end) {
  for (std::size_t s = 0; s < std::min(begin.springs.size(), end.springs.size()); ++s) {
    const double low = begin.springs[s].position;
    const double high = end.springs[s].position;
    if (std::abs(high - low) > kCycleReturns * std::max(1.0, std::abs(low) + std::abs(high))) {
      return s;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<CycleProblem> why_no_inertia(const Mechanism& mechanism, const FoundMotion& motion) {
  const MotionPlan& plan = motion.plan;
  if (plan.which < 0) {
    return CycleProblem{"the motion has no case, which gives speeds and loads",
                        "add case: LABEL to 'motion'"};
  }
  const Case& which = mechanism.cases[static_cast<std::size_t>(plan.which)];
  if (!which.has_inertia()) {
    return CycleProblem{
        fmt::format("case '{}' of the motion has no inertia forces", which.label),
        "add acceleration: {} to the case, and mass and inertia to the bodies that have any"};
  }
  if (!plan.schedule || motion.solution.status != MotionStatus::completed) {
    return CycleProblem{"the motion does not reach its end",
                        "let it run as far as it goes, from 'from' to 'to' in time"};
  }
  return std::nullopt;
}

std::optional<CycleProblem> why_no_mass(const Mechanism& mechanism) {
  if (std::ranges::none_of(mechanism.masses, &BodyMass::counts)) {
    return CycleProblem{"no body has mass or inertia", "add them to 'bodies'"};
  }
  return std::nullopt;
}

std::optional<CycleProblem> why_not_steady(const Mechanism& mechanism, const FoundMotion& motion) {
  const MotionPlan& plan = motion.plan;
  if (plan.drives.size() > 1) {
    return CycleProblem{"the motion has several drives", "give one drive, which runs steadily"};
  }
  const std::string& name = first_drive(mechanism, plan).name;
  const double speed = plan.schedule->at(0, 0.0).speed;
  for (int step = 0; step <= plan.steps; ++step) {
    const DriveInstant there =
        plan.schedule->at(0, static_cast<double>(step) / static_cast<double>(plan.steps));
    const double way = plan.drives.front().to - plan.drives.front().from;
    const bool is_steady = std::abs(there.speed - speed) <= kSteady * std::abs(speed) &&
                           std::abs(there.acceleration * way) <= kSteady * speed * speed &&
                           speed != 0.0;
    if (!is_steady) {
      return CycleProblem{
          fmt::format("drive '{}' does not run at a steady speed", name),
          fmt::format("leave out 'law', give its speed in the case of the motion, and "
                      "acceleration: {{{}: 0}}",
                      name)};
    }
  }
  const Case& which = mechanism.cases[static_cast<std::size_t>(plan.which)];
  for (const Primary& known : which.motions) {
    if (known.index != plan.drives.front().freedom && known.value != 0.0 && !known.is_assumed) {
      return CycleProblem{
          fmt::format("case '{}' gives '{}' a speed in addition to that of the drive",
                      which.label,
                      known.given),
          "give the speed of the drive alone"};
    }
  }
  return std::nullopt;
}

std::optional<CycleProblem> why_no_cycle(CycleSampler& sampler) {
  const Mechanism& mechanism = sampler.mechanism();
  const FoundMotion& motion = sampler.motion();
  if (auto problem = why_not_steady(mechanism, motion)) {
    return problem;
  }
  const PlannedDrive& drive = motion.plan.drives.front();
  const std::string& name = first_drive(mechanism, motion.plan).name;
  if (!turns(mechanism, drive)) {
    return CycleProblem{fmt::format("drive '{}' slides, and only turns come round", name),
                        "let the motion be driven by a freedom that turns"};
  }
  const double count = std::abs(drive.to - drive.from) / (2.0 * std::numbers::pi);
  if (std::abs(count - std::max(1.0, std::round(count))) > kCycleReturns * count) {
    return CycleProblem{
        fmt::format("drive '{}' makes {:.6g} turns; a cycle needs whole turns", name, count),
        "write to: 360 deg, or as many turns as it takes until everything is where it was"};
  }
  const std::optional<MotionPosition> begin = sampler.at(0.0);
  const std::optional<MotionPosition> end = sampler.at(1.0);
  if (!begin || !end) {
    return CycleProblem{"the ends of the motion have no answer", "begin it elsewhere"};
  }
  if (const auto body = find_displaced(mechanism, begin->state.poses, end->state.poses)) {
    return CycleProblem{
        fmt::format("at the end of the motion body '{}' is not where it was at the start",
                    mechanism.topology.body(*body).name),
        "let the drive turn as often as it takes until everything is where it was"};
  }
  if (begin->solved && end->solved) {
    if (const auto spring = find_wound_spring(*begin->solved, *end->solved)) {
      return CycleProblem{fmt::format("at the end of the motion spring '{}' is not as long as at "
                                      "the start, or not as far turned",
                                      mechanism.springs[*spring].name),
                          "let it join bodies that come back to where they were"};
    }
  }
  return std::nullopt;
}

std::optional<CycleProblem> why_not_closed(const LegendrePieces& found,
                                           const Mechanism& mechanism) {
  if (!mechanism.frictions.empty()) {
    return std::nullopt;
  }
  const VecX begin = found.values(found.from());
  const VecX end = found.values(found.to());
  for (Eigen::Index f = 0; f < begin.size(); ++f) {
    if (std::abs(end[f] - begin[f]) > kCycleReturns * found.size(static_cast<std::size_t>(f))) {
      return CycleProblem{"at the end of the motion other forces act than at its start",
                          "let the drive turn as often as it takes until everything is as it was"};
    }
  }
  return std::nullopt;
}

std::optional<CouplingId> ground_axis(const Topology& topology, BodyId body) {
  for (std::size_t c = 0; c < topology.couplings.size(); ++c) {
    const CouplingTopology& one = topology.couplings[c];
    const bool joins =
        (one.tail == body && one.head == BodyId{0}) || (one.head == body && one.tail == BodyId{0});
    if (joins && one.type == CouplingType::revolute) {
      return CouplingId{static_cast<int>(c)};
    }
  }
  return std::nullopt;
}

std::vector<CycleMotor> cycle_motors(CycleSampler& sampler) {
  const Mechanism& mechanism = sampler.mechanism();
  const MotionPlan& plan = sampler.motion().plan;
  const Case& which = mechanism.cases[static_cast<std::size_t>(plan.which)];
  const std::optional<MotionPosition> there = sampler.at(kSomewhere);
  std::vector<CycleMotor> motors;
  for (std::size_t a = 0; there && a < mechanism.topology.actuators.size(); ++a) {
    const ActuatorTopology& actuator = mechanism.topology.actuators[a];
    const std::optional<double> rate =
        there->state.rates.empty() ? std::nullopt
                                   : there->state.rates[static_cast<std::size_t>(actuator.freedom)];
    const bool is_given =
        std::ranges::find(which.actions, actuator.action, &Primary::index) != which.actions.end();
    const bool is_drive = actuator.freedom == plan.drives.front().freedom;
    if (!is_given && (is_drive || (rate && *rate != 0.0))) {
      const double ratio = is_drive ? 1.0 : *rate / plan.schedule->at(0, kSomewhere).speed;
      motors.push_back({.actuator = static_cast<int>(a), .ratio = ratio});
    }
  }
  return motors;
}

}  // namespace kinestat
