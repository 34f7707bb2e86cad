#include "expression/functions.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "expression/units.hpp"

namespace kinestat {

namespace {

constexpr auto kFunctions = std::to_array<FunctionName>({
    {"sin", Function::sin, Arity::one},
    {"cos", Function::cos, Arity::one},
    {"tan", Function::tan, Arity::one},
    {"asin", Function::asin, Arity::one},
    {"acos", Function::acos, Arity::one},
    {"atan", Function::atan, Arity::one},
    {"atan2", Function::atan2, Arity::two},
    {"sqrt", Function::sqrt, Arity::one},
    {"abs", Function::abs, Arity::one},
    {"exp", Function::exp, Arity::one},
    {"log", Function::log, Arity::one},
    {"ln", Function::ln, Arity::one},
    {"log10", Function::log10, Arity::one},
    {"min", Function::min, Arity::two_or_more},
    {"max", Function::max, Arity::two_or_more},
    {"floor", Function::floor, Arity::one},
    {"ceil", Function::ceil, Arity::one},
    {"round", Function::round, Arity::one},
    {"mod", Function::mod, Arity::two},
    {"gcd", Function::gcd, Arity::two_or_more},
    {"hypot", Function::hypot, Arity::two_or_more},
});

constexpr auto kConditionWords = std::to_array<std::string_view>({"and", "or", "not"});

std::vector<std::string> list_function_names() {
  std::vector<std::string> names;
  for (const FunctionName& row : kFunctions) {
    names.emplace_back(row.name);
  }
  return names;
}

std::vector<std::string> list_reserved_names() {
  std::vector<std::string> names(unit_names().begin(), unit_names().end());
  names.insert(names.end(), function_names().begin(), function_names().end());
  names.emplace_back("pi");
  names.insert(names.end(), kConditionWords.begin(), kConditionWords.end());
  return names;
}

}  // namespace

const FunctionName* find_function(std::string_view name) {
  const auto at = std::ranges::find(kFunctions, name, &FunctionName::name);
  return at != kFunctions.end() ? &*at : nullptr;
}

std::string_view name_of(Function function) {
  return std::ranges::find(kFunctions, function, &FunctionName::function)->name;
}

std::span<const std::string> function_names() {
  static const std::vector<std::string> names = list_function_names();
  return names;
}

bool is_condition_word(std::string_view word) {
  return std::ranges::find(kConditionWords, word) != kConditionWords.end();
}

std::span<const std::string> reserved_names() {
  static const std::vector<std::string> names = list_reserved_names();
  return names;
}

bool is_reserved_name(std::string_view name) {
  return std::ranges::any_of(reserved_names(), [name](const std::string& one) {
    return name.starts_with(one.front()) && one == name;
  });
}

}  // namespace kinestat
