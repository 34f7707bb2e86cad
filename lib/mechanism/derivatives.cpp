#include "mechanism/derivatives.hpp"

#include <algorithm>
#include <utility>

#include "core/contract.hpp"
#include "mechanism/coupling_catalogue.hpp"
#include "mechanism/internal/compliance_binder.hpp"
#include "mechanism/internal/coupling_binder.hpp"
#include "mechanism/internal/extent.hpp"
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
  void bind_geometries(MechanismDerivatives& result) {
    GeometryOf<Dual>& geometry = result.geometry;
    geometry.origin = mechanism_.geometry.origin;
    geometry.length = mechanism_.geometry.length;
    result.breaks_coupling.assign(result.parameter_count, false);
    std::vector<bool> has_point;
    std::vector<Vec3Of<Dual>> points;
    gears_ = bind_gear_frame<Dual>(description_, evaluator_);
    find_whole_numbers(result.breaks_coupling);
    for (std::size_t e = 0; e < description_.couplings.size(); ++e) {
      const CouplingDescription& coupling = description_.couplings[e];
      CouplingGeometryOf<Dual> drawn = expect(bind_geometry<Dual>(
          coupling, description_.space, gears_ ? &*gears_ : nullptr, evaluator_, found_));
      add_points(coupling, drawn, points);
      add_coupling(e, std::move(drawn), result);
      has_point.push_back(has_place(coupling));
    }
    geometry.references = bind_reference_points<Dual>(
        description_, has_point, mechanism_.topology, geometry, evaluator_);
    drop_rounding(geometry, result.parameter_count);
    result.length = find_length(points, result.parameter_count);
  }

  // Teeth, planets and turns of ropes come one by one.
  void find_whole_numbers(std::vector<bool>& breaks) {
    if (description_.gears) {
      for (const GearMember& member : description_.gears->members) {
        add_whole_number(member.teeth, breaks);
        add_whole_number(member.count, breaks);
      }
    }
    for (const CableDescription& cable : description_.cables) {
      for (const CableStation& station : cable.over) {
        add_whole_number(station.turns, breaks);
      }
    }
  }

  void add_whole_number(const std::optional<Value>& value, std::vector<bool>& breaks) {
    if (!value) {
      return;
    }
    const Dual number = expect(evaluator_.number(*value, QuantityKind::dimensionless));
    for (std::size_t p = 0; p < breaks.size(); ++p) {
      breaks[p] = breaks[p] || derivative(number, p) != 0.0;
    }
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

  void add_coupling(std::size_t e,
                    CouplingGeometryOf<Dual> geometry,
                    MechanismDerivatives& result) {
    const CouplingDescription& coupling = description_.couplings[e];
    const CouplingTopology& topology = mechanism_.topology.couplings[e];
    const Vec3Of<Dual> origin = result.geometry.origin.cast<Dual>();
    if (!has_place(coupling)) {
      geometry.at = origin;
    }
    result.geometry.points.push_back(geometry.at);
    geometry = measured_from<Dual>(origin, std::move(geometry));
    const auto screws = coupling_screws<Dual>(coupling.type, description_.space, geometry);
    for (const NamedTwistOf<Dual>& freedom : screws.freedoms) {
      result.geometry.motions.push_back(freedom.screw);
    }
    if (coupling.type == CouplingType::screws || coupling.screw) {
      find_breaking_parameters(screws, result.breaks_coupling);
    }
    const bool is_in_space =
        mechanism_.static_order == OrderChoice::spatial && !coupling.passive.has_value();
    const auto constraints =
        is_in_space ? coupling_screws<Dual>(coupling.type, Space::spatial, geometry).constraints
                    : screws.constraints;
    for (int a = topology.first_action; a < topology.first_action + topology.action_count; ++a) {
      add_action(a, topology, screws, constraints, geometry.at, result.geometry);
    }
    if (geometry.other_flank) {
      geometry.line_of_action = *geometry.other_flank;
      const auto other = coupling_screws<Dual>(coupling.type, flank_space(), geometry);
      result.geometry.other_flanks.push_back(
          {.action = topology.first_action, .screw = other.constraints.front().screw});
    }
  }

  Space flank_space() const {
    return mechanism_.static_order == OrderChoice::spatial ? Space::spatial : description_.space;
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
  std::optional<GearFrameOf<Dual>> gears_;
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
  binder.bind_geometries(result);
  binder.bind_frictions(result);
  result.compliances = bind_compliances<Dual>(description, mechanism.topology, evaluator);
  for (std::size_t c = 0; c < mechanism.cases.size(); ++c) {
    result.cases.push_back(binder.bind_case(description.cases[c], mechanism.cases[c]));
  }
  return result;
}

}  // namespace kinestat
