#include "studies/motion/task/columns/dynamic_columns.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "core/axis_name.hpp"

namespace kinestat {

namespace {

using Dynamic = std::function<std::optional<double>(const CaseDynamics&)>;

void add_wrench(const std::string& element,
                std::optional<Wrench> CaseDynamics::*wrench,
                const Mechanism& mechanism,
                std::vector<DynamicWrenchComponent>& to) {
  const bool is_planar = mechanism.space == Space::planar;
  const auto add = [&](const char* what, QuantityKind kind, int axis, int index) {
    to.push_back({.element = element,
                  .quantity = std::string(what) + kAxisNames[static_cast<std::size_t>(axis)],
                  .kind = kind,
                  .value = [wrench, origin = mechanism.geometry.origin, index](
                               const CaseDynamics& one) -> std::optional<double> {
                    const std::optional<Wrench>& found = one.*wrench;
                    return found ? std::optional(about_world(*found, origin).coordinates()[index])
                                 : std::nullopt;
                  }});
  };
  for (int axis = is_planar ? 2 : 0; axis < 3; ++axis) {
    add("moment/", QuantityKind::moment, axis, axis);
  }
  for (int axis = 0; axis < (is_planar ? 2 : 3); ++axis) {
    add("force/", QuantityKind::force, axis, 3 + axis);
  }
}

class DynamicReadings {
 public:
  DynamicReadings(const FileUnits& units, const Mechanism& mechanism, const MotionPlan& plan)
      : units_(units), mechanism_(mechanism), plan_(plan) {}

  std::vector<MotionReading> run() {
    add("", std::string(kKineticEnergyColumn), QuantityKind::energy, [](const CaseDynamics& one) {
      return std::optional(one.kinetic_energy);
    });
    add("",
        std::string(kKineticEnergyRateColumn),
        QuantityKind::power,
        [](const CaseDynamics& one) { return std::optional(one.kinetic_energy_rate); });
    for (DynamicWrenchComponent& one : dynamic_wrenches(mechanism_)) {
      add(std::move(one.element), std::move(one.quantity), one.kind, std::move(one.value));
    }
    add_magnitude(kGroundElement, &CaseDynamics::ground);
    add_magnitude(kShakingElement, &CaseDynamics::shaking);
    for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
      add_drive(d);
    }
    return std::move(readings_);
  }

 private:
  void add(std::string element, std::string quantity, QuantityKind kind, Dynamic value) {
    readings_.push_back(
        {.column = {.element = std::move(element),
                    .quantity = std::move(quantity),
                    .unit = units_.text(kind)},
         .kind = kind,
         .value = [value = std::move(value)](const MotionPosition& at) -> std::optional<double> {
           return at.solved && at.solved->dynamics ? value(*at.solved->dynamics) : std::nullopt;
         }});
  }

  // Of the force, which no direction of the world tells better than another.
  void add_magnitude(std::string_view element, std::optional<Wrench> CaseDynamics::*wrench) {
    add(std::string(element),
        "force/magnitude",
        QuantityKind::force,
        [wrench](const CaseDynamics& one) {
          const std::optional<Wrench>& found = one.*wrench;
          return found ? std::optional(found->force.norm()) : std::nullopt;
        });
  }

  void add_drive(std::size_t d) {
    const Topology& topology = mechanism_.topology;
    const PlannedDrive& drive = plan_.drives[d];
    const std::string& name = topology.actuators[static_cast<std::size_t>(drive.actuator)].name;
    const bool turns = topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
    const auto i = static_cast<Eigen::Index>(d);
    add(name,
        turns ? "inertia" : "mass",
        turns ? QuantityKind::inertia : QuantityKind::mass,
        [i](const CaseDynamics& one) { return std::optional(one.reduced.value().inertia(i, i)); });
    add(name,
        turns ? "bias_moment" : "bias_force",
        turns ? QuantityKind::moment : QuantityKind::force,
        [i](const CaseDynamics& one) { return std::optional(one.reduced.value().bias[i]); });
  }

  const FileUnits& units_;
  const Mechanism& mechanism_;
  const MotionPlan& plan_;
  std::vector<MotionReading> readings_;
};

}  // namespace

std::vector<DynamicWrenchComponent> dynamic_wrenches(const Mechanism& mechanism) {
  std::vector<DynamicWrenchComponent> components;
  add_wrench(std::string(kGroundElement), &CaseDynamics::ground, mechanism, components);
  add_wrench(std::string(kShakingElement), &CaseDynamics::shaking, mechanism, components);
  return components;
}

std::vector<MotionReading> dynamic_readings(const FileUnits& units,
                                            const Mechanism& mechanism,
                                            const MotionPlan& plan) {
  return DynamicReadings(units, mechanism, plan).run();
}

}  // namespace kinestat
