#include "draw/train/scheme_train.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "draw/linkage/file_numbers.hpp"
#include "draw/linkage/linkage_parts.hpp"
#include "draw/symbols.hpp"
#include "mechanism/gears/gear_train.hpp"

namespace kinestat {

namespace {

class TrainFinder {
 public:
  TrainFinder(const Analysis& analysis, const GearSchemeOptions& options)
      : analysis_(analysis), topology_(analysis.mechanism.topology), options_(options) {}

  std::optional<SchemeTrain> find() {
    if (!is_half_section(analysis_.description)) {
      return std::nullopt;
    }
    if (analysis_.description.gears) {
      add_written_gears();
    } else {
      add_drawn_gears();
    }
    if (result_.meshes.empty()) {
      return std::nullopt;
    }
    const auto [low, high] = std::ranges::minmax_element(result_.meshes, {}, &SchemeMesh::at);
    result_.has_places = high->at > low->at;
    add_elements();
    return std::move(result_);
  }

 private:
  int body_named(std::string_view name) const {
    const auto at = std::ranges::find(topology_.bodies, name, &BodyTopology::name);
    return at == topology_.bodies.end() ? 0 : static_cast<int>(at - topology_.bodies.begin());
  }

  // The body to which a planet's pin belongs.
  int carrier_of(int planet) const {
    for (const CouplingTopology& coupling : topology_.couplings) {
      const bool is_pin = coupling.type == CouplingType::revolute;
      if (is_pin && (coupling.tail.value == planet || coupling.head.value == planet)) {
        return coupling.tail.value == planet ? coupling.head.value : coupling.tail.value;
      }
    }
    return 0;
  }

  void add_written_gears() {
    const MechanismDescription& description = analysis_.description;
    const GearsDescription& gears = *description.gears;
    const FileNumbers numbers(description);
    const GearTrain train = find_gear_train(description);
    for (const GearAxis& axis : train.axes) {
      const int body = body_named(axis.bodies.front());
      result_.planets.push_back({.body = body, .carrier = carrier_of(body)});
    }
    for (std::size_t i = 0; i < gears.members.size(); ++i) {
      const GearMember& member = gears.members[i];
      const double teeth = numbers.number(member.teeth, QuantityKind::dimensionless).value_or(1.0);
      result_.wheels.push_back({.name = fmt::format("{} {}", member.name.text, short_number(teeth)),
                                .body = body_named(member.body.text),
                                .radius = teeth / 2,
                                .is_ring = member.internal,
                                .planet = train.axis_of[i]});
    }
    const auto module_of = [&](const MeshDescription& mesh) {
      const std::optional<Value>& value = mesh.module ? mesh.module : gears.module;
      return value ? numbers.number(*value, QuantityKind::length).value_or(1.0) : 1.0;
    };
    for (std::size_t m = 0; m < gears.meshes.size(); ++m) {
      const MeshDescription& mesh = gears.meshes[m];
      const double at =
          mesh.at ? numbers.number(*mesh.at, QuantityKind::length).value_or(0.0) : 0.0;
      result_.meshes.push_back({.first = train.first[m], .second = train.second[m], .at = at});
      for (const int wheel : {train.first[m], train.second[m]}) {
        const GearMember& member = gears.members[static_cast<std::size_t>(wheel)];
        const double teeth =
            numbers.number(member.teeth, QuantityKind::dimensionless).value_or(1.0);
        result_.wheels[static_cast<std::size_t>(wheel)].radius = module_of(mesh) * teeth / 2;
      }
    }
  }

  // Gears that are couplings between pitch points and hinges.
  void add_drawn_gears() {
    std::vector<MeshWheels> meshes;
    for (MeshWheels& mesh : find_mesh_wheels(analysis_.description, analysis_.mechanism)) {
      const bool is_gear = topology_.coupling(mesh.coupling).type == CouplingType::gear;
      const bool is_parallel =
          mesh.tail && mesh.head && mesh.tail->axis.cross(mesh.head->axis).norm() <= kParallelAxes;
      if (is_gear && is_parallel) {
        meshes.push_back(std::move(mesh));
      }
    }
    if (meshes.empty()) {
      return;
    }
    const Vec3 along = meshes.front().tail->axis;
    const Vec3 main = main_axis(meshes, along);
    for (const MeshWheels& mesh : meshes) {
      const Vec3 pitch =
          analysis_.mechanism.geometry.points[static_cast<std::size_t>(mesh.coupling.value)];
      const int first = wheel_index(*mesh.tail, main, along);
      const int second = wheel_index(*mesh.head, main, along);
      result_.meshes.push_back({.first = first, .second = second, .at = pitch.dot(along)});
    }
  }

  static double off_line(const Vec3& point, const Vec3& line, const Vec3& along) {
    return (point - line).cross(along).norm();
  }

  double near() const { return kDrawnTogether * analysis_.mechanism.geometry.length; }

  // About which most wheels turn; rings above all.
  Vec3 main_axis(const std::vector<MeshWheels>& meshes, const Vec3& along) const {
    Vec3 best = meshes.front().tail->centre;
    int most = -1;
    for (const MeshWheels& mesh : meshes) {
      for (const Wheel* wheel : {&*mesh.tail, &*mesh.head}) {
        int votes = 0;
        for (const MeshWheels& other : meshes) {
          for (const Wheel* voter : {&*other.tail, &*other.head}) {
            const bool is_on = off_line(voter->centre, wheel->centre, along) <= near();
            votes += is_on ? (voter->kind == WheelKind::ring ? 100 : 1) : 0;
          }
        }
        if (votes > most) {
          most = votes;
          best = wheel->centre;
        }
      }
    }
    return best;
  }

