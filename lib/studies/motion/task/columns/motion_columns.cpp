#include "studies/motion/task/columns/motion_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <string>
#include <unordered_set>
#include <utility>

#include "cases/case_efficiency.hpp"
#include "core/axis_name.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "mechanism/label_kind.hpp"
#include "studies/motion/task/columns/column_detail.hpp"
#include "studies/motion/task/columns/dynamic_columns.hpp"
#include "studies/motion/task/columns/motion_column_choice.hpp"
#include "studies/motion/task/columns/quotient_columns.hpp"
#include "studies/motion/task/columns/reaction_columns.hpp"
#include "studies/motion/task/columns/spring_columns.hpp"

namespace kinestat {

namespace {

using Reader = std::function<std::optional<double>(const MotionPosition&)>;

using Vector = std::array<std::optional<double>, 3>;

// Empty where it would be rounding.
std::optional<double> reported(double value, double bound) {
  return is_reported(value, bound) ? std::optional(value) : std::nullopt;
}

Vector reported(const BoundedRate& rate) {
  return {reported(rate.value[0], rate.bound),
          reported(rate.value[1], rate.bound),
          reported(rate.value[2], rate.bound)};
}

std::optional<double> entry(const std::vector<std::optional<double>>& list,
                            const std::vector<double>& bounds,
                            std::size_t i) {
  return i < list.size() && list[i] ? reported(*list[i], bounds[i]) : std::nullopt;
}

// Empty too where the position is so near a singular one that they would be rounding.
bool has_acceleration(const MotionPosition& position) {
  return has_motion(position) && !position.state.twist_rates.empty();
}

// The axis of the turn times its angle [rad].
Vec3 rotation_vector(const Mat3& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

class ReadingList {
 public:
  ReadingList(const MechanismDescription& description,
              const Mechanism& mechanism,
              const MotionPlan& plan,
              const MotionPosition& first)
      : units_(description.units),
        mechanism_(mechanism),
        topology_(mechanism.topology),
        plan_(plan),
        first_(first),
        detail_(detail_of(plan, mechanism)) {}

  std::vector<MotionReading> run() {
    needs_ = kPlaces;
    if (plan_.schedule) {
      add("", std::string(kTimeColumn), QuantityKind::time, [](const MotionPosition& at) {
        return at.time;
      });
    }
    add_positions();
    add_traces();
    needs_ = kVelocities;
    add_velocities();
    needs_ = kAccelerations;
    add_accelerations();
    needs_.reset();
    add_actions();
    add_reactions();
    add_springs();
    add_powers();
    add_losses();
    add_efficiency();
    if (report().dynamics && plan_.which >= 0 && which().has_inertia()) {
      std::vector<MotionReading> dynamics = dynamic_readings(units_, mechanism_, plan_);
      std::ranges::move(dynamics, std::back_inserter(readings_));
    }
    add_transmission();
    return std::move(readings_);
  }

 private:
  const MotionReport& report() const { return plan_.report; }

  void add(std::string element, std::string quantity, QuantityKind kind, Reader value) {
    readings_.push_back({.column = {.element = std::move(element),
                                    .quantity = std::move(quantity),
                                    .unit = units_.text(kind)},
                         .kind = kind,
                         .value = std::move(value),
                         .needs = needs_});
  }

  bool is_named(int freedom) const {
    const auto of_actuator = [&](int actuator) {
      return topology_.actuators[static_cast<std::size_t>(actuator)].freedom == freedom;
    };
    return std::ranges::find(report().freedoms, freedom) != report().freedoms.end() ||
           std::ranges::any_of(report().actuators, of_actuator);
  }

  bool drives_output(int freedom) const {
    return plan_.which >= 0 && std::ranges::any_of(which().outputs, [&](int actuator) {
             return topology_.actuators[static_cast<std::size_t>(actuator)].freedom == freedom;
           });
  }

  bool turns(int freedom) const {
    return topology_.freedoms[static_cast<std::size_t>(freedom)].is_rotation;
  }

  // The components that exist: x and y in the plane.
  int axis_count() const { return mechanism_.space == Space::planar ? 2 : 3; }

  void add_positions() {
    for (int f = 0; f < topology_.freedom_count(); ++f) {
      const auto i = static_cast<std::size_t>(f);
      const bool is_asked = report().position || report().is_default || is_named(f) ||
                            std::ranges::find(report().positions, f) != report().positions.end();
      if (is_asked && first_.freedoms[i]) {
        add(topology_.freedom_name(f),
            "position",
            position_kind(turns(f)),
            [i](const MotionPosition& at) { return at.freedoms[i]; });
        readings_.back().column.is_output = drives_output(f);
      }
    }
    for (int b = 1; report().position && b < topology_.body_count(); ++b) {
      add_pose(b);
    }
  }

  void add_pose(int body) {
    const auto b = static_cast<std::size_t>(body);
    const std::string& name = topology_.bodies[b].name;
    const Vec3 reference = mechanism_.geometry.references[b];
    add_place(name, BodyId{body}, reference);
    if (mechanism_.space == Space::planar) {
      add(name, "rotation/z", QuantityKind::angle, [b](const MotionPosition& at) {
        return std::optional(at.turns[b]);
      });
      return;
    }
    for (int i = 0; i < 3; ++i) {
      add(name,
          std::string("rotation/") + kAxisNames[static_cast<std::size_t>(i)],
          QuantityKind::angle,
          [b, i](const MotionPosition& at) {
            return std::optional(zero_within_bound(rotation_vector(at.state.poses[b].rotation)[i],
                                                   at.state.bounds.bodies[b].turn));
          });
    }
  }

  void add_place(const std::string& element, BodyId body, const Vec3& drawn) {
    add_vector(element,
               "at",
               QuantityKind::length,
               [body, drawn, origin = mechanism_.geometry.origin](const MotionPosition& at) {
                 const Vec3 place = point_position(at.state, body, drawn, origin);
                 return Vector{place.x(), place.y(), place.z()};
               });
  }

  void add_vector(const std::string& element,
                  const std::string& quantity,
                  QuantityKind kind,
                  const std::function<Vector(const MotionPosition&)>& value) {
    // Worked out once a position, where the first of its components is read.
    const auto vector = std::make_shared<Vector>();
    for (std::size_t i = 0; i < static_cast<std::size_t>(axis_count()); ++i) {
      const Reader alone = [value, vector, i](const MotionPosition& at) {
        *vector = value(at);
        return (*vector)[i];
      };
      const Reader behind = [vector, i](const MotionPosition&) { return (*vector)[i]; };
      add(element, quantity + "/" + kAxisNames[i], kind, i == 0 ? alone : behind);
      readings_.back().alone = alone;
    }
  }

  void add_traces() {
    for (const TracedPoint& point : plan_.trace) {
      const std::string& name = point.name;
      needs_ = kPlaces;
      add_place(name, point.body, point.at);
      if (detail_.velocity) {
        needs_ = kVelocities;
        add_vector(
            name, "linear", QuantityKind::velocity, [point](const MotionPosition& at) -> Vector {
              return has_motion(at) ? reported(point_velocity(at.state, point.body, point.at))
                                    : Vector{};
            });
      }
      if (detail_.acceleration) {
        needs_ = kAccelerations;
        add_vector(name,
                   "linear_acceleration",
                   QuantityKind::acceleration,
                   [point](const MotionPosition& at) -> Vector {
                     return has_acceleration(at)
                                ? reported(point_acceleration(at.state, point.body, point.at))
                                : Vector{};
                   });
      }
    }
  }

  void add_velocities() {
    for (int f = 0; detail_.velocity && f < topology_.freedom_count(); ++f) {
      if (report().velocity || report().is_default || is_named(f)) {
        const auto i = static_cast<std::size_t>(f);
        add(topology_.freedom_name(f),
            "velocity",
            turns(f) ? QuantityKind::angular_velocity : QuantityKind::velocity,
            [i](const MotionPosition& at) {
              return has_motion(at) ? entry(at.state.rates, at.state.bounds.rates, i)
                                    : std::nullopt;
            });
      }
    }
    for (int b = 1; report().velocity && b < topology_.body_count(); ++b) {
      const BodyId body{b};
      const Vec3 reference = mechanism_.geometry.references[static_cast<std::size_t>(b)];
      add_angular(
          b, "angular", QuantityKind::angular_velocity, &MotionState::twists, &BodyBounds::angular);
      add_vector(topology_.bodies[static_cast<std::size_t>(b)].name,
                 "linear",
                 QuantityKind::velocity,
                 [body, reference](const MotionPosition& at) -> Vector {
                   return has_motion(at) ? reported(point_velocity(at.state, body, reference))
                                         : Vector{};
                 });
    }
  }

  void add_angular(int body,
                   const std::string& quantity,
                   QuantityKind kind,
                   std::vector<Twist> MotionState::*twists,
                   double BodyBounds::*bound) {
    const auto b = static_cast<std::size_t>(body);
    for (int i = mechanism_.space == Space::planar ? 2 : 0; i < 3; ++i) {
      add(topology_.bodies[b].name,
          quantity + "/" + kAxisNames[static_cast<std::size_t>(i)],
          kind,
          [b, i, twists, bound](const MotionPosition& at) -> std::optional<double> {
            const std::vector<Twist>& list = at.state.*twists;
            return has_motion(at) && b < list.size()
                       ? reported(list[b].angular[i], at.state.bounds.bodies[b].*bound)
                       : std::nullopt;
          });
    }
  }

  void add_accelerations() {
    for (int f = 0; detail_.acceleration && f < topology_.freedom_count(); ++f) {
      const auto i = static_cast<std::size_t>(f);
      if ((report().acceleration || is_named(f)) && first_.freedoms[i]) {
        add(topology_.freedom_name(f),
            "acceleration",
            turns(f) ? QuantityKind::angular_acceleration : QuantityKind::acceleration,
            [i](const MotionPosition& at) {
              return has_motion(at) ? entry(at.state.rate_rates, at.state.bounds.rate_rates, i)
                                    : std::nullopt;
            });
      }
    }
    for (int b = 1; report().acceleration && b < topology_.body_count(); ++b) {
      const BodyId body{b};
      const Vec3 reference = mechanism_.geometry.references[static_cast<std::size_t>(b)];
      add_angular(b,
                  "angular_acceleration",
                  QuantityKind::angular_acceleration,
                  &MotionState::twist_rates,
                  &BodyBounds::angular_rate);
      add_vector(topology_.bodies[static_cast<std::size_t>(b)].name,
                 "linear_acceleration",
                 QuantityKind::acceleration,
                 [body, reference](const MotionPosition& at) -> Vector {
                   return has_acceleration(at)
                              ? reported(point_acceleration(at.state, body, reference))
                              : Vector{};
                 });
    }
  }

  bool names_action(int action) const {
    const auto of_actuator =
        std::ranges::find(topology_.actuators, action, &ActuatorTopology::action);
    return std::ranges::find(report().actions, action) != report().actions.end() ||
           (of_actuator != topology_.actuators.end() &&
            (report().works ||
             names_actuator(static_cast<std::size_t>(of_actuator - topology_.actuators.begin()))));
  }

  void add_actions() {
    for (int a = 0; detail_.statics && a < topology_.action_count(); ++a) {
      if (report().action || names_action(a)) {
        const auto i = static_cast<std::size_t>(a);
        add(topology_.action_name(a),
            std::string(kActionColumn),
            topology_.actions[i].is_couple ? QuantityKind::moment : QuantityKind::force,
            [i](const MotionPosition& at) -> std::optional<double> {
              if (!at.solved || !at.solved->action) {
                return std::nullopt;
              }
              const auto& magnitudes = at.solved->action->magnitudes;
              return i < magnitudes.size() ? magnitudes[i] : std::nullopt;
            });
      }
    }
  }

  void add_reactions() {
    if (detail_.statics && report().reaction) {
      std::ranges::move(reaction_readings(units_, mechanism_), std::back_inserter(readings_));
    }
  }

  void add_springs() {
    if (report().action) {
      std::ranges::move(spring_readings(units_, mechanism_), std::back_inserter(readings_));
    }
  }

  bool names_actuator(std::size_t actuator) const {
    return std::ranges::find(report().actuators, static_cast<int>(actuator)) !=
           report().actuators.end();
  }

  // By itself only where something runs.
  bool has_power(std::size_t actuator) const {
    return report().power || names_actuator(actuator) || (report().works && detail_.velocity);
  }

  // Of a load, whose power is what goes in or comes out of the case.
  bool is_end(std::size_t load) const {
    return std::ranges::count(which().input_loads, load) +
               std::ranges::count(which().output_loads, load) >
           0;
  }

  void add_powers() {
    for (std::size_t i = 0; detail_.statics && i < topology_.actuators.size(); ++i) {
      if (has_power(i)) {
        add(topology_.actuators[i].name,
            "power",
            QuantityKind::power,
            [i](const MotionPosition& at) -> std::optional<double> {
              return at.solved && at.solved->power ? std::optional(at.solved->power->actuators[i])
                                                   : std::nullopt;
            });
      }
    }
    if (!report().has_powers() || plan_.which < 0) {
      return;
    }
    const std::vector<std::string> loads = load_names();
    for (std::size_t i = 0; i < loads.size(); ++i) {
      if (report().power || (is_end(i) && detail_.velocity)) {
        add(loads[i],
            "power",
            QuantityKind::power,
            [i](const MotionPosition& at) -> std::optional<double> {
              return at.solved && at.solved->power ? std::optional(at.solved->power->loads[i])
                                                   : std::nullopt;
            });
      }
    }
  }

  // What meshes lose changes the actions of actuators, beside those without it.
  void add_losses() {
    const bool has_losses = detail_.statics && !mechanism_.lossy_meshes.empty();
    for (std::size_t i = 0; has_losses && i < topology_.actuators.size(); ++i) {
      const ActuatorTopology& actuator = topology_.actuators[i];
      if (report().action || names_action(actuator.action)) {
        const auto a = static_cast<std::size_t>(actuator.action);
        add(actuator.name,
            "lossy_action",
            topology_.actions[a].is_couple ? QuantityKind::moment : QuantityKind::force,
            [a](const MotionPosition& at) -> std::optional<double> {
              const LossyState* const lossy = lossy_state_of(at);
              return lossy != nullptr ? lossy->actions[a] : std::nullopt;
            });
      }
      if (has_power(i)) {
        add(actuator.name,
            "lossy_power",
            QuantityKind::power,
            [i](const MotionPosition& at) -> std::optional<double> {
              const LossyState* const lossy = lossy_state_of(at);
              return lossy != nullptr ? std::optional(lossy->actuators[i]) : std::nullopt;
            });
      }
    }
  }

  void add_efficiency() {
    if (report().efficiency) {
      add("",
          std::string(kEfficiencyColumn),
          QuantityKind::dimensionless,
          [&mechanism = mechanism_](const MotionPosition& at) {
            return at.solved ? case_efficiency(*at.solved, mechanism).value : std::nullopt;
          });
      readings_.back().is_bounded = true;
    }
  }

  // Those of the case, then those that follow from the motion, in the order of a solved case.
  std::vector<std::string> load_names() const {
    std::vector<std::string> names;
    for (const Load& load : which().loads) {
      names.push_back(load.name);
    }
    for (const MovingLoad& load : which().moving_loads) {
      names.push_back(load.name);
    }
    std::ranges::move(spring_load_names(mechanism_), std::back_inserter(names));
    if (which().has_inertia()) {
      std::ranges::move(inertial_load_names(mechanism_), std::back_inserter(names));
    }
    return names;
  }

  const Case& which() const { return mechanism_.cases[static_cast<std::size_t>(plan_.which)]; }

  const std::string& output_name() const {
    return topology_.actuators[static_cast<std::size_t>(which().outputs.front())].name;
  }

  void add_transmission() {
    if (report().transmission_angle) {
      add(output_name(), "transmission_angle", QuantityKind::angle, [](const MotionPosition& at) {
        return at.transmission_angle;
      });
      readings_.back().folds = {.least = 0.0, .greatest = std::numbers::pi / 2.0};
    }
    std::ranges::move(quotient_readings(units_, mechanism_, plan_), std::back_inserter(readings_));
  }

  const FileUnits& units_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  const MotionPlan& plan_;
  const MotionPosition& first_;
  MotionDetail detail_;
  std::optional<MotionDetail> needs_;  // of those that are being added
  std::vector<MotionReading> readings_;
};

}  // namespace

std::vector<MotionReading> motion_readings(const MechanismDescription& description,
                                           const Mechanism& mechanism,
                                           const MotionPlan& plan,
                                           const MotionPosition& first) {
  std::vector<MotionReading> readings = ReadingList(description, mechanism, plan, first).run();
  if (plan.report.chosen) {
    const ChosenColumns& chosen = *plan.report.chosen;
    const std::unordered_set<std::string> usual(chosen.usual.begin(), chosen.usual.end());
    const std::unordered_set<std::string> named(chosen.named.begin(), chosen.named.end());
    for (MotionReading& one : readings) {
      one.column.is_named = named.contains(one.column.name());
    }
    keep_readings(
        [&](const MotionColumn& one) { return one.is_named || usual.contains(one.name()); },
        readings);
  }
  return readings;
}

}  // namespace kinestat
