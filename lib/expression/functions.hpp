// The functions that expressions may call.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace kinestat {

/// `ln` and `log` are both the natural logarithm. `mod` has the sign of the divisor, `round` takes
/// halves away from zero, `gcd` is that of whole numbers.
enum class Function : std::uint8_t {
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  sqrt,
  abs,
  exp,
  log,
  ln,
  log10,
  min,
  max,
  floor,
  ceil,
  round,
  mod,
  gcd,
  hypot
};

/// How many values a function takes.
enum class Arity { one, two, two_or_more };

struct FunctionName {
  std::string_view name;
  Function function = Function::sin;
  Arity arity = Arity::one;
};

/// The function of that name, or null.
const FunctionName* find_function(std::string_view name);

/// "sin".
std::string_view name_of(Function function);

/// Every function's name, for messages.
std::span<const std::string> function_names();

/// True for and, or, not.
bool is_condition_word(std::string_view word);

/// What conditions of a sweep ask of planets, as assembles(planet).
inline constexpr std::string_view kAssembles = "assembles";
inline constexpr std::string_view kClears = "clears";

/// True for one of them.
constexpr bool is_condition_question(std::string_view word) {
  return word == kAssembles || word == kClears;
}

/// Names that parameters may not have: units, functions, constants and the words of conditions.
std::span<const std::string> reserved_names();

/// True for one of them.
bool is_reserved_name(std::string_view name);

}  // namespace kinestat
