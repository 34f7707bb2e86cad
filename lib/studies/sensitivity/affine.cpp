#include "studies/sensitivity/affine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contract.hpp"
#include "core/rounding.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// How many steps each parameter is moved at the last probes, where all move. Steps are round
// numbers, and what repeats mostly does so after a round one too: a staircase looks straight at
// points of the same phase. Multiples of the golden ratio share none with any period.
double turns(std::size_t i) {
  const double multiple = std::numbers::phi * static_cast<double>(i + 1);
  return multiple - std::floor(multiple);
}

double forward_mix(std::size_t i) {
  return 0.31 + turns(i);
}

double backward_mix(std::size_t i) {
  return -0.47 - turns(i + 5);
}

// Close by, for what stands still between its jumps.
double near_mix(std::size_t i) {
  return turns(i + 11) / 1024.0;
}

// A value of a parameter is rounded where it is typed anew in its unit.
BoundedNumber as_typed(double value) {
  return {.value = value, .bound = kDataRounding * std::abs(value)};
}

BoundedNumber moved_by(const FreeParameter& parameter) {
  const double sizes = std::abs(parameter.value) + std::abs(parameter.step);
  return {.value = parameter.step, .bound = kDataRounding * sizes};
}

// One magnitude at all probes.
std::optional<AffineValue> fit_one(std::span<const FreeParameter> parameters,
                                   std::span<const BoundedNumber> values,
                                   std::span<const std::vector<double>> probes,
                                   double scale) {
  AffineValue result;
  BoundedNumber constant = values[0];
  double largest = std::abs(values[0].value);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const BoundedNumber change = values[i + 1] - values[0];
    const BoundedNumber slope = change / moved_by(parameters[i]);
    const double coefficient = zero_within_bound(slope.value, slope.bound);
    result.coefficients.push_back(coefficient);
    if (coefficient != 0.0) {
      constant = constant - slope * as_typed(parameters[i].value);
    }
    largest = std::max(
        {largest, std::abs(values[i + 1].value), std::abs(coefficient * parameters[i].value)});
  }
  result.constant = constant.zeroed();
  for (std::size_t p = parameters.size() + 1; p < probes.size(); ++p) {
    double expected = result.constant;
    double terms = std::max(largest, scale);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      expected += result.coefficients[i] * probes[p][i];
      terms = std::max(terms, std::abs(result.coefficients[i] * probes[p][i]));
    }
    if (!(std::abs(values[p].value - expected) <= kAffine * terms)) {
      return std::nullopt;
    }
  }
  return result;
}

}  // namespace

std::vector<std::vector<double>> affine_probes(std::span<const FreeParameter> parameters) {
  std::vector<double> base;
  for (const FreeParameter& parameter : parameters) {
    base.push_back(parameter.value);
  }
  std::vector<std::vector<double>> probes = {base};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    probes.push_back(base);
    probes.back()[i] += parameters[i].step;
  }
  for (const auto mix : {forward_mix, backward_mix, near_mix}) {
    probes.push_back(base);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      probes.back()[i] += mix(i) * parameters[i].step;
    }
  }
  return probes;
}

std::vector<std::optional<AffineValue>> fit_affine(std::span<const FreeParameter> parameters,
                                                   std::span<const std::vector<double>> probes,
                                                   std::span<const Magnitudes> at_probes,
                                                   std::span<const double> scale) {
  KINESTAT_EXPECTS(at_probes.size() == probes.size());
  std::vector<std::optional<AffineValue>> result(scale.size());
  if (!std::ranges::all_of(at_probes, &Magnitudes::has_value)) {
    return result;
  }
  std::vector<BoundedNumber> values(probes.size());
  for (std::size_t m = 0; m < scale.size(); ++m) {
    for (std::size_t p = 0; p < probes.size(); ++p) {
      KINESTAT_EXPECTS(at_probes[p]->size() == scale.size());
      values[p] = (*at_probes[p])[m];
    }
    result[m] = fit_one(parameters, values, probes, scale[m]);
  }
  return result;
}

}  // namespace kinestat
