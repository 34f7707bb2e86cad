#include "cases/free_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cases/case_passes.hpp"
#include "core/contract.hpp"
#include "core/rounding.hpp"
#include "core/tolerance.hpp"
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
      const double number = unit.scale.written_from_si(value->value);
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
  std::vector<CaseAnalysis> cases = solve_magnitudes(*mechanism);
  return Probe{.mechanism = *std::move(mechanism), .cases = std::move(cases)};
}

// Each probe rounds the numbers of the file anew.
BoundedNumber rounded_anew(const BoundedNumber& number) {
  return {.value = number.value, .bound = number.bound + kDataRounding * std::abs(number.value)};
}

// The rates of a case at one probe; one that no other body feels and nobody gives is no number, and
// so is not affine.
Magnitudes rates_of(const CaseAnalysis& one) {
  if (!one.motion || one.motion->rates.empty()) {
    return std::nullopt;
  }
  std::vector<BoundedNumber> rates;
  for (int f = 0; f < static_cast<int>(one.motion->rates.size()); ++f) {
    rates.push_back(one.motion->knows_rate(f)
                        ? rounded_anew(bounded_rate(*one.motion, f))
                        : BoundedNumber{.value = std::numeric_limits<double>::quiet_NaN()});
  }
  return rates;
}

// An action that equilibrium leaves open is no number, and so is not affine.
Magnitudes actions_of(const CaseAnalysis& one) {
  if (!one.action || one.action->magnitudes.empty()) {
    return std::nullopt;
  }
  std::vector<BoundedNumber> actions;
  for (int a = 0; a < static_cast<int>(one.action->magnitudes.size()); ++a) {
    const bool is_known = one.action->magnitudes[static_cast<std::size_t>(a)].has_value();
    actions.push_back(is_known ? rounded_anew(bounded_action(*one.action, a))
                               : BoundedNumber{.value = std::numeric_limits<double>::quiet_NaN()});
  }
  return actions;
}

// What the equations of a probe make of the rounding of their numbers.
std::vector<double> rate_rounding_at(const Probe& probe,
                                     std::size_t index,
                                     std::span<const std::size_t> wanted) {
  const CaseAnalysis& one = probe.cases[index];
  return rate_rounding(wanted, probe.mechanism, one.which, *one.motion);
}

std::vector<double> action_rounding_at(const Probe& probe,
                                       std::size_t index,
                                       std::span<const std::size_t> wanted) {
  const CaseAnalysis& one = probe.cases[index];
  if (one.coast_flanks.empty()) {
    return action_rounding(wanted, probe.mechanism, one.which, *one.action);
  }
  Mechanism on_coast_flanks = probe.mechanism;
  load_coast_flanks(one.coast_flanks, on_coast_flanks.geometry);
  return action_rounding(wanted, on_coast_flanks, one.which, *one.action);
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

// Whether the change of a magnitude with some parameter, or what is left of it where all of them
// are zero, is so small that it may be rounding, but not so small that its own bound says so.
bool may_be_rounding(const std::vector<Magnitudes>& probes,
                     std::size_t m,
                     const std::vector<FreeParameter>& parameters,
                     double largest) {
  const auto is_in_doubt = [&](const BoundedNumber& x) {
    return std::abs(x.value) > x.bound && std::abs(x.value) <= kAffine * largest;
  };
  const BoundedNumber drawn = (*probes[0])[m];
  BoundedNumber constant = drawn;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const BoundedNumber change = (*probes[i + 1])[m] - drawn;
    if (is_in_doubt(change)) {
      return true;
    }
    constant = constant - change * BoundedNumber{.value = parameters[i].value / parameters[i].step};
  }
  return is_in_doubt(constant);
}

// The magnitudes of which that holds. What is larger, and rounding all the same, is seen at the
// last probes, where it fits no affine function.
std::vector<std::size_t> perhaps_rounding(const std::vector<Magnitudes>& probes,
                                          const std::vector<FreeParameter>& parameters,
                                          const std::vector<double>& largest) {
  std::vector<std::size_t> result;
  for (std::size_t m = 0; m < largest.size(); ++m) {
    if (may_be_rounding(probes, m, parameters, largest[m])) {
      result.push_back(m);
    }
  }
  return result;
}

// The dependence of the rates or of the actions of the case with that index.
class AffineFit {
 public:
  using ValuesOf = Magnitudes (*)(const CaseAnalysis&);
  using RoundingAt = std::vector<double> (*)(const Probe&,
                                             std::size_t,
                                             std::span<const std::size_t>);

  AffineFit(const std::vector<FreeParameter>& parameters,
            const std::vector<std::vector<double>>& points,
            const std::vector<std::optional<Probe>>& probes,
            std::size_t index)
      : parameters_(parameters), points_(points), probes_(probes), index_(index) {}

