#include "studies/compare/compare_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "expression/evaluate.hpp"
#include "studies/compare/compare_place.hpp"

namespace kinestat {

namespace {

// Says what is wrong with one option.
class OptionReader {
 public:
  OptionReader(std::string option, Diagnostics& found)
      : option_(std::move(option)), found_(found) {}

  // A number that is not negative, perhaps with a unit; "0.1%" is 0.001 and relative.
  std::optional<ToleranceRule> read(std::string_view text) {
    ToleranceRule rule;
    rule.is_relative = text.ends_with('%');
    text.remove_suffix(rule.is_relative ? 1 : 0);
    const auto parsed = parse_expression(text);
    if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
      return refuse(error->message);
    }
    const auto value = evaluate(std::get<Expression>(parsed), no_names);
    if (const auto* error = std::get_if<ExpressionError>(&value)) {
      return refuse(error->message);
    }
    const auto& quantity = std::get<Quantity>(value);
    if (!(quantity.value >= 0.0)) {
      return refuse("a tolerance is not negative");
    }
    if (is_bare(quantity.dimension)) {
      rule.value = rule.is_relative ? quantity.value / 100 : quantity.value;
      return rule;
    }
    if (rule.is_relative) {
      return refuse("a percentage has no unit");
    }
    rule.value = quantity.value;
    rule.dimension = quantity.dimension;
    return rule;
  }

  std::nullopt_t refuse(std::string_view problem,
                        std::string hint = "write a number such as 1e-6") {
    found_.error("E0101", {}, fmt::format("{}: {}", option_, printable(problem)), std::move(hint));
    return std::nullopt;
  }

 private:
  std::string option_;
  Diagnostics& found_;
};

std::optional<double> read_bare(const std::string& option,
                                const std::string& text,
                                Diagnostics& found) {
  if (text.empty()) {
    return {};
  }
  OptionReader reader(fmt::format("{} '{}'", option, printable(text)), found);
  const std::optional<ToleranceRule> rule = reader.read(text);
  if (rule && (rule->dimension || rule->is_relative)) {
    return reader.refuse("this is for values of every kind, so it is a bare number");
  }
  return rule ? std::optional(rule->value) : std::nullopt;
}

std::optional<ToleranceRule> read_rule(const std::string& text, Diagnostics& found) {
  OptionReader reader(fmt::format("--tolerance '{}'", printable(text)), found);
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) {
    return reader.refuse("this is not KEY=VALUE", "write for example --tolerance moment=1e-6");
  }
  const std::string key = text.substr(0, equals);
  const bool is_place = key.starts_with('/');
  if (!is_place && std::ranges::find(value_kinds(), key) == value_kinds().end()) {
    return reader.refuse(
        fmt::format("there is no kind of quantity '{}'", key),
        guess_before(key,
                     value_kinds(),
                     fmt::format("kinds are {}; a place begins with '/'",
                                 plain_list(value_kinds(), value_kinds().size()))));
  }
  std::optional<ToleranceRule> rule = reader.read(text.substr(equals + 1));
  if (!rule) {
    return {};
  }
  if (rule->dimension && !is_place && !may_measure(*rule->dimension, key)) {
    return reader.refuse(
        fmt::format("this is {}, not of the kind '{}'", phrase_of(*rule->dimension), key),
        "write a unit that fits, or the number alone");
  }
  rule->key = key;
  return rule;
}

bool fits(const ToleranceRule& rule, const NumberPair& pair) {
  const bool is_meant =
      rule.is_place() ? is_within(pair.place, rule.key) : rule.key == pair.unit.kind;
  return is_meant && (!rule.dimension || *rule.dimension == pair.unit.dimension);
}

double larger_of(const NumberPair& pair) {
  return std::max(std::abs(pair.a), std::abs(pair.b));
}

}  // namespace

std::optional<Tolerances> read_tolerances(const ToleranceTexts& texts, Diagnostics& found) {
  Tolerances result;
  result.relative = read_bare("--rtol", texts.rtol, found).value_or(kReportsAgree);
  result.absolute = read_bare("--atol", texts.atol, found);
  for (const std::string& text : texts.tolerances) {
    if (std::optional<ToleranceRule> rule = read_rule(text, found)) {
      result.rules.push_back(*std::move(rule));
    }
  }
  return found.has_errors() ? std::nullopt : std::optional(std::move(result));
}

double allowed_difference(const NumberPair& pair, const Tolerances& tolerances) {
  const auto rule = std::find_if(tolerances.rules.rbegin(),
                                 tolerances.rules.rend(),
                                 [&](const ToleranceRule& one) { return fits(one, pair); });
  if (rule != tolerances.rules.rend()) {
    return rule->is_relative ? rule->value * larger_of(pair)
           : rule->dimension ? pair.unit.scale.from_si(rule->value)
                             : rule->value;
  }
  if (pair.unit.kind == count_unit().kind) {
    return 0.0;
  }
  return std::max(tolerances.relative * larger_of(pair),
                  tolerances.absolute.value_or(kReportsAgreeBesideLargest * pair.largest));
}

bool are_equal(const NumberPair& pair, double allowed) {
  if (allowed == 0.0) {
    return pair.a == pair.b;
  }
  const double rounding = kEpsilon * larger_of(pair) + kEpsilon * allowed;
  return std::abs(pair.a - pair.b) <= allowed + rounding;
}

}  // namespace kinestat
