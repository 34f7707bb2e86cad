// Which constraints are redundant: self-stresses by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

/// A self-stress: actions of couplings that are in equilibrium with each other alone. What does not
/// fit in its direction causes them: one redundant constraint.
struct RedundantConstraint {
  /// One an action of the mechanism [N·m or N], the first positive. 1 N or, of a couple, 1 N·m goes
  /// round a circuit; where there is no circuit, the first is 1.
  VecX magnitudes;
  std::vector<Wrench> wrenches;     ///< of each coupling, tail on head [SI]
  std::optional<CouplingId> chord;  ///< of the circuit through which it flows; empty: several
  /// Of the wrench that goes round the circuit, the same through every coupling.
  std::optional<ScrewAxis> axis;
  bool is_line_free = false;  ///< the axis is a force that may as well act along parallel lines
};

struct Redundancies {
  int order = 6;           ///< λ
  int net_constraint = 0;  ///< C_N = λ l - rank M_N
  /// Of these, what couplings bear. Teeth count as rolling pairs, which prevent five motions but
  /// bear one force; clutches bear none: the rest loads nothing.
  int borne = 0;
  std::vector<RedundantConstraint> constraints;  ///< `borne` of them, or none if too many to read
};

/// In the coordinates dual to `twists`, the basis of the motions in the order asked for. First
/// those of single circuits, forces before couples, then what flows through several.
/// `net_constraint` is that of the same order.
Redundancies find_redundancies(const Mechanism& mechanism,
                               const CoordinateBasis& twists,
                               int net_constraint);

}  // namespace kinestat
