#include "cases/findings/load_findings.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "dynamics/spring_obstacle_text.hpp"

namespace kinestat {

namespace {

// Why the forces of inertia of a case are not known; a motion that is not determined has its own
// finding.
void add_inertia_obstacle(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const InertiaObstacle& obstacle = *one.inertia_obstacle;
  switch (obstacle.kind) {
    case InertiaObstacle::Kind::unknown_motion:
      return;
    case InertiaObstacle::Kind::unmovable:
      found.error(
          "E0511",
          file.mechanism.topology.coupling(obstacle.coupling->coupling).where,
          fmt::format("case '{}' has no inertia forces, since the acceleration of coupling '{}' is "
                      "not known: {}",
                      one.which.label,
                      file.mechanism.topology.coupling(obstacle.coupling->coupling).name,
                      reason_of(obstacle.coupling->why)),
          "'kinestat help couplings' says what each type needs to be moved, and a ball cannot be "
          "driven; without 'acceleration' the case is solved as statics");
      return;
    case InertiaObstacle::Kind::idle_spin:
      found.error("E0511",
                  one.which.where,
                  fmt::format("case '{}' has no inertia forces: they depend on how fast body '{}' "
                              "turns by itself, an idle freedom, and the case gives no rate for it",
                              one.which.label,
                              file.mechanism.topology.body(*obstacle.body).name),
                  "join one of its ends by a universal coupling instead of a ball; or give it no "
                  "inertia about the axis of that turn, as a slender rod has none");
      return;
    case InertiaObstacle::Kind::singular:
      found.error(
          "E0511",
          one.which.where,
          fmt::format("case '{}' has no inertia forces, since its position is singular: there the "
                      "speeds of its drives do not determine accelerations",
                      one.which.label),
          "draw the mechanism a little away from that position, or drive it by another coupling");
      return;
  }
}

void add_open_inertia(const CaseAnalysis& one, CaseFindings& found) {
  CaseFinding& added = found.warning(
      "W0517",
      one.which.where,
      fmt::format("case '{}': rounding of the accelerations leaves forces of inertia open by up to "
                  "{:.1g} times the largest",
                  one.which.label,
                  one.dynamics->open_share),
      "the position is nearly singular, or the case gives the speed of what hardly moves: move "
      "away from it, or give the speed of another coupling");
  added.size = one.dynamics->open_share;
}

// Bodies that turn and whose turning asks for nothing.
void add_point_masses(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  std::vector<std::string> names;
  for (const BodyDynamics& body : one.dynamics->bodies) {
    const BodyMass& mass = file.mechanism.masses[static_cast<std::size_t>(body.body.value)];
    const Vec3 turns = bounded_body(*one.motion, body.body).angular.zeroed();
    const BoundedVector speeds_up = {.value = body.angular_acceleration,
                                     .bound = Vec3::Constant(body.angular_bound)};
    const bool turns_at_all = !turns.isZero(0.0) || !speeds_up.zeroed().isZero(0.0);
    if (turns_at_all && !mass.has_inertia) {
      names.push_back(fmt::format("'{}'", file.mechanism.topology.body(body.body).name));
    }
    if (mass.polar_axis && !turns.cross(*mass.polar_axis).isZero(kRotorAxis * turns.norm())) {
      found.error("E0323",
                  mass.where,
                  fmt::format("body '{}' turns about another axis than that of its 'polar' inertia "
                              "in case '{}'",
                              file.mechanism.topology.body(body.body).name,
                              one.which.label),
                  "give its three moments of inertia or the rows of its tensor");
    }
  }
  if (!names.empty()) {
    found.warning("W0310",
                  one.which.where,
                  fmt::format("{} {} in case '{}' and {} no 'inertia': counted as {}",
                              plain_list(names),
                              names.size() == 1 ? "turns" : "turn",
                              one.which.label,
                              names.size() == 1 ? "has" : "have",
                              names.size() == 1 ? "a point mass" : "point masses"),
                  "give 'inertia' about the centre of mass; write 0 where that is meant");
  }
}

// Of several positions, that in which a gas spring is farthest past its stroke.
void add_spring_obstacle(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const SpringObstacle& obstacle = *one.spring_obstacle;
  const Spring& spring = file.mechanism.springs[obstacle.spring];
  const auto add = [&](std::string hint) -> CaseFinding& {
    return found.error(
        "E0324", spring.where, text_of(obstacle, spring, file.description.units), std::move(hint));
  };
  switch (obstacle.kind) {
    case SpringObstacle::Kind::no_length:
      add("give points that are apart, or make it a spring of a coupling");
      return;
    case SpringObstacle::Kind::past_stroke: {
      CaseFinding& added =
          add("'length' is that of the extended spring, from which 'stroke' is pushed in; correct "
              "these or its points, or end the motion earlier");
      added.element = limit_word(obstacle, spring);
      added.size = excess_of(obstacle, spring);
      return;
    }
    case SpringObstacle::Kind::no_position:
      add("balls, contacts and cables have none: give the spring two points");
      return;
    case SpringObstacle::Kind::no_speed:
      add("give 'motion' of the case what determines that speed");
      return;
  }
}

void add_curve_obstacle(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const CurveObstacle& obstacle = *one.curve_obstacle;
  const Curve& curve = file.mechanism.curves[obstacle.curve];
  const FileUnits& units = file.description.units;
  switch (obstacle.kind) {
    case CurveObstacle::Kind::outside:
      found.error("E0326",
                  curve.where,
                  fmt::format("case '{}' is beyond curve '{}', which goes {}",
                              one.which.label,
                              curve.name,
                              reach_of(curve, units)),
                  "add points that reach there, or 'period', after which the curve repeats");
      return;
    case CurveObstacle::Kind::no_time:
      found.error("E0326",
                  curve.where,
                  fmt::format("curve '{}' is over time, and the motion has none", curve.name),
                  "give the motion a time: time: 0.5 s; its case says the speed, or 'law' how it "
                  "runs");
      return;
    case CurveObstacle::Kind::no_position:
      found.error(
          "E0326",
          curve.where,
          fmt::format(
              "curve '{}' is over '{}', whose freedom has no position", curve.name, curve.actuator),
          "balls, contacts and cables have none: let the curve be over another actuator");
      return;
    case CurveObstacle::Kind::no_speed:
      found.error("E0326",
                  curve.where,
                  fmt::format("curve '{}' is over the speed of '{}', which case '{}' does not give",
                              curve.name,
                              curve.actuator,
                              one.which.label),
                  "give 'motion' of the case what determines that speed");
      return;
    case CurveObstacle::Kind::no_value:
      found.error(
          "E0326",
          one.which.where,
          fmt::format(
              "'{}' of case '{}' is undefined in this position", obstacle.number, one.which.label),
          "its curves have values, but the expression divides by zero, or takes a root or a "
          "logarithm that does not exist");
      return;
  }
}

}  // namespace

std::string reach_of(const Curve& curve, const FileUnits& units) {
  return fmt::format("from {:.10g} to {:.10g} {}",
                     units.from_si(curve.place_kind, curve.at.front()),
                     units.from_si(curve.place_kind, curve.at.back()),
                     units.text(curve.place_kind));
}

void add_load_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  if (one.inertia_obstacle) {
    add_inertia_obstacle(file, one, found);
  }
  // What leaves the speeds open has a finding of its own.
  const bool is_open = one.motion && one.motion->status != SolveStatus::solved;
  const auto is_told = [is_open](auto kind) { return is_open && kind == decltype(kind)::no_speed; };
  if (one.spring_obstacle && !is_told(one.spring_obstacle->kind)) {
    add_spring_obstacle(file, one, found);
  }
  if (one.curve_obstacle && !is_told(one.curve_obstacle->kind)) {
    add_curve_obstacle(file, one, found);
  }
  if (one.dynamics && one.dynamics->open_share > kKnownInertia) {
    add_open_inertia(one, found);
  }
  if (one.dynamics && one.motion && one.motion->status == SolveStatus::solved) {
    add_point_masses(file, one, found);
  }
}

}  // namespace kinestat
