#include "draw/train/scheme_train.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "draw/linkage/file_numbers.hpp"
#include "draw/linkage/linkage_parts.hpp"
#include "draw/symbols.hpp"
#include "mechanism/gears/gear_layout.hpp"

namespace kinestat {

namespace {

// Which axes of the section `gears` are those of planets: a carrier that moves bears them, or one
// body on the ground runs in a ring about the axis from which it stands off, or meshes with such.
std::vector<bool> find_planets(const MechanismDescription& description, const GearTrain& train) {
  const GearsDescription& gears = *description.gears;
  std::vector<bool> is_planet(train.axes.size(), false);
  const auto can_be = [&](std::size_t a) { return train.axes[a].bodies.size() == 1; };
  const auto runs_in_ring = [&](const GearAxis& axis) {
    return std::ranges::any_of(axis.on_centre, [&](int mesh) {
      return gears.members[at(train.first[at(mesh)])].internal ||
             gears.members[at(train.second[at(mesh)])].internal;
    });
  };
  for (std::size_t a = 0; a < train.axes.size(); ++a) {
    const GearAxis& axis = train.axes[a];
    const bool has_own_ring = std::ranges::any_of(
        axis.members, [&](int member) { return gears.members[at(member)].internal; });
    is_planet[a] = axis.carrier != description.ground.text ||
                   (can_be(a) && !has_own_ring && runs_in_ring(axis));
  }
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (std::size_t m = 0; m < train.first.size(); ++m) {
      const int a = train.axis_of[at(train.first[m])];
      const int b = train.axis_of[at(train.second[m])];
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        if (from >= 0 && to >= 0 && is_planet[at(from)] && !is_planet[at(to)] && can_be(at(to)) &&
            train.axes[at(from)].about == train.axes[at(to)].about) {
          is_planet[at(to)] = true;
          goes_on = true;
        }
      }
    }
  }
  return is_planet;
}

class TrainFinder {
 public:
  TrainFinder(const Analysis& analysis, const GearSchemeOptions& options, bool is_half)
      : analysis_(analysis),
        topology_(analysis.mechanism.topology),
        options_(options),
        is_half_(is_half) {}

