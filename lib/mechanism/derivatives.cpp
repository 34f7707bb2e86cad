#include "mechanism/derivatives.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "mechanism/coupling_catalogue.hpp"
#include "mechanism/internal/coupling_binder.hpp"
#include "mechanism/internal/friction_binder.hpp"
#include "mechanism/internal/reference_points.hpp"
#include "mechanism/internal/rounding_slopes.hpp"
#include "mechanism/reciprocity.hpp"

namespace kinestat {

namespace {

using DualEvaluator = EvaluatorOf<Dual>;

// The answer of a description that was right when it was bound to plain numbers.
template <class Item>
Item expect(const std::optional<Item>& answer) {
  KINESTAT_EXPECTS(answer.has_value());
  return *answer;
}

class DerivativeBinder {
 public:
  DerivativeBinder(const MechanismDescription& description,
                   const Mechanism& mechanism,
                   DualEvaluator& evaluator,
                   Diagnostics& found)
      : description_(description), mechanism_(mechanism), evaluator_(evaluator), found_(found) {}

  // Also finds which parameters break a coupling.
  GeometryOf<Dual> bind_geometries(std::vector<bool>& breaks) {
    GeometryOf<Dual> result;
    result.origin = mechanism_.geometry.origin;
    result.length = mechanism_.geometry.length;
    std::vector<bool> has_point;
    for (std::size_t e = 0; e < description_.couplings.size(); ++e) {
      add_coupling(description_.couplings[e], mechanism_.topology.couplings[e], result, breaks);
      has_point.push_back(has_place(description_.couplings[e]));
    }
    result.references = bind_reference_points<Dual>(
        description_, has_point, mechanism_.topology, result, evaluator_);
    drop_rounding(result, breaks.size());
    return result;
  }

  void bind_frictions(MechanismDerivatives& result) {
    result.starts_friction.assign(result.parameter_count, false);
    for (std::size_t e = 0; e < description_.couplings.size(); ++e) {
      if (has_friction_law(description_.couplings[e]) && description_.couplings[e].friction) {
        find_starts(friction_of(CouplingId{static_cast<int>(e)}), result.starts_friction);
      }
    }
    for (const CouplingFriction& friction : mechanism_.frictions) {
      result.frictions.push_back(friction_of(friction.coupling));
    }
  }

  CaseDerivatives bind_case(const CaseDescription& description, const Case& bound) {
    const Topology& topology = mechanism_.topology;
    CaseDerivatives result;
    for (std::size_t i = 0; i < bound.motions.size(); ++i) {
      const auto f = static_cast<std::size_t>(bound.motions[i].index);
      result.motions.push_back(number(description.motions[i].value,
                                      topology.freedoms[f].is_rotation
                                          ? QuantityKind::angular_velocity
                                          : QuantityKind::velocity));
    }
    for (std::size_t i = 0; i < bound.actions.size(); ++i) {
      const auto a = static_cast<std::size_t>(bound.actions[i].index);
      result.actions.push_back(
          number(description.actions[i].value,
                 topology.actions[a].is_couple ? QuantityKind::moment : QuantityKind::force));
    }
    for (const Load& load : bound.loads) {
      result.loads.push_back(bind_load(load, description));
    }
    return result;
  }

 private:
  // A vector without components is zero.
  Vec3Of<Dual> vector(const std::vector<Value>& components, QuantityKind kind) {
    return expect(evaluator_.vector(components, kind));
  }

  WrenchOf<Dual> force_at(const Vec3Of<Dual>& point, const Vec3Of<Dual>& force) const {
    const Vec3Of<Dual> arm = point - mechanism_.geometry.origin.cast<Dual>();
    return {.moment = arm.cross(force), .force = force};
  }

  // That of the case counts before that of the file; what neither has is the weight of a body.
  WrenchOf<Dual> bind_load(const Load& load, const CaseDescription& description) {
    for (const auto* list : {&description.loads, &description_.loads}) {
      for (const LoadDescription& one : *list) {
        if (one.name.text == load.name) {
          return bind_load(one);
        }
      }
    }
    const std::string body = mechanism_.topology.body(load.acts.body).name;
    const auto at = std::ranges::find(
        description_.bodies, body, [](const BodyDescription& one) { return one.name.text; });
    KINESTAT_EXPECTS(at != description_.bodies.end());
    const Dual mass = number(*at->mass, QuantityKind::mass);
    const Vec3Of<Dual> gravity =
        vector(description_.gravity->coordinates, QuantityKind::acceleration);
    return force_at(vector(at->centre_of_mass->coordinates, QuantityKind::length), mass * gravity);
  }

