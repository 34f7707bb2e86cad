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
    }
  }

  CaseDerivatives bind_case(const CaseDescription& description, const Case& bound) {
    CaseNumbersOf<Dual> numbers = rebinder_.bind_case(description, bound);
    return {.motions = std::move(numbers.motions),
            .actions = std::move(numbers.actions),
            .loads = std::move(numbers.loads)};
  }

 private:
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
  result.compliances = bind_compliances<Dual>(description, mechanism.topology, evaluator);
  for (std::size_t c = 0; c < mechanism.cases.size(); ++c) {
    result.cases.push_back(binder.bind_case(description.cases[c], mechanism.cases[c]));
  }
  return result;
}

}  // namespace kinestat
