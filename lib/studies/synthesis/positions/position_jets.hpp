// A position of the moving plane, with the derivatives that are prescribed there.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "studies/synthesis/positions/plane.hpp"

namespace kinestat {

/// A group of n infinitesimally separated positions (PIS), written PP…P, n = 1 to 5: the pose of
/// the moving plane and its derivatives 1 to n - 1 by a parameter t of the motion. A moving point z
/// lies at Z(t) = z e^{iγ(t)} + α(t) + iβ(t). The parameter is usually γ itself: γ' = 1, γ'' = … =
/// 0; only another one can describe an instantaneous translation, γ' = 0.
/// do Valle 1983, section 2.
template <class Scalar>
struct PositionJetsOf {
  std::vector<Scalar> x;      ///< α and its derivatives [length / t^k], fixed frame
  std::vector<Scalar> y;      ///< β and its derivatives, likewise
  std::vector<Scalar> angle;  ///< γ and its derivatives [rad / t^k]

  /// Whether t grows along the motion, like time, so that the derivatives have a sense. Where t is
  /// the angle itself nobody says whether it grows or falls.
  bool is_directed = false;

  int order() const { return static_cast<int>(angle.size()); }
};

using PositionJets = PositionJetsOf<double>;

/// Half a unit of the last decimal with which positions are written; zero where they are exact.
struct LastDecimal {
  double length = 0.0;  ///< [length]
  double angle = 0.0;   ///< [rad]
};

/// A pose alone: a group of one position.
PositionJets finite_position(const Point& at, double angle);

/// Derivative k of the origin of the moving frame.
Point origin(const PositionJets& position, int k = 0);

/// Derivatives 0 to n - 1 of e^{iγ}.
std::vector<Point> rotation_jets(const PositionJets& position);

/// Derivatives 0 to n - 1 of the place of a moving point, fixed frame.
std::vector<Point> point_jets(const PositionJets& position, const Point& moving);

/// How many positions a task prescribes: each group counts its order.
int position_count(std::span<const PositionJets> positions);

/// The form of a task, for example "PP-PP-P".
std::string form_of(std::span<const PositionJets> positions);

}  // namespace kinestat