  /// Those that depend on a parameter, or do so in another way than affinely. `is_first` says which
  /// of two kinds a magnitude is.
  template <class IsFirst>
  std::vector<AffineMagnitude> run(ValuesOf values_of,
                                   RoundingAt rounding_at,
                                   const IsFirst& is_first) const {
    std::vector<Magnitudes> values;
    for (const std::optional<Probe>& probe : probes_) {
      values.push_back(probe ? values_of(probe->cases[index_]) : std::nullopt);
    }
    const std::vector<double> largest = scales(values, is_first);
    if (std::ranges::all_of(values, &Magnitudes::has_value)) {
      add_rounding(rounding_at, largest, values);
    }
    return dependent(values, fit_affine(parameters_, points_, values, largest));
  }

 private:
  void add_rounding(RoundingAt rounding_at,
                    const std::vector<double>& largest,
                    std::vector<Magnitudes>& values) const {
    const std::vector<std::size_t> wanted = perhaps_rounding(values, parameters_, largest);
    for (std::size_t p = 0; !wanted.empty() && p <= parameters_.size(); ++p) {
      const std::vector<double> rounding = rounding_at(*probes_[p], index_, wanted);
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        (*values[p])[wanted[i]].bound += rounding[i];
      }
    }
  }

  static std::vector<AffineMagnitude> dependent(
      const std::vector<Magnitudes>& values, const std::vector<std::optional<AffineValue>>& fits) {
    std::vector<AffineMagnitude> result;
    for (std::size_t m = 0; m < fits.size(); ++m) {
      const bool has_value = std::isfinite((*values[0])[m].value);
      const bool is_constant =
          fits[m] && std::ranges::all_of(fits[m]->coefficients, [](double c) { return c == 0.0; });
      if (has_value && !is_constant) {
        result.push_back({.index = static_cast<int>(m), .value = fits[m]});
      }
    }
    return result;
  }

  const std::vector<FreeParameter>& parameters_;
  const std::vector<std::vector<double>>& points_;  // parallel to the probes
  const std::vector<std::optional<Probe>>& probes_;
  std::size_t index_;
};

struct Probes {
  std::vector<std::vector<double>> points;
  std::vector<std::optional<Probe>> probes;  // parallel
};

// Where a parameter cannot have so much more, as a share near one, it is moved the other way or
// less far, and its step is what it was moved by; a point at which all move comes nearer.
Probes probe(const Analysis& analysis,
             const std::vector<Probed>& free,
             std::vector<FreeParameter>& parameters) {
  constexpr double kWays[] = {1.0, -0.25, 0.0625, -0.0625};
  const std::size_t singly = parameters.size() + 1;  // probes at which one is moved, or none
  std::vector<std::vector<double>> points = affine_probes(parameters);
  std::vector<std::optional<Probe>> probes = {
      Probe{.mechanism = analysis.mechanism, .cases = analysis.cases}};
  for (std::size_t p = 1; p < points.size(); ++p) {
    points[p] = affine_probes(parameters)[p];
    const std::vector<double> wanted = points[p];
    probes.emplace_back();
    for (const double way : kWays) {
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        points[p][i] = points[0][i] + way * (wanted[i] - points[0][i]);
      }
      if ((probes[p] = solve_at(analysis.description, free, points[p]))) {
        break;
      }
    }
    if (probes[p] && p < singly) {
      parameters[p - 1].step = points[p][p - 1] - points[0][p - 1];
    }
  }
  return {.points = std::move(points), .probes = std::move(probes)};
}

AffineDependence find_affine_dependence(const Analysis& analysis) {
  AffineDependence result{.parameters = {},
                          .cases = std::vector<AffineCase>(analysis.cases.size())};
  const std::vector<Probed> free = find_free(analysis);
  if (free.empty() || analysis.cases.empty()) {
    return result;
  }
  std::vector<FreeParameter> parameters;
  for (const Probed& one : free) {
    parameters.push_back(one.parameter);
    result.parameters.push_back(
        {.name = analysis.description.parameters[one.index].name.text, .unit = one.unit});
  }
  const auto [points, probes] = probe(analysis, free, parameters);
  const Topology& topology = analysis.mechanism.topology;
  for (std::size_t c = 0; c < analysis.cases.size(); ++c) {
    const AffineFit fit(parameters, points, probes, c);
    result.cases[c].rates = fit.run(rates_of, rate_rounding_at, [&](std::size_t f) {
      return topology.freedoms[f].is_rotation;
    });
    result.cases[c].actions = fit.run(actions_of, action_rounding_at, [&](std::size_t a) {
      return topology.actions[a].is_couple;
    });
  }
  return result;
}

}  // namespace

const AffineDependence& affine_dependence(const Analysis& analysis) {
  return analysis.affine.get([&] { return find_affine_dependence(analysis); });
}

const AffineCase& affine_case(const Analysis& analysis, const CaseAnalysis& one) {
  const std::ptrdiff_t index = &one - analysis.cases.data();
  KINESTAT_EXPECTS(index >= 0 && index < std::ssize(analysis.cases));
  return affine_dependence(analysis).cases[static_cast<std::size_t>(index)];
}

}  // namespace kinestat
