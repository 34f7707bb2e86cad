#include "studies/motion/task/figures/value_ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

namespace {

constexpr std::array kWays = {0x1p-20, 0x1p-14, 0x1p-8, 0x1p-2};
constexpr double kGrows = 0.1;  // of the value

// Of what is left where values end.
constexpr double kJustBeyond = 0.999;

// The last values of those on a way of which half is left each time.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> values_towards(const ValueLeft& value,
                                                         double end,
                                                         double way) {
  std::array<double, kCount> values{};
  for (double& one : values) {
    const std::optional<double> found = value(end + way);
    if (!found) {
      return std::nullopt;
    }
    one = *found;
    way *= 0.5;
  }
  return values;
}

struct Limit {
  double value = 0.0;
  double error = 0.0;
};

constexpr std::size_t kTowards = 6;  // values by which a limit is known
using Approach = std::array<double, kTowards>;

// By Aitken's method, which is exact of any power of the way; the same without the last value
// tells its error.
std::optional<Limit> limit_of_power(const Approach& values) {
  constexpr double kOff = 0.02;  // of what is added to the last value
  const auto extrapolated = [](double a, double b, double c) -> std::optional<double> {
    const double share = (c - b) / (b - a);
    return share > 0.0 && share < 1.0 ? std::optional(c + (c - b) * share / (1.0 - share))
                                      : std::nullopt;
  };
  const auto [a, b, first, second, third, last] = values;
  const std::optional<double> before = extrapolated(first, second, third);
  const std::optional<double> found = extrapolated(second, third, last);
  if (!before || !found) {
    return std::nullopt;
  }
  const double error = std::abs(*found - *before);
  return error <= kOff * std::abs(*found - last)
             ? std::optional(Limit{.value = *found, .error = error})
             : std::nullopt;
}

// By polynomials of a power of the way, by Neville's method; that of one degree less tells the
// error.
Limit limit_of_polynomial(const Approach& values, double power) {
  Approach row = values;
  double less = 0.0;
  for (std::size_t degree = 1; degree < kTowards; ++degree) {
    const double nearer = std::exp2(power * static_cast<double>(degree)) - 1.0;
    less = row[kTowards - 1];
    for (std::size_t k = kTowards - 1; k >= degree; --k) {
      row[k] += (row[k] - row[k - 1]) / nearer;
    }
  }
  const double found = row[kTowards - 1];
  return {.value = found,
          .error = std::max(std::abs(found - less), std::abs(found - row[kTowards - 2]))};
}

// Empty where the values do not come nearer to each other. Near a limit of the way they are mostly
// polynomials of its root, near a jam of the way itself. Of values that differ by rounding alone,
// which grows beside singular positions, the farthest has least of it.
std::optional<Limit> limit_of(const Approach& values) {
  constexpr double kNearer = 0.9;
  constexpr double kRounding = 0x1p-30;
  constexpr double kUncertain = 0.1;  // of how far the values are apart
  const auto [a, b, c, d, third, last] = values;
  double range = 0.0;
  for (const double one : values) {
    range = std::max(range, std::abs(one - last));
  }
  const double step = std::abs(last - third);
  if (range <= kRounding * std::abs(last)) {
    const bool is_rounding = step > std::abs(b - a) && step > kSameValue * std::abs(last);
    return Limit{.value = is_rounding ? a : last, .error = range};
  }
  if (step > kNearer * std::abs(third - d)) {
    return std::nullopt;
  }
  Limit best = limit_of_polynomial(values, 1.0);
  for (const std::optional<Limit>& other :
       {std::optional(limit_of_polynomial(values, 0.5)), limit_of_power(values)}) {
    best = other && other->error < best.error ? *other : best;
  }
  if (best.error > kUncertain * range) {
    return std::nullopt;
  }
  best.value = zero_within_bound(best.value, best.error + kRounding * std::abs(a));
  return best;
}

