#include "mechanism/internal/structure_binder.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/text.hpp"
#include "mechanism/internal/coupling_binder.hpp"
#include "mechanism/internal/reference_points.hpp"

namespace kinestat {

namespace {

template <class Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) {
    names.push_back(item.name);
  }
  return names;
}

// An actuator that waits for its freedom and action to be numbered.
struct PendingActuator {
  std::string name;
  std::string freedom;
  SourceRange where;
};

// A coupling on its way from the description to its screws.
struct Joint {
  const CouplingDescription* description = nullptr;
  BodyId tail;
  BodyId head;
  CouplingGeometry geometry;  ///< in the world
};

class StructureBinder {
 public:
  StructureBinder(const MechanismDescription& description,
                  Space constraints,
                  Evaluator& evaluator,
                  Diagnostics& found,
                  Mechanism& result)
      : description_(description),
        constraints_(constraints),
        evaluator_(evaluator),
        found_(found),
        topology_(result.topology),
        geometry_(result.geometry) {}

  void run() {
    bind_bodies();
    for (const CouplingDescription& coupling : description_.couplings) {
      declare(coupling.name);
    }
    for (const ActuatorDescription& actuator : description_.actuators) {
      declare(actuator.name);
      attach(actuator);
    }
    std::vector<Joint> joints;
    for (const CouplingDescription& coupling : description_.couplings) {
      if (const std::optional<Joint> joint = bind_joint(coupling)) {
        joints.push_back(*joint);
      }
    }
    place(joints);
    for (const Joint& joint : joints) {
      add_coupling(joint);
    }
    geometry_.references = bind_reference_points(description_, topology_, geometry_, evaluator_);
  }

 private:
  void bind_bodies() {
    add_body(description_.ground);
    for (const BodyDescription& body : description_.bodies) {
      if (body.name.text == description_.ground.text) {
        continue;  // the ground may be listed, to give it attributes
      }
      if (body_ids_.contains(body.name.text)) {
        auto& problem = found_.error("E0307",
                                     body.name.where,
                                     fmt::format("body '{}' is declared twice", body.name.text),
                                     "give one of the two another name");
        problem.notes.push_back(
            {topology_.body(body_ids_.at(body.name.text)).where, "first declared here"});
        continue;
      }
      add_body(body.name);
    }
  }

  void add_body(const Name& name) {
    body_ids_.emplace(name.text, BodyId{topology_.body_count()});
    topology_.bodies.push_back({.name = name.text, .where = name.where});
  }

  // Couplings and actuators share one name space.
  void declare(const Name& name) {
    const auto [at, is_new] = declared_.emplace(name.text, name.where);
    if (!is_new) {
      auto& problem =
          found_.error("E0307",
                       name.where,
                       fmt::format("'{}' is already the name of a coupling or actuator", name.text),
                       "give one of the two another name");
      problem.notes.push_back({at->second, "first declared here"});
    }
  }

  void attach(const ActuatorDescription& actuator) {
    const auto at = std::ranges::find(description_.couplings,
                                      actuator.coupling.text,
                                      [](const CouplingDescription& c) { return c.name.text; });
    if (at == description_.couplings.end()) {
      std::vector<std::string> names;
      for (const CouplingDescription& coupling : description_.couplings) {
        names.push_back(coupling.name.text);
      }
      unknown("E0313",
              actuator.coupling,
              fmt::format("actuator '{}' drives coupling '{}', which is not declared",
                          actuator.name.text,
                          actuator.coupling.text),
              "couplings",
              names);
      return;
    }
    pending_[actuator.coupling.text].push_back(
        {.name = actuator.name.text,
         .freedom = actuator.freedom ? actuator.freedom->text : std::string(),
         .where = actuator.freedom ? actuator.freedom->where : actuator.name.where});
  }

  void unknown(std::string_view code,
               const Name& name,
               std::string message,
               std::string_view kind,
               const std::vector<std::string>& declared) {
    const std::string guess = did_you_mean(name.text, declared);
    found_.error(code,
                 name.where,
                 std::move(message),
                 fmt::format("declared {} are {}{}{}",
                             kind,
                             plain_list(declared),
                             guess.empty() ? "" : "; ",
                             guess));
  }

  std::optional<BodyId> find_body(const CouplingDescription& coupling, const Name& name) {
    const auto at = body_ids_.find(name.text);
    if (at != body_ids_.end()) {
      return at->second;
    }
    unknown(
        "E0312",
        name,
        fmt::format(
            "coupling '{}' joins body '{}', which is not declared", coupling.name.text, name.text),
        "bodies",
        names_of(topology_.bodies));
    return std::nullopt;
  }

