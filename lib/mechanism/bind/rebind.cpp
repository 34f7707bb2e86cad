#include "mechanism/bind/rebind.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "couplings/coupling_catalogue.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/bind/extent.hpp"
#include "mechanism/bind/judged_numbers.hpp"
#include "mechanism/bind/varying_parameters.hpp"
#include "mechanism/couplings/internal/coupling_binder.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

// Types whose rows of the catalogue are reciprocal whatever the numbers are, so that there is
// nothing to check anew.
bool is_always_right(const CouplingDescription& coupling) {
  using enum CouplingType;
  return coupling.type == gear
             ? coupling.screw == nullptr && !coupling.contact
             : !has_teeth(coupling.type) && coupling.type != cable && coupling.type != screws;
}

// The numbers that a Rebinder finds anew and asks as the check of the file does.
std::set<const Value*> rebound_numbers(const MechanismDescription& description) {
  std::set<const Value*> numbers;
  const auto add = [&](const Value& value) { numbers.insert(&value); };
  const auto add_some = [&](const std::optional<Value>& value) {
    if (value) {
      numbers.insert(&*value);
    }
  };
  const auto add_axis = [&](const std::optional<AxisDescription>& axis) {
    if (axis) {
      std::ranges::for_each(axis->components, add);
    }
  };
  for (const CouplingDescription& one : description.couplings) {
    if (one.at && one.at->point) {
      std::ranges::for_each(one.at->point->coordinates, add);
    }
    for (const auto* axis :
         {&one.axis, &one.normal, &one.line, &one.slot, &one.tangent, &one.line_of_action}) {
      add_axis(*axis);
    }
    for (const AxisDescription& axis : one.axes) {
      std::ranges::for_each(axis.components, add);
    }
    for (const auto* value : {&one.pitch,
                              &one.lead,
                              &one.pressure_angle,
                              &one.normal_pressure_angle,
                              &one.helix_angle}) {
      add_some(*value);
    }
  }
  if (description.gears) {
    for (const GearMember& member : description.gears->members) {
      add(member.teeth);
    }
    add_some(description.gears->module);
    for (const MeshDescription& mesh : description.gears->meshes) {
      add_some(mesh.module);
    }
  }
  for (const CaseDescription& one : description.cases) {
    for (const auto* side : {&one.motions, &one.actions}) {
      std::ranges::for_each(*side, add, &Assignment::value);
    }
  }
  return numbers;
}

// Whether a number moves on which the file is checked by more than a rule of that number, and which
// is not found anew: only whole binding knows whether it is right then.
bool decides_more(const MechanismDescription& description, const VaryingParameters& varying) {
  const std::set<const Value*> rebound = rebound_numbers(description);
  const std::vector<const Value*> judged = find_judged_numbers(description).by_more;
  return std::ranges::any_of(judged, [&](const Value* value) {
    return varying.stand_in(*value) && !rebound.contains(value);
  });
}

bool has_more_than_couplings(const MechanismDescription& description, const Mechanism& mechanism) {
  const auto has_loads = [](const CaseDescription& one) { return !one.loads.empty(); };
  const auto may_rub = [](const CouplingDescription& one) {
    return one.friction != nullptr || one.characteristic != nullptr;
  };
  const bool may_leave_order =
      description.space == Space::spatial && (description.kinematic_order == OrderChoice::planar ||
                                              description.static_order == OrderChoice::planar);
  return may_leave_order || !description.cables.empty() || !description.loads.empty() ||
         description.gravity || !description.curves.empty() || !mechanism.contacts.empty() ||
         std::ranges::any_of(description.cases, has_loads) ||
         std::ranges::any_of(description.couplings, may_rub);
}

// Whether complete_flanks puts the other flank of a coupling first.
bool is_other_first(const Mechanism& mechanism,
                    std::size_t coupling,
                    const CouplingGeometry& drawn) {
  const CouplingId id{static_cast<int>(coupling)};
  const auto rule = std::ranges::find(mechanism.tooth_rules, id, &ToothRule::coupling);
  return rule != mechanism.tooth_rules.end() && rule->has_other &&
         is_pulling(
             *rule, mechanism.topology, mechanism.geometry.motions, drawn.at, drawn.line_of_action);
}

