#include "description/gear_expansion.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

namespace kinestat {

namespace {

Value usual_pressure_angle(SourceRange where) {
  return {.expression = std::get<Expression>(parse_expression(kUsualPressureAngle)),
          .where = where};
}

class GearExpansion {
 public:
  explicit GearExpansion(MechanismDescription& description)
      : description_(description), gears_(*description.gears) {
    bodies_.insert(description.ground.text);
    for (const BodyDescription& body : description.bodies) {
      bodies_.insert(body.name.text);
    }
    for (const CouplingDescription& coupling : description.couplings) {
      taken_.insert(coupling.name.text);
    }
    for (const ActuatorDescription& actuator : description.actuators) {
      taken_.insert(actuator.name.text);
    }
  }

  void run() {
    const bool is_good = std::ranges::all_of(
        gears_.meshes, [&](const MeshDescription& mesh) { return takes_name(mesh); });
    if (!is_good) {
      return;
    }
    if (description_.space == Space::planar) {
      place_on_axes();
    }
    for (std::size_t i = 0; i < gears_.meshes.size(); ++i) {
      add_mesh(static_cast<int>(i));
    }
  }

 private:
  // Whether its gears and bodies are there and its name was free, which is then taken.
  bool takes_name(const MeshDescription& mesh) {
    const GearMember* first = find_member(gears_, mesh.first);
    const GearMember* second = find_member(gears_, mesh.second);
    return first != nullptr && second != nullptr && bodies_.contains(first->body.text) &&
           bodies_.contains(second->body.text) && first->body.text != second->body.text &&
           taken_.insert(mesh.name.text).second;
  }

  // Puts couplings that have no place on the main axis, which is a point in a planar mechanism.
  void place_on_axes() {
    std::set<std::string> on_axis;
    for (const GearMember& member : gears_.members) {
      on_axis.insert(member.body.text);
    }
    for (const MeshDescription& mesh : gears_.meshes) {
      on_axis.insert(carrier_of(mesh, description_));
    }
    on_axis.erase(description_.ground.text);
    for (const CouplingDescription& coupling : description_.couplings) {
      add_clutched(coupling, on_axis);
    }
    on_axis.merge(lone_shafts(on_axis));
    for (CouplingDescription& coupling : description_.couplings) {
      if (turns_alone(coupling) &&
          (on_axis.contains(coupling.tail.text) || on_axis.contains(coupling.head.text))) {
        coupling.at = CouplingPoint{
            .point = {}, .of_bodies = {}, .along_axis = {}, .where = coupling.name.where};
      }
    }
  }

  // A coupling that only lets its bodies turn, and says nothing of where.
  static bool turns_alone(const CouplingDescription& coupling) {
    return !coupling.at && (coupling.type == CouplingType::revolute ||
                            coupling.type == CouplingType::brake || joins_one_axis(coupling.type));
  }

  // Bodies that nothing puts on an axis and that do nothing but turn: in the ground, in what is on
  // an axis, or in one another. They turn about the main axis.
  std::set<std::string> lone_shafts(const std::set<std::string>& on_axis) const {
    std::set<std::string> held;
    for (const CouplingDescription& coupling : description_.couplings) {
      held.insert({coupling.tail.text, coupling.head.text});
    }
    std::set<std::string> lone;
    for (const BodyDescription& body : description_.bodies) {
      if (!on_axis.contains(body.name.text) && held.contains(body.name.text) &&
          !is_in_cable(body.name.text)) {
        lone.insert(body.name.text);
      }
    }
    const auto is_shaft = [&](const std::string& body) {
      return body == description_.ground.text || on_axis.contains(body) || lone.contains(body);
    };
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (const CouplingDescription& coupling : description_.couplings) {
        const auto& [tail, head] = std::tie(coupling.tail.text, coupling.head.text);
        if (!turns_alone(coupling) || !is_shaft(tail) || !is_shaft(head)) {
          goes_on = lone.erase(tail) + lone.erase(head) > 0 || goes_on;
        }
      }
    }
    return lone;
  }

  bool is_in_cable(const std::string& body) const {
    return std::ranges::any_of(description_.cables, [&](const CableDescription& cable) {
      return std::ranges::find(cable.over, body, [](const CableStation& one) {
               return one.body.text;
             }) != cable.over.end();
    });
  }

  // A shaft without gears turns about the axis of what a clutch joins it to, and so on along a row
  // of clutches.
  void add_clutched(const CouplingDescription& coupling, std::set<std::string>& on_axis) const {
    const std::string& tail = coupling.tail.text;
    const std::string& head = coupling.head.text;
    const std::string& ground = description_.ground.text;
    if (!joins_one_axis(coupling.type) || tail == ground || head == ground ||
        on_axis.contains(tail) == on_axis.contains(head)) {
      return;
    }
    on_axis.insert({tail, head});
    for (const CouplingDescription& other : description_.couplings) {
      add_clutched(other, on_axis);
    }
  }

  void add_mesh(int index) {
    const MeshDescription& mesh = gears_.meshes[static_cast<std::size_t>(index)];
    const GearMember& first = *find_member(gears_, mesh.first);
    const GearMember& second = *find_member(gears_, mesh.second);
    CouplingDescription coupling;
    coupling.name = mesh.name;
    coupling.type = CouplingType::gear;
    coupling.tail = {.text = first.body.text, .where = mesh.first.where};
    coupling.head = {.text = second.body.text, .where = mesh.second.where};
    coupling.axis =
        AxisDescription{.keyword = 'z', .sign = 1.0, .components = {}, .where = mesh.name.where};
    const bool has_own_angle = mesh.pressure_angle || mesh.normal_pressure_angle;
    coupling.pressure_angle = has_own_angle ? mesh.pressure_angle : gears_.pressure_angle;
    coupling.normal_pressure_angle =
        has_own_angle ? mesh.normal_pressure_angle : gears_.normal_pressure_angle;
    if (!coupling.pressure_angle && !coupling.normal_pressure_angle) {
      coupling.pressure_angle = usual_pressure_angle(mesh.name.where);
    }
    coupling.helix_angle = mesh.helix_angle ? mesh.helix_angle : gears_.helix_angle;
    coupling.internal = first.internal || second.internal;
    coupling.mesh = index;
    description_.couplings.push_back(std::move(coupling));
  }

  MechanismDescription& description_;
  const GearsDescription& gears_;
  std::set<std::string> bodies_;
  std::set<std::string> taken_;  ///< names of couplings, actuators and meshes
};

}  // namespace

void expand_gears(MechanismDescription& description) {
  if (description.gears && description.has_mechanism()) {
    GearExpansion(description).run();
  }
}

bool has_all_meshes(const MechanismDescription& description) {
  const auto count = std::ranges::count_if(description.couplings, &CouplingDescription::is_mesh);
  return !description.gears || static_cast<std::size_t>(count) == description.gears->meshes.size();
}

MechanismDescription without_meshes(const MechanismDescription& description) {
  MechanismDescription result = description;
  std::erase_if(result.couplings, [](const CouplingDescription& one) { return one.is_mesh(); });
  return result;
}

const GearMember* find_member(const GearsDescription& gears, const Name& name) {
  const auto at = std::ranges::find(
      gears.members, name.text, [](const GearMember& one) { return one.name.text; });
  return at == gears.members.end() ? nullptr : &*at;
}

const std::string& carrier_of(const MeshDescription& mesh,
                              const MechanismDescription& description) {
  return mesh.carrier ? mesh.carrier->text : description.ground.text;
}

}  // namespace kinestat
