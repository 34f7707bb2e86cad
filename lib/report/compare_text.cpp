#include "report/compare_text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "core/version.hpp"
#include "report/json_values.hpp"
#include "report/numbers.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostPlaces = 50;
constexpr std::size_t kLongestText = 40;

// So many that three of them show the difference.
int digits_of(const Difference& difference) {
  constexpr double kFewest = 6.0;
  constexpr double kMost = 17.0;
  if (difference.type != DifferenceType::number) {
    return static_cast<int>(kFewest);
  }
  const double larger = std::max(std::abs(difference.a->number), std::abs(difference.b->number));
  const double equal_digits = std::ceil(std::log10(larger / difference.amount));
  return static_cast<int>(std::clamp(3.0 + equal_digits, kFewest, kMost));
}

// Printable, without its end if it is long; characters stay whole.
std::string shortened(const std::string& text) {
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  std::string shown = printable(text);
  if (shown.size() > kLongestText) {
    std::size_t end = kLongestText;
    while (end > 0 && continues(shown[end])) {
      --end;
    }
    shown = shown.substr(0, end) + "…";
  }
  return shown;
}

std::string cell(const Difference& difference, const std::optional<ReportValue>& value) {
  if (difference.count > 1) {
    return value ? fmt::format("{} values", difference.count) : "";
  }
  if (!value) {
    return difference.type == DifferenceType::text || difference.type == DifferenceType::no_value
               ? "several values"
               : "";
  }
  switch (value->type) {
    case ValueType::number:
      // The sum turns -0 into 0.
      return fmt::format("{:.{}g}", value->number + 0.0, digits_of(difference));
    case ValueType::text:
      return fmt::format("'{}'", shortened(value->text));
    case ValueType::null:
      return "null";
    case ValueType::empty:
      return "empty";
  }
  return "";
}

std::string unit_cell(const Difference& difference) {
  if (difference.type != DifferenceType::unit || difference.unit.text == difference.other_unit) {
    return difference.count > 1 ? "" : difference.unit.text;
  }
  const auto shown = [](const std::string& unit) { return unit.empty() ? "none" : unit; };
  return fmt::format("{}, {}", shown(difference.unit.text), shown(difference.other_unit));
}

std::vector<std::string> row_of(const Difference& difference) {
  const bool has_amount = difference.type == DifferenceType::number;
  return {printable(difference.place),
          cell(difference, difference.a),
          cell(difference, difference.b),
          has_amount ? format_short(difference.amount) : std::string(word_of(difference.type)),
          has_amount ? format_short(difference.allowed) : "",
          unit_cell(difference)};
}

// How far beyond its tolerance a number is; what is no number counts most.
double excess(const Difference& difference) {
  return difference.type == DifferenceType::number ? difference.amount / difference.allowed : 0.0;
}

std::string summary(const ReportComparison& comparison) {
  const std::vector<Difference>& all = comparison.differences;
  std::size_t count = 0;
  for (const Difference& one : all) {
    count += one.count;
  }
  const auto worst = std::ranges::max_element(all, {}, excess);
  std::string text = fmt::format("{} of {} values differ", count, comparison.value_count);
  if (all.size() > 1 && worst->type == DifferenceType::number) {
    text += fmt::format("; furthest from its tolerance is {}", printable(worst->place));
  }
  return text + "\n";
}

bool has_number(const Difference& difference) {
  const auto is_number = [](const std::optional<ReportValue>& value) {
    return value && value->type == ValueType::number;
  };
  return is_number(difference.a) || is_number(difference.b);
}

Json value_json(const ReportValue& value) {
  switch (value.type) {
    case ValueType::number:
      return number(value.number);
    case ValueType::text:
      return printable(value.text);
    case ValueType::null:
    case ValueType::empty:
      break;
  }
  return nullptr;
}

Json difference_json(const Difference& difference) {
  Json entry;
  entry["place"] = printable(difference.place);
  entry["type"] = word_of(difference.type);
  entry["count"] = difference.count;
  if (difference.count == 1) {
    entry["a"] = difference.a ? value_json(*difference.a) : Json(nullptr);
    entry["b"] = difference.b ? value_json(*difference.b) : Json(nullptr);
  }
  if (difference.count == 1 && has_number(difference)) {
    entry["kind"] = difference.unit.kind;
    entry["unit"] = difference.unit.text;
  }
  if (difference.type == DifferenceType::unit) {
    entry["other_unit"] = difference.other_unit;
  }
  if (difference.type == DifferenceType::number) {
    entry["difference"] = number(difference.amount);
    entry["tolerance"] = number(difference.allowed);
  }
  return entry;
}

}  // namespace

std::string comparison_text(const ReportComparison& comparison) {
  const std::vector<Difference>& all = comparison.differences;
  if (all.empty()) {
    return fmt::format("equal: {} values\n", comparison.value_count);
  }
  Table table({"Place", "A", "B", "Difference", "Tolerance", "Unit"});
  for (std::size_t i = 0; i < std::min(all.size(), kMostPlaces); ++i) {
    table.add(row_of(all[i]));
  }
  std::string text = table.text("");
  if (all.size() > kMostPlaces) {
    text += fmt::format("and {} more places; --format json lists all\n", all.size() - kMostPlaces);
  }
  return text + "\n" + summary(comparison);
}

std::string comparison_json(const ReportComparison& comparison,
                            const std::string& a,
                            const std::string& b) {
  Json result;
  result["kinestat"]["version"] = kVersion;
  result["kinestat"]["comparison"] = 1;
  result["a"] = printable(a);
  result["b"] = printable(b);
  result["status"] = comparison.differences.empty() ? "equal" : "different";
  result["values"] = comparison.value_count;
  result["differences"] = Json::array();
  for (const Difference& one : comparison.differences) {
    result["differences"].push_back(difference_json(one));
  }
  return result.dump(2) + "\n";
}

}  // namespace kinestat
