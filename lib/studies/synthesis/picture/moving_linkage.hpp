// The best linkage of a synthesis task, carried through its positions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/picture.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// Where a body is: it has turned about the origin of the fixed frame, then shifted, from where it
/// is drawn.
struct PlanePose {
  Point shift;         ///< [m]
  double angle = 0.0;  ///< [rad]
};

/// The picture shows the first position and is moved as draw/linkage/linkage_drawing.hpp says;
/// `bodies` are the values of data-body.
struct MovingLinkage {
  Picture picture;
  std::vector<std::string> bodies;
  std::vector<std::vector<PlanePose>> steps;  ///< of each body
  std::vector<std::string> labels;            ///< of each step: the input, and which position it is
  int first = -1;          ///< the step in the first position, as drawn; -1: none
  bool is_closed = false;  ///< the last step leads back to the first
  std::string input;       ///< "A0A": what is driven
};

/// Of the task the first linkage, over all of the circuit that holds the first position; the other
/// positions are drawn faintly. Empty without a linkage.
std::optional<MovingLinkage> draw_moving_linkage(const SynthesisAnalysis& analysis,
                                                 std::size_t task);

}  // namespace kinestat
