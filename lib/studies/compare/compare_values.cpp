#include "studies/compare/compare_values.hpp"

#include <algorithm>
#include <utility>

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

std::string kind_of(const Dimension& dimension) {
  for (const QuantityKind kind : all_quantity_kinds()) {
    if (has_word(kind) && fits(dimension, kind)) {
      return word_of(kind);
    }
  }
  return "number";
}

}  // namespace

const std::vector<std::string>& value_kinds() {
  static const std::vector<std::string> kinds = list_kinds();
  return kinds;
}

ValueUnit count_unit() {
  return bare_unit("count");
}

ValueUnit bare_unit(std::string kind) {
  return {.kind = std::move(kind), .text = {}, .scale = {}, .dimension = {}, .assumes = {}};
}

ValueUnit unit_per(const ValueUnit& above, const ValueUnit& below) {
  return {.kind = "ratio",
          .text = above.text + " per " + below.text,
          .scale = above.scale / below.scale,
          .dimension = above.dimension / below.dimension,
          .assumes = above.assumes + below.assumes};
}

std::variant<ValueUnit, ExpressionError> read_unit(std::string_view text) {
  if (text.empty() || text == "1") {
    return bare_unit("number");
  }
  // A ratio of two kinds has a unit of two, "rad/s per mm/s"; its derivative one more,
  // "rad/s per mm/s per mm", in which each divides all before it.
  constexpr std::string_view kPer = " per ";
  if (const std::size_t per = text.rfind(kPer); per != std::string_view::npos) {
    const auto above = read_unit(text.substr(0, per));
    const auto below = read_unit(text.substr(per + kPer.size()));
    for (const auto* part : {&above, &below}) {
      if (const auto* error = std::get_if<ExpressionError>(part)) {
        return *error;
      }
    }
    return unit_per(std::get<ValueUnit>(above), std::get<ValueUnit>(below));
  }
  auto parsed = parse_unit(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    return *error;
  }
  const auto& unit = std::get<UnitExpression>(parsed);
  return ValueUnit{.kind = kind_of(unit.dimension),
                   .text = unit.text,
                   .scale = unit.scale,
                   .dimension = unit.dimension,
                   .assumes = {}};
}

ReportValue KeptValue::value() const {
  return {.place = std::string(place),
          .type = type,
          .number = number,
          .unit = unit,
          .text = std::string(text)};
}

const KeptValue* ReportValues::find(std::string_view place) const {
  for (; indexed_count_ < items_.size(); ++indexed_count_) {
    index_.emplace(items_[indexed_count_].place, indexed_count_);
  }
  const auto at = index_.find(place);
  return at == index_.end() ? nullptr : &items_[at->second];
}

bool ReportValues::add(const ReportValue& value) {
  if (find(value.place) != nullptr) {
    return false;
  }
  append(value);
  return true;
}

bool ReportValues::add_number(std::string_view place, double number, const ValueUnit& unit) {
  if (find(place) != nullptr) {
    return false;
  }
  append_number(place, number, unit);
  return true;
}

void ReportValues::append(const ReportValue& value) {
  keep(value.place,
       {.place = {},
        .text = kept(value.text),
        .number = value.number,
        .unit = static_cast<std::uint32_t>(value.unit),
        .type = value.type});
}

void ReportValues::append_number(std::string_view place, double number, const ValueUnit& unit) {
  keep(place,
       {.place = {},
        .text = {},
        .number = number,
        .unit = index_of(unit),
        .type = ValueType::number});
}

void ReportValues::keep(std::string_view place, KeptValue value) {
  value.place = kept(place);
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
