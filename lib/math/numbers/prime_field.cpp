#include "math/numbers/prime_field.hpp"

#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "core/contract.hpp"

namespace kinestat {

namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t kLeastPrime = std::uint64_t{1} << 60U;

// Below 2^64 the test of GMP is a proof (Baillie, Pomerance, Selfridge and Wagstaff).
bool is_prime(std::uint64_t n) {
  constexpr int kRounds = 24;
  return mpz_probab_prime_p(Integer(n).backend().data(), kRounds) != 0;
}

}  // namespace

int totient(int n) {
  int result = n;
  for_each_prime_divisor(n, [&](int q) { result = result / q * (q - 1); });
  return result;
}

PrimeField::PrimeField(int parts_of_a_turn, std::uint64_t seed)
    : root_count_(std::lcm(4, parts_of_a_turn)) {
  KINESTAT_EXPECTS(parts_of_a_turn >= 1 && parts_of_a_turn <= 1 << 20);
  std::mt19937_64 random(seed);
  const auto step = static_cast<std::uint64_t>(root_count_);
  do {
    modulus_ = (kLeastPrime + random() % kLeastPrime) / step * step + 1;
  } while (modulus_ < kLeastPrime || !is_prime(modulus_));
  do {
    root_ = power(2 + random() % (modulus_ - 2), (modulus_ - 1) / step);
  } while (!is_primitive(root_));
}

bool PrimeField::is_primitive(Value root) const {
  bool result = true;
  for_each_prime_divisor(root_count_, [&](int q) {
    result = result && power(root, static_cast<std::uint64_t>(root_count_ / q)) != 1;
  });
  return result;
}

double PrimeField::prime_count() const {
  const double range = static_cast<double>(kLeastPrime);
  return range / (std::log(1.5 * range) * totient(root_count_));
}

PrimeField::Value PrimeField::sum(Value a, Value b) const {
  const Value result = a + b;
  return result >= modulus_ ? result - modulus_ : result;
}

PrimeField::Value PrimeField::difference(Value a, Value b) const {
  return a >= b ? a - b : a + modulus_ - b;
}

PrimeField::Value PrimeField::product(Value a, Value b) const {
  return static_cast<Value>(Wide{a} * b % modulus_);
}

PrimeField::Value PrimeField::power(Value base, std::uint64_t exponent) const {
  Value result = 1;
  for (; exponent > 0; exponent /= 2) {
    result = exponent % 2 == 1 ? product(result, base) : result;
    base = product(base, base);
  }
  return result;
}

// Euclid's algorithm for p and b: each remainder is b times a factor, modulo p. No factor is larger
// than p.
PrimeField::Value PrimeField::quotient(Value a, Value b) const {
  KINESTAT_EXPECTS(b != 0);
  Value before = modulus_;
  Value rest = b;
  std::int64_t factor_before = 0;
  std::int64_t factor = 1;
  while (rest > 1) {
    const Value times = before / rest;
    before = std::exchange(rest, before - times * rest);
    factor_before =
        std::exchange(factor, factor_before - static_cast<std::int64_t>(times) * factor);
  }
  return product(
      a, static_cast<Value>(factor < 0 ? factor + static_cast<std::int64_t>(modulus_) : factor));
}

std::optional<PrimeField::Value> PrimeField::residue(const Rational& value) const {
  const auto* fraction = value.backend().data();
  const Value above = mpz_fdiv_ui(mpq_numref(fraction), modulus_);
  const Value below = mpz_fdiv_ui(mpq_denref(fraction), modulus_);
  return below == 0 ? std::nullopt : std::optional(quotient(above, below));
}

PrimeField::Value PrimeField::root(std::int64_t k) const {
  const std::int64_t rest = k % root_count_;
  return power(root_, static_cast<std::uint64_t>(rest < 0 ? rest + root_count_ : rest));
}

std::optional<std::int64_t> PrimeField::parts_of(const Rational& turns) const {
  const Rational parts = (turns - rounded_down(turns)) * root_count_;
  return is_whole(parts) ? std::optional(parts.convert_to<std::int64_t>()) : std::nullopt;
}

// cos = (z + 1/z) / 2 and sin = (z - 1/z) / 2i.
std::optional<PrimeField::Value> PrimeField::cosine(const Rational& turns) const {
  const std::optional<std::int64_t> k = parts_of(turns);
  return k ? std::optional(quotient(sum(root(*k), root(-*k)), 2)) : std::nullopt;
}

std::optional<PrimeField::Value> PrimeField::sine(const Rational& turns) const {
  const std::optional<std::int64_t> k = parts_of(turns);
  const Value two_i = product(2, root(root_count_ / 4));
  return k ? std::optional(quotient(difference(root(*k), root(-*k)), two_i)) : std::nullopt;
}

}  // namespace kinestat
