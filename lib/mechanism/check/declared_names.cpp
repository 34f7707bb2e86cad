#include "mechanism/check/declared_names.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

DriveKind drive_kind_of(const CouplingDescription& coupling, const std::optional<Name>& freedom) {
  using enum CouplingType;
  if (freedom && !freedom->text.empty()) {
    const char first = freedom->text.front();
    return first == 'v' ? DriveKind::sliding
                        : (first == 'w' ? DriveKind::turning : DriveKind::unknown);
  }
  if (takes(kind_of(coupling.type), CouplingKey::sliding_axis)) {
    return DriveKind::sliding;
  }
  if (coupling.type == screws) {
    const bool is_one = coupling.freedoms.size() == 1;
    return !is_one                                               ? DriveKind::unknown
           : coupling.freedoms[0].kind == ScrewWord::translation ? DriveKind::sliding
                                                                 : DriveKind::turning;
  }
  return DriveKind::turning;
}

// Builds the tables, in which couplings and actuators share one name space.
class NameCollector {
 public:
  NameCollector(const MechanismDescription& description, Diagnostics& found)
      : description_(description), found_(found) {}

  DeclaredNames collect() {
    add_bodies();
    add_couplings();
    add_actuators();
    add_gears();
    for (const CableDescription& cable : description_.cables) {
      add_cable(cable);
    }
    add_labels();
    for (const ParameterDescription& parameter : description_.parameters) {
      names_.parameters.add(parameter.name);
    }
    return std::move(names_);
  }

 private:
  void add_bodies() {
    if (description_.has_mechanism()) {
      names_.bodies.reserve(1 + description_.bodies.size());
      names_.bodies.add(description_.ground);
    }
    for (const BodyDescription& body : description_.bodies) {
      if (!body.is_virtual) {
        names_.bodies.add(body.name);
      }
    }
  }

  void add_couplings() {
    for (const CouplingDescription& coupling : description_.couplings) {
      by_name_.emplace(coupling.name.text, &coupling);
      if (coupling.part != nullptr || coupling.is_mesh()) {
        continue;  // its cable or the section gears adds its name
      }
      names_.couplings.add(coupling.name);
      taken_.emplace(coupling.name.text, coupling.name.where);
      if (has_teeth(coupling.type)) {
        names_.meshes.add(coupling.name);
      }
      if (kind_of(coupling.type).engages) {
        add_actuator(coupling.name, DriveKind::turning);
      }
    }
  }

  void add_actuators() {
    for (const ActuatorDescription& actuator : description_.actuators) {
      const auto at = by_name_.find(actuator.coupling.text);
      add_actuator(
          actuator.name,
          at == by_name_.end() ? DriveKind::unknown : drive_kind_of(*at->second, actuator.freedom));
      taken_.emplace(actuator.name.text, actuator.name.where);
    }
  }

  void add_actuator(const Name& name, DriveKind kind) {
    if (!names_.actuators.add(name)) {
      names_.actuator_kinds.push_back(kind);
    }
  }

  void add_gears() {
    if (!description_.gears) {
      return;
    }
    for (const GearMember& member : description_.gears->members) {
      names_.members.add(member.name);
    }
    for (const MeshDescription& mesh : description_.gears->meshes) {
      names_.couplings.add(mesh.name);
      names_.meshes.add(mesh.name);
      const auto [at, is_new] = taken_.emplace(mesh.name.text, mesh.name.where);
      if (!is_new) {
        auto& problem = found_.error(
            "E0307",
            mesh.name.where,
            fmt::format("'{}' is already the name of a coupling or actuator", mesh.name.text),
            "give one of the two another name");
        problem.notes.push_back({at->second, "first declared here"});
      }
    }
  }

  void add_cable(const CableDescription& cable) {
    for (int i = 1; i <= segment_count(cable); ++i) {
      add_made_coupling(cable, segment_name(cable, i));
    }
    for (const VirtualLink& link : virtual_links(cable)) {
      add_made_coupling(cable, link.name);
      const int body = names_.bodies.find(link.name);
      if (body >= 0) {
        clash(cable, link.name, "a body", names_.bodies.where(body));
      }
      names_.bodies.add({.text = link.name, .where = cable.name.where});
    }
  }

