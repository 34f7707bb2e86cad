// Random expressions with the value that they have by another way than the library's.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "math/numbers/rational.hpp"

namespace kinestat::sample {

/// Exponents of length, mass, time and angle.
using Powers = std::array<int, 4>;

inline constexpr Powers kAngle = {0, 0, 0, 1};

enum class Kind { literal, unit, name, pi, negate, add, subtract, multiply, divide, power, call };

/// A tree of its own, which knows nothing of the library's nodes. A literal is
/// digits * 10^-decimals.
struct Tree {
  Kind kind = Kind::literal;
  int digits = 0;
  int decimals = 0;
  std::string word;  ///< of a unit, name or call
  std::vector<Tree> parts;
};

/// A unit by its definition: size = numerator/denominator * π^pi_power in SI.
struct UnitRow {
  const char* name;
  int numerator;
  int denominator;
  int pi_power;
  Powers powers;
};

/// A parameter: a whole number of thousandths in SI.
struct NameRow {
  const char* name;
  int thousandths;
  Powers powers;
};

const std::vector<UnitRow>& units();
const std::vector<NameRow>& names();

/// The names by which derivatives are taken: indices into names().
inline constexpr std::array<std::size_t, 2> kVariables = {0, 2};

// Only its four operations are used; all that the library adds to them is worked out anew.
using Fraction = Rational;

struct ExactValue {
  Fraction factor;
  int pi_power = 0;
};

enum class Verdict {
  value,      ///< there is a value
  dimension,  ///< dimensions do not fit
  undefined,  ///< division by zero, root of a negative number, …
  unclear     ///< rounding decides which of the others: not for comparison
};

/// What an expression means, in long double, with a bound for the rounding of doubles.
struct Meaning {
  Verdict verdict = Verdict::value;
  long double value = 0;
  long double error = 0;  ///< 0 where doubles do not round at all
  Powers powers{};
  std::array<long double, 2> slopes{};       ///< by kVariables
  std::array<long double, 2> slope_sizes{};  ///< sums of magnitudes
  bool is_smooth = true;                     ///< far enough from kinks to compare slopes
  std::optional<ExactValue> exact;
};

/// A tree of about that depth with the given dimension, or now and then with a fault in it.
Tree make_tree(std::mt19937& random, const Powers& powers, int depth);

Meaning meaning_of(const Tree& tree);

/// How max(max(a, b), c) is written; max(a, b, c) finds a fault of c before one of max(a, b).
enum class Calls { as_nested, also_flat };

/// The tree as text, in one of the many ways in which it can be written.
std::string text_of(std::mt19937& random, const Tree& tree, Calls calls);

}  // namespace kinestat::sample
