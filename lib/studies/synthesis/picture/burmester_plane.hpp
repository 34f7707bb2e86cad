// What a picture of a synthesis task shows, as points of the plane of motion.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/synthesis/curves/plane_cubic.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

struct NamedPoint {
  std::string name;
  Point at;
};

/// A dyad in the first position, fixed frame [m].
struct DrawnDyad {
  Dyad dyad;
  char letter = 'A';
  Point circle_point;  ///< of a slider the same as the centre point
  Point centre_point;
  Point direction;         ///< of a slider, or of the line of an inverted one
  bool is_chosen = false;  ///< of the best linkage
};

/// The curves of four conditions.
struct DrawnCurves {
  FourPositionCurves curves;
  std::vector<PositionJets> positions;  ///< those that they are of
  std::string without;  ///< "5": what of five positions they leave out; empty if there are four
};

/// A part of the plane along its axes [m].
struct PlaneWindow {
  Point low;
  Point high;

  Point middle() const { return (low + high) / 2.0; }

  bool holds(const Point& p) const {
    return p.real() >= low.real() && p.real() <= high.real() && p.imag() >= low.imag() &&
           p.imag() <= high.imag();
  }
};

struct BurmesterPlane {
  std::vector<NamedPoint> poles;
  std::vector<DrawnDyad> dyads;
  std::vector<DrawnCurves> curves;  ///< none, one, or two that meet in the dyads
  std::optional<Circle> circle;     ///< of straight paths, or of inflection
  std::string circle_name;
  std::optional<Point> ball;  ///< Ball's point
  PlaneWindow window;         ///< holds positions, and poles and dyads that are not too far away
};

BurmesterPlane find_plane(const SynthesisTask& task);

/// The word of what speaks against a linkage of the dyad `partner` and that of a point on the curve
/// of circle points; without a partner against a crank there that drives. Empty if nothing does.
std::string find_rejection(const std::vector<PositionJets>& positions,
                           const LinkageLimits& limits,
                           const std::optional<Dyad>& partner,
                           const Point& circle_point);

/// Whether they are one dyad of the task.
bool is_same(const Dyad& one, const Dyad& other);

}  // namespace kinestat
