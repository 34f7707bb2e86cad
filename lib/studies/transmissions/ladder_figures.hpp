// What a ladder of gears asks of its transmission, gear by gear and as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "studies/transmissions/gear_figures.hpp"

namespace kinestat {

struct LadderGear {
  std::string label;         ///< "1", "2", …, "R"
  std::uint8_t engaged = 0;  ///< elements, as bits
  GearFigures figures;
  double efficiency = 1.0;            ///< with the losses of the task
  std::vector<double> planet_speeds;  ///< by set: that meshes with the sun, in its carrier, over
                                      ///< the speed of the input
};

/// The largest sizes are those of any gear, over torque and speed of the input.
struct LadderFigures {
  double spread = 0.0;            ///< first ratio by last
  double mean_efficiency = 0.0;   ///< of the forward gears
  double least_efficiency = 0.0;  ///< of all gears
  double unevenness = 0.0;        ///< of the steps
  double element_torque = 0.0;
  double element_slip = 0.0;
  double shaft_speed = 0.0;
  double planet_speed = 0.0;  ///< of planets in their carriers
  std::size_t rotating_clutches = 0;
  std::optional<std::uint64_t> hollow_shafts = {};  ///< at least; empty: around no axis
};

/// The gears of a ladder: engaged elements as bits, the reverse gear last.
std::vector<LadderGear> find_ladder_gears(const TransmissionTask& task,
                                          const TransmissionTrain& transmission,
                                          std::span<const std::uint8_t> ladder);

LadderFigures find_ladder_figures(const TransmissionTask& task,
                                  const TransmissionTrain& transmission,
                                  const std::vector<LadderGear>& gears);

/// Root mean square deviation of the logarithms of the steps between these ratios from their mean.
double unevenness(std::span<const double> ratios);

}  // namespace kinestat
