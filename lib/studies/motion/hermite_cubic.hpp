// How a freedom or its rate changes between two positions of a motion.
#pragma once

#include <optional>

namespace kinestat {

/// A cubic from its ends at 0 and 1.
struct HermiteCubic {
  double low = 0.0;
  double high = 0.0;
  double low_slope = 0.0;
  double high_slope = 0.0;

  double at(double t) const;
  double slope_at(double t) const;

  /// How far a rate whose mean is that can be off it, by the fourth derivative that the mean shows.
  double error_by_mean(double mean) const;

  /// What a rate may be off it; `stretch`: how far the fastest freedom moves meanwhile [rad, or
  /// sizes of the mechanism].
  double error(double stretch) const;

  /// Where to look whether it is zero oftener than its ends show; none where their signs tell all.
  std::optional<double> doubtful_part(double error) const;

  /// Whether the signs of its ends tell how often it is zero: once or never, wherever it is within
  /// `error` of the cubic.
  bool is_told_by_ends(double error) const;

  /// Whether it falls or rises clearly at its ends.
  bool is_clear_at_low(double error) const;
  bool is_clear_at_high(double error) const;

  /// Between ends of different signs.
  double zero() const;

 private:
  bool is_clear_of_zero(double error) const;
};

}  // namespace kinestat
