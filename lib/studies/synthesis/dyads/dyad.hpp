// A dyad: a link that joins the moving plane to the fixed one, and so keeps a point on a circle.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "studies/synthesis/dyads/bounded_point.hpp"
#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

enum class DyadKind {
  crank,           ///< circle point and centre point at a distance
  slider,          ///< the centre lies at infinity: the circle point moves on a straight line
  inverted_slider  ///< the circle point lies at infinity: a line of the plane slides on a fixed
                   ///< point
};

/// The word in reports.
std::string_view word_of(DyadKind kind);

/// Which of its two points: that of the moving plane, or that of the fixed one.
enum class DyadPoint { circle_point, centre_point };

/// The word in files and reports.
std::string_view word_of(DyadPoint which);

/// (pt: díade) What of it is used depends on the kind.
struct Dyad {
  DyadKind kind = DyadKind::crank;
  Point circle_point = {
      0.0, 0.0};  ///< moving frame; of an inverted slider the point of the line at its foot
  Point centre_point = {0.0,
                        0.0};  ///< fixed frame; of a slider the circle point in the first position

  /// Unit vector. Of a slider: along its path, fixed frame. Of an inverted slider: along the line,
  /// moving frame; its foot is where the perpendicular from the origin of the frame meets it.
  Point direction = {1.0, 0.0};

  /// By how much each coordinate of circle point, centre and direction may be changed before the
  /// positions tell it from their rounding.
  Point circle_bound = {0.0, 0.0};
  Point centre_bound = {0.0, 0.0};
  Point direction_bound = {0.0, 0.0};
  double length = 0.0;    ///< of a crank
  int multiplicity = 1;   ///< 2: two dyads that coincide
  double digits = 16.0;   ///< decimal digits that the data and the method leave, estimated
  double residual = 0.0;  ///< the worst breach of its conditions, see find_residual

  /// Of a slider, or an inverted one, that the decimals of the positions cannot tell from a very
  /// long crank: the length of that crank, and by how much the positions miss the slider [length].
  /// Zero of others.
  double crank_length = 0.0;
  double deviation = 0.0;

  BoundedPoint bounded_circle_point() const {
    return BoundedPoint::within(circle_point, circle_bound);
  }

  BoundedPoint bounded_centre_point() const {
    return BoundedPoint::within(centre_point, centre_bound);
  }
};

/// How far a dyad misses the positions: the largest change, from the first position, of what it
/// keeps constant (of the square of the length, or of the distance from the line), and the largest
/// prescribed derivative of it, each as a share of the terms of its sum.
double find_residual(const Dyad& dyad, std::span<const PositionJets> positions);

/// A fixed order, whatever the order in which they were found: cranks by their length, then
/// sliders, then inverted sliders.
void sort_dyads(std::vector<Dyad>& dyads);

}  // namespace kinestat
