#include "report/benchmark_report.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "report/csv.hpp"
#include "report/numbers.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "report/table_archive.hpp"

namespace kinestat {

namespace {

struct Side {
  const char* key;
  const char* unit_words;  ///< of the dense equations
  TradeOff BenchmarkedCase::*result;
};

constexpr std::array<Side, 2> kSides = {{
    {.key = "motion", .unit_words = "M_NS of the circuits", .result = &BenchmarkedCase::motion},
    {.key = "action",
     .unit_words = "equilibrium of the bodies",
     .result = &BenchmarkedCase::action},
}};

// Why a side was left out, as a word for scripts and a sentence for people.
struct ReasonWords {
  const char* key;
  const char* sentence;
};

ReasonWords words_of(NoProblem reason) {
  switch (reason) {
    case NoProblem::none:
      return {.key = "measured", .sentence = ""};
    case NoProblem::not_asked:
      return {.key = "not_asked", .sentence = "nothing is known of them"};
    case NoProblem::open:
      return {.key = "open", .sentence = "what is known leaves some of them open"};
    case NoProblem::dependent:
      return {.key = "dependent", .sentence = "what is known contradicts itself"};
    case NoProblem::too_large:
      return {.key = "too_large", .sentence = "too many of them for dense methods"};
    case NoProblem::no_unknowns:
      break;
  }
  return {.key = "no_unknowns", .sentence = "all of them are known"};
}

Json extreme_json(const ExtremeResult& result) {
  Json json = object_of(4);
  json["status"] = std::string(text_of(result.status));
  json["error"] = number(result.error);
  json["value_error"] = number(result.value_error);
  json["bound"] = number(result.bound);
  return json;
}

Json method_json(const MethodResult& method) {
  Json json = object_of(6);
  json["time"] = number(method.time);
  json["fastest"] = number(method.fastest);
  json["slowest"] = number(method.slowest);
  json["worst_error"] = number(method.worst_error);
  json["pareto"] = method.is_on_front;
  json["extremes"] = object_of(method.extremes.size());
  for (std::size_t i = 0; i < method.extremes.size(); ++i) {
    json["extremes"][std::string(kExtremes[i].name)] = extreme_json(method.extremes[i]);
  }
  return json;
}

Json side_json(const TradeOff& result) {
  Json json = object_of(4);
  json["status"] = words_of(result.reason).key;
  if (result.reason == NoProblem::none) {
    json["unknowns"] = result.unknowns;
    json["unit_seconds"] = number(result.unit_seconds);
    json["methods"] = object_of(result.methods.size());
    for (const MethodResult& method : result.methods) {
      json["methods"][std::string(key_of(method.method))] = method_json(method);
    }
  }
  return json;
}

Json cases_json(const std::vector<BenchmarkedCase>& cases) {
  Json json = object_of(cases.size());
  for (const BenchmarkedCase& one : cases) {
    Json& sides = json[one.label] = object_of(2);
    for (const Side& side : kSides) {
      sides[side.key] = side_json(one.*side.result);
    }
  }
  return json;
}

std::string exact_or_empty(const std::optional<double>& value) {
  return value ? format_exact(*value) : std::string();
}

// The method is the element.
class CsvRows {
 public:
  explicit CsvRows(std::string mechanism) : mechanism_(std::move(mechanism)), text_(kCsvHeader) {}

  void add_side(const std::string& label, const Side& side, const TradeOff& result) {
    label_ = label;
    side_ = side.key;
    if (result.reason != NoProblem::none) {
      return;
    }
    add("", "unknowns", std::to_string(result.unknowns), "", "solved");
    add("", "unit_seconds", format_exact(result.unit_seconds), "s", "solved");
    for (const MethodResult& method : result.methods) {
      add_method(method);
    }
  }

  std::string take() { return std::move(text_); }

 private:
  void add_method(const MethodResult& method) {
    const std::string name(key_of(method.method));
    add(name, "time", format_exact(method.time), "", "solved");
    add(name, "fastest", format_exact(method.fastest), "", "solved");
    add(name, "slowest", format_exact(method.slowest), "", "solved");
    add(name,
        "worst_error",
        exact_or_empty(method.worst_error),
        "",
        method.is_on_front ? "pareto" : "dominated");
    for (std::size_t i = 0; i < method.extremes.size(); ++i) {
      const ExtremeResult& result = method.extremes[i];
      const std::string path = fmt::format("extremes/{}/", kExtremes[i].name);
      const std::string status(text_of(result.status));
      add(name, path + "error", exact_or_empty(result.error), "", status);
      add(name, path + "value_error", exact_or_empty(result.value_error), "", status);
      add(name, path + "bound", exact_or_empty(result.bound), "", status);
    }
  }

