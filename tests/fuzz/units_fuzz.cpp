// Any text as a unit: a scale that goes there and back, or an error with its place.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "expression/file_units.hpp"
#include "expression/units.hpp"
#include "fuzz/diagnostic_invariants.hpp"
#include "fuzz/require.hpp"

namespace kinestat::fuzz {

namespace {

void check_scale(const UnitScale& scale, std::string_view text) {
  const double factor = scale.factor();
  require(std::isfinite(factor) && factor > 0.0, "a unit has a size", text);
  require(std::abs(scale.from_si(scale.to_si(3.0)) - 3.0) < 1e-9, "a unit goes back", text);
}

// The kind takes the unit or says why not; then it and what follows from it are still units.
void check_kind(QuantityKind kind, const std::string& text) {
  static const FileUnits kDefaults;
  FileUnits units = kDefaults;
  if (const auto error = units.set(kind, text)) {
    check_error(*error, text);
    require(units.text(kind) == kDefaults.text(kind), "a refused unit changes nothing", text);
    return;
  }
  require(!units.text(kind).empty(), "an accepted unit has a text", text);
  for (const QuantityKind other : all_quantity_kinds()) {
    const double factor = units.factor(other);
    require(std::isfinite(factor) && factor > 0.0, "a unit of the file has a size", text);
  }
}

void check_text(const std::string& text) {
  const auto parsed = parse_unit(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    check_error(*error, text);
    check_kind(QuantityKind::length, text);
    return;
  }
  const auto& unit = std::get<UnitExpression>(parsed);
  check_scale(unit.scale, text);
  const auto again = parse_unit(unit.text);
  require(std::holds_alternative<UnitExpression>(again), "its text is a unit again", text);
  require(std::get<UnitExpression>(again).scale == unit.scale &&
              std::get<UnitExpression>(again).dimension == unit.dimension,
          "its text is the same unit again",
          text);
  // One kind a text, which decides which: all would be as many times slower than the rest.
  static const std::vector<QuantityKind> kKinds = [] {
    std::vector<QuantityKind> kinds;
    std::ranges::copy_if(all_quantity_kinds(), std::back_inserter(kinds), [](QuantityKind kind) {
      return !key_of(kind).empty();
    });
    return kinds;
  }();
  check_kind(kKinds[sum_of(text) % kKinds.size()], text);
}

}  // namespace

}  // namespace kinestat::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinestat::fuzz::check_text(std::string(data, data + size));
  return 0;
}
