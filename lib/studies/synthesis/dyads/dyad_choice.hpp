// Linkages of three and four positions, which leave a point of each dyad free.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "studies/synthesis/dyads/few_positions.hpp"
#include "studies/synthesis/selection/selection.hpp"

namespace kinestat {

/// A rectangle along the axes of the frame of these points, given by two opposite corners [length].
struct ChoiceArea {
  Point from;
  Point to;
  DyadPoint of = DyadPoint::circle_point;
};

/// Every pair of circle points, or of centre points, in an area, by free numbers for a selection.
/// Of three positions any point will do: the numbers are the coordinates of both [length]. Of four
/// they lie on a curve: the numbers are their places along its part in the area, each from 0 to 1.
/// One dyad may be given; the numbers are those of the other then. With a function, whose positions
/// these are as seen from the output, they are those of the circle point of its input.
class DyadChoice {
 public:
  DyadChoice(std::vector<PositionJets> positions,
             const ChoiceArea& area,
             std::optional<Dyad> given = {},
             std::optional<AngleFunction> function = {});

  /// One range a number, with about `samples` combinations in all. Empty if four positions have no
  /// curve, or none in the area.
  std::vector<SelectionRange> ranges(int samples) const;

  /// Whether both dyads are chosen.
  ChoiceHalves halves() const {
    return chosen_count() == 2 ? ChoiceHalves::alike : ChoiceHalves::differ;
  }

  /// Both dyads, that which is given first, or none where one of them is left open; of a function
  /// both cranks.
  std::vector<Dyad> dyads(std::span<const double> numbers) const;

  /// The linkage of these dyads.
  std::optional<LinkageCandidate> candidate(std::span<const double> numbers,
                                            const LinkageLimits& limits) const;

  const std::vector<PositionJets>& positions() const { return positions_; }

  /// Of four positions.
  const std::optional<FourPositionCurves>& curves() const { return curves_; }

 private:
  int chosen_count() const { return given_ || function_ ? 1 : 2; }

  void find_steps();
  Point on_curve(double share) const;
  Point chosen_point(std::span<const double> numbers) const;
  std::optional<Dyad> chosen_dyad(std::span<const double> numbers) const;

  // A piece of the curve, with the length of all pieces before it and its own.
  struct Step {
    Point from;
    Point to;
    double before = 0.0;
    double length = 0.0;
  };

  std::vector<PositionJets> positions_;
  ChoiceArea area_;
  Pose frame_;  // of the chosen points, at the first position
  std::optional<Dyad> given_;
  std::optional<AngleFunction> function_;
  std::optional<FourPositionCurves> curves_;
  std::vector<Step> steps_;  // fixed frame, at the first position
};

}  // namespace kinestat
