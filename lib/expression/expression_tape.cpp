#include "expression/expression_tape.hpp"

#include <limits>
#include <variant>
#include <vector>

#include "core/contract.hpp"
#include "expression/evaluate.hpp"
#include "expression/evaluate/arithmetic.hpp"
#include "expression/evaluate/evaluate_as.hpp"
#include "expression/evaluate/sum_rounding.hpp"

namespace kinestat {

namespace {

// For error_of.
class RecordedNumbers {
 public:
  using Number = TapeNumber;

  RecordedNumbers(std::span<const TapeQuantity> values,
                  std::vector<std::optional<TapeNumber>>& errors,
                  LaneRecorder& recorder)
      : values_(values), errors_(errors), recorder_(recorder) {}

  TapeNumber value(int index) const { return values_[static_cast<std::size_t>(index)].value; }

  TapeNumber constant(double value) const { return recorder_.constant(value); }

  TapeNumber sum(TapeNumber a, TapeNumber b) const { return recorder_.add(a, b); }

  TapeNumber product(TapeNumber a, TapeNumber b) const { return recorder_.multiply(a, b); }

  TapeNumber quotient(TapeNumber a, TapeNumber b) const { return recorder_.divide(a, b); }

  TapeNumber magnitude(TapeNumber a) const {
    const TapeRange range = recorder_.range(a);  // of a list that grows with what is recorded
    if (range.low >= 0.0) {
      return a;
    }
    const TapeNumber negative = recorder_.subtract(recorder_.constant(0.0), a);
    return range.high <= 0.0 ? negative : recorder_.larger(a, negative);
  }

  const std::optional<TapeNumber>& known_error(int index) const {
    return errors_[static_cast<std::size_t>(index)];
  }

  void keep_error(int index, TapeNumber error) const {
    errors_[static_cast<std::size_t>(index)] = error;
  }

 private:
  std::span<const TapeQuantity> values_;
  std::vector<std::optional<TapeNumber>>& errors_;  // of each node, once it is recorded
  LaneRecorder& recorder_;
};

class ExpressionRecorder {
 public:
  ExpressionRecorder(const SlotExpression& expression,
                     std::span<const std::optional<TapeQuantity>> slots,
                     LaneRecorder& recorder)
      : expression_(expression),
        slots_(slots),
        recorder_(recorder),
        errors_(expression.expression().nodes().size()) {}

  std::optional<TapeQuantity> record() {
    for (const Node& node : expression_.expression().nodes()) {
      const std::optional<TapeQuantity> one = record(node);
      if (!one) {
        return std::nullopt;
      }
      numbers_.push_back(*one);
    }
    demand_finite(numbers_.back().value);
    return numbers_.back();
  }

  // A number counted in a unit, in SI.
  TapeNumber to_si(TapeNumber count, const UnitScale& unit) {
    const UnitScale above{unit.numerator, 1.0, unit.pi_power};
    const TapeNumber result =
        recorder_.divide(recorder_.multiply(count, recorder_.constant(above.factor())),
                         recorder_.constant(unit.denominator));
    recorder_.demand_no_underflow(result, count, recorder_.constant(1.0));
    return result;
  }

  // What overflows stays infinite or becomes a NaN, or makes a zero that is looked for.
  void demand_finite(TapeNumber number) {
    recorder_.demand_at_most(number, recorder_.constant(std::numeric_limits<double>::max()));
  }

 private:
  std::optional<TapeQuantity> record(const Node& node) {
    if (node.kind == NodeKind::name) {
      return slots_[static_cast<std::size_t>(
          expression_.slots()[static_cast<std::size_t>(node.name)])];
    }
    if (node.left < 0) {
      const Quantity value = leaf(node);
      return TapeQuantity{recorder_.constant(value.value), value.dimension};
    }
    const int right = node.right < 0 ? node.left : node.right;
    const Node& divisor = expression_.expression().nodes()[static_cast<std::size_t>(right)];
    const Unit* unit = node.right < 0 ? nullptr : divisor.unit;
    const TapeQuantity& a = numbers_[static_cast<std::size_t>(node.left)];
    const TapeQuantity& b = numbers_[static_cast<std::size_t>(right)];
    std::optional<TapeQuantity> result =
        recorder_.is_constant(a.value) && recorder_.is_constant(b.value)
            ? record_constant(node, a, b, unit)
            : record_operation(node, a, b, unit);
    if (result && is_sum(node.kind)) {
      result->value = settled(node, result->value);
    }
    return result;
  }

