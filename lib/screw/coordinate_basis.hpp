// The coordinates in which a network is solved: as few as its screws need.
#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// The basis of a subspace of the screws. Where it is made of coordinates, as in the literature,
/// `coordinates` names them and `basis` holds unit vectors.
struct CoordinateBasis {
  Mat6X basis;                   ///< orthonormal columns; 6 x order
  std::vector<int> coordinates;  ///< ascending; empty where the basis is oblique

  int order() const { return static_cast<int>(basis.cols()); }

  bool is_made_of_coordinates() const { return !coordinates.empty(); }
};

enum class ScrewKind { twist, wrench };

/// The smallest basis that holds all columns of `screws` (6 x any). It is made of the coordinates
/// that are not zero in every column if they are independent, otherwise it is orthonormal. The
/// decision divides the rows that hold lengths (v_O, T_O) by `length` [m], the mechanism's size.
CoordinateBasis find_minimal_basis(const Mat6X& screws, ScrewKind kind, double length);

/// The planar basis: rows 2, 3, 4 for twists (wz, vx, vy) and wrenches (Tz, Fx, Fy) alike.
CoordinateBasis planar_basis();

CoordinateBasis spatial_basis();

/// Names of the rows: "wz", "vx", … or "Tz", "Fx", …; "s1", "s2", … where the basis is oblique.
std::vector<std::string> row_names(const CoordinateBasis& basis, ScrewKind kind);

}  // namespace kinestat
