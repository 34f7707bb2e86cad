// The conditions that a dyad meets multiply separated positions, as rows of a linear system.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "studies/synthesis/positions/internal/jets.hpp"
#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

/// The circle condition |Z - w| = const, minus itself in the first position, is linear in
/// (u, v, a, b, p, q, h) with h = 1, p = au + bv, q = bu - av: the circle point z = u + iv and the
/// centre w = a + ib, both in the fixed frame at the first position, from `x`, `y`, in units of
/// `length`. One row for each position but the first (k = 0), and for each derivative (k >= 1).
/// These are the generalised coefficients A_ml of do Valle 1983, section 3.2, p. 47, written
/// without poles, so that any angle and any parameter will do.
template <class Scalar>
struct ConditionRowsOf {
  std::vector<std::array<Scalar, 7>> rows;  ///< each divided by its largest entry
  std::vector<double> noise;   ///< what rounding of the positions does to each such row
  std::vector<double> slopes;  ///< and what a change of a position by one unit of length does
  Scalar x{0};
  Scalar y{0};
  Scalar length{1};
  double radius = 1.0;  ///< of the positions about x, y, over `length`
};

using ConditionRows = ConditionRowsOf<double>;

/// Displacement from the first position: a point z there lies at E z + D, with derivatives.
template <class Scalar>
struct DisplacementJetsOf {
  std::vector<Scalar> cosine, sine;  ///< E
  std::vector<Scalar> x, y;          ///< D
  Scalar versine{0};                 ///< 1 - cos, without cancellation
};

template <class Scalar>
DisplacementJetsOf<Scalar> displacement_jets(const PositionJetsOf<Scalar>& first,
                                             const PositionJetsOf<Scalar>& position,
                                             const Scalar& centre_x,
                                             const Scalar& centre_y) {
  using std::sin;
  std::vector<Scalar> angle = position.angle;
  angle[0] = turn_between(first.angle[0], position.angle[0]);
  auto [cosine, sine] = turn_jets(angle);
  DisplacementJetsOf<Scalar> result{
      .cosine = cosine, .sine = sine, .x = {}, .y = {}, .versine = {}};
  const Scalar half = sin(angle[0] / 2);
  result.versine = 2 * half * half;
  const Scalar p_x = first.x[0] - centre_x;
  const Scalar p_y = first.y[0] - centre_y;
  // D = o - o_1 + (1 - E)(o_1 - O), the derivatives D' = o' - E' (o_1 - O).
  result.x.push_back((position.x[0] - first.x[0]) + result.versine * p_x + sine[0] * p_y);
  result.y.push_back((position.y[0] - first.y[0]) + result.versine * p_y - sine[0] * p_x);
  for (std::size_t k = 1; k < angle.size(); ++k) {
    result.x.push_back(position.x[k] - (cosine[k] * p_x - sine[k] * p_y));
    result.y.push_back(position.y[k] - (cosine[k] * p_y + sine[k] * p_x));
  }
  return result;
}

/// Row k of a displacement whose lengths are in units of the system; not scaled yet.
template <class Scalar>
std::array<Scalar, 7> condition_row(const DisplacementJetsOf<Scalar>& d, std::size_t k) {
  // H = conj(D) E.
  const Scalar h_x = product_jet(d.x, d.cosine, k) + product_jet(d.y, d.sine, k);
  const Scalar h_y = product_jet(d.x, d.sine, k) - product_jet(d.y, d.cosine, k);
  const Scalar square = product_jet(d.x, d.x, k) + product_jet(d.y, d.y, k);
  const Scalar versine = k == 0 ? d.versine : Scalar(-d.cosine[k]);
  return {h_x,
          Scalar(-h_y),
          Scalar(-d.x[k]),
          Scalar(-d.y[k]),
          versine,
          Scalar(-d.sine[k]),
          Scalar(square / 2)};
}

/// The centroid of the positions becomes the origin. The unit of length balances the columns: a
/// displacement by a turn about a far pole is large beside the turn.
/// `unit` is the rounding of what is given, as a share of it.
template <class Scalar>
ConditionRowsOf<Scalar> make_condition_rows(
    std::span<const PositionJetsOf<Scalar>> positions,
    double unit = static_cast<double>(std::numeric_limits<Scalar>::epsilon()));

}  // namespace kinestat
