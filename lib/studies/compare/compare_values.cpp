#include "studies/compare/compare_values.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "expression/unit_quotient.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kBlockSize = std::size_t{1} << 16U;

// The key that tolerances use for a kind: "angular_velocity".
std::string word_of(QuantityKind kind) {
  std::string word(name_of(kind));
  std::ranges::replace(word, ' ', '_');
  return word;
}

// A pitch is told from a length by its radian alone, a lead from a pitch by nothing.
bool has_word(QuantityKind kind) {
  return kind != QuantityKind::dimensionless && kind != QuantityKind::pitch &&
         kind != QuantityKind::lead;
}

std::vector<std::string> list_kinds() {
  std::vector<std::string> kinds;
  for (const QuantityKind kind : all_quantity_kinds()) {
    if (has_word(kind)) {
      kinds.push_back(word_of(kind));
    }
  }
  kinds.insert(kinds.end(), {"ratio", "efficiency", "direction", "count", "number"});
  return kinds;
}

// Moments have products for units, one of which has the name Nm; the names of others, such as kJ,
// are those of energies.
bool is_of_energy(const UnitExpression& unit) {
  return fits(unit.dimension, QuantityKind::energy) && unit.text != "Nm" &&
         unit.text.find_first_of("*/") == std::string::npos;
}

// A stiffness about an axis fits moments, too, as an angle has no dimension.
std::string kind_of(const UnitExpression& unit) {
  if (is_of_energy(unit)) {
    return word_of(QuantityKind::energy);
  }
  for (const bool is_exact : {true, false}) {
    for (const QuantityKind kind : all_quantity_kinds()) {
      const bool is_meant =
          is_exact ? dimension_of(kind) == unit.dimension : fits(unit.dimension, kind);
      if (has_word(kind) && is_meant) {
        return word_of(kind);
      }
    }
  }
  return "number";
}

struct SplitPlace {
  std::string_view parent;
  std::string_view key;
};

SplitPlace split(std::string_view place) {
  const std::size_t slash = place.rfind('/');
  return slash == std::string_view::npos
             ? SplitPlace{.parent = {}, .key = place}
             : SplitPlace{.parent = place.substr(0, slash), .key = place.substr(slash + 1)};
}

std::size_t hash_of(std::string_view parent, std::string_view key) {
  const std::hash<std::string_view> hash;
  return 31 * hash(parent) + hash(key);
}

}  // namespace

const std::vector<std::string>& value_kinds() {
  static const std::vector<std::string> kinds = list_kinds();
  return kinds;
}

bool may_measure(const Dimension& dimension, std::string_view kind) {
  for (const QuantityKind one : all_quantity_kinds()) {
    if (has_word(one) && word_of(one) == kind) {
      return fits(dimension, one);
    }
  }
  return kind_of({.scale = {}, .dimension = dimension, .text = si_unit_of(dimension)}) == kind;
}

ValueUnit count_unit() {
  return bare_unit("count");
}

ValueUnit bare_unit(std::string kind) {
  return {.kind = std::move(kind), .text = {}, .scale = {}, .dimension = {}, .assumes = {}};
}

ValueUnit unit_per(const ValueUnit& above, const ValueUnit& below) {
  return {.kind = "ratio",
          .text = unit_quotient(above.text, below.text),
          .scale = above.scale / below.scale,
          .dimension = above.dimension / below.dimension,
          .assumes = above.assumes + below.assumes};
}

namespace {

// A quotient has a unit of two, "N/(kg*mm)". Versions up to 0.2.0 wrote it "rad/s per
// mm/s", and its derivative "rad/s per mm/s per mm", in which each divides all before it.
std::optional<std::pair<std::string_view, std::string_view>> parts_of_quotient(
    std::string_view text) {
  constexpr std::string_view kPer = " per ";
  if (const std::size_t per = text.rfind(kPer); per != std::string_view::npos) {
    return std::pair(text.substr(0, per), text.substr(per + kPer.size()));
  }
  const std::size_t over = text.ends_with(')') ? text.rfind("/(") : std::string_view::npos;
  if (over == std::string_view::npos) {
    return std::nullopt;
  }
  return std::pair(text.substr(0, over), text.substr(over + 2, text.size() - over - 3));
}

}  // namespace

