#include "studies/motion/task/dynamic_columns.hpp"

#include <array>
#include <functional>
#include <string>
#include <utility>

namespace kinestat {

namespace {

constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};

using Dynamic = std::function<std::optional<double>(const CaseDynamics&)>;

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
    add_wrench(std::string(kGroundElement), [](const CaseDynamics& one) { return one.ground; });
    add_wrench(std::string(kShakingElement), [](const CaseDynamics& one) { return one.shaking; });
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

  // The components about the world origin that exist.
  void add_wrench(const std::string& element,
                  const std::function<std::optional<Wrench>(const CaseDynamics&)>& wrench) {
    const auto component = [wrench, origin = mechanism_.geometry.origin](int i) -> Dynamic {
      return [wrench, origin, i](const CaseDynamics& one) -> std::optional<double> {
        const std::optional<Wrench> found = wrench(one);
        return found ? std::optional(about_world(*found, origin).coordinates()[i]) : std::nullopt;
      };
    };
    const bool is_planar = mechanism_.space == Space::planar;
    for (int i = is_planar ? 2 : 0; i < 3; ++i) {
      add(element,
          std::string("moment/") + kAxisNames[static_cast<std::size_t>(i)],
          QuantityKind::moment,
          component(i));
    }
    for (int i = 0; i < (is_planar ? 2 : 3); ++i) {
      add(element,
          std::string("force/") + kAxisNames[static_cast<std::size_t>(i)],
          QuantityKind::force,
          component(3 + i));
    }
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
        [i](const CaseDynamics& one) { return std::optional(one.reduced.inertia(i, i)); });
    add(name,
        turns ? "bias_moment" : "bias_force",
        turns ? QuantityKind::moment : QuantityKind::force,
        [i](const CaseDynamics& one) { return std::optional(one.reduced.bias[i]); });
  }

  const FileUnits& units_;
  const Mechanism& mechanism_;
  const MotionPlan& plan_;
  std::vector<MotionReading> readings_;
};

}  // namespace

std::vector<MotionReading> dynamic_readings(const FileUnits& units,
                                            const Mechanism& mechanism,
                                            const MotionPlan& plan) {
  return DynamicReadings(units, mechanism, plan).run();
}

}  // namespace kinestat
