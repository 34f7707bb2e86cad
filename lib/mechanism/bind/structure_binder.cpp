#include "mechanism/bind/structure_binder.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "core/utf8.hpp"
#include "mechanism/bind/extent.hpp"
#include "mechanism/bind/reference_points.hpp"
#include "mechanism/bind/tooth_rules.hpp"
#include "mechanism/cases/actuator_binder.hpp"
#include "mechanism/check/expect.hpp"
#include "mechanism/check/geometry_check.hpp"
#include "mechanism/couplings/internal/converter_binder.hpp"
#include "mechanism/couplings/internal/coupling_binder.hpp"
#include "mechanism/couplings/internal/friction_binder.hpp"
#include "mechanism/couplings/internal/screw_binder.hpp"

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

// A coupling on its way from the description to its screws.
struct Joint {
  const CouplingDescription* description = nullptr;
  BodyId tail;
  BodyId head;
  CouplingGeometry geometry;
};

class StructureBinder {
 public:
  StructureBinder(const MechanismDescription& description,
                  ScrewSpaces spaces,
                  Evaluator& evaluator,
                  Diagnostics& found,
                  Mechanism& result)
      : description_(description),
        spaces_(spaces),
        evaluator_(evaluator),
        found_(found),
        topology_(result.topology),
        geometry_(result.geometry),
        frictions_(result.frictions),
        is_unplaced_(result.is_unplaced),
        result_(result),
        actuators_(description, result, found) {}

  void run() {
    bind_bodies();
    for (const CouplingDescription& coupling : description_.couplings) {
      declare(coupling.name);
    }
    for (const ActuatorDescription& actuator : description_.actuators) {
      declare(actuator.name);
    }
    gears_ = bind_gear_frame<double>(description_, evaluator_);
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
    turn_teeth(joints.size());
    geometry_.references =
        bind_reference_points<double>(description_, has_point_, topology_, geometry_, evaluator_);
  }

