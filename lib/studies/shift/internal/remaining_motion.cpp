#include "studies/shift/internal/remaining_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/numbers/bounded_arithmetic.hpp"

namespace kinestat {

namespace {

// Zero where its own bound does not tell it from zero.
BoundedNumber zero_within_bound(const BoundedNumber& number) {
  return number.zeroed() == 0.0 ? BoundedNumber{} : number;
}

BoundedNumber minus(const BoundedNumber& number) {
  return {.value = -number.value, .bound = number.bound};
}

BoundedNumber rate_in(const RateRow& row, const std::vector<BoundedNumber>& motion) {
  BoundedNumber sum;
  for (std::size_t i = 0; i < row.size(); ++i) {
    sum = bounded_sum(sum, bounded_product(row[i], motion[i]));
  }
  return zero_within_bound(sum);
}

}  // namespace

RemainingMotion::RemainingMotion(int motions)
    : basis_(static_cast<std::size_t>(motions), Motion(static_cast<std::size_t>(motions))),
      value_(static_cast<std::size_t>(motions)) {
  for (std::size_t i = 0; i < basis_.size(); ++i) {
    basis_[i][i].value = 1.0;
  }
}

bool RemainingMotion::changes(const RateRow& row) const {
  return std::ranges::any_of(
      basis_, [&](const Motion& motion) { return rate_in(row, motion).value != 0.0; });
}

// The motion that changes the rate most brings it to its value and takes its change out of the
// others; multipliers are at most 1.
bool RemainingMotion::prescribe(const RateRow& row, double rate) {
  std::vector<BoundedNumber> rates;
  std::size_t pivot = 0;
  for (const Motion& motion : basis_) {
    rates.push_back(rate_in(row, motion));
    pivot = std::abs(rates.back().value) > std::abs(rates[pivot].value) ? rates.size() - 1 : pivot;
  }
  if (rates.empty() || rates[pivot].value == 0.0) {
    return false;
  }
  const Motion motion = std::move(basis_[pivot]);
  const auto add = [&](const BoundedNumber& share, Motion& sum) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] = zero_within_bound(bounded_sum(sum[i], bounded_product(share, motion[i])));
    }
  };
  add((BoundedNumber{.value = rate, .bound = 0.0} + minus(rate_in(row, value_))) / rates[pivot],
      value_);
  for (std::size_t j = 0; j < basis_.size(); ++j) {
    if (j != pivot && rates[j].value != 0.0) {
      add(minus(rates[j] / rates[pivot]), basis_[j]);
    }
  }
  basis_.erase(basis_.begin() + static_cast<std::ptrdiff_t>(pivot));
  return true;
}

BoundedNumber RemainingMotion::rate(const RateRow& row) const {
  return rate_in(row, value_);
}

}  // namespace kinestat
