#include "math/numbers/root_sum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/contract.hpp"
#include "math/elimination/exact_elimination.hpp"
#include "math/numbers/prime_field.hpp"

namespace kinestat {

RootSum::RootSum(const Rational& value, int root_count) : root_count_(root_count) {
  KINESTAT_EXPECTS(root_count > 0 && root_count % 4 == 0);
  add_term(0, value);
  reduce();
}

RootSum RootSum::in_field(int root_count) const {
  KINESTAT_EXPECTS(is_zero() || root_count % root_count_ == 0);
  RootSum result(Rational(0), root_count);
  for (const auto& [k, factor] : terms_) {
    result.add_term(k * (root_count / root_count_), factor);
  }
  result.reduce();
  return result;
}

RootSum RootSum::root(int k, int root_count) {
  RootSum result(Rational(0), root_count);
  const int rest = k % root_count;
  result.add_term(rest < 0 ? rest + root_count : rest, Rational(1));
  result.reduce();
  return result;
}

RootSum RootSum::cosine(int k, int root_count) {
  const RootSum half(Rational(1, 2), root_count);
  return half * (root(k, root_count) + root(-k, root_count));
}

// 1/2i = -i/2, and i is a quarter turn.
RootSum RootSum::sine(int k, int root_count) {
  const RootSum half(Rational(-1, 2), root_count);
  return half * root(root_count / 4, root_count) * (root(k, root_count) - root(-k, root_count));
}

void RootSum::add_term(int k, const Rational& factor) {
  if (factor.is_zero()) {
    return;
  }
  const auto place = terms_.try_emplace(k).first;
  place->second += factor;
  if (place->second.is_zero()) {
    terms_.erase(place);
  }
}

// For each prime q that divides N, the q roots that differ by N/q in k sum to zero: of each such
// set, the one whose rest modulo the power of q in N is in its last q-th is replaced by the others.
// The roots that remain are a basis (Bosma, Canonical bases for cyclotomic fields, 1990).
void RootSum::reduce(int prime) {
  int power = prime;
  while (root_count_ / power % prime == 0) {
    power *= prime;
  }
  std::vector<std::pair<int, Rational>> replaced;
  for (const auto& [k, factor] : terms_) {
    if (k % power / (power / prime) == prime - 1) {
      replaced.emplace_back(k, factor);
    }
  }
  for (const auto& [k, factor] : replaced) {
    for (int i = 0; i < prime; ++i) {
      add_term((k + i * (root_count_ / prime)) % root_count_, -factor);
    }
  }
}

void RootSum::reduce() {
  for_each_prime_divisor(root_count_, [&](int q) { reduce(q); });
}

std::complex<double> RootSum::value() const {
  std::complex<double> sum = 0.0;
  for (const auto& [k, factor] : terms_) {
    sum += to_double(factor) * std::polar(1.0, 2.0 * std::numbers::pi * k / root_count_);
  }
  return sum;
}

std::optional<PrimeField::Value> RootSum::residue(const PrimeField& field) const {
  KINESTAT_EXPECTS(is_zero() || field.root_count() == root_count_);
  PrimeField::Value sum = 0;
  for (const auto& [k, factor] : terms_) {
    const std::optional<PrimeField::Value> part = field.residue(factor);
    if (!part) {
      return std::nullopt;
    }
    sum = field.sum(sum, field.product(*part, field.root(k)));
  }
  return sum;
}

RootSum RootSum::operator-() const {
  RootSum result = *this;
  for (auto& [k, factor] : result.terms_) {
    factor = -factor;
  }
  return result;
}

RootSum& RootSum::operator+=(const RootSum& other) {
  KINESTAT_EXPECTS(is_zero() || other.is_zero() || root_count_ == other.root_count_);
  root_count_ = std::max(root_count_, other.root_count_);
  for (const auto& [k, factor] : other.terms_) {
    add_term(k, factor);
  }
  return *this;
}

RootSum operator*(const RootSum& a, const RootSum& b) {
  KINESTAT_EXPECTS(a.is_zero() || b.is_zero() || a.root_count_ == b.root_count_);
  RootSum result;
  result.root_count_ = std::max(a.root_count_, b.root_count_);
  for (const auto& [i, x] : a.terms_) {
    for (const auto& [k, y] : b.terms_) {
      result.add_term((i + k) % result.root_count_, x * y);
    }
  }
  if (!result.is_zero()) {
    result.reduce();
  }
  return result;
}

// y with this · y = 1: one unknown a root of the basis, the k at which `reduce` leaves a root
// alone.
RootSum RootSum::inverse() const {
  KINESTAT_EXPECTS(!is_zero());
  std::vector<int> basis;
  for (int k = 0; k < root_count_; ++k) {
    if (root(k, root_count_).terms_.contains(k)) {
      basis.push_back(k);
    }
  }
  ExactMatrix matrix{.rows = root_count_, .columns = static_cast<int>(basis.size()), .entries = {}};
  for (int c = 0; c < matrix.columns; ++c) {
    const RootSum product = *this * root(basis[static_cast<std::size_t>(c)], root_count_);
    for (const auto& [k, factor] : product.terms_) {
      matrix.entries.push_back({.row = k, .column = c, .value = factor});
    }
  }
  std::vector<Rational> one(static_cast<std::size_t>(root_count_));
  one.front() = 1;
  const ExactSolution solution = ExactElimination(matrix, {}).solve({}, one);
  RootSum result(Rational(0), root_count_);
  for (std::size_t i = 0; i < basis.size(); ++i) {
    result.add_term(basis[i], solution.x[i]);
  }
  return result;
}

}  // namespace kinestat
