#include "mechanism/bind/derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/dual_vector.hpp"
#include "mechanism/bind/extent.hpp"
#include "mechanism/bind/number_rebinder.hpp"
#include "mechanism/bind/reference_points.hpp"
#include "mechanism/bind/rounding_slopes.hpp"
#include "mechanism/check/expect.hpp"
#include "mechanism/couplings/internal/compliance_binder.hpp"
#include "mechanism/couplings/internal/converter_binder.hpp"
#include "mechanism/couplings/internal/coupling_binder.hpp"
#include "mechanism/couplings/internal/friction_binder.hpp"
#include "mechanism/couplings/reciprocity.hpp"
#include "mechanism/geometry.hpp"
#include "mechanism/inertia/mass_binder.hpp"

namespace kinestat {

namespace {

using DualEvaluator = EvaluatorOf<Dual>;

class DerivativeBinder {
 public:
  DerivativeBinder(const MechanismDescription& description,
                   const Mechanism& mechanism,
                   DualEvaluator& evaluator,
                   Diagnostics& found)
      : description_(description),
        mechanism_(mechanism),
        evaluator_(evaluator),
        found_(found),
        rebinder_(description, mechanism, evaluator, found) {}

  // Also finds which parameters break a coupling.
  void bind_geometries(MechanismDerivatives& result) {
    GeometryOf<Dual>& geometry = result.geometry;
    geometry.origin = mechanism_.geometry.origin;
    geometry.length = mechanism_.geometry.length;
    result.breaks_coupling.assign(result.parameter_count, false);
    std::vector<bool> has_point;
    std::vector<Vec3Of<Dual>> points;
    find_whole_numbers(result.breaks_coupling);
    for (std::size_t e = 0; e < description_.couplings.size(); ++e) {
      const CouplingDescription& coupling = description_.couplings[e];
      CouplingGeometryOf<Dual> drawn = rebinder_.drawn(coupling);
      add_points(coupling, drawn, points);
      add_coupling(e, std::move(drawn), result);
      has_point.push_back(has_place(coupling));
    }
    rebinder_.complete(geometry);
    geometry.references = bind_reference_points<Dual>(
        description_, has_point, mechanism_.topology, geometry, evaluator_);
    drop_rounding(geometry, result.parameter_count);
    result.length = find_length(points, result.parameter_count);
  }

  // Teeth, planets and turns of cables come one by one.
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
      result.frictions.push_back(friction.converter ? converter_of(friction)
                                                    : friction_of(friction.coupling));
      result.frictions.back().planets = friction.planets;
      result.frictions.back().is_balanced = friction.is_balanced;
      result.frictions.back().beside = friction.beside;
    }
  }

  CaseDerivatives bind_case(const CaseDescription& description, const Case& bound) {
    CaseNumbersOf<Dual> numbers = rebinder_.bind_case(description, bound);
    CaseDerivatives result{.motions = std::move(numbers.motions),
                           .actions = std::move(numbers.actions),
                           .loads = std::move(numbers.loads),
                           .accelerations = {}};
    for (const Primary& motion : bound.motions) {
      result.accelerations.emplace_back(0.0);
      for (std::size_t i = 0; bound.accelerations && i < bound.accelerations->size(); ++i) {
        if ((*bound.accelerations)[i].index == motion.index) {
          const bool turns = turns_at(motion.index);
          result.accelerations.back() =
              number(description.accelerations[i].value,
                     turns ? QuantityKind::angular_acceleration : QuantityKind::acceleration);
        }
      }
    }
    return result;
  }

  void bind_masses(MechanismDerivatives& result) {
    result.masses.resize(mechanism_.masses.size());
    for (const BodyDescription& body : description_.bodies) {
      const auto& bodies = mechanism_.topology.bodies;
      const auto at = std::ranges::find(bodies, body.name.text, &BodyTopology::name);
      const auto b = static_cast<std::size_t>(at - bodies.begin());
      if (b < mechanism_.masses.size() && mechanism_.masses[b].counts()) {
        result.masses[b] = mass_of(body, b, result.geometry);
      }
    }
  }

  void bind_springs(MechanismDerivatives& result) {
    for (std::size_t i = 0; i < mechanism_.springs.size(); ++i) {
      result.springs.push_back(spring_of(description_.springs[i], mechanism_.springs[i]));
    }
  }

 private:
  bool turns_at(int freedom) const {
    return mechanism_.topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation;
  }

  Dual number(const Value& value, QuantityKind kind) {
    return expect(evaluator_.number(value, kind));
  }

  Dual number(const std::optional<Value>& value, QuantityKind kind, double otherwise = 0.0) {
    return value ? number(*value, kind) : Dual(otherwise);
  }

