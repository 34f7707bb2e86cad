// Before what takes moments of lines for any type of number.
#include "mechanism/bind/exact_input_mechanism.hpp"

#include "mechanism/bind/number_rebinder.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

template <class Screw>
ExactInputScrew exact_input_screw(const Screw& screw) {
  const Vec6Of<ExactInput> coordinates = screw.coordinates();
  ExactInputScrew result;
  for (std::size_t i = 0; i < 6; ++i) {
    result[i] = coordinates[static_cast<Eigen::Index>(i)];
  }
  return result;
}

ExactInputCase exact_input_case(CaseNumbersOf<ExactInput> numbers) {
  ExactInputCase result{
      .motions = std::move(numbers.motions), .actions = std::move(numbers.actions), .loads = {}};
  for (const WrenchOf<ExactInput>& load : numbers.loads) {
    result.loads.push_back(exact_input_screw(load));
  }
  return result;
}

}  // namespace

std::optional<ExactInputMechanism> bind_exact_input(const MechanismDescription& description,
                                                    const Mechanism& mechanism,
                                                    Diagnostics& found) {
  const int errors_before = found.error_count();
  EvaluatorOf<ExactInput> evaluator(
      description, evaluate_parameters<ExactInput>(parameters_of(description)).table, found);
  NumberRebinder<ExactInput> rebinder(description, mechanism, evaluator, found);
  GeometryOf<ExactInput> geometry;
  geometry.origin = mechanism.geometry.origin;
  geometry.length = mechanism.geometry.length;
  for (std::size_t e = 0; e < description.couplings.size(); ++e) {
    (void)rebinder.add_coupling(e, rebinder.drawn(description.couplings[e]), geometry);
  }
  rebinder.complete(geometry);
  ExactInputMechanism result;
  for (const TwistOf<ExactInput>& motion : geometry.motions) {
    result.motions.push_back(exact_input_screw(motion));
  }
  for (const WrenchOf<ExactInput>& action : geometry.actions) {
    result.actions.push_back(exact_input_screw(action));
  }
  for (const OtherFlankOf<ExactInput>& flank : geometry.other_flanks) {
    result.other_flanks.push_back(exact_input_screw(flank.screw));
  }
  for (std::size_t c = 0; c < mechanism.cases.size(); ++c) {
    result.cases.push_back(
        exact_input_case(rebinder.bind_case(description.cases[c], mechanism.cases[c])));
  }
  evaluator.refuse_values_by_rounding();
  return found.error_count() == errors_before ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace kinestat
