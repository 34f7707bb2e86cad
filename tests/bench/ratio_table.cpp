#include "ratio_table.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace kinestat::bench {

namespace {

std::string text_line(const Ratio& ratio) {
  std::string target;
  if (ratio.target) {
    target = fmt::format(
        "   target {:g}: {}", *ratio.target, ratio.median <= *ratio.target ? "held" : "MISSED");
  }
  return fmt::format("{:<38} {:>9.3f} {:>9.3f} {:>9.3f}{}\n",
                     ratio.name,
                     ratio.median,
                     ratio.least,
                     ratio.most,
                     target);
}

std::string csv_line(const Ratio& ratio, const std::string& unit) {
  return fmt::format("\"{}\",\"{}\",{:.6g},{:.6g},{:.6g},{}\n",
                     ratio.name,
                     unit,
                     ratio.median,
                     ratio.least,
                     ratio.most,
                     ratio.target ? fmt::format("{:g}", *ratio.target) : "");
}

}  // namespace

Ratio make_ratio(std::string name, std::vector<double> values, std::optional<double> target) {
  std::ranges::sort(values);
  return {.name = std::move(name),
          .median = values[values.size() / 2],
          .least = values.front(),
          .most = values.back(),
          .target = target};
}

std::string write_ratios(const std::vector<Ratio>& ratios,
                         const std::string& unit,
                         TableForm form) {
  if (form == TableForm::csv) {
    std::string csv = "job,unit,median,min,max,target\n";
    for (const Ratio& ratio : ratios) {
      csv += csv_line(ratio, unit);
    }
    return csv;
  }
  std::string text =
      fmt::format("{:<38} {:>9} {:>9} {:>9}\n", "in " + unit, "median", "min", "max");
  for (const Ratio& ratio : ratios) {
    text += text_line(ratio);
  }
  return text;
}

}  // namespace kinestat::bench