  // What is mere rounding of the terms of a sum is zero, as in evaluate.
  TapeNumber settled(const Node& sum, TapeNumber value) {
    const RecordedNumbers numbers(numbers_, errors_, recorder_);
    const TapeNumber bound = error_of_terms(expression_.expression().nodes(), numbers, sum);
    const TapeNumber larger = recorder_.larger(numbers.magnitude(numbers.value(sum.left)),
                                               numbers.magnitude(numbers.value(sum.right)));
    const TapeNumber limit =
        recorder_.smaller(bound, recorder_.multiply(larger, recorder_.constant(0.5)));
    const TapeNumber result = recorder_.zero_within(value, limit);
    if (result != value && !recorder_.is_constant(bound)) {
      demand_finite(bound);
    }
    return result;
  }

  std::optional<TapeQuantity> record_constant(const Node& node,
                                              const TapeQuantity& a,
                                              const TapeQuantity& b,
                                              const Unit* unit) {
    const Outcome outcome = operate(node,
                                    {recorder_.value(a.value), a.dimension},
                                    {recorder_.value(b.value), b.dimension},
                                    unit);
    const auto* value = std::get_if<Quantity>(&outcome);
    return value != nullptr
               ? std::optional(TapeQuantity{recorder_.constant(value->value), value->dimension})
               : std::nullopt;
  }

  // The operations of `operate` that a tape can record; none of the others.
  std::optional<TapeQuantity> record_operation(const Node& node,
                                               const TapeQuantity& a,
                                               const TapeQuantity& b,
                                               const Unit* unit) {
    if (is_sum(node.kind) && a.dimension != b.dimension) {
      return std::nullopt;
    }
    switch (node.kind) {
      case NodeKind::negate:
        return TapeQuantity{recorder_.subtract(recorder_.constant(0.0), a.value), a.dimension};
      case NodeKind::add:
        return TapeQuantity{recorder_.add(a.value, b.value), a.dimension};
      case NodeKind::subtract:
        return TapeQuantity{recorder_.subtract(a.value, b.value), a.dimension};
      case NodeKind::multiply:
        return TapeQuantity{unit != nullptr ? to_si(a.value, unit->scale) : product(a, b),
                            a.dimension * b.dimension};
      case NodeKind::divide:
        return unit != nullptr
                   ? std::nullopt
                   : std::optional(TapeQuantity{quotient(a, b), a.dimension / b.dimension});
      default:
        return std::nullopt;
    }
  }

  TapeNumber product(const TapeQuantity& a, const TapeQuantity& b) {
    const TapeNumber result = recorder_.multiply(a.value, b.value);
    recorder_.demand_no_underflow(result, a.value, b.value);
    return result;
  }

  TapeNumber quotient(const TapeQuantity& a, const TapeQuantity& b) {
    const TapeNumber result = recorder_.divide(a.value, b.value);
    recorder_.demand_no_underflow(result, a.value, recorder_.constant(1.0));
    if (!recorder_.is_constant(b.value)) {
      demand_finite(b.value);  // a share of infinity would be a zero like others
      demand_finite(result);
    }
    return result;
  }

  const SlotExpression& expression_;
  std::span<const std::optional<TapeQuantity>> slots_;
  LaneRecorder& recorder_;
  std::vector<TapeQuantity> numbers_;
  std::vector<std::optional<TapeNumber>> errors_;  // of each node, where a sum asked for it
};

}  // namespace

std::optional<TapeQuantity> record_quantity(const SlotExpression& expression,
                                            std::span<const std::optional<TapeQuantity>> slots,
                                            LaneRecorder& recorder) {
  return ExpressionRecorder(expression, slots, recorder).record();
}

std::optional<TapeNumber> record_as(QuantityKind kind,
                                    const SlotExpression& expression,
                                    const FileUnits& units,
                                    std::span<const std::optional<TapeQuantity>> slots,
                                    LaneRecorder& recorder) {
  KINESTAT_EXPECTS(kind != QuantityKind::lead);
  ExpressionRecorder one(expression, slots, recorder);
  const std::optional<TapeQuantity> value = one.record();
  if (!value) {
    return std::nullopt;
  }
  const bool counts_in_unit = is_bare(value->dimension);
  if (!counts_in_unit && !fits(value->dimension, kind)) {
    return std::nullopt;
  }
  const TapeNumber result =
      counts_in_unit ? one.to_si(value->value, units.scale(kind)) : value->value;
  recorder.demand_at_most(result, recorder.constant(largest_number(kind)));
  return result;
}

}  // namespace kinestat