// However uncertain the place of the end is, farther from it each of some halves adds more, and at
// it the value is far above that where the way begins: one that would grow towards another end
// close behind it is not.
Growth growth_beside(const ValueLeft& value, double end) {
  constexpr double kFarAbove = 1000.0;
  const double nearest = std::abs(value(end).value_or(0.0));
  if (nearest <= kFarAbove * std::abs(value(1.0).value_or(0.0))) {
    return {};
  }
  for (const double share : kWays) {
    const auto values = values_towards<5>(value, end, share * (1.0 - end));
    if (!values) {
      continue;
    }
    const auto& [a, b, c, d, e] = *values;
    const Growth growth = growth_of({c, d, e});
    const Growth before = growth_of({b, c, d});
    const Growth far = growth_of({a, b, c});
    if ((growth.grows && before.grows && far.grows) ||
        (growth.falls && before.falls && far.falls)) {
      return growth;
    }
  }
  return {};
}

// Where a value ends, from one that is there.
double end_of(const ValueLeft& value, double left) {
  constexpr int kHalvings = 30;
  double none = 0.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = std::midpoint(none, left);
    (value(middle) ? left : none) = middle;
  }
  return left;
}

// Equilibrium is lost to rounding a little before a jam. What is next to nothing there and runs on
// to zero comes to zero.
std::optional<double> zero_beyond(const ValueLeft& value, double end, double size) {
  constexpr double kNextToNothing = 0x1p-18;
  const double step = 0x1p-10 * (1.0 - end);
  const std::optional<double> last = value(end);
  const std::optional<double> before = value(end + step);
  if (!last || !before || !(std::abs(*last) <= kNextToNothing * size) ||
      std::abs(*before) <= std::abs(*last)) {
    return std::nullopt;
  }
  const double zero = end - *last / (*before - *last) * step;
  return zero >= 0.0 && zero <= end ? std::optional(zero) : std::nullopt;
}

// Nearer to the end powers are purer, and rounding is larger.
std::optional<double> limit_at(const ValueLeft& value, double end) {
  constexpr double kGood = 0x1p-36;
  std::optional<Limit> best;
  for (const double share : {0x1p-8, 0x1p-5, 0x1p-14, 0x1p-20, 0x1p-2, 0x1p-26, 0x1p-32}) {
    const auto values = values_towards<kTowards>(value, end, share * (1.0 - end));
    const std::optional<Limit> limit = values ? limit_of(*values) : std::nullopt;
    if (limit && (!best || limit->error < best->error)) {
      best = limit;
    }
    if (values && best && best->error <= kGood * std::abs((*values)[0])) {
      break;
    }
  }
  return best ? std::optional(best->value) : std::nullopt;
}

}  // namespace

Growth growth_of(const std::array<double, 3>& values) {
  const auto [far, near, nearest] = values;
  const double last = nearest - near;
  const bool has_any =
      std::abs(last) > std::abs(near - far) && std::abs(last) > kGrows * std::abs(nearest);
  return {.falls = has_any && last < 0.0, .grows = has_any && last > 0.0};
}

ValueEnd find_value_end(const ValueLeft& value,
                        double size,
                        const std::function<bool(double left)>& is_lost) {
  const auto look = [&](double way) -> std::optional<ValueEnd> {
    const auto values = values_towards<3>(value, 0.0, 0.5 * way);
    if (!values) {
      return std::nullopt;
    }
    const Growth growth = growth_of(*values);
    return ValueEnd{.growth = growth,
                    .left = 0.0,
                    .value = growth.has_any() ? std::nullopt : limit_at(value, 0.0)};
  };
  if (const auto found = look(kWays.front())) {
    return *found;
  }
  ValueEnd end;
  end.left = end_of(value, 1.0);
  if (is_lost(kJustBeyond * end.left)) {
    for (const double way : kWays) {
      if (const auto found = look(way)) {
        return *found;
      }
    }
  }
  if (const std::optional<double> zero = zero_beyond(value, end.left, size)) {
    return {.growth = {}, .left = *zero, .value = 0.0};
  }
  end.growth = growth_beside(value, end.left);
  if (!end.growth.has_any()) {
    const auto limit = limit_at(value, end.left);
    end.value = limit ? limit : value(end.left);
  }
  return end;
}

}  // namespace kinestat