// Whether every screw of a coupling is a line through its point, or has no line: then a point that
// moves takes them along, and nothing else of the coupling changes.
bool has_lines_through(const Topology& topology,
                       std::size_t coupling,
                       const Geometry& geometry,
                       const Vec3& point) {
  const CouplingTopology& one = topology.couplings[coupling];
  const auto motions = std::span(geometry.motions)
                           .subspan(static_cast<std::size_t>(one.first_freedom),
                                    static_cast<std::size_t>(one.freedom_count));
  const auto actions = std::span(geometry.actions)
                           .subspan(static_cast<std::size_t>(one.first_action),
                                    static_cast<std::size_t>(one.action_count));
  return std::ranges::all_of(motions,
                             [&](const Twist& twist) {
                               return twist.angular.isZero(0.0) ||
                                      twist.linear == moment_of_line(point, twist.angular);
                             }) &&
         std::ranges::all_of(actions, [&](const Wrench& wrench) {
           return wrench.force.isZero(0.0) || wrench.moment == moment_of_line(point, wrench.force);
         });
}

}  // namespace

std::optional<Rebinder> Rebinder::make(const MechanismDescription& description,
                                       const Mechanism& mechanism,
                                       const std::vector<bool>& varies) {
  if (has_more_than_couplings(description, mechanism) || !mechanism.geometry.origin.is_world() ||
      mechanism.cases.size() != description.cases.size()) {
    return std::nullopt;
  }
  Rebinder result(description, mechanism);
  result.action_space_ =
      description.static_order == OrderChoice::spatial ? Space::spatial : description.space;
  result.table_ = evaluate_parameters(parameters_of(description)).table;
  if (description.gears) {
    result.gears_ = GearPlaces::make(description, result.table_, varies);
  }
  const VaryingParameters varying(result.table_, varies);
  if (description.gears.has_value() != result.gears_.has_value() ||
      varying.stand_in(description.losses) || decides_more(description, varying) ||
      !result.add_couplings(mechanism, varies)) {
    return std::nullopt;
  }
  result.add_primaries(mechanism, varies);
  return result;
}

bool Rebinder::add_couplings(const Mechanism& mechanism, const std::vector<bool>& varies) {
  moves_.assign(description_->couplings.size(), false);
  turns_ = moves_;
  for (std::size_t e = 0; e < description_->couplings.size(); ++e) {
    if (!add_coupling(e, mechanism, varies)) {
      return false;
    }
  }
  const bool keeps_flanks = std::ranges::none_of(
      mechanism.tooth_rules, [&](const ToothRule& rule) { return !rule.has_other && moves(rule); });
  return keeps_flanks && find_extent(points_).origin.isZero(0.0);
}

// Whether it may tell another flank.
bool Rebinder::moves(const ToothRule& rule) const {
  const auto moves = [&](int freedom) {
    return freedom >= 0 && moves_[at(mechanism_->topology.freedoms[at(freedom)].coupling.value)];
  };
  return moves_[at(rule.coupling.value)] || moves(rule.tail) || moves(rule.head);
}

