#include "mechanism/motion_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

namespace {

// How far a slide may be from one limit to the other [m]. In a circuit without other slides the two
// points that were drawn in one place are apart by what its other bodies bridge, at most the
// greatest distance between two of the couplings of each, to either side.
double longest_slide(const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  double bridged = 0.0;
  for (int body = 0; body < static_cast<int>(topology.bodies.size()); ++body) {
    std::vector<Vec3> points;
    for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology.couplings[e];
      if (coupling.tail.value == body || coupling.head.value == body) {
        points.push_back(mechanism.geometry.points[e]);
      }
    }
    double widest = 0.0;
    for (const Vec3& a : points) {
      for (const Vec3& b : points) {
        widest = std::max(widest, (a - b).norm());
      }
    }
    bridged += widest;
  }
  return 2.0 * std::max(bridged, mechanism.geometry.length);
}

class MotionBinder {
 public:
  MotionBinder(const MechanismDescription& description, const Mechanism& mechanism)
      : description_(description),
        motion_(*description.motion),
        mechanism_(mechanism),
        evaluator_(make_evaluator(description, ignored_)) {
    evaluator_.measure_from(mechanism.geometry.origin);
  }

  MotionPlan run() {
    for (const DriveRange& range : motion_.drives) {
      add_drive(range);
    }
    const auto steps = motion_.steps
                           ? evaluator_.number(*motion_.steps, QuantityKind::dimensionless)
                           : std::nullopt;
    plan_.steps = static_cast<int>(std::lround(steps.value_or(kUsualSteps)));
    plan_.which = motion_.label ? case_of(*motion_.label) : -1;
    for (const TracePoint& point : motion_.trace) {
      const auto body =
          std::ranges::find(mechanism_.topology.bodies, point.body.text, &BodyTopology::name);
      const std::string usual = fmt::format("{}.{}", point.body.text, plan_.trace.size() + 1);
      plan_.trace.push_back({.name = point.name ? point.name->text : usual,
                             .body = {static_cast<int>(body - mechanism_.topology.bodies.begin())},
                             .at = evaluator_.point(point.at).value_or(Vec3::Zero())});
    }
    plan_.report.is_default = motion_.report.empty();
    for (const Name& name : motion_.report) {
      add_report(name.text);
    }
    plan_.where = motion_.where;
    KINESTAT_EXPECTS(!ignored_.has_errors());
    return std::move(plan_);
  }

 private:
  int case_of(const Name& label) const {
    const auto at = std::ranges::find(mechanism_.cases, label.text, &Case::label);
    KINESTAT_EXPECTS(at != mechanism_.cases.end());
    return static_cast<int>(at - mechanism_.cases.begin());
  }

  void add_drive(const DriveRange& range) {
    const Topology& topology = mechanism_.topology;
    const auto at =
        std::ranges::find(topology.actuators, range.actuator.text, &ActuatorTopology::name);
    KINESTAT_EXPECTS(at != topology.actuators.end());
    const bool turns = topology.freedoms[static_cast<std::size_t>(at->freedom)].is_rotation;
    const QuantityKind kind = turns ? QuantityKind::angle : QuantityKind::length;
    const auto value = [&](const std::optional<Value>& text) {
      return text ? evaluator_.number(*text, kind).value_or(0.0) : 0.0;
    };
    const double from = value(range.from);
    const int sense = limit_sense(range.to, description_);
    plan_.drives.push_back({.actuator = static_cast<int>(at - topology.actuators.begin()),
                            .freedom = at->freedom,
                            .from = from,
                            .to = sense == 0 ? value(range.to)
                                             : from + sense * (turns ? 2.0 * std::numbers::pi
                                                                     : longest_slide(mechanism_)),
                            .until_limit = sense != 0,
                            .where = range.actuator.where});
  }

  // A word, an actuator, or a freedom or an action of a coupling.
  void add_report(const std::string& name) {
    if (bool* const word = find_report_word(name, plan_.report)) {
      *word = true;
      return;
    }
    const Topology& topology = mechanism_.topology;
    for (int i = 0; i < static_cast<int>(topology.actuators.size()); ++i) {
      if (topology.actuators[static_cast<std::size_t>(i)].name == name) {
        plan_.report.actuators.push_back(i);
        return;
      }
    }
    for (int f = 0; f < topology.freedom_count(); ++f) {
      if (topology.freedom_name(f) == name) {
        plan_.report.freedoms.push_back(f);
        return;
      }
    }
    for (int a = 0; a < topology.action_count(); ++a) {
      if (topology.action_name(a) == name) {
        plan_.report.actions.push_back(a);
        return;
      }
    }
  }

  const MechanismDescription& description_;
  const MotionDescription& motion_;
  const Mechanism& mechanism_;
  Diagnostics ignored_;
  Evaluator evaluator_;
  MotionPlan plan_;
};

}  // namespace

bool* find_report_word(std::string_view word, MotionReport& report) {
  const std::pair<std::string_view, bool*> words[] = {
      {"position", &report.position},
      {"velocity", &report.velocity},
      {"acceleration", &report.acceleration},
      {"action", &report.action},
      {"power", &report.power},
      {"ratio", &report.ratio},
      {"transmission_angle", &report.transmission_angle},
      {"mechanical_advantage", &report.mechanical_advantage}};
  const auto* const at = std::ranges::find(words, word, &std::pair<std::string_view, bool*>::first);
  return at == std::end(words) ? nullptr : at->second;
}

std::optional<MotionPlan> bind_motion(const MechanismDescription& description,
                                      const Mechanism& mechanism) {
  return description.motion ? std::optional(MotionBinder(description, mechanism).run())
                            : std::nullopt;
}

}  // namespace kinestat
