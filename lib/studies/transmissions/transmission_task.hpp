// What is asked of a transmission.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "studies/transmissions/roles.hpp"
#include "studies/transmissions/teeth_choice.hpp"

namespace kinestat {

struct ClosedRange {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
};

/// Gears, and the ratios that they shall have.
struct LadderTask {
  int forward = 0;
  int reverse = 0;              ///< none or one
  bool needs_direct = false;    ///< one forward gear of ratio 1, whatever the sets are
  bool one_change = true;       ///< one element opens and one engages from each gear to the next
  bool reverse_change = false;  ///< and from first to reverse
  ClosedRange first = {};
  ClosedRange last = {};
  ClosedRange spread = {};         ///< first over last
  ClosedRange step = {};           ///< of one gear over the next; begins above 1
  ClosedRange reverse_ratio = {};  ///< its size
};

/// Stationary ratios z_ring/z_sun that sets of a kind may have: a range, or values alone.
struct StationaryRatios {
  ClosedRange range = {};
  std::vector<double> values = {};  ///< ascending
  bool tries_all = true;            ///< the values; too many of them are searched as a range is
};

/// What no gear of the ladder may exceed, torques over that of the input, speeds over its speed.
struct TransmissionLimits {
  std::optional<double> element_torque = {};
  std::optional<double> element_slip = {};
  std::optional<double> shaft_speed = {};
  std::optional<double> planet_speed = {};  ///< in its carrier
  std::optional<double> efficiency = {};    ///< least, of each gear
  std::optional<int> rotating_clutches = {};
  std::optional<std::uint64_t> hollow_shafts = {};
};

/// By what transmissions are compared; less is better.
enum class TransmissionRank {
  efficiency,  ///< mean share of the power that the forward gears lose
  steps,       ///< root mean square deviation of the logarithms of the steps from their mean
  torque,      ///< largest torque of an element in any gear
  speed,       ///< largest speed of a shaft in any gear
  elements     ///< rotating clutches and hollow shafts together; of as many the efficiency
};

/// How the transmission shall be arranged.
enum class SectionLayout {
  any,
  coaxial,  ///< input and output end on the axis, at either side
  sideways  ///< a gear or chain takes the drive off between sets and housing
};

struct TransmissionTask {
  int simple_sets = 0;
  int double_planet_sets = 0;
  int elements = 0;
  std::optional<int> brakes = {};  ///< among the elements; empty: any number
  int engaged = 0;                 ///< elements in every gear
  int free_shafts = 0;             ///< that elements alone touch
  LadderTask ladder = {};
  std::array<StationaryRatios, 2> stationary_ratios = {};  ///< by SetKind
  std::optional<TeethLimits> teeth = {};
  std::array<double, 2> losses{};  ///< by SetKind, with the carrier at rest
  TransmissionLimits limits = {};
  TransmissionRank rank = TransmissionRank::efficiency;
  SectionLayout layout = SectionLayout::any;
  std::optional<std::array<int, 2>> structures = {};  ///< the first and last by number; empty: all

  int sets() const { return simple_sets + double_planet_sets; }
};

}  // namespace kinestat