bool Rebinder::add_coupling(std::size_t e,
                            const Mechanism& mechanism,
                            const std::vector<bool>& varies) {
  const CouplingDescription& coupling = description_->couplings[e];
  const VaryingParameters varying(table_, varies);
  const std::optional<int> gear_axis = gear_axis_of(coupling);
  const bool is_in_gears = coupling.is_mesh() || gear_axis;
  const bool is_plain =
      is_always_right(coupling) &&
      (is_in_gears || !coupling.at ||
       (coupling.at->point && !coupling.at->along_axis && coupling.at->of_bodies.empty()));
  Diagnostics found;
  Evaluator evaluator(*description_, table_, found);
  const auto drawn =
      bind_geometry<double>(coupling, description_->space, frame(), evaluator, found);
  KINESTAT_EXPECTS(drawn.has_value());
  const auto& flanks = mechanism.geometry.other_flanks;
  const int force = mechanism.topology.couplings[e].first_action;
  const auto other = std::ranges::find(flanks, force, &OtherFlankOf<double>::action);
  const bool has_flank = drawn->other_flank && other != flanks.end();
  const std::optional<std::size_t> point =
      has_place(coupling) ? std::optional(points_.size()) : std::nullopt;
  add_points(coupling, *drawn, points_);
  if (!is_plain) {
    return !varying.stand_in_any_of(coupling);
  }
  const bool shape_varies = varying.stand_in_shape_of(coupling);
  const bool moves_with_gears = is_in_gears && gears_->moves();
  if (!shape_varies && !moves_with_gears && !(coupling.at && varying.stand_in(*coupling.at))) {
    return true;
  }
  if (is_in_gears && (shape_varies || (coupling.at && varying.stand_in(*coupling.at)))) {
    return false;
  }
  MovingCoupling moving{.coupling = static_cast<int>(e),
                        .drawn = *drawn,
                        .at = {},
                        .constraints = {},
                        .is_in_space = description_->space == Space::planar &&
                                       action_space_ == Space::spatial &&
                                       !coupling.passive.has_value(),
                        .is_bound_whole = shape_varies,
                        .is_in_gears = is_in_gears,
                        .gear_axis = gear_axis,
                        .flank = has_flank ? static_cast<int>(other - flanks.begin()) : -1,
                        .is_other_first = is_other_first(mechanism, e, *drawn),
                        .point = point};
  if (coupling.is_mesh()) {
    moving.tangent = gears_->frame().layout.meshes[static_cast<std::size_t>(coupling.mesh)].tangent;
  } else if (!gear_axis) {
    add_numbers(coupling, varies, moving);
  }
  if (moving.is_other_first) {
    std::swap(moving.drawn.line_of_action, *moving.drawn.other_flank);
  }
  add_constraints(coupling, moving);
  moving.is_through_point =
      !shape_varies && has_lines_through(mechanism_->topology, e, mechanism.geometry, drawn->at);
  moves_[e] = true;
  turns_[e] = shape_varies || coupling.is_mesh();
  moving_.push_back(std::move(moving));
  return point.has_value() || is_in_gears;
}

const GearFrame* Rebinder::frame() const {
  return gears_ ? &gears_->frame() : nullptr;
}

// The axis of `gears` on which a coupling without a point of its own stands.
std::optional<int> Rebinder::gear_axis_of(const CouplingDescription& coupling) const {
  const bool has_point = coupling.at && (coupling.at->point || !coupling.at->of_bodies.empty());
  if (!gears_ || coupling.is_mesh() || has_point) {
    return std::nullopt;
  }
  const GearTrain& train = gears_->frame().layout.train;
  const int axis = train.axis_between(coupling.tail.text, coupling.head.text);
  return axis >= 0 ? std::optional(axis) : std::nullopt;
}

// The coordinates of its point.
void Rebinder::add_numbers(const CouplingDescription& coupling,
                           const std::vector<bool>& varies,
                           MovingCoupling& moving) const {
  const VaryingParameters varying(table_, varies);
  for (std::size_t i = 0; coupling.at && i < coupling.at->point->coordinates.size(); ++i) {
    const Value& coordinate = coupling.at->point->coordinates[i];
    moving.at[i].constant = moving.drawn.at[static_cast<Eigen::Index>(i)];
    if (varying.stand_in(coordinate)) {
      moving.at[i].formula.emplace(coordinate.expression,
                                   [&](const std::string& name) { return table_.index_of(name); });
    }
  }
}

// Which constraints of the catalogue its actions are, by their names.
void Rebinder::add_constraints(const CouplingDescription& coupling, MovingCoupling& moving) const {
  const CouplingScrews screws = coupling_screws(
      coupling.type, moving.is_in_space ? Space::spatial : description_->space, moving.drawn);
  const CouplingTopology& topology =
      mechanism_->topology.couplings[static_cast<std::size_t>(moving.coupling)];
  for (int a = topology.first_action; a < topology.first_action + topology.action_count; ++a) {
    const ActionLabel& label = mechanism_->topology.actions[static_cast<std::size_t>(a)];
    const auto at = std::ranges::find(screws.constraints, label.name, &NamedWrench::name);
    KINESTAT_EXPECTS(label.actuator >= 0 || at != screws.constraints.end());
    moving.constraints.push_back(
        label.actuator >= 0 ? -1 : static_cast<int>(at - screws.constraints.begin()));
  }
}

