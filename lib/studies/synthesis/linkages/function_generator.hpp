// Four-bars whose output link follows a function of their input link at some precision points.
#pragma once

#include <span>
#include <vector>

#include "studies/synthesis/dyads/dyad.hpp"
#include "studies/synthesis/linkages/linkage.hpp"

namespace kinestat {

/// The angles that two links have together, each about its own fixed pivot.
struct AngleFunction {
  Point input_pivot;           ///< fixed frame [length]
  Point output_pivot;          ///< likewise
  std::vector<double> input;   ///< from the first precision point [rad]
  std::vector<double> output;  ///< likewise

  /// 1 where the input turns anticlockwise from precision point to precision point, else -1.
  int sense() const { return input.back() > input.front() ? 1 : -1; }
};

/// How the input link stands as seen from the output link, both drawn as in the first position. A
/// coupler of these links is a dyad of these positions: its circle point is its pivot on the input
/// link, its centre point that on the output link. So is the frame.
std::vector<PositionJets> seen_from_output(const AngleFunction& function);

/// The couplers among such dyads, each as the two cranks of its four-bar: first that of the input,
/// then that of the output. The frame of the coupler is the fixed one in the first position. The
/// frame of the linkage is left out, and what joins no four-bar.
std::vector<Dyad> cranks_of_couplers(const AngleFunction& function, std::span<const Dyad> couplers);

/// The positions of the coupler of such a four-bar.
std::vector<PositionJets> coupler_positions(const AngleFunction& function, const Linkage& four_bar);

}  // namespace kinestat
