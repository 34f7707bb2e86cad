// The counts of Davies' method: gross and net degrees of freedom and of constraint.
#pragma once

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Counts of motions, for l circuits and screws of order λ (Cazangi 2008, section 3.8.1, p.
/// 36).
struct MotionCounts {
  int order = 0;           ///< λ
  int gross_freedom = 0;   ///< F, the columns of M_N
  int rank = 0;            ///< m = rank M_N
  int net_freedom = 0;     ///< F_N = F - m: how many primary motions are needed
  int net_constraint = 0;  ///< C_N = λ l - m: how many circuit equations are redundant
};

/// Counts of actions, for k cut-sets and screws of order λ (Cazangi 2008, section 3.8.2, p.
/// 37).
struct ActionCounts {
  int order = 0;             ///< λ
  int gross_constraint = 0;  ///< C, passive constraints and internalised actions: columns of A_N
  int rank = 0;              ///< a = rank A_N
  int net_constraint = 0;    ///< C_N = C - a: how many primary actions are needed
  int net_freedom = 0;       ///< F_N = λ k - a: how many freedoms nothing resists
};

/// Computes the counts of motions from the rank of the velocity system of the given order.
MotionCounts motion_counts(const Mechanism& mechanism, int order, int system_rank);

/// Computes the counts of actions from the rank of the equilibrium system of the given order.
ActionCounts action_counts(const Mechanism& mechanism, int order, int system_rank);

}  // namespace kinestat
