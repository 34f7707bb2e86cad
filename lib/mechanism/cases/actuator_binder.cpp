#include "mechanism/cases/actuator_binder.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

std::vector<std::string> coupling_names(const MechanismDescription& description) {
  std::vector<std::string> names;
  for (const CouplingDescription& coupling : description.couplings) {
    names.push_back(coupling.name.text);
  }
  return names;
}

// Whether a name may be one of those that the sections `gears` and `cables` add.
bool is_generated(const MechanismDescription& description, const std::string& name) {
  const auto is_mesh = [&](const MeshDescription& mesh) { return mesh.name.text == name; };
  const auto is_of_cable = [&](const CableDescription& cable) {
    return name.starts_with(cable.name.text + "_");
  };
  return (description.gears && std::ranges::any_of(description.gears->meshes, is_mesh)) ||
         std::ranges::any_of(description.cables, is_of_cable);
}

}  // namespace

ActuatorBinder::ActuatorBinder(const MechanismDescription& description,
                               Mechanism& result,
                               Diagnostics& found)
    : description_(description),
      topology_(result.topology),
      geometry_(result.geometry),
      found_(found) {
  const std::vector<std::string> names = coupling_names(description);
  const std::set<std::string> declared(names.begin(), names.end());
  for (const ActuatorDescription& actuator : description.actuators) {
    if (!declared.contains(actuator.coupling.text) &&
        !is_generated(description, actuator.coupling.text)) {
      refuse(actuator);
      continue;
    }
    pending_[actuator.coupling.text].push_back(
        {.name = actuator.name.text,
         .freedom = actuator.freedom ? actuator.freedom->text : std::string(),
         .where = actuator.freedom ? actuator.freedom->where : actuator.name.where});
  }
}

void ActuatorBinder::refuse(const ActuatorDescription& actuator) {
  const auto hint = [&] {
    const std::vector<std::string> names = coupling_names(description_);
    const std::string guess = did_you_mean(actuator.coupling.text, names);
    return fmt::format(
        "declared couplings are {}{}{}", plain_list(names), guess.empty() ? "" : "; ", guess);
  };
  found_.error("E0313",
               actuator.coupling.where,
               fmt::format("actuator '{}' drives coupling '{}', which is not declared",
                           actuator.name.text,
                           printable(actuator.coupling.text)),
               found_.is_hint_worth_it() ? hint() : "");
}

// A clutch or brake is an actuator of its own name.
std::vector<ActuatorBinder::Pending> ActuatorBinder::take(const CouplingDescription& coupling) {
  std::vector<Pending> pending;
  if (kind_of(coupling.type).engages) {
    pending.push_back({.name = coupling.name.text, .freedom = {}, .where = coupling.name.where});
  }
  const auto declared = pending_.find(coupling.name.text);
  if (declared != pending_.end()) {
    pending.insert(pending.end(), declared->second.begin(), declared->second.end());
  }
  return pending;
}

void ActuatorBinder::add(CouplingId id,
                         const CouplingDescription& coupling,
                         const CouplingScrews& screws,
                         const Vec3& at) {
  for (const Pending& actuator : take(coupling)) {
    const std::optional<std::size_t> which = choose_freedom(actuator, coupling, screws);
    if (which) {
      append(id, actuator, *which, internal_action<double>(screws.freedoms[*which], at));
    }
  }
}

std::optional<std::size_t> ActuatorBinder::choose_freedom(const Pending& actuator,
                                                          const CouplingDescription& coupling,
                                                          const CouplingScrews& screws) {
  std::vector<std::string> names;
  for (const NamedTwist& freedom : screws.freedoms) {
    names.push_back(freedom.name);
  }
  if (actuator.freedom.empty() && names.size() == 1) {
    return 0;
  }
  const auto at = std::ranges::find(names, actuator.freedom);
  if (at != names.end()) {
    return static_cast<std::size_t>(at - names.begin());
  }
  const std::string message =
      names.empty() ? fmt::format("coupling '{}' has no freedom to drive", coupling.name.text)
      : actuator.freedom.empty()
          ? fmt::format("coupling '{}' has several freedoms", coupling.name.text)
          : fmt::format("coupling '{}' has no freedom '{}'", coupling.name.text, actuator.freedom);
  found_.error("E0313",
               actuator.where,
               message,
               names.empty() ? "choose another coupling"
               : actuator.freedom.empty()
                   ? fmt::format("add 'freedom:' with one of {}", plain_list(names))
                   : fmt::format("write freedom: {}", fmt::join(names, " or ")));
  return std::nullopt;
}

void ActuatorBinder::append(CouplingId id,
                            const Pending& actuator,
                            std::size_t freedom,
                            const NamedWrench& action) {
  CouplingTopology& coupling = topology_.couplings.back();
  const int index = static_cast<int>(topology_.actuators.size());
  topology_.actuators.push_back({.name = actuator.name,
                                 .freedom = coupling.first_freedom + static_cast<int>(freedom),
                                 .action = topology_.action_count(),
                                 .where = actuator.where});
  topology_.actions.push_back(
      {.coupling = id, .name = actuator.name, .is_couple = action.is_couple, .actuator = index});
  geometry_.actions.push_back(action.screw);
  ++coupling.action_count;
}

}  // namespace kinestat
