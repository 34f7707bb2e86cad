#include "studies/compare/compare_text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "core/version.hpp"
#include "report/json_archive.hpp"
#include "report/number_format.hpp"
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
  std::string shown = printable(text);
  if (shown.size() > kLongestText) {
    std::size_t end = kLongestText;
    while (end > 0 && !begins_character(shown[end])) {
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

void write_compared(const std::optional<ReportValue>& value, Archive& to) {
  if (value && value->type == ValueType::number) {
    to.number(value->number, {});
  } else if (value && value->type == ValueType::text) {
    to.text(printable(value->text));
  } else {
    to.null();
  }
}

Shape compared_shape() {
  Shape shape = number_shape(ByContext::beside, true);
  shape.form = Shape::Form::cell;
  return shape;
}

void add_values(Record<Difference>& keys) {
  using View = Difference;
  const auto is_one = [](const View& v) { return v.count == 1; };
  const auto is_number = [](const View& v) { return v.count == 1 && has_number(v); };
  keys.custom("a",
              compared_shape(),
              "The value in A, if count is 1; null for no value and for several.",
              [](const View& v, Archive& to) { write_compared(v.a, to); })
      .only_if(is_one);
  keys.custom("b",
              compared_shape(),
              "The value in B, if count is 1, in the unit of A where it can be converted.",
              [](const View& v, Archive& to) { write_compared(v.b, to); })
      .only_if(is_one);
  keys.text("kind",
            "What a number counts: a kind that --tolerance takes.",
            [](const View& v) { return v.unit.kind; })
      .only_if(is_number);
  keys.text("unit",
            "Unit of the numbers; empty for a bare number, and where the report does not tell it.",
            [](const View& v) { return v.unit.text; })
      .only_if(is_number);
  keys.text("other_unit",
            "Unit of the number in B, where it cannot be converted.",
            [](const View& v) { return v.other_unit; })
      .only_if([](const View& v) { return v.type == DifferenceType::unit; });
}

void add_amounts(Record<Difference>& keys) {
  using View = Difference;
  const auto has_amount = [](const View& v) { return v.type == DifferenceType::number; };
  keys.number("difference",
              ByContext::beside,
              "Of two numbers: the magnitude of their difference.",
              [](const View& v) { return v.amount; })
      .at_least(0)
      .only_if(has_amount);
  keys.number("tolerance",
              ByContext::beside,
              "Of two numbers: the difference that would still be equal.",
              [](const View& v) { return v.allowed; })
      .at_least(0)
      .only_if(has_amount);
}

const Record<Difference>& difference_record() {
  using View = Difference;
  static const Record<View> record("One difference.", [](Record<View>& keys) {
    keys.text("place",
              "JSON Pointer, in which things of a list that have names are listed under their "
              "names; of a table /mechanism/case/pass/element/quantity, in the wide layout without "
              "the pass. Of several files the file is the first key.",
              [](const View& v) { return printable(v.place); });
    keys.word("type",
              words_up_to(DifferenceType::only_in_b),
              "Two numbers beyond their tolerance; two texts; a value against none; two units that "
              "cannot be converted; a place in one report only.",
              [](const View& v) { return word_of(v.type); });
    keys.count("count",
               "Number of values at this place and below it; above 1 only for a place in one "
               "report only.",
               [](const View& v) { return v.count; });
    add_values(keys);
    add_amounts(keys);
  });
  return record;
}

const Record<ComparisonView>& comparing_program_record() {
  using View = ComparisonView;
  static const Record<View> record("The program that compared.", [](Record<View>& keys) {
    keys.text("version", "Version of the program.", [](const View&) { return kVersion; });
    keys.count("comparison", "Version of this form.", [](const View&) { return 1; });
  });
  return record;
}

void add_result(Record<ComparisonView>& keys) {
  using View = ComparisonView;
  keys.word("status", {"equal", "different"}, "Whether there are differences.", [](const View& v) {
    return v.comparison.differences.empty() ? "equal" : "different";
  });
  keys.count("values", "Number of places at which either report has a value.", [](const View& v) {
    return v.comparison.value_count;
  });
  keys.list("differences",
            difference_record(),
            "All differences: first those at places of A in its order, then what only B has.",
            [](const View& v, const Each<Difference>& each) {
              for (const Difference& one : v.comparison.differences) {
                each(one);
              }
            });
}

}  // namespace

TextBlocks comparison_blocks(const ReportComparison& comparison) {
  const std::vector<Difference>& all = comparison.differences;
  if (all.empty()) {
    return TextBlocks(fmt::format("equal: {} values\n", comparison.value_count));
  }
  Table table({"Place", "A", "B", "Difference", "Tolerance", "Unit"});
  for (std::size_t i = 0; i < std::min(all.size(), kMostPlaces); ++i) {
    table.add(row_of(all[i]));
  }
  TextBlocks text(std::move(table), "");
  if (all.size() > kMostPlaces) {
    text += fmt::format("and {}; --format json lists all\n",
                        counted(all.size() - kMostPlaces, "more place"));
  }
  text += "\n";
  text += summary(comparison);
  return text;
}

const Record<ComparisonView>& comparison_record() {
  using View = ComparisonView;
  static const Record<View> record(
      "What 'kinestat compare --format json' writes about two reports, A and B.",
      [](Record<View>& keys) {
        keys.part("kinestat", comparing_program_record(), [](const View& v) { return v; });
        keys.text("a", "Path of A as it was given; - is standard input.", [](const View& v) {
          return printable(v.a);
        });
        keys.text("b", "Path of B as it was given; - is standard input.", [](const View& v) {
          return printable(v.b);
        });
        add_result(keys);
      });
  return record;
}

std::string comparison_json(const ReportComparison& comparison,
                            const std::string& a,
                            const std::string& b) {
  const ComparisonView view{.comparison = comparison, .a = a, .b = b};
  return json_text(comparison_record(), view, FileUnits(), JsonLayout::indented);
}

}  // namespace kinestat
