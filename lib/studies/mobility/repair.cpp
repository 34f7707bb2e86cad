#include "studies/mobility/repair.hpp"

#include <algorithm>
#include <utility>

#include "math/elimination/elimination.hpp"
#include "network/bases.hpp"
#include "network/node_system.hpp"
#include "studies/mobility/internal/repair_search.hpp"

namespace kinestat {

Mechanism released(const Mechanism& mechanism, const std::vector<CouplingChange>& changes) {
  Mechanism result = mechanism;
  Topology& topology = result.topology;
  topology.freedoms.clear();
  result.geometry.motions.clear();
  for (int e = 0; e < topology.coupling_count(); ++e) {
    CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    const auto first = static_cast<std::ptrdiff_t>(coupling.first_freedom);
    coupling.first_freedom = topology.freedom_count();
    for (std::ptrdiff_t f = first; f < first + coupling.freedom_count; ++f) {
      topology.freedoms.push_back(mechanism.topology.freedoms[static_cast<std::size_t>(f)]);
      result.geometry.motions.push_back(mechanism.geometry.motions[static_cast<std::size_t>(f)]);
    }
    for (const CouplingChange& change : changes) {
      for (std::size_t i = 0; change.coupling.value == e && i < change.added.size(); ++i) {
        const bool turns = !change.added[i].angular.isZero(0.0);
        topology.freedoms.push_back({.coupling = {e}, .name = "added", .is_rotation = turns});
        result.geometry.motions.push_back(change.added[i]);
        ++coupling.freedom_count;
      }
    }
  }
  return result;
}

Repair verify_repair(const Mechanism& mechanism,
                     const MotionCounts& before,
                     std::vector<CouplingChange> changes) {
  const Mechanism better = released(mechanism, changes);
  const CoordinateBasis basis = motion_basis(better.geometry, OrderChoice::spatial);
  const Elimination elimination(velocity_system(better.topology, better.geometry, basis), {});
  Repair repair;
  for (const CouplingChange& change : changes) {
    repair.freed += static_cast<int>(change.added.size());
  }
  repair.changes = std::move(changes);
  repair.after = motion_counts(better, basis.order(), elimination.rank());
  repair.is_verified = repair.after.net_freedom == before.net_freedom &&
                       repair.after.net_constraint == before.net_constraint - repair.freed;
  return repair;
}

std::vector<Repair> find_repairs(const Mechanism& mechanism,
                                 const MotionCounts& before,
                                 const Redundancies& redundancies,
                                 int most) {
  std::vector<Repair> repairs;
  if (redundancies.constraints.empty()) {
    return repairs;
  }
  for (std::vector<CouplingChange>& changes :
       search_changes(mechanism, redundancies.constraints, most)) {
    repairs.push_back(verify_repair(mechanism, before, std::move(changes)));
  }
  std::erase_if(repairs, [](const Repair& repair) { return !repair.is_verified; });
  return repairs;
}

}  // namespace kinestat
