// Before what takes moments of lines for any type of number.
#include "mechanism/bind/number_rebinder.hpp"

#include <algorithm>
#include <utility>

#include "core/contract.hpp"
#include "couplings/coupling_catalogue.hpp"
#include "mechanism/bind/tooth_rules.hpp"
#include "mechanism/check/expect.hpp"
#include "mechanism/gears/planet_weight.hpp"
#include "mechanism/label_kind.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

template <class Scalar>
CouplingGeometryOf<Scalar> NumberRebinder<Scalar>::drawn(const CouplingDescription& coupling) {
  return expect(bind_geometry<Scalar>(
      coupling, description_.space, gears_ ? &*gears_ : nullptr, evaluator_, found_));
}

template <class Scalar>
CouplingScrewsOf<Scalar> NumberRebinder<Scalar>::add_coupling(std::size_t e,
                                                              CouplingGeometryOf<Scalar> geometry,
                                                              GeometryOf<Scalar>& result) const {
  const CouplingDescription& coupling = description_.couplings[e];
  const CouplingTopology& topology = mechanism_.topology.couplings[e];
  result.points.push_back(geometry.at);
  const auto screws = coupling_screws<Scalar>(coupling.type, description_.space, geometry);
  for (const NamedTwistOf<Scalar>& freedom : screws.freedoms) {
    result.motions.push_back(freedom.screw);
  }
  const bool is_in_space =
      mechanism_.static_order == OrderChoice::spatial && !coupling.passive.has_value();
  const auto constraints =
      is_in_space ? coupling_screws<Scalar>(coupling.type, Space::spatial, geometry).constraints
                  : screws.constraints;
  for (int a = topology.first_action; a < topology.first_action + topology.action_count; ++a) {
    add_action(a, topology, screws, constraints, geometry.at, result);
  }
  const bool bears =
      topology.action_count > 0 &&
      mechanism_.topology.actions[static_cast<std::size_t>(topology.first_action)].actuator < 0;
  if (geometry.other_flank && bears) {
    geometry.line_of_action = *geometry.other_flank;
    const auto other = coupling_screws<Scalar>(coupling.type, flank_space(), geometry);
    result.other_flanks.push_back(
        {.action = topology.first_action, .screw = other.constraints.front().screw});
  }
  return screws;
}

template <class Scalar>
void NumberRebinder<Scalar>::complete(GeometryOf<Scalar>& result) const {
  complete_flanks<Scalar>(mechanism_.tooth_rules, mechanism_.topology, result);
}

template <class Scalar>
CaseNumbersOf<Scalar> NumberRebinder<Scalar>::bind_case(const CaseDescription& description,
                                                        const Case& bound) {
  const Topology& topology = mechanism_.topology;
  CaseNumbersOf<Scalar> result;
  for (std::size_t i = 0; i < bound.motions.size(); ++i) {
    const auto f = static_cast<std::size_t>(bound.motions[i].index);
    result.motions.push_back(number(description.motions[i].value, kind_of(topology.freedoms[f])));
  }
  for (std::size_t i = 0; i < bound.actions.size(); ++i) {
    const auto a = static_cast<std::size_t>(bound.actions[i].index);
    const bool moves = bound.actions[i].moves();  // and is no number yet
    result.actions.push_back(
        moves ? Scalar(bound.actions[i].value)
              : number(description.actions[i].value, kind_of(topology.actions[a])));
  }
  for (const Load& load : bound.loads) {
    result.loads.push_back(bind_load(load, description));
  }
  return result;
}

template <class Scalar>
Scalar NumberRebinder<Scalar>::number(const Value& value, QuantityKind kind) {
  return expect(evaluator_.number(value, kind));
}

// A vector without components is zero.
template <class Scalar>
Vec3Of<Scalar> NumberRebinder<Scalar>::vector(const std::vector<Value>& components,
                                              QuantityKind kind) {
  return expect(evaluator_.vector(components, kind));
}

