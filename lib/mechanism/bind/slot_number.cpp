#include "mechanism/bind/slot_number.hpp"

#include <cmath>
#include <variant>

#include "core/tolerance.hpp"
#include "expression/evaluate.hpp"

namespace kinestat {

std::optional<double> slot_number(const SlotExpression& value,
                                  QuantityKind kind,
                                  const FileUnits& units,
                                  const Slots& slots,
                                  std::vector<Quantity>& scratch) {
  const std::optional<Quantity> quantity = value.evaluate(slots, scratch);
  if (quantity && is_bare(quantity->dimension) && units.scale(kind) == UnitScale{} &&
      std::abs(quantity->value) <= kLargestNumber) {
    return quantity->value;  // no unit and no limit for `fit` to look at
  }
  const auto fitted = quantity ? fit<double>(*quantity, kind, units)
                               : std::variant<double, ExpressionError>(ExpressionError{});
  const double* number = std::get_if<double>(&fitted);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

}  // namespace kinestat
