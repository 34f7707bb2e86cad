// Linkages of three and four positions, which leave the circle points free.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "studies/synthesis/dyads/few_positions.hpp"
#include "studies/synthesis/selection/selection.hpp"

namespace kinestat {

/// A rectangle along the axes of the moving frame, given by two opposite corners [length].
struct CirclePointArea {
  Point from;
  Point to;
};

/// Every pair of circle points in an area, by free numbers for a selection. Of three positions any
/// point is a circle point: the numbers are the coordinates of both [length]. Of four they lie on a
/// curve: the numbers are their places along its part in the area, each from 0 to 1.
class CirclePointChoice {
 public:
  CirclePointChoice(std::vector<PositionJets> positions, const CirclePointArea& area);

  /// One range a number, with about `samples` combinations in all. Empty if four positions have no
  /// curve, or none in the area.
  std::vector<SelectionRange> ranges(int samples) const;

  /// The dyads of both circle points, or none where one of them has no centre.
  std::vector<Dyad> dyads(std::span<const double> numbers) const;

  /// The linkage of these dyads.
  std::optional<LinkageCandidate> candidate(std::span<const double> numbers,
                                            const LinkageLimits& limits) const;

  const std::vector<PositionJets>& positions() const { return positions_; }

  /// Of four positions.
  const std::optional<FourPositionCurves>& curves() const { return curves_; }

 private:
  void find_steps(const CirclePointArea& area);
  Point on_curve(double share) const;
  Point circle_point(std::span<const double> numbers) const;

  // A piece of the curve, with the length of all pieces before it and its own.
  struct Step {
    Point from;
    Point to;
    double before = 0.0;
    double length = 0.0;
  };

  std::vector<PositionJets> positions_;
  CirclePointArea area_;
  std::optional<FourPositionCurves> curves_;
  std::vector<Step> steps_;  // fixed frame, at the first position
};

}  // namespace kinestat
