// Ratios of many gears for many stationary ratios at a time, and their ranges over boxes of these.
//
// Speeds are affine in each stationary ratio, as each stands in one equation. Over a box the speed
// of the output has the sign of its corners, if they have one; then the ratio is monotone along
// each edge of the box, and its range is that of the values at the corners: exactly, not by a
// bound.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "studies/transmissions/generic_train.hpp"
#include "studies/transmissions/roles.hpp"
#include "studies/transmissions/transmission_task.hpp"

namespace kinestat {

/// Numbers of so many states of the sets at a time.
inline constexpr std::size_t kRatioLanes = 8;

struct alignas(64) RatioLanes {
  std::array<double, kRatioLanes> at{};
};

/// Of a gear, up to a common factor; their quotient is the ratio.
struct SpeedLanes {
  RatioLanes input;
  RatioLanes output;
};

/// The stationary ratios z_ring/z_sun of all sets.
using StationaryPoint = std::array<double, kMostGearSets>;

struct StationaryBox {
  StationaryPoint from{};
  StationaryPoint to{};
};

/// The equation of a set: w_sun - i0 w_ring - (1 - i0) w_carrier = 0.
SetEquation<double> set_equation(const RoleChoice& choice, int set, double stationary_ratio);

/// Speeds of inputs and outputs of gears with some roles of the sets.
class RatioTable {
 public:
  explicit RatioTable(const GenericTrain& train);

  /// Takes over points, kRatioLanes or twice as many.
  void set_points(const RoleChoice& choice, std::span<const StationaryPoint> points);

  /// Takes over the corners of a box.
  void set_corners(const RoleChoice& choice, const StationaryBox& box);

  /// The ranges of the ratios of states over the points of all lanes; without end where the output
  /// changes its sign.
  void ranges(std::span<const std::uint32_t> states, std::span<ClosedRange> ranges) const;

  /// The ratios in all lanes, one or two a state; zero where the output rests, or hardly moves.
  void ratios(std::span<const std::uint32_t> states, std::span<RatioLanes> ratios) const;

  /// The speeds in the first kRatioLanes points.
  void speeds(std::span<const std::uint32_t> states, std::span<SpeedLanes> speeds) const;

  /// How many times kRatioLanes points it has.
  std::size_t blocks() const { return blocks_; }

 private:
  void find_speeds(std::uint32_t state, std::size_t block, SpeedLanes& speeds) const;

  const GenericTrain& train_;
  std::size_t blocks_ = 0;
  std::vector<RatioLanes> minors_;  // a block after the other
};

}  // namespace kinestat
