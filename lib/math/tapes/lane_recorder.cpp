#include "math/tapes/lane_recorder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "math/tapes/internal/lane_tape_maker.hpp"

namespace kinestat {

namespace {

bool is_power_of_two(double value) {
  int exponent = 0;
  return std::abs(std::frexp(value, &exponent)) == 0.5;
}

double without_rounding(double value, double size) {
  return std::abs(value) <= kCancellation * size ? 0.0 : value;
}

}  // namespace

TapeNumber LaneRecorder::push(const Node& node) {
  nodes_.push_back(node);
  return {.node = static_cast<int>(nodes_.size()) - 1};
}

TapeNumber LaneRecorder::constant(double value) {
  const auto [at, is_new] = constants_.try_emplace(std::bit_cast<std::uint64_t>(value), 0);
  if (is_new) {
    at->second = push({.value = value, .range = {value, value}}).node;
  }
  return {.node = at->second};
}

TapeNumber LaneRecorder::input(double value, const TapeRange& range) {
  Node node{.what = What::input, .value = value, .range = range, .input = input_count_++};
  if (std::isfinite(range.most())) {
    node.form = form_of_input(node.input, range);
  }
  return push(node);
}

std::optional<TapeForm> LaneRecorder::form(TapeNumber a) const {
  return is_constant(a) ? std::optional(form_of_constant(value(a))) : node(a).form;
}

TapeNumber LaneRecorder::operation(Kind kind,
                                   double value,
                                   const TapeRange& range,
                                   const Operands& operands) {
  const bool is_constant = std::ranges::all_of(operands, [&](int operand) {
    return operand < 0 || nodes_[static_cast<std::size_t>(operand)].what == What::constant;
  });
  if (is_constant) {
    return constant(value);
  }
  const auto [at, is_new] = operations_.try_emplace({kind, operands}, 0);
  if (is_new) {
    at->second = push({.what = What::operation,
                       .value = value,
                       .range = range,
                       .kind = kind,
                       .operands = operands})
                     .node;
  }
  return {.node = at->second};
}

// Of operands one of which hangs on inputs.
TapeNumber LaneRecorder::affine(Kind kind,
                                double value,
                                const TapeRange& range,
                                const Operands& operands,
                                std::optional<TapeForm> form) {
  const TapeNumber result = operation(kind, value, form ? narrowed(range, *form) : range, operands);
  if (!is_constant(result)) {
    nodes_[static_cast<std::size_t>(result.node)].form = std::move(form);
  }
  return result;
}

TapeNumber LaneRecorder::add(TapeNumber a, TapeNumber b) {
  if (is_zero(a)) {
    return b;
  }
  return is_zero(b) ? a
                    : affine(Kind::add,
                             value(a) + value(b),
                             range(a) + range(b),
                             {a.node, b.node, -1},
                             sum_of(form(a), 1.0, form(b)));
}

TapeNumber LaneRecorder::subtract(TapeNumber a, TapeNumber b) {
  return is_zero(b) ? a
                    : affine(Kind::subtract,
                             value(a) - value(b),
                             range(a) - range(b),
                             {a.node, b.node, -1},
                             sum_of(form(a), -1.0, form(b)));
}

// Two factors round as one where one of them is a power of two.
TapeNumber LaneRecorder::scaled(TapeNumber a, double factor) {
  if (factor == 0.0) {
    return constant(0.0);
  }
  const Node& inner = node(a);
  if (inner.what == What::operation && inner.kind == Kind::multiply) {
    const TapeNumber first{.node = inner.operands[0]};
    const TapeNumber second{.node = inner.operands[1]};
    if (is_constant(second) && (is_power_of_two(factor) || is_power_of_two(value(second)))) {
      return scaled(first, value(second) * factor);
    }
  }
  return factor == 1.0 ? a
                       : affine(Kind::multiply,
                                value(a) * factor,
                                range(a) * TapeRange{factor, factor},
                                {a.node, constant(factor).node, -1},
                                sum_of(form_of_constant(0.0), factor, form(a)));
}

TapeNumber LaneRecorder::multiply(TapeNumber a, TapeNumber b) {
  if (is_constant(b)) {
    return is_constant(a) ? constant(value(a) * value(b)) : scaled(a, value(b));
  }
  return is_constant(a)
             ? scaled(b, value(a))
             : operation(
                   Kind::multiply, value(a) * value(b), range(a) * range(b), {a.node, b.node, -1});
}

// Zero by what may be zero has no value there.
TapeNumber LaneRecorder::divide(TapeNumber a, TapeNumber b) {
  if (is_zero(a) && range(b).least() > 0.0) {
    return a;
  }
  if (is_constant(b) && !is_constant(a) && is_power_of_two(value(b))) {
    return scaled(a, 1.0 / value(b));
  }
  return operation(Kind::divide, value(a) / value(b), range(a) / range(b), {a.node, b.node, -1});
}

TapeNumber LaneRecorder::smaller(TapeNumber a, TapeNumber b) {
  const TapeRange chosen{std::min(range(a).low, range(b).low),
                         std::min(range(a).high, range(b).high)};
  return operation(Kind::smaller,
                   std::min(value(a), value(b)),
                   range_of_choice(range(a), range(b), chosen),
                   {a.node, b.node, -1});
}

TapeNumber LaneRecorder::larger(TapeNumber a, TapeNumber b) {
  const TapeRange chosen{std::max(range(a).low, range(b).low),
                         std::max(range(a).high, range(b).high)};
  return operation(Kind::larger,
                   std::max(value(a), value(b)),
                   range_of_choice(range(a), range(b), chosen),
                   {a.node, b.node, -1});
}

TapeNumber LaneRecorder::zero_within(TapeNumber a, TapeNumber bound) {
  if (is_zero(bound) || range(a).least() > range(bound).most()) {
    return a;
  }
  return operation(Kind::zero_within,
                   zero_within_bound(value(a), value(bound)),
                   {std::min(range(a).low, 0.0), std::max(range(a).high, 0.0)},
                   {a.node, bound.node, -1});
}

TapeNumber LaneRecorder::negate_product(TapeNumber a, TapeNumber b) {
  if (is_constant(a)) {
    return multiply(constant(-value(a)), b);
  }
  return is_constant(b) ? multiply(a, constant(-value(b)))
                        : operation(Kind::negate_product,
                                    -(value(a) * value(b)),
                                    TapeRange{0.0, 0.0} - range(a) * range(b),
                                    {a.node, b.node, -1});
}

TapeNumber LaneRecorder::subtract_product(TapeNumber a, TapeNumber b, TapeNumber c) {
  if (is_zero(b) || is_zero(c)) {
    return a;
  }
  if (is_zero(a)) {
    return negate_product(b, c);
  }
  const double product = value(b) * value(c);
  const TapeRange products = range(b) * range(c);
  std::optional<TapeForm> sum;
  if (is_constant(b) || is_constant(c)) {
    sum =
        is_constant(b) ? sum_of(form(a), -value(b), form(c)) : sum_of(form(a), -value(c), form(b));
  }
  const TapeRange difference = sum ? narrowed(range(a) - products, *sum) : range(a) - products;
  const double most = range(a).most() + products.most();
  if (may_be_rounding(difference, most)) {
    sum.reset();
  }
  return affine(Kind::subtract_product,
                without_rounding(value(a) - product, std::abs(value(a)) + std::abs(product)),
                without_rounding(difference, most),
                {a.node, b.node, c.node},
                std::move(sum));
}

TapeNumber LaneRecorder::substitute(std::span<const Product> products, TapeNumber pivot) {
  std::vector<Product> used;
  double sum = 0.0;
  double size = 0.0;
  TapeRange sums{0.0, 0.0};
  double most = 0.0;
  bool all_constant = is_constant(pivot);
  for (const Product& one : products) {
    if (is_zero(one.a) || is_zero(one.b)) {
      continue;
    }
    used.push_back(one);
    const double product = value(one.a) * value(one.b);
    const TapeRange all = range(one.a) * range(one.b);
    sum -= product;
    size += std::abs(product);
    sums = sums - all;
    most += all.most();
    all_constant = all_constant && is_constant(one.a) && is_constant(one.b);
  }
  const double result = without_rounding(sum, size) / value(pivot);
  if (used.empty() || all_constant) {
    return constant(used.empty() ? 0.0 : result);
  }
  if (used.size() == 1) {
    return divide(negate_product(used[0].a, used[0].b), pivot);
  }
  const auto first = static_cast<int>(products_.size());
  products_.insert(products_.end(), used.begin(), used.end());
  return push({.what = What::operation,
               .value = result,
               .range = without_rounding(sums, most) / range(pivot),
               .kind = Kind::substitute_sum,
               .operands = {-1, -1, pivot.node},
               .first_product = first,
               .end_product = static_cast<int>(products_.size())});
}

// Each once.
void LaneRecorder::demand(Kind kind, const Operands& operands) {
  const auto [at, is_new] = operations_.try_emplace({kind, operands}, 0);
  if (is_new) {
    at->second =
        push({.what = What::operation, .range = {}, .kind = kind, .operands = operands}).node;
    demands_.push_back(at->second);
  }
}

// Of several constant limits the smallest counts.
void LaneRecorder::demand_at_most(TapeNumber magnitude_of, TapeNumber limit) {
  if (range(magnitude_of).most() <= range(limit).low) {
    return;
  }
  if (!is_constant(limit)) {
    demand(Kind::demand_at_most, {magnitude_of.node, limit.node, -1});
    return;
  }
  const auto [at, is_new] = limits_.try_emplace(magnitude_of.node, -1);
  if (is_new) {
    at->second = push({.what = What::operation,
                       .range = {},
                       .kind = Kind::demand_at_most,
                       .operands = {magnitude_of.node, limit.node, -1}})
                     .node;
    demands_.push_back(at->second);
  }
  int& present = nodes_[static_cast<std::size_t>(at->second)].operands[1];
  if (value(limit) < value({.node = present})) {
    present = limit.node;
  }
}

void LaneRecorder::demand_at_least(TapeNumber magnitude_of, TapeNumber limit) {
  if (!(range(magnitude_of).least() >= range(limit).high)) {
    demand(Kind::demand_at_least, {magnitude_of.node, limit.node, -1});
  }
}

void LaneRecorder::demand_no_underflow(TapeNumber result, TapeNumber b, TapeNumber c) {
  const bool is_sure = result == b || range(result).least() > 0.0;
  if (!is_sure && !is_zero(b) && !is_zero(c)) {
    demand(Kind::demand_no_underflow, {result.node, b.node, c.node});
  }
}

LaneTape LaneRecorder::make_tape(std::span<const TapeNumber> outputs) const {
  return LaneTapeMaker(*this).make(outputs);
}

}  // namespace kinestat
