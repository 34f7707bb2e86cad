#include "draw/axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"

namespace kinestat {

namespace {

constexpr const char* kMinus = "−";

// The smallest of the steps 1, 2, 5 times a power of ten that is not below `least`.
double decimal_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

double step_in_degrees(double least) {
  constexpr std::array<double, 6> kParts = {15.0, 30.0, 45.0, 90.0, 180.0, 360.0};
  if (least <= 10.0 || least > kParts.back()) {
    return decimal_step(least);
  }
  return *std::ranges::lower_bound(kParts, least);
}

// Ends that are ticks may lie beside them by rounding: a share of a step that nobody sees.
constexpr double kRounding = 0.001;

// Below there is no room for ticks between the numbers that there are.
constexpr double kLeastSize = std::numeric_limits<double>::min() * 1e16;

// Values that agree in so many digits are drawn as one.
constexpr int kTellsApart = 6;

// Room around a single value, or around values that differ by rounding only.
AxisDemand widened(AxisDemand demand) {
  KINESTAT_EXPECTS(std::isfinite(demand.low) && std::isfinite(demand.high));
  if (demand.high < demand.low) {
    std::swap(demand.low, demand.high);
  }
  const double span = demand.high - demand.low;
  const double shown = shown_span(span, std::max(std::abs(demand.low), std::abs(demand.high)));
  if (shown != span) {
    demand.low -= shown / 2;
    demand.high += shown / 2;
  }
  return demand;
}

double step_of(const AxisDemand& demand) {
  const double least =
      std::max(demand.least_step, (demand.high - demand.low) / std::max(1, demand.tick_count));
  return demand.in_degrees ? step_in_degrees(least) : decimal_step(least);
}

// So that labels need few digits: 0 for axes of usual size.
int label_exponent(double size) {
  const int power = static_cast<int>(std::floor(std::log10(size)));
  return power >= 5 || power < -2 ? static_cast<int>(std::floor(power / 3.0)) * 3 : 0;
}

std::string with_minus(std::string text) {
  if (!text.empty() && text.front() == '-') {
    text.replace(0, 1, kMinus);
  }
  return text;
}

void add_ticks(double step, AxisRange& axis) {
  axis.exponent = label_exponent(std::max(std::abs(axis.low), std::abs(axis.high)));
  const double unit = std::pow(10.0, axis.exponent);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step / unit) + 0.01)));
  const auto first = static_cast<long>(std::ceil(axis.low / step - kRounding));
  const auto last = static_cast<long>(std::floor(axis.high / step + kRounding));
  for (long i = first; i <= last; ++i) {
    const double value = static_cast<double>(i) * step;
    std::string label = fmt::format("{:.{}f}", value / unit, decimals);
    axis.ticks.push_back({.value = value, .label = i == 0 ? "0" : with_minus(std::move(label))});
  }
}

}  // namespace

double AxisRange::share(double value) const {
  if (kind == ScaleKind::linear) {
    return std::isfinite(value) ? (value - low) / (high - low)
                                : std::numeric_limits<double>::quiet_NaN();
  }
  if (!std::isfinite(value) || value <= 0.0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::log(value / low) / std::log(high / low);
}

double shown_span(double span, double size) {
  if (size < kLeastSize) {
    return 2.0;
  }
  return span <= size * std::pow(10.0, -kTellsApart) ? size : span;
}

AxisRange linear_axis(const AxisDemand& demand) {
  const AxisDemand wide = widened(demand);
  const double step = step_of(wide);
  AxisRange axis;
  axis.low = std::floor(wide.low / step + kRounding) * step;
  axis.high = std::ceil(wide.high / step - kRounding) * step;
  add_ticks(step, axis);
  return axis;
}

AxisRange tight_axis(const AxisDemand& demand) {
  const AxisDemand wide = widened(demand);
  AxisRange axis;
  axis.low = wide.low;
  axis.high = wide.high;
  add_ticks(step_of(wide), axis);
  return axis;
}

AxisRange logarithmic_axis(const AxisDemand& demand) {
  KINESTAT_EXPECTS(demand.low > 0.0 && demand.high >= demand.low && std::isfinite(demand.high));
  int first = static_cast<int>(std::floor(std::log10(demand.low)));
  int last = static_cast<int>(std::ceil(std::log10(demand.high)));
  if (first == last) {
    --first;
  }
  const int stride =
      std::max(1, (last - first + demand.tick_count - 1) / std::max(1, demand.tick_count));
  // From tick to tick, so that the ends of the axis have labels.
  last = first + (last - first + stride - 1) / stride * stride;
  AxisRange axis;
  axis.kind = ScaleKind::logarithmic;
  axis.low = std::pow(10.0, first);
  axis.high = std::pow(10.0, last);
  for (int power = first; power <= last; power += stride) {
    axis.ticks.push_back({.value = std::pow(10.0, power), .label = power_of_ten(power)});
  }
  return axis;
}

std::string power_of_ten(int exponent) {
  constexpr std::array<const char*, 10> kSuperscripts = {
      "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent == 0) {
    return "1";
  }
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += kSuperscripts[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

std::string label_number(double value, int digits) {
  if (!std::isfinite(value)) {
    return "–";
  }
  if (value == 0.0) {
    return "0";
  }
  const int power = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (power >= 6 || power < -4) {
    const double mantissa = value / std::pow(10.0, power);
    return with_minus(fmt::format("{:.{}g}", mantissa, digits)) + "×" + power_of_ten(power);
  }
  // Whole digits before the point are all written: 12345.6 with four digits is 12346.
  const int decimals = std::max(0, digits - 1 - power);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return with_minus(std::move(text));
}

std::vector<double> ratio_ticks(double low, double high) {
  constexpr std::array<double, 8> kFine = {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0};
  constexpr std::array<double, 3> kCoarse = {1.0, 2.0, 5.0};
  std::vector<double> ticks;
  const auto add = [&](const auto& factors) {
    for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10.0) {
      for (const double factor : factors) {
        if (factor * power >= low && factor * power <= high) {
          ticks.push_back(factor * power);
        }
      }
    }
  };
  high / low > 12.0 ? add(kCoarse) : add(kFine);
  return ticks;
}

std::vector<double> spread_places(const std::vector<double>& wished, double distance) {
  // Neighbours that are too near form a block around the mean of what its members wish.
  struct Block {
    double sum = 0.0;  // of the wishes, each less its place in the block
    double count = 0.0;
    double first = 0.0;
  };

  std::vector<Block> blocks;
  for (const double wish : wished) {
    blocks.push_back({.sum = wish, .count = 1.0, .first = wish});
    while (blocks.size() > 1) {
      const Block last = blocks.back();
      Block& before = blocks[blocks.size() - 2];
      if (before.first + distance * before.count <= last.first) {
        break;
      }
      before.sum += last.sum - last.count * before.count * distance;
      before.count += last.count;
      before.first = before.sum / before.count;
      blocks.pop_back();
    }
  }
  std::vector<double> places;
  for (const Block& block : blocks) {
    for (double i = 0.0; i < block.count; i += 1.0) {
      places.push_back(block.first + i * distance);
    }
  }
  return places;
}

}  // namespace kinestat
