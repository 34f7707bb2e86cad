#include "cases/speed_ratio_scan.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Between so many speed ratios one is looked for at which the torque fits.
constexpr std::size_t kIntervals = 48;
constexpr int kMostSteps = 100;

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

// By false position with halved weights (Illinois), then halving, until the ends are neighbours:
// they miss in other senses. Empty where the torque has no value between them, or jumps.
std::optional<double> find_root(Sample low,
                                Sample high,
                                const std::function<std::optional<double>(double)>& at) {
  const double most = kTorqueFits * (std::abs(low.miss) + std::abs(high.miss));
  double low_weight = low.miss;
  double high_weight = high.miss;
  int side = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    const double middle = 0.5 * (low.ratio + high.ratio);
    double ratio = i % 4 == 3 ? middle
                              : (low.ratio * high_weight - high.ratio * low_weight) /
                                    (high_weight - low_weight);
    if (!(ratio > low.ratio && ratio < high.ratio)) {
      ratio = middle;
    }
    if (ratio <= low.ratio || ratio >= high.ratio) {
      break;  // neighbours
    }
    const std::optional<double> now = at(ratio);
    if (!now || *now == 0.0) {
      return now ? std::optional(ratio) : std::nullopt;
    }
    if ((*now < 0.0) == (low.miss < 0.0)) {
      low = {.ratio = ratio, .miss = *now};
      low_weight = *now;
      high_weight = side == -1 ? 0.5 * high_weight : high_weight;
      side = -1;
    } else {
      high = {.ratio = ratio, .miss = *now};
      high_weight = *now;
      low_weight = side == 1 ? 0.5 * low_weight : low_weight;
      side = 1;
    }
  }
  const Sample& nearer = std::abs(low.miss) < std::abs(high.miss) ? low : high;
  return std::abs(nearer.miss) <= most ? std::optional(nearer.ratio) : std::nullopt;
}

}  // namespace

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
