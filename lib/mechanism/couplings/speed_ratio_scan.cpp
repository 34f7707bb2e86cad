#include "mechanism/couplings/speed_ratio_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/tolerance.hpp"
#include "math/dense/root_search.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

namespace {

// Between so many speed ratios one is looked for at which the torque fits.
constexpr std::size_t kIntervals = 48;

struct Range {
  double low = 0.0;
  double high = 1.0;
};

// Where the characteristic may have a value.
Range range_of(const ConverterLaw& law) {
  Range range;
  const auto* curve = !law.capacity.law                            ? &law.capacity
                      : law.torque_ratio && !law.torque_ratio->law ? &*law.torque_ratio
                                                                   : nullptr;
  return curve != nullptr ? Range{.low = curve->at.front(), .high = curve->at.back()} : range;
}

struct Sample {
  double ratio = 0.0;
  double miss = 0.0;
};

// Between two ratios that miss in other senses. Empty where the torque has no value between them,
// or jumps.
std::optional<double> find_root(const Sample& low,
                                const Sample& high,
                                const std::function<std::optional<double>(double)>& at) {
  const double ratio = root_between(
      [&](double one) {
        return one == low.ratio    ? low.miss
               : one == high.ratio ? high.miss
                                   : at(one).value_or(std::numeric_limits<double>::quiet_NaN());
      },
      low.ratio,
      high.ratio);
  const std::optional<double> miss = at(ratio);
  const double most = kTorqueFits * (std::abs(low.miss) + std::abs(high.miss));
  return miss && std::abs(*miss) <= most ? std::optional(ratio) : std::nullopt;
}

}  // namespace

double torque_miss(double torque, double asked) {
  return zero_within_bound(torque - asked, kCancellation * (std::abs(torque) + std::abs(asked)));
}

SpeedRatioScan::SpeedRatioScan(const ConverterLaw& law) {
  const auto [low, high] = range_of(law);
  for (std::size_t i = 0; i < kIntervals; ++i) {
    nodes_.push_back(low + (high - low) * static_cast<double>(i) / kIntervals);
  }
  nodes_.push_back(high);
}

FittingRatios SpeedRatioScan::run(const std::function<std::optional<double>(std::size_t)>& at_node,
                                  const std::function<std::optional<double>(double)>& at) const {
  FittingRatios result;
  std::optional<double> last;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::optional<double> now = at_node(i);
    if (now) {
      result.least = result.has_any ? std::min(result.least, *now) : *now;
      result.greatest = result.has_any ? std::max(result.greatest, *now) : *now;
      result.has_any = true;
    }
    if (now == 0.0) {
      result.ratios.push_back(nodes_[i]);
    } else if (now && last && *last != 0.0 && (*now < 0.0) != (*last < 0.0)) {
      const auto root = find_root(
          {.ratio = nodes_[i - 1], .miss = *last}, {.ratio = nodes_[i], .miss = *now}, at);
      if (root) {
        result.ratios.push_back(*root);
      }
    }
    last = now;
  }
  return result;
}

}  // namespace kinestat