 private:
  void bind_bodies() {
    topology_.bodies.reserve(description_.bodies.size() + 1);
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

  std::string declared_bodies(const std::string& name) const {
    const std::vector<std::string> bodies = names_of(topology_.bodies);
    const std::string guess = did_you_mean(name, bodies);
    return fmt::format(
        "declared bodies are {}{}{}", plain_list(bodies), guess.empty() ? "" : "; ", guess);
  }

  std::optional<BodyId> find_body(const CouplingDescription& coupling, const Name& name) {
    const auto at = body_ids_.find(name.text);
    if (at != body_ids_.end()) {
      return at->second;
    }
    found_.error("E0312",
                 name.where,
                 fmt::format("coupling '{}' joins body '{}', which is not declared",
                             coupling.name.text,
                             printable(name.text)),
                 found_.is_hint_worth_it() ? declared_bodies(name.text) : "");
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
    const bool has_point =
        check_axis_place(coupling, description_, gears_ ? &*gears_ : nullptr, found_);
    const bool is_complete = check_geometry(coupling, description_.space, evaluator_, found_);
    const auto geometry = bind_geometry<double>(
        coupling, description_.space, gears_ ? &*gears_ : nullptr, evaluator_, found_);
    if (!tail || !head || !has_point || !is_complete || !geometry) {
      return std::nullopt;
    }
    return Joint{.description = &coupling, .tail = *tail, .head = *head, .geometry = *geometry};
  }

  // The size of the mechanism, and from where it is measured; a coupling without a point of its own
  // acts there. Far from the origin of the world all is bound once more, from the new one.
  void place(std::vector<Joint>& joints) {
    std::vector<Vec3> points;
    for (const Joint& joint : joints) {
      add_points(*joint.description, joint.geometry, points);
    }
    const Extent extent = find_extent(points);
    geometry_.length = extent.length;
    if (extent.length < 1.0 / kLargestNumber) {
      found_.error("E0320",
                   joints.front().description->name.where,
                   "the mechanism is smaller than what can be computed with",
                   fmt::format("its couplings are less than {:g} m apart; look at the units",
                               1.0 / kLargestNumber));
    }
    geometry_.origin = LocalOrigin(extent.origin);
    evaluator_.measure_from(geometry_.origin);
    for (std::size_t i = 0; i < joints.size() && !geometry_.origin.is_world(); ++i) {
      Diagnostics said_before;
      Evaluator evaluator = evaluator_.complaining_to(said_before);
      joints[i].geometry = expect(bind_geometry<double>(*joints[i].description,
                                                        description_.space,
                                                        gears_ ? &*gears_ : nullptr,
                                                        evaluator,
                                                        said_before));
    }
  }

  void add_coupling(const Joint& joint) {
    const CouplingDescription& coupling = *joint.description;
    const CouplingGeometry& local = joint.geometry;
    const ScrewBinder binder(coupling, description_.space, spaces_);
    const CouplingScrews drawn = binder.drawn(local, geometry_.length, found_);
    const CouplingScrews screws = binder.counted(local, drawn);
    check_stiffness(coupling, screws, found_);
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
    geometry_.points.push_back(local.at);
    has_point_.push_back(has_place(coupling));
    is_unplaced_.push_back(!has_place(coupling) && !is_on_axis(coupling));
    add_screws(id, screws);
    if (local.other_flank && !screws.constraints.empty()) {
      add_other_flank(binder, local);
    }
    actuators_.add(id, coupling, drawn, local.at);
    add_friction(id, coupling, screws);
  }

  bool is_on_axis(const CouplingDescription& coupling) const {
    return gears_ && gears_->layout.train.axis_between(coupling.tail.text, coupling.head.text) >= 0;
  }

  // Couplings with an error are no joints.
  void turn_teeth(std::size_t joint_count) {
    if (joint_count != description_.couplings.size()) {
      return;
    }
    const std::vector<TurningTeeth> teeth = find_turning_teeth(description_, topology_, geometry_);
    result_.tooth_rules = find_tooth_rules(topology_, geometry_, teeth);
    complete_flanks(result_.tooth_rules, topology_, geometry_);
    result_.one_flanked = find_one_flanked(description_, topology_, geometry_);
  }

  // Of the mesh that was added last; its force is its only constraint.
  void add_other_flank(const ScrewBinder& binder, CouplingGeometry local) {
    local.line_of_action = *local.other_flank;
    const CouplingScrews drawn = binder.drawn(local, geometry_.length, found_);
    const CouplingScrews screws = binder.counted(local, drawn);
    geometry_.other_flanks.push_back(
        {.action = topology_.action_count() - 1, .screw = screws.constraints.front().screw});
  }

  // Both couplings of a torque converter have its law, each its own couple of it; what is wrong
  // with it is said once.
  void add_converter(CouplingId id, const CouplingDescription& coupling) {
    const bool is_of_stator = !coupling.stator_of.empty();
    Diagnostics said_before;
    Evaluator silent = evaluator_.complaining_to(said_before);
    auto law = is_of_stator ? bind_converter<double>(coupling, silent, said_before)
                            : bind_converter<double>(coupling, evaluator_, found_);
    const auto first =
        std::ranges::find(topology_.couplings, coupling.stator_of, &CouplingTopology::name);
    const auto stator =
        body_ids_.find(coupling.stator ? coupling.stator->text : description_.ground.text);
    const bool is_whole =
        is_of_stator ? first != topology_.couplings.end() : stator != body_ids_.end();
    if (!law || !is_whole) {
      return;
    }
    const CouplingTopology& own = topology_.coupling(id);
    law->pump = is_of_stator ? first->tail : own.tail;
    law->stator = is_of_stator ? own.tail : stator->second;
    law->turbine = own.head;
    CouplingFriction friction;
    friction.coupling = id;
    friction.where = coupling.characteristic->where;
    friction.converter = std::make_shared<const ConverterLaw>(*std::move(law));
    frictions_.push_back(std::move(friction));
  }

  // Friction that no force presses is left out.
  void add_friction(CouplingId id,
                    const CouplingDescription& coupling,
                    const CouplingScrews& screws) {
    if (coupling.characteristic) {
      add_converter(id, coupling);
      return;
    }
    const auto friction =
        coupling.friction
            ? bind_friction(coupling, id, screws, description_.units, evaluator_, found_)
            : std::nullopt;
    if (friction && (friction->mu > 0.0 || friction->mu_static.value_or(0.0) > 0.0 ||
                     friction->tau > 0.0 || friction->viscous > 0.0)) {
      frictions_.push_back(*friction);
    }
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

  const MechanismDescription& description_;
  ScrewSpaces spaces_;
  Evaluator& evaluator_;
  Diagnostics& found_;
  Topology& topology_;
  Geometry& geometry_;
  std::vector<CouplingFriction>& frictions_;
  std::vector<bool>& is_unplaced_;
  Mechanism& result_;
  std::map<std::string, BodyId> body_ids_;
  std::map<std::string, SourceRange> declared_;
  std::vector<bool> has_point_;  ///< of each coupling of the topology
  std::optional<GearFrame> gears_;
  ActuatorBinder actuators_;
};

}  // namespace

void bind_bodies_and_couplings(const MechanismDescription& description,
                               ScrewSpaces spaces,
                               Evaluator& evaluator,
                               Diagnostics& found,
                               Mechanism& result) {
  StructureBinder(description, spaces, evaluator, found, result).run();
}

}  // namespace kinestat
