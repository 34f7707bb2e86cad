// The functions of expressions.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "expression/evaluate/arithmetic.hpp"
#include "expression/evaluate/settled_whole.hpp"
#include "math/numbers/typed_angle.hpp"

namespace kinestat {

namespace {

constexpr Dimension kAngleDimension{0, 0, 0, 1};
constexpr double kLargestWhole = 9007199254740992.0;  // 2^53: up to here doubles count by one

Fault argument_fault(std::string message, std::string hint) {
  return {.code = "E0309",
          .message = std::move(message),
          .hint = std::move(hint),
          .part = Fault::Part::left};
}

Fault value_fault(std::string message, std::string hint) {
  return {.code = "E0316",
          .message = std::move(message),
          .hint = std::move(hint),
          .part = Fault::Part::left};
}

Outcome apply_to_angle(Function function, const Quantity& a) {
  using enum Function;
  if (a.dimension != kAngleDimension) {
    return argument_fault(
        fmt::format("'{}' takes an angle, not {}", name_of(function), phrase_of(a.dimension)),
        "write 30 deg or 0.52 rad, here or where its value is given");
  }
  if (function == tan && cosine(a.value) == 0.0) {
    return value_fault("'tan' of an odd multiple of 90 deg does not exist",
                       "check the values that the angle is made of");
  }
  const double value = function == sin   ? sine(a.value)
                       : function == cos ? cosine(a.value)
                                         : tangent(a.value);
  return checked({value, {}});
}

Outcome to_angle(Function function, const Quantity& a) {
  using enum Function;
  if (function != atan && std::abs(a.value) > 1.0) {
    return value_fault(fmt::format("'{}' of {} does not exist", name_of(function), a.value),
                       "the value in brackets must lie from -1 to 1");
  }
  const double value = function == asin   ? std::asin(a.value)
                       : function == acos ? std::acos(a.value)
                                          : std::atan(a.value);
  return checked({value, kAngleDimension});
}

Outcome logarithm(Function function, const Quantity& a) {
  using enum Function;
  if (a.value <= 0.0) {
    return value_fault(fmt::format("'{}' of {} does not exist", name_of(function), a.value),
                       "the value in brackets must be greater than zero");
  }
  return checked({function == log10 ? std::log10(a.value) : std::log(a.value), {}});
}

Outcome square_root(const Quantity& a) {
  const Dimension& d = a.dimension;
  if (d.length % 2 != 0 || d.mass % 2 != 0 || d.time % 2 != 0 || d.angle % 2 != 0) {
    return argument_fault(fmt::format("{} has no square root", phrase_of(d)),
                          "a length, for example, is the root of a length squared");
  }
  if (a.value < 0.0) {
    return value_fault(fmt::format("'sqrt' of {} does not exist", a.value),
                       "the value under the root must not be negative");
  }
  return checked({std::sqrt(a.value), {d.length / 2, d.mass / 2, d.time / 2, d.angle / 2}});
}

Outcome apply_to_bare(Function function, const Quantity& a) {
  using enum Function;
  if (!is_bare(a.dimension)) {
    return argument_fault(
        fmt::format("'{}' takes a bare number, not {}", name_of(function), phrase_of(a.dimension)),
        "divide by a unit first, such as x/(1 mm)");
  }
  switch (function) {
    case asin:
    case acos:
    case atan:
      return to_angle(function, a);
    case log:
    case ln:
    case log10:
      return logarithm(function, a);
    case exp:
      return checked({std::exp(a.value), {}}, Zero::underflow);
    case floor:
      return checked({std::floor(settled_whole(a.value)), {}});
    case ceil:
      return checked({std::ceil(settled_whole(a.value)), {}});
    default:
      KINESTAT_EXPECTS(function == round);
      return checked({std::round(settled_whole(2.0 * a.value) / 2.0), {}});
  }
}

bool is_whole_double(double value) {
  return std::floor(value) == value;
}

// From there on a double stands for several whole numbers.
bool is_beyond_whole(double value) {
  return !(std::abs(value) < kLargestWhole);
}

Fault whole_fault(Function function, const Quantity& a, const Quantity& b) {
  const bool is_first = is_beyond_whole(a.value);
  return Fault{.code = "E0316",
               .message = fmt::format("'{}' of {} has no sure answer: from 2^53 on whole numbers "
                                      "are rounded",
                                      name_of(function),
                                      is_first ? a.value : b.value),
               .hint = "its values must lie below 9007199254740992",
               .part = is_first ? Fault::Part::left : Fault::Part::right};
}

// Of whole numbers it is exact.
Outcome remainder(const Quantity& a, const Quantity& b) {
  if (b.value == 0.0) {
    return Fault{.code = "E0316",
                 .message = "division by zero in 'mod'",
                 .hint = "the second value must not be zero",
                 .part = Fault::Part::right};
  }
  const bool are_whole = is_whole_double(a.value) && is_whole_double(b.value);
  if (are_whole && (is_beyond_whole(a.value) || is_beyond_whole(b.value))) {
    return whole_fault(Function::mod, a, b);
  }
  if (is_beyond_whole(a.value / b.value)) {
    return value_fault("'mod' has no sure answer: its first value is 2^53 times the second or more",
                       "its rest is lost in the rounding of the first");
  }
  if (!are_whole && is_settled_whole(a.value / b.value)) {
    return checked({0.0, a.dimension});
  }
  const double rest = std::fmod(a.value, b.value);
  const bool has_other_sign = rest != 0.0 && (rest < 0.0) != (b.value < 0.0);
  return checked({has_other_sign ? rest + b.value : rest + 0.0, a.dimension});
}

Outcome divisor_of(const Quantity& a, const Quantity& b) {
  if (!is_bare(a.dimension) || !is_whole_double(a.value) || !is_whole_double(b.value)) {
    return Fault{.code = is_bare(a.dimension) ? "E0316" : "E0309",
                 .message = "'gcd' takes whole numbers",
                 .hint = "write whole numbers such as teeth"};
  }
  if (is_beyond_whole(a.value) || is_beyond_whole(b.value)) {
    return whole_fault(Function::gcd, a, b);
  }
  const auto divisor = std::gcd(static_cast<long long>(a.value), static_cast<long long>(b.value));
  return Quantity{static_cast<double>(divisor), {}};
}

Outcome apply_to_pair(Function function, const Quantity& a, const Quantity& b) {
  using enum Function;
  if (a.dimension != b.dimension) {
    return Fault{.code = "E0309",
                 .message = fmt::format("'{}' takes values that measure the same, not {} and {}",
                                        name_of(function),
                                        phrase_of(a.dimension),
                                        phrase_of(b.dimension)),
                 .hint = "write both with a unit of the same kind, or both without"};
  }
  switch (function) {
    case atan2:  // + 0.0: minus zero is zero, so that (0, -1) is at 180 deg, never at -180 deg
      return checked({std::atan2(a.value + 0.0, b.value + 0.0), kAngleDimension});
    case min:
      return Quantity{std::min(a.value, b.value), a.dimension};
    case max:
      return Quantity{std::max(a.value, b.value), a.dimension};
    case mod:
      return remainder(a, b);
    case gcd:
      return divisor_of(a, b);
    default:
      KINESTAT_EXPECTS(function == hypot);
      return checked({std::hypot(a.value, b.value), a.dimension});
  }
}

}  // namespace

Outcome apply(Function function, const Quantity& a, const Quantity& b) {
  using enum Function;
  switch (function) {
    case sin:
    case cos:
    case tan:
      return apply_to_angle(function, a);
    case sqrt:
      return square_root(a);
    case abs:
      return checked({std::abs(a.value), a.dimension});
    case asin:
    case acos:
    case atan:
    case exp:
    case log:
    case ln:
    case log10:
    case floor:
    case ceil:
    case round:
      return apply_to_bare(function, a);
    case atan2:
    case min:
    case max:
    case mod:
    case gcd:
    case hypot:
      break;
  }
  return apply_to_pair(function, a, b);
}

}  // namespace kinestat
