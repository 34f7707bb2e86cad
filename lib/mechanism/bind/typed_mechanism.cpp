// Before what takes moments of lines for any type of number.
#include "mechanism/bind/typed_mechanism.hpp"

#include "mechanism/bind/bind.hpp"
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

template <class Screw>
bool round_screw(const TypedScrew& typed, Screw& screw) {
  Vec6 coordinates;
  for (std::size_t i = 0; i < 6; ++i) {
    if (!typed[i].precise) {
      return false;
    }
    coordinates[static_cast<Eigen::Index>(i)] = static_cast<double>(*typed[i].precise);
  }
  screw = Screw::from_coordinates(coordinates);
  return true;
}

template <class Screw>
bool round_screws(const std::vector<TypedScrew>& typed, std::vector<Screw>& screws) {
  for (std::size_t i = 0; i < screws.size(); ++i) {
    if (!round_screw(typed[i], screws[i])) {
      return false;
    }
  }
  return true;
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

std::optional<Mechanism> rounded_nearby(const MechanismDescription& description,
                                        const Mechanism& mechanism,
                                        bool is_in_space) {
  if (mechanism.geometry.origin.isZero(0.0) || (is_in_space && frees_more_in_space(description))) {
    return std::nullopt;
  }
  Mechanism result = mechanism;
  result.cases.clear();
  if (is_in_space) {
    result.static_order = OrderChoice::spatial;  // by which what couplings bear in space is read
  }
  const std::optional<TypedMechanism> typed = bind_typed(description, result);
  result.static_order = mechanism.static_order;
  result.cases = mechanism.cases;
  Geometry& geometry = result.geometry;
  if (!typed || typed->motions.size() != geometry.motions.size() ||
      typed->actions.size() != geometry.actions.size() ||
      !round_screws(typed->motions, geometry.motions) ||
      !round_screws(typed->actions, geometry.actions)) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < geometry.other_flanks.size(); ++i) {
    if (!round_screw(typed->other_flanks[i], geometry.other_flanks[i].screw)) {
      return std::nullopt;
    }
  }
  return result;
}

}  // namespace kinestat
