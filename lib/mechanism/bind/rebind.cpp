#include "mechanism/bind/rebind.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "couplings/coupling_catalogue.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/bind/dependence.hpp"
#include "mechanism/bind/extent.hpp"
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

bool has_more_than_couplings(const MechanismDescription& description, const Mechanism& mechanism) {
  const auto has_loads = [](const CaseDescription& one) { return !one.loads.empty(); };
  const auto may_rub = [](const CouplingDescription& one) { return one.friction != nullptr; };
  return description.gears || !description.cables.empty() || !description.loads.empty() ||
         description.gravity || !mechanism.contacts.empty() ||
         std::ranges::any_of(description.cases, has_loads) ||
         std::ranges::any_of(description.couplings, may_rub);
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

std::optional<double> number_of(const SlotExpression& value,
                                QuantityKind kind,
                                const FileUnits& units,
                                const Slots& slots,
                                std::vector<Quantity>& scratch) {
  const std::optional<Quantity> quantity = value.evaluate(slots, scratch);
  if (quantity && is_bare(quantity->dimension) && units.scale(kind) == UnitScale{} &&
      std::abs(quantity->value) <= kLargestNumber) {
    return quantity->value;  // no unit and no limit for `fit` to look at
  }
  const auto fitted = quantity ? fit<double>(*quantity, kind, units)
                               : std::variant<double, ExpressionError>(ExpressionError{});
  const double* number = std::get_if<double>(&fitted);
  return number != nullptr ? std::optional(*number) : std::nullopt;
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
  if (Dependence(result.table_, varies).of(description.losses) ||
      !result.add_couplings(mechanism, varies)) {
    return std::nullopt;
  }
  result.add_primaries(mechanism, varies);
  return result;
}

bool Rebinder::add_couplings(const Mechanism& mechanism, const std::vector<bool>& varies) {
  moves_.assign(description_->couplings.size(), false);
  for (std::size_t e = 0; e < description_->couplings.size(); ++e) {
    if (!add_coupling(e, mechanism, varies)) {
      return false;
    }
  }
  return find_extent(points_).origin.isZero(0.0);
}

bool Rebinder::add_coupling(std::size_t e,
                            const Mechanism& mechanism,
                            const std::vector<bool>& varies) {
  const CouplingDescription& coupling = description_->couplings[e];
  const Dependence depends(table_, varies);
  const bool is_plain = is_always_right(coupling) &&
                        (!coupling.at || (coupling.at->point && !coupling.at->along_axis &&
                                          coupling.at->of_bodies.empty()));
  Diagnostics found;
  Evaluator evaluator(*description_, table_, found);
  const auto drawn =
      bind_geometry<double>(coupling, description_->space, nullptr, evaluator, found);
  KINESTAT_EXPECTS(drawn.has_value());
  const std::size_t point = points_.size();
  add_points(coupling, *drawn, points_);
  if (!is_plain) {
    return !depends.of_all(coupling);
  }
  const bool shape_varies = depends.of_shape(coupling);
  if (!shape_varies && !(coupling.at && depends.of(coupling.at->point))) {
    return true;
  }
  MovingCoupling moving{.coupling = static_cast<int>(e),
                        .drawn = *drawn,
                        .at = {},
                        .constraints = {},
                        .is_in_space = description_->space == Space::planar &&
                                       action_space_ == Space::spatial &&
                                       !coupling.passive.has_value(),
                        .is_bound_whole = shape_varies,
                        .point = point};
  add_numbers(coupling, varies, moving);
  add_constraints(coupling, moving);
  moving.is_through_point =
      !shape_varies && has_lines_through(*topology_, e, mechanism.geometry, drawn->at);
  moves_[e] = true;
  moving_.push_back(std::move(moving));
  return has_place(coupling);
}

// The coordinates of its point.
void Rebinder::add_numbers(const CouplingDescription& coupling,
                           const std::vector<bool>& varies,
                           MovingCoupling& moving) const {
  const Dependence depends(table_, varies);
  for (std::size_t i = 0; coupling.at && i < coupling.at->point->coordinates.size(); ++i) {
    const Value& coordinate = coupling.at->point->coordinates[i];
    moving.at[i].constant = moving.drawn.at[static_cast<Eigen::Index>(i)];
    if (depends.of(coordinate)) {
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
      topology_->couplings[static_cast<std::size_t>(moving.coupling)];
  for (int a = topology.first_action; a < topology.first_action + topology.action_count; ++a) {
    const ActionLabel& label = topology_->actions[static_cast<std::size_t>(a)];
    const auto at = std::ranges::find(screws.constraints, label.name, &NamedWrench::name);
    KINESTAT_EXPECTS(label.actuator >= 0 || at != screws.constraints.end());
    moving.constraints.push_back(
        label.actuator >= 0 ? -1 : static_cast<int>(at - screws.constraints.begin()));
  }
}

void Rebinder::add_primaries(const Mechanism& mechanism, const std::vector<bool>& varies) {
  const Dependence depends(table_, varies);
  const auto slot_of = [&](const std::string& name) { return table_.index_of(name); };
  for (std::size_t c = 0; c < description_->cases.size(); ++c) {
    const CaseDescription& one = description_->cases[c];
    for (std::size_t i = 0; i < one.motions.size(); ++i) {
      const auto f = static_cast<std::size_t>(mechanism.cases[c].motions[i].index);
      if (depends.of(one.motions[i].value)) {
        primaries_.push_back({.which = c,
                              .is_motion = true,
                              .primary = i,
                              .kind = kind_of(topology_->freedoms[f]),
                              .value = SlotExpression(one.motions[i].value.expression, slot_of)});
      }
    }
    for (std::size_t i = 0; i < one.actions.size(); ++i) {
      const auto a = static_cast<std::size_t>(mechanism.cases[c].actions[i].index);
      if (depends.of(one.actions[i].value)) {
        primaries_.push_back({.which = c,
                              .is_motion = false,
                              .primary = i,
                              .kind = kind_of(topology_->actions[a]),
                              .value = SlotExpression(one.actions[i].value.expression, slot_of)});
      }
    }
  }
}

bool Rebinder::rebind_geometry(const Slots& slots, Geometry& geometry) {
  for (MovingCoupling& moving : moving_) {
    const bool is_bound = moving.is_bound_whole ? bind_whole(slots, moving) : place(slots, moving);
    if (!is_bound) {
      return false;
    }
    points_[moving.point] = moving.drawn.at;
  }
  if (!find_extent(points_).origin.isZero(0.0)) {
    return false;
  }
  for (const MovingCoupling& moving : moving_) {
    moving.is_through_point ? move_lines(moving, geometry) : write_screws(moving, geometry);
  }
  return true;
}

bool Rebinder::place(const Slots& slots, MovingCoupling& moving) {
  for (std::size_t i = 0; i < moving.at.size(); ++i) {
    if (!moving.at[i].formula) {
      continue;
    }
    const std::optional<double> coordinate = number_of(
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
  return true;
}

void Rebinder::write_screws(const MovingCoupling& moving, Geometry& geometry) const {
  const CouplingTopology& topology =
      topology_->couplings[static_cast<std::size_t>(moving.coupling)];
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
    const auto actuator = static_cast<std::size_t>(topology_->actions[action].actuator);
    const auto freedom =
        static_cast<std::size_t>(topology_->actuators[actuator].freedom - topology.first_freedom);
    geometry.actions[action] = internal_action<double>(screws.freedoms[freedom], drawn.at).screw;
  }
}

void Rebinder::move_lines(const MovingCoupling& moving, Geometry& geometry) const {
  const CouplingTopology& topology =
      topology_->couplings[static_cast<std::size_t>(moving.coupling)];
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
}

bool Rebinder::rebind_cases(const Slots& slots, std::span<Case> cases) {
  for (const MovingPrimary& one : primaries_) {
    Case& which = cases[one.which];
    const std::optional<double> value =
        number_of(one.value, one.kind, description_->units, slots, scratch_);
    if (!value) {
      return false;
    }
    (one.is_motion ? which.motions : which.actions)[one.primary].value = *value;
  }
  return true;
}

}  // namespace kinestat
