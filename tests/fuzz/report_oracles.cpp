#include "fuzz/report_oracles.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "fuzz/require.hpp"

namespace kinestat::fuzz {

namespace {

// Without a bound, where doubles alone have proved nine digits.
constexpr double kFast = 1e-6;
constexpr double kProved = 1e-9;
constexpr double kFirstRow = 1e-7;
// Rows have no bounds: what doubles do not prove may lose some digits there.
constexpr double kRow = 1e-7;
constexpr double kUnprovedRow = 1e-3;
constexpr double kRoundings = 1e-12;
// What is zero by the bound of its own error need not be with more digits; values of one kind have
// different units, so that little can be said of them together.
constexpr double kZero = 1e-3;
constexpr double kShown = 1e-5;  // six digits

struct Side {
  const char* pass;
  const char* values;
};

constexpr std::array<Side, 2> kSides = {{{"kinematics", "freedoms"}, {"statics", "actions"}}};

const Json* find(const Json& json, std::string_view key) {
  if (!json.is_object()) {
    return nullptr;
  }
  const auto at = json.find(std::string(key));
  return at == json.end() ? nullptr : &*at;
}

std::optional<double> number_at(const Json& json, std::string_view key) {
  const Json* const value = find(json, key);
  return value != nullptr && value->is_number() ? std::optional(value->get<double>())
                                                : std::nullopt;
}

std::string text_at(const Json& json, std::string_view key) {
  const Json* const value = find(json, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

// The side of a case, null where it is not solved.
const Json* solved_side(const Json& of_case, const Side& side) {
  const Json* const found = find(of_case, side.pass);
  return found != nullptr && text_at(*found, "status") == "solved" &&
                 find(*found, side.values) != nullptr
             ? found
             : nullptr;
}

Json evidence_of(const Json& side) {
  const Json* const evidence = find(side, "evidence");
  return evidence != nullptr ? *evidence : Json::object();
}

double largest_of(const Json& values) {
  double largest = 0.0;
  for (const Json& value : values) {
    if (value.is_number()) {
      largest = std::max(largest, std::abs(value.get<double>()));
    }
  }
  return largest;
}

// The share that two answers may differ by; empty where nothing is promised of the two together.
std::optional<double> allowed_share(const Json& automatic, const Json& other, bool is_fast) {
  const std::optional<double> bound = number_at(automatic, "error_bound");
  if (!bound) {
    return std::nullopt;
  }
  if (is_fast) {
    const bool is_proved = text_at(automatic, "precision") == "double" && *bound < kProved;
    return is_proved ? std::optional(kFast) : std::nullopt;
  }
  const std::optional<double> its = number_at(other, "error_bound");
  if (!its || text_at(automatic, "refers_to") != text_at(other, "refers_to")) {
    return std::nullopt;
  }
  return *bound + *its + 1e-15;
}

void check_alike(const Json& values, const Json& others, double share, const std::string& what) {
  const double largest = largest_of(values);
  const double rounding = kRoundings * largest;
  for (const auto& item : values.items()) {
    const std::optional<double> other = number_at(others, item.key());
    if (!item.value().is_number() || !other) {
      continue;
    }
    const double one = item.value().get<double>();
    const double size = std::max(std::abs(one), std::abs(*other));
    const bool is_zero = one == 0.0 || *other == 0.0;
    require(std::abs(one - *other) <= (is_zero ? kZero * largest : share * size + rounding),
            "two ways to a value agree",
            fmt::format("{}: {} is {} and {}", what, item.key(), one, *other));
  }
}

void collect_numbers(const Json& json, std::set<double>& numbers) {
  if (json.is_number()) {
    numbers.insert(json.get<double>());
  } else if (json.is_boolean()) {
    numbers.insert(json.get<bool>() ? 1.0 : 0.0);
  } else if (json.is_structured()) {
    for (const Json& one : json) {
      collect_numbers(one, numbers);
    }
  }
}

std::optional<double> as_number(std::string_view text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

// The cells of a line by RFC 4180; names hold no line breaks.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (const char one : line) {
    if (one == '"') {
      is_quoted = !is_quoted;
    } else if (one == ',' && !is_quoted) {
      cells.emplace_back();
    } else if (one != '\r') {
      cells.back() += one;
    }
  }
  return cells;
}

const Json* case_of(const Json& report, const std::string& label) {
  const Json* const cases = find(report, "cases");
  return cases != nullptr ? find(*cases, label) : nullptr;
}

// Whether it has a warning that a link has no length, or that rounding decides: its places may be
// lost in rounding, where its screws are not.
bool is_degenerate(const Json& report) {
  const Json* const said = find(report, "diagnostics");
  return said != nullptr && std::ranges::any_of(*said, [](const Json& one) {
           const std::string code = text_at(one, "code");
           return code == "W0309" || code == "W0501";
         });
}

// Whether the doubles have both sides of a case, by their bounds.
bool is_proved(const Json& of_case) {
  return std::ranges::all_of(kSides, [&](const Side& side) {
    const Json* const found = find(of_case, side.pass);
    if (found == nullptr) {
      return true;
    }
    const Json evidence = evidence_of(*found);
    return text_at(evidence, "precision") == "double" &&
           number_at(evidence, "error_bound").value_or(1.0) < kProved;
  });
}

}  // namespace

void check_accuracies(const Json& automatic, const Json& other, bool is_fast) {
  const Json* const cases = find(automatic, "cases");
  if (cases == nullptr) {
    return;
  }
  for (const auto& item : cases->items()) {
    const Json* const same = case_of(other, item.key());
    for (const Side& side : kSides) {
      const Json* const one = solved_side(item.value(), side);
      const Json* const two = same != nullptr ? solved_side(*same, side) : nullptr;
      if (one == nullptr || two == nullptr) {
        continue;
      }
      if (const auto share = allowed_share(evidence_of(*one), evidence_of(*two), is_fast)) {
        check_alike(one->at(side.values), two->at(side.values), *share, item.key());
      }
    }
  }
}

void check_table(const Json& report, const std::string& csv) {
  std::set<double> numbers;
  collect_numbers(report, numbers);
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = cells_of(line);
  const auto column = std::ranges::find(header, "value") - header.begin();
  require(column < std::ssize(header), "a table has values", line);
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    require(cells.size() == header.size(), "a row has as many cells as the header", line);
    const std::string& cell = cells[static_cast<std::size_t>(column)];
    const std::optional<double> value = as_number(cell);
    require(cell.empty() || value.has_value(), "a value is a number", line);
    // Words that end a path are 1.
    require(!value || *value == 1.0 || numbers.contains(*value),
            "a number of the table is in the report",
            line);
  }
}

void check_text(const Json& report, const std::string& text) {
  const Json* const cases = find(report, "cases");
  if (cases == nullptr) {
    return;
  }
  std::string label;
  std::set<std::string> wrong;
  std::set<std::string> right;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Case ")) {
      label = line.substr(5);
      continue;
    }
    std::istringstream words(line);
    std::string name;
    std::string shown;
    std::string unit;
    if (!line.starts_with(' ') || !(words >> name >> shown >> unit) || !as_number(shown) ||
        std::isalpha(static_cast<unsigned char>(unit[0])) == 0) {
      continue;
    }
    const Json* const of_case = case_of(report, label);
    for (const Side& side : kSides) {
      const Json* const its = of_case != nullptr ? find(*of_case, side.pass) : nullptr;
      const Json* const values = its != nullptr ? find(*its, side.values) : nullptr;
      const std::optional<double> value =
          values != nullptr ? number_at(*values, name) : std::nullopt;
      if (value) {
        const bool is_right = std::abs(*as_number(shown) - *value) <= kShown * std::abs(*value);
        const std::string which = fmt::format("{}: {} of {}", label, name, side.pass);
        (is_right ? right : wrong).insert(which);
      }
    }
  }
  // A name may have other rows as well.
  for (const std::string& which : wrong) {
    require(right.contains(which), "the text has the values of the report", which);
  }
}

