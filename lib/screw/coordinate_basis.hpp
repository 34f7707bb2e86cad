// The coordinates in which a network is solved: as few as its screws need.
#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

enum class ScrewKind { twist, wrench };

/// The basis of a subspace of the screws. Where it is made of coordinates, as in the literature,
/// `coordinates` names them and `basis` holds unit vectors.
/// The six coordinates count in units of their own: those that hold a length (v_O, T_O) in the
/// mechanism's size, so that micrometres and kilometres give the same numbers.
struct CoordinateBasis {
  Mat6X basis;                   ///< orthonormal columns; 6 x order
  std::vector<int> coordinates;  ///< ascending; empty where the basis is oblique
  Vec6 unit = Vec6::Ones();      ///< SI per unit of each of the six coordinates; powers of two

  int order() const { return static_cast<int>(basis.cols()); }

  bool is_made_of_coordinates() const { return !coordinates.empty(); }

  /// A screw [SI] in this basis.
  VecX coordinates_of(const Vec6& screw) const {
    return basis.transpose() * screw.cwiseQuotient(unit);
  }

  /// Whether a screw [SI] lies in the span, up to rounding of its own size.
  bool holds(const Vec6& screw) const;

  /// The screw [SI] of coordinates in this basis.
  Vec6 screw_of(const Eigen::Ref<const VecX>& x) const { return unit.cwiseProduct(basis * x); }

  /// SI per unit of a coordinate that holds a length: of a velocity or a moment.
  double length_unit(ScrewKind kind) const { return unit[kind == ScrewKind::twist ? 3 : 0]; }
};

/// The smallest basis that holds all columns of `screws` (6 x any, SI). It is made of the
/// coordinates that are not zero in every column if they are independent, otherwise it is
/// orthonormal. `length` [m] is the mechanism's size.
CoordinateBasis find_minimal_basis(const Mat6X& screws, ScrewKind kind, double length);

/// The planar basis: rows 2, 3, 4 for twists (wz, vx, vy) and wrenches (Tz, Fx, Fy) alike.
CoordinateBasis planar_basis(ScrewKind kind, double length);

CoordinateBasis spatial_basis(ScrewKind kind, double length);

/// Names of the rows: "wz", "vx", … or "Tz", "Fx", …; "s1", "s2", … where the basis is oblique.
std::vector<std::string> row_names(const CoordinateBasis& basis, ScrewKind kind);

}  // namespace kinestat
