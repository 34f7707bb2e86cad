// Measured ratios as a table for people or as CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace kinestat::bench {

/// Times of one job in units of another, from runs that alternated.
struct Ratio {
  std::string name;
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;
  std::optional<double> target;  ///< what the median must not exceed
};

/// `values` must not be empty.
Ratio make_ratio(std::string name, std::vector<double> values, std::optional<double> target);

enum class TableForm { text, csv };

/// One line a ratio; `unit` names what they are measured in.
std::string write_ratios(const std::vector<Ratio>& ratios, const std::string& unit, TableForm form);

}  // namespace kinestat::bench