  // Of the wheel of that body and radius, which is added if it is new.
  int wheel_index(const Wheel& wheel, const Vec3& main, const Vec3& along) {
    const bool is_ring = wheel.kind == WheelKind::ring;
    for (std::size_t i = 0; i < result_.wheels.size(); ++i) {
      const SchemeWheel& known = result_.wheels[i];
      if (known.body == wheel.body.value && known.is_ring == is_ring &&
          std::abs(known.radius - wheel.radius) <= near()) {
        return static_cast<int>(i);
      }
    }
    int planet = -1;
    if (off_line(wheel.centre, main, along) > near()) {
      planet = planet_index(wheel.body.value);
    }
    result_.wheels.push_back({.name = topology_.body(wheel.body).name,
                              .body = wheel.body.value,
                              .radius = wheel.radius,
                              .is_ring = is_ring,
                              .planet = planet});
    return static_cast<int>(result_.wheels.size()) - 1;
  }

  int planet_index(int body) {
    const auto at = std::ranges::find(result_.planets, body, &SchemePlanet::body);
    if (at != result_.planets.end()) {
      return static_cast<int>(at - result_.planets.begin());
    }
    result_.planets.push_back({.body = body, .carrier = carrier_of(body)});
    return static_cast<int>(result_.planets.size()) - 1;
  }

  void add_elements() {
    for (std::size_t i = 0; i < topology_.actuators.size(); ++i) {
      const ActuatorTopology& actuator = topology_.actuators[i];
      const FreedomLabel& freedom = topology_.freedoms[static_cast<std::size_t>(actuator.freedom)];
      const CouplingTopology& coupling = topology_.coupling(freedom.coupling);
      if (!freedom.is_rotation) {
        continue;
      }
      const bool has_ground = coupling.tail.value == 0 || coupling.head.value == 0;
      SchemeElement element{
          .name = actuator.name,
          .kind = kind_of(static_cast<int>(i), coupling.type, has_ground),
          .body = coupling.tail.value == 0 ? coupling.head.value : coupling.tail.value,
          .other = has_ground ? 0 : coupling.head.value,
          .is_engaged = is_engaged(static_cast<int>(i), actuator)};
      result_.elements.push_back(std::move(element));
    }
  }

  SchemeElementKind kind_of(int actuator, CouplingType type, bool has_ground) const {
    if (!has_ground) {
      return SchemeElementKind::clutch;
    }
    const auto holds = [actuator](const std::vector<int>& list) {
      return std::ranges::find(list, actuator) != list.end();
    };
    const auto is_of_any_case = [&](std::vector<int> Case::*list) {
      return std::ranges::any_of(analysis_.cases,
                                 [&](const CaseAnalysis& one) { return holds(one.which.*list); });
    };
    if (type == CouplingType::brake) {
      return SchemeElementKind::brake;
    }
    // Another case may drive what this one holds, or is driven by.
    if (const CaseAnalysis* const shown = shown_case()) {
      if (is_held(*shown, actuator)) {
        return SchemeElementKind::brake;
      }
      if (holds(shown->which.inputs)) {
        return SchemeElementKind::input;
      }
      if (holds(shown->which.outputs)) {
        return SchemeElementKind::output;
      }
    }
    if (is_of_any_case(&Case::inputs)) {
      return SchemeElementKind::input;
    }
    if (is_of_any_case(&Case::outputs)) {
      return SchemeElementKind::output;
    }
    return is_ever_held(actuator) ? SchemeElementKind::brake : SchemeElementKind::input;
  }

  bool is_held(const CaseAnalysis& one, int actuator) const {
    const int freedom = topology_.actuators[static_cast<std::size_t>(actuator)].freedom;
    return std::ranges::any_of(one.which.motions, [freedom](const Primary& primary) {
      return primary.index == freedom && primary.value == 0.0;
    });
  }

  bool is_ever_held(int actuator) const {
    return std::ranges::any_of(analysis_.cases,
                               [&](const CaseAnalysis& one) { return is_held(one, actuator); });
  }

  // Null where no case is shown.
  const CaseAnalysis* shown_case() const {
    return options_.which && *options_.which < analysis_.cases.size()
               ? &analysis_.cases[*options_.which]
               : nullptr;
  }

  // Held by the case, or, where its rest follows from others, at rest and not said to be open; an
  // input drives.
  bool is_engaged(int actuator, const ActuatorTopology& of) const {
    if (shown_case() == nullptr) {
      return false;
    }
    const CaseAnalysis& one = *shown_case();
    if (std::ranges::find(one.which.inputs, actuator) != one.which.inputs.end() ||
        std::ranges::find(one.which.outputs, actuator) != one.which.outputs.end() ||
        is_held(one, actuator)) {
      return true;
    }
    const bool is_open = std::ranges::any_of(one.which.actions, [&](const Primary& primary) {
      return primary.index == of.action && primary.value == 0.0;
    });
    const bool is_solved = one.motion && !one.motion->rates.empty();
    return !is_open && is_solved && one.which.asks_actions &&
           one.motion->rates[static_cast<std::size_t>(of.freedom)] == 0.0;
  }

  const Analysis& analysis_;
  const Topology& topology_;
  const GearSchemeOptions& options_;
  SchemeTrain result_;
};

}  // namespace

bool is_half_section(const MechanismDescription& description) {
  if (!description.gears) {
    return true;
  }
  const GearTrain train = find_gear_train(description);
  return std::ranges::all_of(
      train.axes, [](const GearAxis& axis) { return axis.bodies.size() == 1 && axis.about < 0; });
}

std::optional<SchemeTrain> find_scheme_train(const Analysis& analysis,
                                             const GearSchemeOptions& options) {
  return TrainFinder(analysis, options).find();
}

}  // namespace kinestat
