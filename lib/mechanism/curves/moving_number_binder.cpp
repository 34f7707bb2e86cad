#include "mechanism/curves/moving_number_binder.hpp"

#include <algorithm>
#include <vector>

namespace kinestat {

bool names_curve(const Value& value, const MechanismDescription& description) {
  return std::ranges::any_of(value.expression.names(), [&](const std::string& name) {
    return std::ranges::any_of(
        description.curves, [&](const CurveDescription& curve) { return curve.name.text == name; });
  });
}

std::optional<MovingNumber> bind_moving_number(const Value& value,
                                               QuantityKind kind,
                                               std::span<const Curve> curves,
                                               Evaluator& evaluator) {
  std::vector<LawVariable<double>> samples;
  for (const Curve& curve : curves) {
    if (std::ranges::count(value.expression.names(), curve.name) == 0) {
      continue;
    }
    if (curve.at.empty()) {
      return std::nullopt;
    }
    samples.push_back({.name = curve.name, .value = {.value = 1.0, .dimension = curve.dimension}});
  }
  if (samples.empty()) {
    const std::optional<double> number = evaluator.number(value, kind);
    return number ? std::optional(MovingNumber{.value = *number, .law = nullptr}) : std::nullopt;
  }
  std::optional<NumberLaw<double>> law = evaluator.law(value, kind, samples);
  return law ? std::optional(MovingNumber{
                   .value = 0.0, .law = std::make_shared<const NumberLaw<double>>(*std::move(law))})
             : std::nullopt;
}

}  // namespace kinestat
