// Advice: which added freedoms take the redundancy away and leave the mobility as it is.
#pragma once

#include <optional>
#include <vector>

#include "network/freedom_counts.hpp"
#include "studies/mobility/redundancy.hpp"

namespace kinestat {

/// A coupling that is to free more.
struct CouplingChange {
  CouplingId coupling;
  std::optional<CouplingType> to;  ///< the type that does; empty: none of the catalogue
  bool is_left_out = false;        ///< it would bear nothing any more
  std::vector<Twist> added;        ///< unit screws of its new freedoms
};

/// Changes that belong together, and what the released mechanism was found to have.
struct Repair {
  std::vector<CouplingChange> changes;  ///< in the order of the couplings
  int freed = 0;                        ///< how many freedoms are added: redundancies removed
  MotionCounts after;                   ///< of the released mechanism in the spatial order
  bool is_verified = false;             ///< as many redundancies less, the same mobility
};

/// A copy in which the couplings have their new freedoms.
Mechanism released(const Mechanism& mechanism, const std::vector<CouplingChange>& changes);

/// Counts the released mechanism anew and compares it with `before`, the counts in space.
Repair verify_repair(const Mechanism& mechanism,
                     const MotionCounts& before,
                     std::vector<CouplingChange> changes);

/// Up to `most` repairs that remove all that is redundant in space, each verified; the cheapest
/// first: few changed couplings, of common types, actuated ones left alone. Added freedoms are
/// chosen so that each removes one redundancy (their powers on the self-stresses are independent):
/// then the mobility stays (Reshetov 1979, self-aligning mechanisms). Empty if nothing is redundant
/// or the self-stresses are not listed.
std::vector<Repair> find_repairs(const Mechanism& mechanism,
                                 const MotionCounts& before,
                                 const Redundancies& redundancies,
                                 int most);

}  // namespace kinestat