  void add(const std::string& method,
           const std::string& quantity,
           const std::string& value,
           const std::string& unit,
           const std::string& status) {
    text_ += csv_line(std::array<std::string, 8>{
        mechanism_, label_, "bench", method, side_ + "/" + quantity, value, unit, status});
  }

  std::string mechanism_;
  std::string label_;
  std::string side_;
  std::string text_;
};

std::string error_cell(const ExtremeResult& result) {
  if (!result.error) {
    return std::string(text_of(result.status));
  }
  return *result.error == 0.0 ? "0" : fmt::format("{:.0e}", *result.error);
}

std::string side_text(const BenchmarkedCase& one, const Side& side) {
  const TradeOff& result = one.*side.result;
  const std::string title = fmt::format("Case {}, {}s", one.label, side.key);
  if (result.reason != NoProblem::none) {
    return result.reason == NoProblem::not_asked
               ? std::string()
               : fmt::format("{}: left out, {}\n\n", title, words_of(result.reason).sentence);
  }
  std::vector<std::string> head = {"Method", "time [D]", "front"};
  for (const Extreme& extreme : kExtremes) {
    head.emplace_back(extreme.name);
  }
  Table table(std::move(head));
  for (const MethodResult& method : result.methods) {
    std::vector<std::string> row = {std::string(words_of(method.method)),
                                    fmt::format("{:.3g}", method.time),
                                    method.is_on_front ? "*" : ""};
    for (const ExtremeResult& extreme : method.extremes) {
      row.push_back(error_cell(extreme));
    }
    table.add(std::move(row));
  }
  return fmt::format("{}: {} unknowns; D = dense LU in double ({}), {:.3g} µs here\n",
                     title,
                     result.unknowns,
                     side.unit_words,
                     1e6 * result.unit_seconds) +
         table.text("  ") + "\n";
}

bool is_not_asked(const BenchmarkedCase& one) {
  return std::ranges::all_of(
      kSides, [&](const Side& side) { return (one.*side.result).reason == NoProblem::not_asked; });
}

bool is_measured(const BenchmarkedCase& one) {
  return std::ranges::any_of(
      kSides, [&](const Side& side) { return (one.*side.result).reason == NoProblem::none; });
}

std::string case_text(const BenchmarkedCase& one) {
  if (is_not_asked(one)) {
    return fmt::format("Case {}: left out, neither motions nor actions are known\n\n", one.label);
  }
  std::string text;
  for (const Side& side : kSides) {
    text += side_text(one, side);
  }
  return text;
}

std::string text_of(const std::vector<BenchmarkedCase>& cases) {
  if (cases.empty()) {
    return "The file has no cases, so there is nothing to solve.\n";
  }
  std::string text;
  for (const BenchmarkedCase& one : cases) {
    text += case_text(one);
  }
  if (std::ranges::none_of(cases, is_measured)) {
    return text + "Nothing was measured.\n";
  }
  return text +
         "Errors are the largest against the exact solution of the same doubles, as a share of "
         "the\n"
         "largest unknown. front *: no other method is both faster and more accurate over all\n"
         "extremes.\n";
}

}  // namespace

FileReport make_benchmark_report(const std::string& file,
                                 const MechanismDescription& description,
                                 const std::vector<BenchmarkedCase>& cases,
                                 const ReportForms& forms,
                                 const Diagnostics& found) {
  FileReport report;
  if (forms.json || forms.json_line) {
    Json json = report_head(file, description);
    json["unit"] = "Eigen PartialPivLU, double, dense";
    json["bench"] = cases_json(cases);
    json["diagnostics"] = diagnostics_json(found);
    report.json = forms.json ? json.dump(2) + "\n" : std::string();
    report.json_line = forms.json_line ? json.dump() + "\n" : std::string();
  }
  if (forms.csv) {
    CsvRows rows(description.name);
    for (const BenchmarkedCase& one : cases) {
      for (const Side& side : kSides) {
        rows.add_side(one.label, side, one.*side.result);
      }
    }
    report.csv.push_back({.pass = "bench", .text = rows.take()});
  }
  if (forms.text) {
    report.text = (description.name.empty() ? file : description.name) + "\n\n" + text_of(cases);
  }
  return report;
}

}  // namespace kinestat
