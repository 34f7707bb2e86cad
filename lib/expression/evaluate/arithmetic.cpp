#include "expression/evaluate/arithmetic.hpp"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace kinestat {

namespace {

constexpr int kLargestExponent = 1000;  // of a base quantity: keeps the exponents far from overflow

Fault dimension_fault(std::string message,
                      std::string hint,
                      Fault::Part part = Fault::Part::whole) {
  return {.code = "E0309", .message = std::move(message), .hint = std::move(hint), .part = part};
}

bool is_countable(const Dimension& d) {
  return std::abs(d.length) <= kLargestExponent && std::abs(d.mass) <= kLargestExponent &&
         std::abs(d.time) <= kLargestExponent && std::abs(d.angle) <= kLargestExponent;
}

}  // namespace

Fault different(const Dimension& a, const Dimension& b, std::string_view joined) {
  const bool has_bare = is_bare(a) || is_bare(b);
  return dimension_fault(
      fmt::format("{} and {} cannot be {}", phrase_of(a), phrase_of(b), joined),
      has_bare ? "write a unit after the bare number" : "both must measure the same");
}

Outcome checked(const Quantity& result, Zero zero) {
  if (!std::isfinite(result.value)) {
    return Fault{.code = "E0316",
                 .message = "the result is not finite",
                 .hint = "numbers reach to about 1.8e308"};
  }
  if (zero == Zero::underflow && result.value == 0.0) {
    return Fault{.code = "E0316",
                 .message = "the result is too small (underflow)",
                 .hint = "numbers reach down to about 4.9e-324; write 0 if that is meant"};
  }
  if (!is_countable(result.dimension)) {
    return dimension_fault("the dimension of the result is beyond any use", "check the powers");
  }
  return result;
}

Outcome add(const Quantity& a, const Quantity& b) {
  if (a.dimension != b.dimension) {
    return different(a.dimension, b.dimension, "added");
  }
  return checked({a.value + b.value, a.dimension});
}

Outcome subtract(const Quantity& a, const Quantity& b) {
  if (a.dimension != b.dimension) {
    return different(a.dimension, b.dimension, "subtracted");
  }
  return checked({a.value - b.value, a.dimension});
}

Outcome multiply(const Quantity& a, const Quantity& b) {
  return checked({a.value * b.value, a.dimension * b.dimension},
                 zero_from(a.value == 0.0 ? a.value : b.value));
}

Outcome divide(const Quantity& a, const Quantity& b) {
  if (b.value == 0.0) {
    return Fault{.code = "E0316",
                 .message = "division by zero",
                 .hint = "check the values that the divisor is made of",
                 .part = Fault::Part::right};
  }
  return checked({a.value / b.value, a.dimension / b.dimension}, zero_from(a.value));
}

Outcome raise(const Quantity& base, const Quantity& exponent) {
  if (!is_bare(exponent.dimension)) {
    return dimension_fault(
        fmt::format("an exponent is a bare number, not {}", phrase_of(exponent.dimension)),
        "write the exponent without a unit",
        Fault::Part::right);
  }
  const bool is_whole = std::floor(exponent.value) == exponent.value;
  if (!is_bare(base.dimension) && !(is_whole && std::abs(exponent.value) <= kLargestExponent)) {
    return dimension_fault(
        fmt::format("{} can only be raised to a small whole power", phrase_of(base.dimension)),
        exponent.value == 0.5 ? "write sqrt( )" : "divide by a unit first",
        Fault::Part::right);
  }
  const int n = is_bare(base.dimension) ? 0 : static_cast<int>(exponent.value);
  if (base.value == 0.0 && exponent.value < 0.0) {
    return Fault{.code = "E0316",
                 .message = "division by zero: zero has no negative power",
                 .hint = "check the values that the base is made of",
                 .part = Fault::Part::left};
  }
  if (base.value < 0.0 && !is_whole) {
    return Fault{.code = "E0316",
                 .message = "a negative number has no fractional power",
                 .hint = "write a whole exponent, or a base that is not negative",
                 .part = Fault::Part::left};
  }
  return checked({std::pow(base.value, exponent.value), power(base.dimension, n)},
                 zero_from(base.value));
}

}  // namespace kinestat