  MassNumbersOf<Dual> mass_of(const BodyDescription& body,
                              std::size_t b,
                              const GeometryOf<Dual>& geometry) {
    const Dual count(mechanism_.masses[b].count);
    MassNumbersOf<Dual> result;
    result.mass = count * number(body.mass, QuantityKind::mass);
    if (body.centre_of_mass) {
      result.centre = expect(evaluator_.point(*body.centre_of_mass));
    } else if (const auto bearing =
                   centre_bearing(description_, mechanism_.topology, BodyId{static_cast<int>(b)})) {
      result.centre = geometry.points[static_cast<std::size_t>(bearing->value)];
    }
    if (!body.inertia.empty()) {
      const InertiaDescription& inertia = body.inertia.front();
      std::vector<Dual> entries;
      for (const Value& entry : inertia.entries) {
        entries.push_back(count * number(entry, QuantityKind::inertia));
      }
      std::optional<Vec3Of<Dual>> axis;
      if (inertia.axis) {
        axis = expect(evaluator_.axis(*inertia.axis)).direction;
      }
      result.tensor = inertia_tensor<Dual>(entries, axis);
    }
    return result;
  }

  SpringNumbersOf<Dual> spring_of(const SpringDescription& spring, const Spring& bound) {
    using enum QuantityKind;
    const bool turns = bound.is_of_freedom() && turns_at(bound.freedom);
    const QuantityKind action = turns ? moment : force;
    SpringNumbersOf<Dual> result;
    result.stiffness = number(spring.stiffness, turns ? angular_stiffness : stiffness);
    if (spring.damping) {
      result.damping =
          damping_in_si(expect(evaluator_.quantity(*spring.damping)), turns, description_.units);
    }
    Dual drawn(0.0);
    if (!bound.is_of_freedom()) {
      result.from = end_of(spring, 0);
      result.to = end_of(spring, 1);
      const Vec3Of<Dual> arm = result.to - result.from;
      drawn = sqrt(Dual(arm.squaredNorm()));
    }
    result.free = bound.is_of_freedom() ? number(spring.free, turns ? angle : length)
                  : spring.free_length  ? number(*spring.free_length, length)
                                        : drawn;
    if (spring.drawn && value_of(result.stiffness) > 0.0) {
      result.free = free_by_force(drawn, number(*spring.drawn, action), result.stiffness);
    }
    if (spring.force && !bound.force.law) {
      result.force = number(*spring.force, action);
    }
    if (spring.gas) {
      const GasSpringDescription& gas = *spring.gas;
      const Dual exponent = number(gas.exponent, dimensionless, 1.0);
      result.gas = {.force = number(gas.force, force),
                    .length = number(gas.length, length),
                    .stroke = number(gas.stroke, length),
                    .hold = gas_hold(number(gas.ratio, dimensionless), exponent),
                    .exponent = exponent};
    }
    return result;
  }

  Vec3Of<Dual> end_of(const SpringDescription& spring, std::size_t i) {
    const auto at = std::ranges::find(
        spring.at, spring.bodies[i].text, [](const auto& one) { return one.first.text; });
    return expect(evaluator_.point(at->second));
  }

  CouplingFrictionOf<Dual> converter_of(const CouplingFriction& bound) {
    const auto e = static_cast<std::size_t>(bound.coupling.value);
    auto law = expect(bind_converter<Dual>(description_.couplings[e], evaluator_, found_));
    law.pump = bound.converter->pump;
    law.turbine = bound.converter->turbine;
    law.stator = bound.converter->stator;
    CouplingFrictionOf<Dual> result;
    result.coupling = bound.coupling;
    result.converter = std::make_shared<const ConverterLawOf<Dual>>(std::move(law));
    return result;
  }

  // Without the cables, which are not differentiated.
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

  // A coefficient of zero is no friction, and cannot become smaller.
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
    const auto screws = rebinder_.add_coupling(e, std::move(geometry), result.geometry);
    if (coupling.type == CouplingType::screws || coupling.screw) {
      find_breaking_parameters(screws, result.breaks_coupling);
    }
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  DualEvaluator& evaluator_;
  Diagnostics& found_;
  NumberRebinder<Dual> rebinder_;
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
  binder.bind_masses(result);
  binder.bind_springs(result);
  result.compliances = bind_compliances<Dual>(description, mechanism.topology, evaluator);
  for (std::size_t c = 0; c < mechanism.cases.size(); ++c) {
    result.cases.push_back(binder.bind_case(description.cases[c], mechanism.cases[c]));
  }
  return result;
}

}  // namespace kinestat
