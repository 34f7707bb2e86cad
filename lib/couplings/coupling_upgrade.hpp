// What a coupling of the catalogue may be replaced by to prevent less.
#pragma once

#include <span>
#include <vector>

#include "description/coupling_description.hpp"
#include "screw/twist.hpp"

namespace kinestat {

/// Another type in the same place that frees what the first one frees, and more.
struct CouplingUpgrade {
  CouplingType to = CouplingType::cylindrical;
  std::vector<Twist> added;  ///< unit screws of the freedoms that it has more
  bool is_rare = false;      ///< costs more than two common couplings
};

/// The upgrades of a type, the usual ones first; empty for a type that has none. `freedoms` are its
/// unit motions in space in the order of the catalogue, `point` is its place in the same frame.
std::vector<CouplingUpgrade> coupling_upgrades(CouplingType type,
                                               std::span<const Twist> freedoms,
                                               const Vec3& point);

}  // namespace kinestat
