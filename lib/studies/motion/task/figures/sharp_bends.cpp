#include "studies/motion/task/figures/sharp_bends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/motion_tolerance.hpp"

namespace kinestat {

namespace {

class BendFinder {
 public:
  explicit BendFinder(std::span<const FreedomRates> rows) : rows_(rows) {
    double fastest = 0.0;
    for (const FreedomRates& row : rows) {
      most_.resize(std::max(most_.size(), row.size()), 0.0);
      for (std::size_t f = 0; f < row.size(); ++f) {
        most_[f] = std::max(most_[f], std::abs(row[f].value_or(0.0)));
        fastest = std::max(fastest, most_[f]);
      }
    }
    // What hardly moves may be rounding.
    for (double& one : most_) {
      one = one > kDoubtfulRate * fastest ? one : fastest;
    }
  }

  bool bends_behind(std::size_t row) const { return differ(rows_[row], rows_[row + 1]); }

  void look(const std::function<FreedomRates(double)>& look) {
    for (std::size_t row = 0; row + 1 < rows_.size(); ++row) {
      const auto step = static_cast<double>(row);
      halve(step, rows_[row], step + 1.0, rows_[row + 1], look);
    }
  }

 private:
  static constexpr double kFinest = 0x1p-14;  // of a step
  static constexpr int kMostLooks = 400;

  bool differ(const FreedomRates& low, const FreedomRates& high) const {
    constexpr double kSharp = 0.5;
    for (std::size_t f = 0; f < std::min(low.size(), high.size()); ++f) {
      if (low[f] && high[f] && std::abs(*high[f] - *low[f]) > kSharp * most_[f]) {
        return true;
      }
    }
    return false;
  }

  void halve(double begin,
             const FreedomRates& low,
             double end,
             const FreedomRates& high,
             const std::function<FreedomRates(double)>& look) {
    if (end - begin < kFinest || looks_ == kMostLooks || !differ(low, high)) {
      return;
    }
    ++looks_;
    const double step = std::midpoint(begin, end);
    const FreedomRates middle = look(step);
    halve(begin, low, step, middle, look);
    halve(step, middle, end, high, look);
  }

  std::span<const FreedomRates> rows_;
  std::vector<double> most_;  // of each freedom
  int looks_ = 0;
};

}  // namespace

bool has_sharp_bends(std::span<const FreedomRates> rows) {
  const BendFinder finder(rows);
  for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
    if (finder.bends_behind(row)) {
      return true;
    }
  }
  return false;
}

void look_into_sharp_bends(std::span<const FreedomRates> rows,
                           const std::function<FreedomRates(double step)>& look) {
  BendFinder(rows).look(look);
}

}  // namespace kinestat
