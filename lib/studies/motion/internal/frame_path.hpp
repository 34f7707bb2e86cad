// How frames round that follow each other.
#pragma once

#include <cmath>
#include <numeric>
#include <span>

#include "core/tolerance.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// A frame follows from the one before by some ten operations.
inline constexpr double kRoundingOfFrame = 4.0 * kEpsilon;

/// Of the joint.
inline int count_of_rates(const MotionJoint& joint) {
  return joint.coordinate < 0 ? 0 : joint.motion.kind == ElementaryKind::ball ? 3 : 1;
}

inline double sum_of_sizes(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0, [](double sum, double value) {
    return sum + std::abs(value);
  });
}

/// How fast frames move that follow each other.
struct Speeds {
  double rate = 0.0;
  double bend = 0.0;

  void add(double rate_here, double bend_here) {
    rate += std::abs(rate_here);
    bend += std::abs(bend_here);
  }

  /// Of a first and of a second derivative.
  double of_order(int order) const { return order == 1 ? rate : bend + rate * rate; }
};

/// From the ground to a frame.
struct FramePath {
  double rounding = kRoundingOfFrame;
  Speeds all;
  Speeds turns;

  /// Of a position, a rate or its derivative; slides count for nothing in angles.
  double rounded(int order, bool is_angle) const {
    return rounding * (order == 0 ? 1.0 : (is_angle ? turns : all).of_order(order));
  }
};

}  // namespace kinestat
