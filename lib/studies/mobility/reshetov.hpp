// The table of Reshetov: which freedoms close each circuit without force.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// What a circuit demands to be closed without force: to turn about and to shift along each axis.
/// Rx Ry Rz Tx Ty Tz.
inline constexpr std::array<const char*, 6> kClosures = {"Rx", "Ry", "Rz", "Tx", "Ty", "Tz"};

/// One circuit of the table.
struct ReshetovCircuit {
  CouplingId chord;
  std::vector<CouplingId> couplings;  ///< in file order
  std::array<int, 6> offered = {};    ///< freedoms along world axes, as kClosures
  int oblique_rotations = 0;          ///< freedoms that turn about no world axis
  int oblique_translations = 0;
  std::array<std::optional<int>, 6> covered_by;  ///< the freedom that serves each demand
};

/// A rotation covers the same rotation, or a missing translation along another axis than its own; a
/// translation only itself (Reshetov 1979; Alves 2023, section 2.2, p. 30). An oblique freedom
/// covers any one of the axes along which it has a part. A freedom that circuits share serves one.
/// The table looks at directions only: for linkages of special dimensions it is wrong.
struct ReshetovTable {
  std::vector<ReshetovCircuit> circuits;
  std::vector<int> unused;  ///< freedoms that serve no demand
  int redundant = 0;        ///< demands that nothing covers
  int mobility = 0;         ///< the number of unused freedoms
};

/// Of the fundamental circuits, with the freedoms of `mechanism`, which must be those in space.
ReshetovTable find_reshetov_table(const Mechanism& mechanism);

}  // namespace kinestat
