// Before what takes moments of lines for any type of number.
#include "mechanism/bind/typed_mechanism.hpp"

#include "mechanism/bind/number_rebinder.hpp"
#include "screw/typed_vector.hpp"

namespace kinestat {

namespace {

template <class Screw>
TypedScrew typed_screw(const Screw& screw) {
  const Vec6Of<Typed> coordinates = screw.coordinates();
  TypedScrew result;
  for (std::size_t i = 0; i < 6; ++i) {
    result[i] = coordinates[static_cast<Eigen::Index>(i)];
  }
  return result;
}

TypedCase typed_case(CaseNumbersOf<Typed> numbers) {
  TypedCase result{
      .motions = std::move(numbers.motions), .actions = std::move(numbers.actions), .loads = {}};
  for (const WrenchOf<Typed>& load : numbers.loads) {
    result.loads.push_back(typed_screw(load));
  }
  return result;
}

}  // namespace

std::optional<TypedMechanism> bind_typed(const MechanismDescription& description,
                                         const Mechanism& mechanism) {
  Diagnostics found;
  EvaluatorOf<Typed> evaluator(
      description, evaluate_parameters<Typed>(parameters_of(description)).table, found);
  NumberRebinder<Typed> rebinder(description, mechanism, evaluator, found);
  GeometryOf<Typed> geometry;
  geometry.origin = mechanism.geometry.origin;
  geometry.length = mechanism.geometry.length;
  for (std::size_t e = 0; e < description.couplings.size(); ++e) {
    (void)rebinder.add_coupling(e, rebinder.drawn(description.couplings[e]), geometry);
  }
  TypedMechanism result;
  for (const TwistOf<Typed>& motion : geometry.motions) {
    result.motions.push_back(typed_screw(motion));
  }
  for (const WrenchOf<Typed>& action : geometry.actions) {
    result.actions.push_back(typed_screw(action));
  }
  for (const OtherFlankOf<Typed>& flank : geometry.other_flanks) {
    result.other_flanks.push_back(typed_screw(flank.screw));
  }
  for (std::size_t c = 0; c < mechanism.cases.size(); ++c) {
    result.cases.push_back(
        typed_case(rebinder.bind_case(description.cases[c], mechanism.cases[c])));
  }
  return found.has_errors() ? std::nullopt : std::optional(std::move(result));
}

}  // namespace kinestat