template <class Scalar>
WrenchOf<Scalar> NumberRebinder<Scalar>::force_at(const Vec3Of<Scalar>& point,
                                                  const Vec3Of<Scalar>& force) const {
  return {.moment = point.cross(force), .force = force};
}

// That of the case counts before that of the file; what neither has is the weight of a body.
template <class Scalar>
WrenchOf<Scalar> NumberRebinder<Scalar>::bind_load(const Load& load,
                                                   const CaseDescription& description) {
  for (const auto* list : {&description.loads, &description_.loads}) {
    for (const LoadDescription& one : *list) {
      if (one.name.text == load.name) {
        return bind_load(one);
      }
    }
  }
  const std::string body = load.name.substr(kWeightPrefix.size());
  const auto at = std::ranges::find(
      description_.bodies, body, [](const BodyDescription& one) { return one.name.text; });
  KINESTAT_EXPECTS(at != description_.bodies.end());
  const auto& bodies = mechanism_.topology.bodies;
  const auto b = std::ranges::find(bodies, body, &BodyTopology::name) - bodies.begin();
  const int count = mechanism_.masses[static_cast<std::size_t>(b)].count;
  const Scalar mass = Scalar(count) * number(*at->mass, QuantityKind::mass);
  const Vec3Of<Scalar> gravity =
      vector(description_.gravity->coordinates, QuantityKind::acceleration);
  KINESTAT_EXPECTS(gears_.has_value() || (at->centre_of_mass && count == 1));
  Vec3Of<Scalar> place =
      at->centre_of_mass
          ? expect(evaluator_.point(*at->centre_of_mass))
          : place_on_axis<Scalar>(gears_->layout, gears_->layout.train.axis_on(body), evaluator_);
  if (count > 1) {
    place = place_of_planet_weights<Scalar>(gears_->layout, body, evaluator_, place);
  }
  return force_at(place, mass * gravity);
}

template <class Scalar>
WrenchOf<Scalar> NumberRebinder<Scalar>::bind_load(const LoadDescription& load) {
  WrenchOf<Scalar> result;
  if (load.at && load.force) {
    result = force_at(expect(evaluator_.point(*load.at)),
                      vector(load.force->coordinates, QuantityKind::force));
  }
  const Vec3Of<Scalar> couple = vector(load.couple, QuantityKind::moment);
  if (load.couple.size() == 1) {
    result.moment[2] = result.moment[2] + couple[0];
  } else {
    result.moment = result.moment + couple;
  }
  return result;
}

template <class Scalar>
Space NumberRebinder<Scalar>::flank_space() const {
  return mechanism_.static_order == OrderChoice::spatial ? Space::spatial : description_.space;
}

// By its name, as `passive` may have left some out.
template <class Scalar>
void NumberRebinder<Scalar>::add_action(int action,
                                        const CouplingTopology& coupling,
                                        const CouplingScrewsOf<Scalar>& screws,
                                        const std::vector<NamedWrenchOf<Scalar>>& constraints,
                                        const Vec3Of<Scalar>& at,
                                        GeometryOf<Scalar>& result) const {
  const ActionLabel& label = mechanism_.topology.actions[static_cast<std::size_t>(action)];
  if (label.actuator < 0) {
    const auto found = std::ranges::find(constraints, label.name, &NamedWrenchOf<Scalar>::name);
    KINESTAT_EXPECTS(found != constraints.end());
    result.actions.push_back(found->screw);
    return;
  }
  const ActuatorTopology& actuator =
      mechanism_.topology.actuators[static_cast<std::size_t>(label.actuator)];
  const auto freedom = static_cast<std::size_t>(actuator.freedom - coupling.first_freedom);
  result.actions.push_back(internal_action<Scalar>(screws.freedoms[freedom], at).screw);
}

template class NumberRebinder<Dual>;
template class NumberRebinder<ExactInput>;

}  // namespace kinestat