void Rebinder::add_primaries(const Mechanism& mechanism, const std::vector<bool>& varies) {
  const VaryingParameters varying(table_, varies);
  const auto slot_of = [&](const std::string& name) { return table_.index_of(name); };
  for (std::size_t c = 0; c < description_->cases.size(); ++c) {
    const CaseDescription& one = description_->cases[c];
    for (std::size_t i = 0; i < one.motions.size(); ++i) {
      const auto f = static_cast<std::size_t>(mechanism.cases[c].motions[i].index);
      if (varying.stand_in(one.motions[i].value)) {
        primaries_.push_back({.which = c,
                              .is_motion = true,
                              .primary = i,
                              .kind = kind_of(mechanism_->topology.freedoms[f]),
                              .value = SlotExpression(one.motions[i].value.expression, slot_of)});
      }
    }
    for (std::size_t i = 0; i < one.actions.size(); ++i) {
      const auto a = static_cast<std::size_t>(mechanism.cases[c].actions[i].index);
      if (varying.stand_in(one.actions[i].value)) {
        primaries_.push_back({.which = c,
                              .is_motion = false,
                              .primary = i,
                              .kind = kind_of(mechanism_->topology.actions[a]),
                              .value = SlotExpression(one.actions[i].value.expression, slot_of)});
      }
    }
  }
}

bool Rebinder::rebind_geometry(const Slots& slots, Geometry& geometry) {
  if (gears_ && gears_->moves() && !gears_->find(slots, scratch_)) {
    return false;
  }
  for (MovingCoupling& moving : moving_) {
    const bool is_bound = moving.is_in_gears      ? place_in_gears(moving)
                          : moving.is_bound_whole ? bind_whole(slots, moving)
                                                  : place(slots, moving);
    if (!is_bound) {
      return false;
    }
    if (moving.point) {
      points_[*moving.point] = moving.drawn.at;
    }
  }
  const Extent extent = find_extent(points_);
  if (!extent.origin.isZero(0.0) || extent.length < 1.0 / kLargestNumber) {
    return false;
  }
  for (const MovingCoupling& moving : moving_) {
    const bool goes_along = moving.is_through_point && !moving.has_turned;
    goes_along ? move_lines(moving, geometry) : write_screws(moving, geometry);
  }
  return std::ranges::none_of(mechanism_->tooth_rules, [&](const ToothRule& rule) {
    const auto moving = std::ranges::find(moving_, rule.coupling.value, &MovingCoupling::coupling);
    const Vec3& point =
        moving != moving_.end()
            ? moving->drawn.at
            : mechanism_->geometry.points[static_cast<std::size_t>(rule.coupling.value)];
    const Vec3& line = geometry.actions[static_cast<std::size_t>(rule.action)].force;
    return moves(rule) && is_pulling(rule, mechanism_->topology, geometry.motions, point, line);
  });
}

// The lines of teeth go on through a pitch point that moves along; where the tangent turns with the
// centres, they are found anew.
bool Rebinder::place_in_gears(MovingCoupling& moving) {
  const GearLayout& layout = gears_->frame().layout;
  const CouplingDescription& coupling =
      description_->couplings[static_cast<std::size_t>(moving.coupling)];
  if (moving.gear_axis) {
    // A place along the axis stays.
    moving.drawn.at.head<2>() =
        layout.centres[static_cast<std::size_t>(*moving.gear_axis)].head<2>();
    return true;
  }
  const MeshLayoutOf<double>& mesh = layout.meshes[static_cast<std::size_t>(coupling.mesh)];
  moving.drawn.at = mesh.pitch_point;
  if (moving.tangent != mesh.tangent) {
    Diagnostics found;
    Evaluator evaluator(*description_, table_, found);
    const auto drawn =
        bind_geometry<double>(coupling, description_->space, frame(), evaluator, found);
    if (!drawn) {
      return false;
    }
    moving.drawn = *drawn;
    moving.tangent = mesh.tangent;
    moving.has_turned = true;
  }
  return true;
}

bool Rebinder::place(const Slots& slots, MovingCoupling& moving) {
  for (std::size_t i = 0; i < moving.at.size(); ++i) {
    if (!moving.at[i].formula) {
      continue;
    }
    const std::optional<double> coordinate = slot_number(
        *moving.at[i].formula, QuantityKind::length, description_->units, slots, scratch_);
    if (!coordinate) {
      return false;
    }
    moving.drawn.at[static_cast<Eigen::Index>(i)] = *coordinate;
  }
  return true;
}

