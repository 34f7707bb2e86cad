#include "cases/free_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cases/case_passes.hpp"
#include "core/rounding.hpp"
#include "expression/parameters.hpp"
#include "kinematics/bounded_motion.hpp"
#include "mechanism/bind/bind.hpp"
#include "statics/coupling_wrenches.hpp"
#include "studies/sensitivity/equation_rounding.hpp"

namespace kinestat {

namespace {

// A free parameter with its unit in the file, so that it can be typed again with another value.
struct Probed {
  std::size_t index = 0;  ///< in the description
  FreeParameter parameter;
  std::string unit;
};

// How far a parameter is moved: its own size, but no less than the mechanism's for a length or a
// bare number, which mostly is one, and than one unit or radian for the rest; a bend would hide
// below rounding if a small value were moved by itself alone.
double step_of(double value, const Quantity& quantity, const FileUnits& units, double length) {
  const Dimension& dimension = quantity.dimension;
  const bool is_length = is_bare(dimension) || dimension == dimension_of(QuantityKind::length);
  const bool is_angle = dimension == dimension_of(QuantityKind::angle);
  const double least = is_length  ? units.from_si(QuantityKind::length, length)
                       : is_angle ? units.from_si(QuantityKind::angle, 1.0)
                                  : 1.0;
  return std::max(std::abs(value), least);
}

std::vector<Probed> find_free(const Analysis& analysis) {
  const MechanismDescription& description = analysis.description;
  const ParameterTable table = evaluate_parameters(parameters_of(description)).table;
  const double length = analysis.mechanism.geometry.length;
  std::vector<Probed> result;
  for (std::size_t i = 0; i < description.parameters.size(); ++i) {
    const ParameterDescription& parameter = description.parameters[i];
    const Quantity* value = parameter.is_free ? table.find(parameter.name.text) : nullptr;
    if (value != nullptr) {
      const NamedUnit unit = description.units.unit_of(value->dimension);
      const double number = unit.scale.from_si(value->value);
      result.push_back({.index = i,
                        .parameter = {.value = number,
                                      .step = step_of(number, *value, description.units, length)},
                        .unit = unit.text});
    }
  }
  return result;
}

// The mechanism with some values of the free parameters, and its cases.
struct Probe {
  Mechanism mechanism;
  std::vector<CaseAnalysis> cases;
};

// The rates and actions of the cases with the free parameters at other values; empty if they cannot
// be bound.
std::optional<Probe> solve_at(const MechanismDescription& description,
                              const std::vector<Probed>& free,
                              const std::vector<double>& values) {
  MechanismDescription moved = description;
  for (std::size_t i = 0; i < free.size(); ++i) {
    auto parsed =
        parse_expression(free[i].unit.empty() ? fmt::format("{}", values[i])
                                              : fmt::format("{}*{}", values[i], free[i].unit));
    if (!std::holds_alternative<Expression>(parsed)) {
      return std::nullopt;  // beyond what a number can be
    }
    moved.parameters[free[i].index].value.expression = std::get<Expression>(std::move(parsed));
  }
  Diagnostics ignored;
  std::optional<Mechanism> mechanism = bind(moved, ignored);
  if (!mechanism) {
    return std::nullopt;
  }
  std::vector<CaseAnalysis> cases =
      solve_case_passes(*mechanism, mechanism->cases, CasePasses::magnitudes);
  return Probe{.mechanism = *std::move(mechanism), .cases = std::move(cases)};
}

// Each probe rounds the numbers of the file anew: those of the equations, and the magnitude itself.
BoundedNumber rounded_anew(const BoundedNumber& number, double by_equations) {
  return {.value = number.value,
          .bound = number.bound + by_equations + kDataRounding * std::abs(number.value)};
}

Magnitudes rates_of(const Mechanism& mechanism, const CaseAnalysis& one) {
  if (!one.motion || one.motion->rates.empty()) {
    return std::nullopt;
  }
  const std::vector<double> by_equations = rate_rounding(mechanism, one.which, *one.motion);
  std::vector<BoundedNumber> rates;
  for (std::size_t f = 0; f < by_equations.size(); ++f) {
    const BoundedNumber rate = bounded_rate(*one.motion, static_cast<int>(f));
    rates.push_back(rounded_anew(rate, by_equations[f]));
  }
  return rates;
}

// An action that equilibrium leaves open is no number, and so is not affine.
Magnitudes actions_of(const Mechanism& drawn, const CaseAnalysis& one) {
  if (!one.action || one.action->magnitudes.empty()) {
    return std::nullopt;
  }
  std::optional<Mechanism> on_coast_flanks;
  if (!one.coast_flanks.empty()) {
    on_coast_flanks = drawn;
    load_coast_flanks(one.coast_flanks, on_coast_flanks->geometry);
  }
  const Mechanism& mechanism = on_coast_flanks ? *on_coast_flanks : drawn;
  const std::vector<double> by_equations = action_rounding(mechanism, one.which, *one.action);
  std::vector<BoundedNumber> actions;
  for (std::size_t a = 0; a < by_equations.size(); ++a) {
    actions.push_back(
        one.action->magnitudes[a].has_value()
            ? rounded_anew(bounded_action(*one.action, static_cast<int>(a)), by_equations[a])
            : BoundedNumber{.value = std::numeric_limits<double>::quiet_NaN()});
  }
  return actions;
}

// Of each magnitude the largest of its kind at any probe: is_first says which of two kinds it is.
template <class IsFirst>
std::vector<double> scales(const std::vector<Magnitudes>& probes, const IsFirst& is_first) {
  double largest[2] = {0.0, 0.0};
  const auto kind = [&](std::size_t m) { return is_first(m) ? 0U : 1U; };
  for (const Magnitudes& values : probes) {
    for (std::size_t m = 0; values && m < values->size(); ++m) {
      const double value = (*values)[m].value;
      if (std::isfinite(value)) {
        largest[kind(m)] = std::max(largest[kind(m)], std::abs(value));
      }
    }
  }
  std::vector<double> result;
  for (std::size_t m = 0; probes[0] && m < probes[0]->size(); ++m) {
    result.push_back(largest[kind(m)]);
  }
  return result;
}

// Those that depend on a parameter, or do so in another way than affinely.
template <class IsFirst>
std::vector<AffineMagnitude> fit(const std::vector<FreeParameter>& parameters,
                                 const std::vector<Magnitudes>& probes,
                                 const IsFirst& is_first) {
  std::vector<AffineMagnitude> result;
  const std::vector<std::optional<AffineValue>> fits =
      fit_affine(parameters, probes, scales(probes, is_first));
  for (std::size_t m = 0; m < fits.size(); ++m) {
    const bool has_value = std::isfinite((*probes[0])[m].value);
    const bool is_constant =
        fits[m] && std::ranges::all_of(fits[m]->coefficients, [](double c) { return c == 0.0; });
    if (has_value && !is_constant) {
      result.push_back({.index = static_cast<int>(m), .value = fits[m]});
    }
  }
  return result;
}

}  // namespace

void find_affine_dependence(Analysis& analysis) {
  const std::vector<Probed> free = find_free(analysis);
  if (free.empty() || analysis.cases.empty()) {
    return;
  }
  std::vector<FreeParameter> parameters;
  for (const Probed& one : free) {
    parameters.push_back(one.parameter);
    analysis.free_parameters.push_back(
        {.name = analysis.description.parameters[one.index].name.text, .unit = one.unit});
  }
  std::vector<std::optional<Probe>> probes;
  for (const std::vector<double>& values : affine_probes(parameters)) {
    probes.push_back(probes.empty()
                         ? Probe{.mechanism = analysis.mechanism, .cases = analysis.cases}
                         : solve_at(analysis.description, free, values));
  }
  const Topology& topology = analysis.mechanism.topology;
  for (std::size_t c = 0; c < analysis.cases.size(); ++c) {
    std::vector<Magnitudes> rates;
    std::vector<Magnitudes> actions;
    for (const std::optional<Probe>& probe : probes) {
      rates.push_back(probe ? rates_of(probe->mechanism, probe->cases[c]) : std::nullopt);
      actions.push_back(probe ? actions_of(probe->mechanism, probe->cases[c]) : std::nullopt);
    }
    analysis.cases[c].affine_rates =
        fit(parameters, rates, [&](std::size_t f) { return topology.freedoms[f].is_rotation; });
    analysis.cases[c].affine_actions =
        fit(parameters, actions, [&](std::size_t a) { return topology.actions[a].is_couple; });
  }
}

}  // namespace kinestat