  WrenchOf<Dual> bind_load(const LoadDescription& load) {
    WrenchOf<Dual> result;
    if (load.at && load.force) {
      result = force_at(vector(load.at->coordinates, QuantityKind::length),
                        vector(load.force->coordinates, QuantityKind::force));
    }
    const Vec3Of<Dual> couple = vector(load.couple, QuantityKind::moment);
    if (load.couple.size() == 1) {
      result.moment[2] = result.moment[2] + couple[0];
    } else {
      result.moment = result.moment + couple;
    }
    return result;
  }

  Dual number(const Value& value, QuantityKind kind) {
    return expect(evaluator_.number(value, kind));
  }

  // Without the ropes, which are not differentiated.
  CouplingFrictionOf<Dual> friction_of(CouplingId id) {
    const CouplingDescription& coupling =
        description_.couplings[static_cast<std::size_t>(id.value)];
    if (!coupling.friction) {
      CouplingFrictionOf<Dual> result;
      result.coupling = id;
      return result;
    }
    return read_friction<Dual>(coupling, id, description_.units, evaluator_, found_);
  }

  // What is zero rubs not at all, and cannot become smaller.
  static void find_starts(const CouplingFrictionOf<Dual>& friction, std::vector<bool>& starts) {
    for (const Dual* number : {&friction.mu,
                               &friction.radius,
                               &friction.thrust_radius,
                               &friction.tau,
                               &friction.viscous}) {
      for (std::size_t p = 0; p < starts.size() && number->value == 0.0; ++p) {
        starts[p] = starts[p] || derivative(*number, p) != 0.0;
      }
    }
  }

  void add_coupling(const CouplingDescription& coupling,
                    const CouplingTopology& topology,
                    GeometryOf<Dual>& result,
                    std::vector<bool>& breaks) {
    CouplingGeometryOf<Dual> geometry =
        expect(bind_geometry<Dual>(coupling, description_.space, evaluator_, found_));
    if (!has_place(coupling)) {
      geometry.at = result.origin.cast<Dual>();
    }
    result.points.push_back(geometry.at);
    geometry = measured_from<Dual>(result.origin.cast<Dual>(), std::move(geometry));
    const auto screws = coupling_screws<Dual>(coupling.type, description_.space, geometry);
    for (const NamedTwistOf<Dual>& freedom : screws.freedoms) {
      result.motions.push_back(freedom.screw);
    }
    if (coupling.type == CouplingType::screws || coupling.screw) {
      find_breaking_parameters(screws, breaks);
    }
    const bool is_in_space =
        mechanism_.static_order == OrderChoice::spatial && !coupling.passive.has_value();
    const auto constraints =
        is_in_space ? coupling_screws<Dual>(coupling.type, Space::spatial, geometry).constraints
                    : screws.constraints;
    for (int a = topology.first_action; a < topology.first_action + topology.action_count; ++a) {
      add_action(a, topology, screws, constraints, geometry.at, result);
    }
  }

  // By its name, as `passive` may have left some out.
  void add_action(int action,
                  const CouplingTopology& coupling,
                  const CouplingScrewsOf<Dual>& screws,
                  const std::vector<NamedWrenchOf<Dual>>& constraints,
                  const Vec3Of<Dual>& at,
                  GeometryOf<Dual>& result) const {
    const ActionLabel& label = mechanism_.topology.actions[static_cast<std::size_t>(action)];
    if (label.actuator < 0) {
      const auto found = std::ranges::find(constraints, label.name, &NamedWrenchOf<Dual>::name);
      KINESTAT_EXPECTS(found != constraints.end());
      result.actions.push_back(found->screw);
      return;
    }
    const ActuatorTopology& actuator =
        mechanism_.topology.actuators[static_cast<std::size_t>(label.actuator)];
    const auto freedom = static_cast<std::size_t>(actuator.freedom - coupling.first_freedom);
    result.actions.push_back(internal_action<Dual>(screws.freedoms[freedom], at).screw);
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  DualEvaluator& evaluator_;
  Diagnostics& found_;
};

}  // namespace

MechanismDerivatives bind_derivatives(const MechanismDescription& description,
                                      const Mechanism& mechanism,
                                      std::span<const int> parameters) {
  Diagnostics found;
  DualEvaluator evaluator(
      description, evaluate_parameters(parameters_of(description), parameters).table, found);
  DerivativeBinder binder(description, mechanism, evaluator, found);
  MechanismDerivatives result;
  result.parameter_count = parameters.size();
  result.breaks_coupling.assign(parameters.size(), false);
  result.geometry = binder.bind_geometries(result.breaks_coupling);
  binder.bind_frictions(result);
  for (std::size_t c = 0; c < mechanism.cases.size(); ++c) {
    result.cases.push_back(binder.bind_case(description.cases[c], mechanism.cases[c]));
  }
  return result;
}

}  // namespace kinestat
