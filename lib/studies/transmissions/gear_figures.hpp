// What a gear asks of its parts: speeds, torques, losses.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "studies/transmissions/corner_ranges.hpp"
#include "studies/transmissions/layouts.hpp"

namespace kinestat {

/// A transmission with numbers: the sets of a structure with their roles, stationary ratios and
/// elements. The structure outlives it.
struct TransmissionTrain {
  const GenericTrain* train = nullptr;
  RoleChoice roles;
  StationaryPoint stationary_ratios{};
  ElementPlacement elements;
};

/// Of a gear, over the torque and the speed of its input.
struct GearFigures {
  double ratio = 0.0;
  std::vector<double> torques;  ///< by element: of its first shaft on its second; open ones none
  std::vector<double> slips;    ///< by element: of its second shaft against its first
  std::vector<double> speeds;   ///< by shaft
  std::vector<double> rolling;  ///< by set: speed of its sun against its carrier
};

/// The figures of the gear that engages these elements, as bits.
GearFigures find_gear_figures(const TransmissionTrain& transmission, std::uint8_t engaged);

/// How gears answer to the stationary ratio of each set.
struct GearLosses {
  std::array<double, kMostGearSets> rolling{};  ///< d ln i/d ln i0: rolling power over input power
  double efficiency = 1.0;
};

/// Losses of gears by their states. A set loses a share of the power that rolls in it: the torques
/// are those of a train of which the stationary ratio is smaller, or larger, by its efficiency, so
/// that the efficiency of a gear is its ratio at a corner of a box over that in its middle.
std::vector<GearLosses> find_gear_losses(const GenericTrain& train,
                                         const RoleChoice& roles,
                                         const StationaryPoint& point,
                                         std::span<const double> set_losses,
                                         std::span<const std::uint32_t> states);

}  // namespace kinestat