std::variant<ValueUnit, ExpressionError> read_unit(std::string_view text) {
  if (text.empty() || text == "1") {
    return bare_unit("number");
  }
  if (const auto parts = parts_of_quotient(text)) {
    const auto above = read_unit(parts->first);
    const auto below = read_unit(parts->second);
    for (const auto* part : {&above, &below}) {
      if (const auto* error = std::get_if<ExpressionError>(part)) {
        return *error;
      }
    }
    return unit_per(std::get<ValueUnit>(above), std::get<ValueUnit>(below));
  }
  auto parsed = parse_unit(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    // Units of one dimension, "mm/m" or "N*m/N/mm", are none to a file.
    const std::size_t over = text.ends_with(')') ? std::string_view::npos : text.rfind('/');
    if (over == std::string_view::npos || over == 0) {
      return *error;
    }
    const auto above = read_unit(text.substr(0, over));
    const auto below = read_unit(text.substr(over + 1));
    const bool are_units =
        std::holds_alternative<ValueUnit>(above) && std::holds_alternative<ValueUnit>(below);
    return are_units ? std::variant<ValueUnit, ExpressionError>(
                           unit_per(std::get<ValueUnit>(above), std::get<ValueUnit>(below)))
                     : std::variant<ValueUnit, ExpressionError>(*error);
  }
  const auto& unit = std::get<UnitExpression>(parsed);
  return ValueUnit{.kind = kind_of(unit),
                   .text = unit.text,
                   .scale = unit.scale,
                   .dimension = unit.dimension,
                   .assumes = {}};
}

std::string KeptValue::place() const {
  std::string result;
  result.reserve(parent.size() + 1 + key.size());
  return result.append(parent).append("/").append(key);
}

ReportValue KeptValue::value() const {
  return {
      .place = place(), .type = type, .number = number, .unit = unit, .text = std::string(text)};
}

const KeptValue* ReportValues::find(std::string_view place) const {
  const auto [parent, key] = split(place);
  const auto position = position_of(parent, key);
  return position ? &items_[*position] : nullptr;
}

std::optional<std::size_t> ReportValues::position_of(std::string_view parent,
                                                     std::string_view key) const {
  for (std::size_t i = index_.count(); i < items_.size(); ++i) {
    index_.add(hash_of(items_[i].parent, items_[i].key), static_cast<std::uint32_t>(i));
  }
  return index_.find(hash_of(parent, key), [&](std::uint32_t item) {
    return items_[item].key == key && items_[item].parent == parent;
  });
}

bool ReportValues::add(std::string_view place, ValueType type, std::string_view text) {
  if (find(place) != nullptr) {
    return false;
  }
  append(place, type, text);
  return true;
}

bool ReportValues::add_number(std::string_view place, double number, const ValueUnit& unit) {
  if (find(place) != nullptr) {
    return false;
  }
  append_number(place, number, index_of(unit));
  return true;
}

void ReportValues::append(std::string_view place, ValueType type, std::string_view text) {
  KeptValue value;
  value.text = kept(text);
  value.type = type;
  keep(place, value);
}

void ReportValues::append_number(std::string_view place, double number, std::uint32_t unit) {
  KeptValue value;
  value.number = number;
  value.unit = unit;
  value.type = ValueType::number;
  keep(place, value);
}

void ReportValues::keep(std::string_view place, KeptValue value) {
  const auto [parent, key] = split(place);
  const bool has_neighbour = !items_.empty() && items_.back().parent == parent;
  value.parent = has_neighbour ? items_.back().parent : kept(parent);
  value.key = kept(key);
  items_.push_back(value);
}

// Blocks stay where they are when the report moves: the deque owns them, and none is so short that
// a string would hold it in itself.
std::string_view ReportValues::kept(std::string_view text) {
  if (blocks_.empty() || blocks_.back().capacity() - blocks_.back().size() < text.size()) {
    blocks_.emplace_back().reserve(std::max(kBlockSize, text.size()));
  }
  std::string& block = blocks_.back();
  const std::size_t begin = block.size();
  block += text;
  return std::string_view(block).substr(begin);
}

std::uint32_t ReportValues::index_of(const ValueUnit& unit) {
  const auto at = std::ranges::find(units_, unit);
  const auto index = static_cast<std::uint32_t>(at - units_.begin());
  if (at == units_.end()) {
    units_.push_back(unit);
  }
  return index;
}

}  // namespace kinestat
