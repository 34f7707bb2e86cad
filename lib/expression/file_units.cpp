#include "expression/file_units.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"

namespace kinestat {

namespace {

constexpr auto kDefaults = std::to_array<std::pair<QuantityKind, std::string_view>>({
    {QuantityKind::length, "m"},
    {QuantityKind::angle, "rad"},
    {QuantityKind::time, "s"},
    {QuantityKind::mass, "kg"},
    {QuantityKind::inertia, "kg*m^2"},
    {QuantityKind::force, "N"},
    {QuantityKind::moment, "N*m"},
    {QuantityKind::angular_velocity, "rad/s"},
    {QuantityKind::angular_acceleration, "rad/s^2"},
    {QuantityKind::power, "W"},
    {QuantityKind::energy, "J"},
    {QuantityKind::stiffness, "N/m"},
});

// A divisor needs parentheses when it is not a single name.
std::string divisor(const std::string& text) {
  return text.find_first_of("*/") == std::string::npos ? text : fmt::format("({})", text);
}

ExpressionError wrong_dimension(const UnitExpression& unit, QuantityKind kind) {
  return {.offset = 0,
          .length = static_cast<int>(unit.text.size()),
          .code = "E0309",
          .message = fmt::format(
              "'{}' measures {}, not {}", unit.text, phrase_of(unit.dimension), phrase_of(kind)),
          .hint = fmt::format("write a unit as in {}", example_of(kind))};
}

}  // namespace

FileUnits::FileUnits() {
  // All defaults have the factor 1.
  for (const auto& [kind, text] : kDefaults) {
    unit(kind).text = text;
  }
  derive();
}

std::optional<ExpressionError> FileUnits::set(QuantityKind kind, std::string_view text) {
  KINESTAT_EXPECTS(kind != QuantityKind::dimensionless);
  auto parsed = parse_unit(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    return *error;
  }
  auto& chosen = std::get<UnitExpression>(parsed);
  if (!fits(chosen.dimension, kind)) {
    return wrong_dimension(chosen, kind);
  }
  unit(kind) = {chosen.scale, std::move(chosen.text), true};
  derive();
  return std::nullopt;
}

void FileUnits::derive() {
  const Entry& length = unit(QuantityKind::length);
  const Entry& time = unit(QuantityKind::time);
  const Entry& moment = unit(QuantityKind::moment);
  const std::string second = divisor(time.text);
  derive(QuantityKind::velocity, length.scale / time.scale, length.text + "/" + second);
  derive(QuantityKind::acceleration,
         length.scale / time.scale / time.scale,
         length.text + "/" + second + "^2");
  derive(QuantityKind::pitch, length.scale, length.text + "/rad");
  derive(QuantityKind::lead, length.scale, length.text + "/rev");
  derive(QuantityKind::angular_stiffness, moment.scale, moment.text + "/rad");
}

void FileUnits::derive(QuantityKind kind, const UnitScale& scale, std::string text) {
  if (!unit(kind).is_set) {
    unit(kind) = {scale, std::move(text), false};
  }
}

NamedUnit FileUnits::unit_of(const Dimension& dimension) const {
  if (is_bare(dimension)) {
    return {};
  }
  for (const QuantityKind kind : all_quantity_kinds()) {
    if (dimension_of(kind) == dimension) {
      return {.text = text(kind), .scale = scale(kind)};
    }
  }
  return {.text = si_unit_of(dimension), .scale = {}};
}

}  // namespace kinestat