  // What a coupling joins and where it is; empty if an error was added.
  std::optional<Joint> bind_joint(const CouplingDescription& coupling) {
    const std::optional<BodyId> tail = find_body(coupling, coupling.tail);
    const std::optional<BodyId> head = find_body(coupling, coupling.head);
    if (tail && head && *tail == *head) {
      found_.error(
          "E0312",
          coupling.head.where,
          fmt::format(
              "coupling '{}' joins body '{}' to itself", coupling.name.text, coupling.head.text),
          "name two different bodies");
      return std::nullopt;
    }
    const auto geometry = bind_geometry(coupling, description_.space, evaluator_, found_);
    if (!tail || !head || !geometry) {
      return std::nullopt;
    }
    return Joint{.description = &coupling, .tail = *tail, .head = *head, .geometry = *geometry};
  }

  // The size of the mechanism, and where its screws are written; a coupling without a point of its
  // own acts there.
  void place(std::vector<Joint>& joints) {
    std::vector<Vec3> points;
    for (const Joint& joint : joints) {
      if (joint.description->at) {
        points.push_back(joint.geometry.at);
      }
    }
    const Extent extent = find_extent(points);
    geometry_.length = extent.length;
    geometry_.origin = extent.origin;
    for (Joint& joint : joints) {
      if (!joint.description->at) {
        joint.geometry.at = extent.origin;
      }
    }
  }

  void add_coupling(const Joint& joint) {
    const CouplingDescription& coupling = *joint.description;
    CouplingGeometry local = joint.geometry;
    local.at -= geometry_.origin;
    CouplingScrews screws = coupling_screws(coupling.type, description_.space, local);
    if (coupling.passive) {
      keep_passive(coupling, screws, found_);  // all that it bears, in space too
    } else if (constraints_ != description_.space) {
      screws.constraints = coupling_screws(coupling.type, constraints_, local).constraints;
    }
    const CouplingId id{topology_.coupling_count()};
    topology_.couplings.push_back({.name = coupling.name.text,
                                   .type = coupling.type,
                                   .tail = joint.tail,
                                   .head = joint.head,
                                   .first_freedom = topology_.freedom_count(),
                                   .freedom_count = static_cast<int>(screws.freedoms.size()),
                                   .first_action = topology_.action_count(),
                                   .action_count = static_cast<int>(screws.constraints.size()),
                                   .where = coupling.name.where});
    geometry_.points.push_back(joint.geometry.at);
    add_screws(id, screws);
    add_actuators(id, coupling, screws, local.at);
  }

  void add_screws(CouplingId id, const CouplingScrews& screws) {
    for (const NamedTwist& freedom : screws.freedoms) {
      topology_.freedoms.push_back(
          {.coupling = id, .name = freedom.name, .is_rotation = freedom.is_rotation});
      geometry_.motions.push_back(freedom.screw);
    }
    for (const NamedWrench& constraint : screws.constraints) {
      topology_.actions.push_back({.coupling = id,
                                   .name = constraint.name,
                                   .is_couple = constraint.is_couple,
                                   .actuator = -1});
      geometry_.actions.push_back(constraint.screw);
    }
  }

  // A clutch or brake is an actuator of its own name.
  void add_actuators(CouplingId id,
                     const CouplingDescription& coupling,
                     const CouplingScrews& screws,
                     const Vec3& at) {
    std::vector<PendingActuator> pending;
    if (coupling.type == CouplingType::clutch || coupling.type == CouplingType::brake) {
      pending.push_back({.name = coupling.name.text, .freedom = {}, .where = coupling.name.where});
    }
    const auto declared = pending_.find(coupling.name.text);
    if (declared != pending_.end()) {
      pending.insert(pending.end(), declared->second.begin(), declared->second.end());
    }
    for (const PendingActuator& actuator : pending) {
      const std::optional<std::size_t> which = choose_freedom(actuator, coupling, screws);
      if (which) {
        add_actuator(id, actuator, *which, internal_action(screws.freedoms[*which], at));
      }
    }
  }

  std::optional<std::size_t> choose_freedom(const PendingActuator& actuator,
                                            const CouplingDescription& coupling,
                                            const CouplingScrews& screws) {
    const std::vector<std::string> names = names_of(screws.freedoms);
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
            : fmt::format(
                  "coupling '{}' has no freedom '{}'", coupling.name.text, actuator.freedom);
    found_.error("E0313",
                 actuator.where,
                 message,
                 names.empty() ? "choose another coupling"
                               : fmt::format("add 'freedom:' with one of {}", plain_list(names)));
    return std::nullopt;
  }

  void add_actuator(CouplingId id,
                    const PendingActuator& actuator,
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

  const MechanismDescription& description_;
  Space constraints_;
  Evaluator& evaluator_;
  Diagnostics& found_;
  Topology& topology_;
  Geometry& geometry_;
  std::map<std::string, BodyId> body_ids_;
  std::map<std::string, SourceRange> declared_;
  std::map<std::string, std::vector<PendingActuator>> pending_;  ///< by coupling
};

}  // namespace

void bind_bodies_and_couplings(const MechanismDescription& description,
                               Space constraints,
                               Evaluator& evaluator,
                               Diagnostics& found,
                               Mechanism& result) {
  StructureBinder(description, constraints, evaluator, found, result).run();
}

}  // namespace kinestat