void check_first_row(const Json& report, const Json& motion) {
  if (is_degenerate(report)) {
    return;
  }
  const Json* const told = find(motion, "motion");
  const Json* const rows = told != nullptr ? find(*told, "rows") : nullptr;
  const Json* const of_case = told != nullptr ? case_of(report, text_at(*told, "case")) : nullptr;
  if (rows == nullptr || rows->empty() || of_case == nullptr) {
    return;
  }
  const Json& row = rows->front();
  const Json& columns = told->at("columns");
  bool is_driven = false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (text_at(columns[i], "quantity") == "drive") {
      is_driven = true;
      if (!row[i].is_number() || row[i].get<double>() != 0.0) {
        return;  // it begins elsewhere
      }
    }
  }
  const bool is_solved =
      row.back() == "solved" && std::ranges::all_of(kSides, [&](auto& side) {
        return find(*of_case, side.pass) == nullptr || solved_side(*of_case, side) != nullptr;
      });
  if (!is_driven || !is_solved) {
    return;
  }
  // Rates are sums of products with coordinates, and lose the digits that these cancel.
  const double lost = 1e-13 * largest_of(row);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string quantity = text_at(columns[i], "quantity");
    const Side* const side = quantity == "velocity" ? &kSides[0]
                             : quantity == "action" ? &kSides[1]
                                                    : nullptr;
    const Json* const its = side != nullptr ? find(*of_case, side->pass) : nullptr;
    const std::optional<double> true_value =
        its != nullptr ? number_at(its->at(side->values), text_at(columns[i], "element"))
                       : std::nullopt;
    if (!true_value || !row[i].is_number()) {
      continue;
    }
    const double value = row[i].get<double>();
    const double allowed =
        kFirstRow * std::abs(*true_value) + lost + 1e-14 * largest_of(its->at(side->values));
    require(
        std::abs(value - *true_value) <= allowed,
        "a motion begins as analysed",
        fmt::format("{} is {}, analyze has {}", text_at(columns[i], "name"), value, *true_value));
  }
}

void check_sweep_row(const Json& report, const Json& row) {
  if (is_degenerate(report)) {
    return;
  }
  const Json* const of_case = case_of(report, text_at(row, "case"));
  if (of_case == nullptr) {
    require(text_at(row, "status") != "solved" || find(report, "cases") == nullptr,
            "a row that is solved has a case",
            row.dump());
    return;
  }
  const double share = is_proved(*of_case) ? kRow : kUnprovedRow;
  for (const auto& item : row.items()) {
    const std::string name = item.key().substr(0, item.key().find(" ["));
    if (!item.value().is_number() || name == "swept") {
      continue;
    }
    const double value = item.value().get<double>();
    std::optional<double> true_value;
    double largest = 0.0;
    if (name == "ratio" || name == "torque_ratio") {
      true_value = number_at(*of_case, name);
    }
    for (const Side& side : kSides) {
      const Json* const its = solved_side(*of_case, side);
      const Json* const values = its != nullptr ? find(*its, side.values) : nullptr;
      if (values != nullptr && !true_value && number_at(*values, name)) {
        true_value = number_at(*values, name);
        largest = largest_of(*values);
      }
    }
    if (true_value) {
      require(
          std::abs(value - *true_value) <= share * std::abs(*true_value) + 1e-7 * share * largest,
          "a sweep says what is analysed",
          fmt::format("{} is {}, analyze has {}", item.key(), value, *true_value));
    }
  }
}

}  // namespace kinestat::fuzz
