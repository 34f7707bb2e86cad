#include "math/dense/smooth_integral.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kFour = 4;

// From 0 to 1, of the polynomial that is 1 at one node and 0 at the others.
double integral_of_basis(std::span<const double> nodes, std::size_t one) {
  std::array<double, 6> coefficients = {1.0};
  std::size_t degree = 0;
  double scale = 1.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (k == one) {
      continue;
    }
    scale *= nodes[one] - nodes[k];
    ++degree;
    for (std::size_t power = degree; power > 0; --power) {
      coefficients[power] = coefficients[power - 1] - nodes[k] * coefficients[power];
    }
    coefficients[0] *= -nodes[k];
  }
  double integral = 0.0;
  for (std::size_t power = 0; power <= degree; ++power) {
    integral += coefficients[power] / static_cast<double>(power + 1);
  }
  return integral / scale;
}

// Of some nodes in order: the first of so many of them that are nearest to those from `i` on.
std::size_t first_of(std::size_t i, std::size_t count, std::size_t all) {
  const std::size_t before = count / 2 - 1;
  return std::min(i < before ? 0 : i - before, all - count);
}

}  // namespace

void SmoothIntegral::place(std::span<const double> nodes) {
  if (std::ranges::equal(nodes, nodes_)) {
    return;
  }
  nodes_.assign(nodes.begin(), nodes.end());
  const auto is_same = [](double a, double b) { return std::abs(a - b) <= kSameValue; };
  count_ = std::min(nodes.size(), kMost);
  rules_.clear();
  intervals_.clear();
  has_equal_steps_ = nodes.size() > 1;
  const double step = nodes.size() > 1
                          ? (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1)
                          : 0.0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    Interval here{.first = first_of(i, count_, nodes.size()), .width = nodes[i + 1] - nodes[i]};
    has_equal_steps_ = has_equal_steps_ && std::abs(here.width - step) <= kSameStep;
    Rule rule;
    for (std::size_t k = 0; k < count_; ++k) {
      rule.nodes[k] = (nodes[here.first + k] - nodes[i]) / here.width;
    }
    here.rule = intervals_.empty() ? 0 : intervals_.back().rule;
    if (intervals_.empty() || !std::ranges::equal(rule.nodes, rules_[here.rule].nodes, is_same)) {
      const std::span<const double> near = std::span(rule.nodes).first(count_);
      const std::size_t four = std::min(count_, kFour);
      const std::size_t first = first_of(i - here.first, four, count_);
      for (std::size_t k = 0; k < count_; ++k) {
        rule.weights[k] = integral_of_basis(near, k);
      }
      for (std::size_t k = 0; k < four; ++k) {
        rule.weights_of_four[first + k] = integral_of_basis(near.subspan(first, four), k);
      }
      here.rule = rules_.size();
      rules_.push_back(rule);
    }
    intervals_.push_back(here);
  }
}

void SmoothIntegral::look(std::span<const double> values) {
  // Beside a corner of straight lines they have 11/60, sines with eight nodes a period less.
  constexpr double kAgree = 0.125;
  returns_ = returns(values);
  if (returns_) {
    return;
  }
  const auto integral = [&](const Interval& here, const Weights& weights) {
    return std::inner_product(weights.begin(),
                              weights.begin() + static_cast<std::ptrdiff_t>(count_),
                              values.begin() + static_cast<std::ptrdiff_t>(here.first),
                              0.0);
  };
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    Interval& here = intervals_[i];
    here.bend =
        integral(here, rules_[here.rule].weights_of_four) - std::midpoint(values[i], values[i + 1]);
  }
  // A straight line lies between two bends: its neighbours tell how much the function bends.
  const auto bend = [this](std::size_t i) {
    return i < intervals_.size() ? std::abs(intervals_[i].width * intervals_[i].bend) : 0.0;
  };
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    Interval& here = intervals_[i];
    const double rest = integral(here, rules_[here.rule].weights) -
                        std::midpoint(values[i], values[i + 1]) - here.bend;
    here.is_smooth =
        std::abs(here.width * rest) <= kAgree * std::max({bend(i - 1), bend(i), bend(i + 1)});
  }
}

bool SmoothIntegral::returns(std::span<const double> values) const {
  constexpr std::size_t kLeastTurn = 8;
  constexpr double kBendsAcross = 4.0;
  const std::size_t count = intervals_.size();
  if (!has_equal_steps_ || count < kLeastTurn) {
    return false;
  }
  double size = 0.0;
  for (const double one : values) {
    size = std::max(size, std::abs(one));
  }
  const double rounding = kSameStep * size;
  if (std::abs(values.back() - values.front()) > rounding) {
    return false;
  }
  const auto value = [&](std::size_t i) { return values[i % count]; };
  const auto bend = [&](std::size_t i) {
    return std::abs(value(i) - 4.0 * value(i + 1) + 6.0 * value(i + 2) - 4.0 * value(i + 3) +
                    value(i + 4));
  };
  double inside = 0.0;
  double across = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double& largest = i + 4 <= count ? inside : across;
    largest = std::max(largest, bend(i));
  }
  return across <= kBendsAcross * inside + 16.0 * rounding;
}

double SmoothIntegral::of(std::span<const double> values, std::span<const double> lines) const {
  double sum = 0.0;
  for (std::size_t i = 0; returns_ && i < intervals_.size(); ++i) {
    sum += intervals_[i].width * std::midpoint(values[i], values[i + 1]);
  }
  if (returns_) {
    return sum;
  }
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    const Interval& here = intervals_[i];
    const Weights& weights = rules_[here.rule].weights;
    sum += here.is_smooth
               ? here.width *
                     std::inner_product(weights.begin(),
                                        weights.begin() + static_cast<std::ptrdiff_t>(count_),
                                        values.begin() + static_cast<std::ptrdiff_t>(here.first),
                                        0.0)
               : lines[i];
  }
  return sum;
}

}  // namespace kinestat