  std::optional<SchemeTrain> find() {
    if (!why_no_scheme_train(analysis_.description).empty()) {
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
    add_converters();
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
    axis_of_ = add_axes(train);
    for (std::size_t i = 0; i < gears.members.size(); ++i) {
      const GearMember& member = gears.members[i];
      const double teeth = numbers.number(member.teeth, QuantityKind::dimensionless).value_or(1.0);
      result_.wheels.push_back({.name = fmt::format("{} {}", member.name.text, short_number(teeth)),
                                .body = body_named(member.body.text),
                                .radius = teeth / 2,
                                .is_ring = member.internal,
                                .planet = planet_of_[at(train.axis_of[i] + 1)],
                                .axis = axis_of_[at(train.axis_of[i] + 1)]});
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
    if (result_.axis_count > 1) {
      use_working_radii(numbers, train);
      add_bearings();
    }
  }

  // Planets of the train, and the axes about which anything else turns.
  std::vector<int> add_axes(const GearTrain& train) {
    const std::vector<bool> is_planet = is_half_ ? std::vector<bool>(train.axes.size(), true)
                                                 : find_planets(analysis_.description, train);
    std::vector<int> axis_of = {0};
    planet_of_ = {-1};
    for (std::size_t a = 0; a < train.axes.size(); ++a) {
      axis_of.push_back(is_planet[a] ? -1 : result_.axis_count++);
      planet_of_.push_back(-1);
    }
    for (std::size_t a = 0; a < train.axes.size(); ++a) {
      if (is_planet[a]) {
        const int body = body_named(train.axes[a].bodies.front());
        const int axis = axis_of[at(train.axes[a].about + 1)];
        planet_of_[a + 1] = static_cast<int>(result_.planets.size());
        axis_of[a + 1] = axis;
        result_.planets.push_back({.body = body, .carrier = carrier_of(body), .axis = axis});
      }
    }
    for (std::size_t b = 1; b < topology_.bodies.size(); ++b) {
      const int axis = train.axis_on(topology_.bodies[b].name);
      axis_of_body_[static_cast<int>(b)] = axis_of[at(axis + 1)];
    }
    return axis_of;
  }

  // Those at which the gears of each mesh work, whose sum is the distance of their axes.
  void use_working_radii(const FileNumbers& file, const GearTrain& train) {
    const GearsDescription& gears = *analysis_.description.gears;
    GearNumbers numbers;
    const auto length = [&](const std::optional<Value>& value) {
      return value ? file.number(*value, QuantityKind::length) : std::nullopt;
    };
    for (const GearMember& member : gears.members) {
      const double teeth = file.number(member.teeth, QuantityKind::dimensionless).value_or(1.0);
      numbers.teeth.push_back(member.internal ? -teeth : teeth);
    }
    for (const MeshDescription& mesh : gears.meshes) {
      numbers.module.push_back(length(mesh.module ? mesh.module : gears.module));
      numbers.at.push_back(length(mesh.at).value_or(0.0));
    }
    for (const GearAxis& axis : train.axes) {
      numbers.distance.push_back(axis.distance == nullptr
                                     ? std::nullopt
                                     : file.number(*axis.distance, QuantityKind::length));
    }
    const std::optional<GearLayout> layout = find_layout(train, numbers);
    if (!layout) {
      return;
    }
    for (std::size_t m = 0; m < gears.meshes.size(); ++m) {
      const double sum = numbers.teeth[at(train.first[m])] + numbers.teeth[at(train.second[m])];
      for (const int wheel : {train.first[m], train.second[m]}) {
        result_.wheels[at(wheel)].radius =
            std::abs(layout->meshes[m].distance * numbers.teeth[at(wheel)] / sum);
      }
    }
  }

  void add_bearings() {
    for (const CouplingTopology& coupling : topology_.couplings) {
      const int first = coupling.tail.value;
      const int second = coupling.head.value;
      const bool is_of_planet = std::ranges::any_of(result_.planets, [&](const SchemePlanet& one) {
        return one.body == first || one.body == second;
      });
      if (coupling.type == CouplingType::revolute && first > 0 && second > 0 && !is_of_planet) {
        result_.bearings.push_back({.first = first, .second = second});
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
      if (const auto axis = axis_of_body_.find(element.body); axis != axis_of_body_.end()) {
        element.axis = axis->second;
      }
      result_.elements.push_back(std::move(element));
    }
  }

  // From pump to turbine; what the stator bears is not drawn.
  void add_converters() {
    for (const CouplingTopology& coupling : topology_.couplings) {
      if (coupling.type != CouplingType::torque_converter || coupling.tail.value == 0) {
        continue;
      }
      SchemeElement element{.name = coupling.name,
                            .kind = SchemeElementKind::clutch,
                            .body = coupling.tail.value,
                            .other = coupling.head.value,
                            .is_fluid = true};
      if (const auto axis = axis_of_body_.find(element.body); axis != axis_of_body_.end()) {
        element.axis = axis->second;
      }
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
  bool is_half_;
  SchemeTrain result_;
  std::vector<int> axis_of_;         // of each axis of the section `gears`, the main axis first
  std::vector<int> planet_of_;       // likewise, -1 for that of a shaft
  std::map<int, int> axis_of_body_;  // empty without that section
};

}  // namespace

std::string why_no_scheme_train(const MechanismDescription& description) {
  if (!description.gears) {
    return "";
  }
  const GearTrain train = find_gear_train(description);
  const std::vector<bool> is_planet = find_planets(description, train);
  for (std::size_t a = 0; a < train.axes.size(); ++a) {
    const GearAxis& axis = train.axes[a];
    if (is_planet[a] && axis.bodies.size() > 1) {
      return fmt::format("the planets '{}' turn about one axis, of which a section shows one",
                         fmt::join(axis.bodies, "', '"));
    }
    if (is_planet[a] && axis.about >= 0 && is_planet[at(axis.about)]) {
      return fmt::format("planet '{}' orbits the axis of another planet, which no section shows",
                         axis.bodies.front());
    }
  }
  for (std::size_t m = 0; m < train.first.size(); ++m) {
    const int a = train.axis_of[at(train.first[m])];
    const int b = train.axis_of[at(train.second[m])];
    const auto place = [&](int axis) {
      return axis >= 0 && is_planet[at(axis)] ? train.axes[at(axis)].about : axis;
    };
    const bool has_ring = description.gears->members[at(train.first[m])].internal ||
                          description.gears->members[at(train.second[m])].internal;
    const bool has_planet = (a >= 0 && is_planet[at(a)]) || (b >= 0 && is_planet[at(b)]);
    if (place(a) != place(b) && (has_ring || has_planet)) {
      return fmt::format(
          "mesh '{}' joins a {} to a gear about another axis, which no section shows",
          description.gears->meshes[m].name.text,
          has_planet ? "planet" : "ring");
    }
  }
  return "";
}

std::optional<SchemeTrain> find_scheme_train(const Analysis& analysis,
                                             const GearSchemeOptions& options) {
  return TrainFinder(analysis, options, false).find();
}

std::optional<SchemeTrain> find_half_section(const Analysis& analysis,
                                             const GearSchemeOptions& options) {
  const auto is_alone = [](const GearAxis& axis) {
    return axis.bodies.size() == 1 && axis.about < 0;
  };
  if (analysis.description.gears &&
      !std::ranges::all_of(find_gear_train(analysis.description).axes, is_alone)) {
    return std::nullopt;
  }
  std::optional<SchemeTrain> train = TrainFinder(analysis, options, true).find();
  const auto is_beside = [&](const SchemeElement& element) {
    return std::ranges::any_of(train->planets, [&](const SchemePlanet& planet) {
      return planet.body == element.body || planet.body == element.other;
    });
  };
  const bool is_right = train && std::ranges::none_of(train->elements, is_beside);
  return is_right ? train : std::nullopt;
}

}  // namespace kinestat