bool Rebinder::bind_whole(const Slots& slots, MovingCoupling& moving) {
  for (std::size_t i = 0; i < slots.values.size(); ++i) {
    if (!slots.has_value[i]) {
      return false;
    }
    table_.set(static_cast<int>(i), slots.values[i]);
  }
  Diagnostics found;
  Evaluator evaluator(*description_, table_, found);
  const CouplingDescription& coupling =
      description_->couplings[static_cast<std::size_t>(moving.coupling)];
  const auto drawn =
      bind_geometry<double>(coupling, description_->space, nullptr, evaluator, found);
  if (!drawn) {
    return false;
  }
  moving.drawn = *drawn;
  if (moving.is_other_first) {
    std::swap(moving.drawn.line_of_action, *moving.drawn.other_flank);
  }
  return true;
}

void Rebinder::write_screws(const MovingCoupling& moving, Geometry& geometry) const {
  const CouplingTopology& topology =
      mechanism_->topology.couplings[static_cast<std::size_t>(moving.coupling)];
  const CouplingGeometry& drawn = moving.drawn;
  const CouplingScrews screws = coupling_screws(topology.type, description_->space, drawn);
  const CouplingScrews in_space =
      moving.is_in_space ? coupling_screws(topology.type, Space::spatial, drawn) : CouplingScrews{};
  const auto& constraints = moving.is_in_space ? in_space.constraints : screws.constraints;
  for (std::size_t f = 0; f < screws.freedoms.size(); ++f) {
    geometry.motions[static_cast<std::size_t>(topology.first_freedom) + f] =
        screws.freedoms[f].screw;
  }
  for (std::size_t a = 0; a < moving.constraints.size(); ++a) {
    const std::size_t action = static_cast<std::size_t>(topology.first_action) + a;
    if (moving.constraints[a] >= 0) {
      geometry.actions[action] = constraints[static_cast<std::size_t>(moving.constraints[a])].screw;
      continue;
    }
    const auto actuator = static_cast<std::size_t>(mechanism_->topology.actions[action].actuator);
    const auto freedom = static_cast<std::size_t>(mechanism_->topology.actuators[actuator].freedom -
                                                  topology.first_freedom);
    geometry.actions[action] = internal_action<double>(screws.freedoms[freedom], drawn.at).screw;
  }
  if (moving.flank >= 0) {
    write_flank(moving, geometry);
  }
}

void Rebinder::move_lines(const MovingCoupling& moving, Geometry& geometry) const {
  const CouplingTopology& topology =
      mechanism_->topology.couplings[static_cast<std::size_t>(moving.coupling)];
  const Vec3& point = moving.drawn.at;
  for (int f = topology.first_freedom; f < topology.first_freedom + topology.freedom_count; ++f) {
    Twist& twist = geometry.motions[static_cast<std::size_t>(f)];
    if (!twist.angular.isZero(0.0)) {
      twist.linear = moment_of_line(point, twist.angular);
    }
  }
  for (int a = topology.first_action; a < topology.first_action + topology.action_count; ++a) {
    Wrench& wrench = geometry.actions[static_cast<std::size_t>(a)];
    if (!wrench.force.isZero(0.0)) {
      wrench.moment = moment_of_line(point, wrench.force);
    }
  }
  if (moving.flank >= 0) {
    Wrench& flank = geometry.other_flanks[static_cast<std::size_t>(moving.flank)].screw;
    flank.moment = moment_of_line(point, flank.force);
  }
}

void Rebinder::write_flank(const MovingCoupling& moving, Geometry& geometry) const {
  CouplingGeometry drawn = moving.drawn;
  drawn.line_of_action = *drawn.other_flank;
  const CouplingTopology& topology =
      mechanism_->topology.couplings[static_cast<std::size_t>(moving.coupling)];
  const Space space = moving.is_in_space ? Space::spatial : description_->space;
  geometry.other_flanks[static_cast<std::size_t>(moving.flank)].screw =
      coupling_screws(topology.type, space, drawn).constraints.front().screw;
}

bool Rebinder::rebind_cases(const Slots& slots, std::span<Case> cases) {
  for (const MovingPrimary& one : primaries_) {
    Case& which = cases[one.which];
    const std::optional<double> value =
        slot_number(one.value, one.kind, description_->units, slots, scratch_);
    if (!value) {
      return false;
    }
    (one.is_motion ? which.motions : which.actions)[one.primary].value = *value;
  }
  return true;
}

}  // namespace kinestat
