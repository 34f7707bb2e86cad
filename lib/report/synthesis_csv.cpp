#include "report/synthesis_csv.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/utf8.hpp"
#include "report/table_archive.hpp"
#include "report/csv.hpp"
#include "report/numbers.hpp"

namespace kinestat {

namespace {

// Keys below which all numbers are lengths, or angles. The coordinates of a drive are one or the
// other, and coefficients, ratios and counts neither.
constexpr std::array<std::string_view, 22> kLengths = {
    "at",           "pole",           "diameter",     "centre",  "radius",    "ball_point",
    "circle_point", "length",         "crank_length", "centres", "deviation", "longest",
    "lengths",      "fixed",          "moving",       "focus",   "offset",    "points",
    "centre_point", "straight_paths", "free_point",   "size"};
constexpr std::array<std::string_view, 6> kAngles = {"angle",
                                                     "margin",
                                                     "transmission",
                                                     "transmission_angle",
                                                     "working_transmission",
                                                     "full_transmission"};

class SynthesisCsv {
 public:
  explicit SynthesisCsv(const SynthesisAnalysis& analysis) : analysis_(analysis) {}

  std::string run(const Json& synthesis) {
    status_ = "solved";
    element_ = "working_digits";
    add("", "", synthesis["working_digits"]);
    element_ = "selection";
    add("", "", synthesis["selection"]);
    const Json& tasks = synthesis["tasks"];
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      task_ = std::to_string(i);
      status_ = tasks[i].contains("status") ? tasks[i]["status"].get<std::string>() : "solved";
      for (const auto& [key, value] : tasks[i].items()) {
        element_ = key;
        add("", unit_below(key, ""), value);
      }
    }
    return std::move(text_);
  }

 private:
  // The derivatives of a position are by its parameter; only lengths have a unit of the file then.
  std::string unit_below(std::string_view key, const std::string& outer) const {
    const FileUnits& units = analysis_.description.units;
    if (std::ranges::find(kLengths, key) != kLengths.end()) {
      return units.text(QuantityKind::length);
    }
    if (std::ranges::find(kAngles, key) != kAngles.end()) {
      return units.text(QuantityKind::angle);
    }
    const bool is_index = !key.empty() && key.front() >= '0' && key.front() <= '9';
    return is_index ? outer : "";
  }

  void add(const std::string& path, const std::string& unit, const Json& value) {
    if (value.is_object() || value.is_array()) {
      for (const auto& [key, item] : value.items()) {
        const bool is_rate = key == "angle" && path.find("derivatives") != std::string::npos;
        const std::string inner = is_rate ? "" : (value.is_array() ? unit : unit_or(key, unit));
        add(path.empty() ? key : path + "/" + key, inner, item);
      }
      return;
    }
    if (value.is_number()) {
      const bool is_count = value.is_number_integer();
      const std::string number =
          is_count ? std::to_string(value.get<long>()) : format_exact(value.get<double>());
      text_ += csv_line(std::array<std::string, 8>{
          name(), task_, "synthesis", element_, path, number, is_count ? "" : unit, status_});
    }
  }

  // Below `lengths` every key is a length; elsewhere a key speaks for itself.
  std::string unit_or(std::string_view key, const std::string& outer) const {
    const std::string own = unit_below(key, outer);
    return own.empty() && (key == "ground" || key == "crank_one" || key == "coupler" ||
                           key == "crank_other")
               ? outer
               : own;
  }

  std::string name() const {
    return analysis_.description.name.empty() ? printable(analysis_.file)
                                              : analysis_.description.name;
  }

  const SynthesisAnalysis& analysis_;
  std::string task_;
  std::string status_;
  std::string element_;
  std::string text_;
};

}  // namespace

std::string synthesis_csv(const SynthesisAnalysis& analysis, const Json& synthesis) {
  return std::string(kCsvHeader) + SynthesisCsv(analysis).run(synthesis);
}

}  // namespace kinestat