  void add_made_coupling(const CableDescription& cable, const std::string& name) {
    names_.couplings.add({.text = name, .where = cable.name.where});
    const auto [at, is_new] = taken_.emplace(name, cable.name.where);
    if (!is_new) {
      clash(cable, name, "a coupling or actuator", at->second);
    }
  }

  void clash(const CableDescription& cable,
             const std::string& name,
             std::string_view other,
             SourceRange where) {
    auto& problem = found_.error(
        "E0307",
        cable.name.where,
        fmt::format(
            "cable '{}' makes '{}', which is already the name of {}", cable.name.text, name, other),
        "give one of the two another name");
    problem.notes.push_back({where, "first declared here"});
  }

  void add_labels() {
    for (const CaseDescription& one : description_.cases) {
      names_.cases.add(one.label);
      names_.states.add(one.label);
    }
    if (description_.shift) {
      for (const GearLabel& gear : description_.shift->names) {
        names_.states.add(gear.label);
      }
    }
  }

  const MechanismDescription& description_;
  Diagnostics& found_;
  DeclaredNames names_;
  std::map<std::string, SourceRange> taken_;  ///< couplings and actuators
  std::map<std::string, const CouplingDescription*> by_name_;
};

}  // namespace

std::optional<SourceRange> NameTable::add(const Name& name) {
  const auto [at, is_new] = entries_.emplace(
      name.text, Entry{.index = static_cast<int>(names_.size()), .where = name.where});
  if (!is_new) {
    return at->second.where;
  }
  names_.push_back(name.text);
  return std::nullopt;
}

int NameTable::find(std::string_view name) const {
  const auto at = entries_.find(name);
  return at == entries_.end() ? -1 : at->second.index;
}

SourceRange NameTable::where(int index) const {
  return entries_.find(names_[static_cast<std::size_t>(index)])->second.where;
}

bool NameTable::check(const Name& reference, std::string_view role, Diagnostics& found) const {
  if (contains(reference.text)) {
    return true;
  }
  found.error(code_,
              reference.where,
              fmt::format("{} {} '{}', which is not declared", role, one_, reference.text),
              hint(found.is_hint_worth_it() ? reference.text : std::string_view()));
  return false;
}

std::string NameTable::hint(std::string_view name) const {
  if (names_.empty()) {
    return fmt::format("the file declares no {}", many_);
  }
  const std::string guess = name.empty() ? std::string() : did_you_mean(name, names_);
  return fmt::format(
      "declared {} are {}{}{}", many_, plain_list(names_), guess.empty() ? "" : "; ", guess);
}

bool DeclaredNames::check_actuator(const Name& reference,
                                   std::string_view role,
                                   Diagnostics& found) const {
  if (!actuators.contains(reference.text) && bodies.contains(reference.text) &&
      !couplings.contains(reference.text)) {
    found.error("E0313",
                reference.where,
                fmt::format("{} '{}', which is a body and not an actuator", role, reference.text),
                fmt::format("name the actuator that drives it; {}", actuators.hint("")));
    return false;
  }
  if (actuators.contains(reference.text) || !couplings.contains(reference.text)) {
    return actuators.check(reference, role, found);
  }
  found.error("E0313",
              reference.where,
              fmt::format("{} '{}', which is a coupling and not an actuator", role, reference.text),
              fmt::format("declare one under 'actuators:', for example {}_drive: {{coupling: {}}}",
                          reference.text,
                          reference.text));
  return false;
}

DriveKind DeclaredNames::kind_of_actuator(std::string_view name) const {
  const int index = actuators.find(name);
  return index < 0 ? DriveKind::unknown : actuator_kinds[static_cast<std::size_t>(index)];
}

DeclaredNames declare_names(const MechanismDescription& description, Diagnostics& found) {
  return NameCollector(description, found).collect();
}

}  // namespace kinestat
