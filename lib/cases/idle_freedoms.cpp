#include "cases/idle_freedoms.hpp"

#include "studies/mobility/passive_freedom.hpp"

namespace kinestat {

namespace {

// Those that the case knows, and those of couplings where something rubs.
std::vector<int> felt_freedoms(const Mechanism& mechanism, const Case& which) {
  std::vector<int> felt;
  for (const Primary& known : which.motions) {
    felt.push_back(known.index);
  }
  for (const CouplingFriction& friction : mechanism.frictions) {
    const CouplingTopology& coupling = mechanism.topology.coupling(friction.coupling);
    for (int i = 0; i < coupling.freedom_count; ++i) {
      felt.push_back(coupling.first_freedom + i);
    }
  }
  return felt;
}

std::vector<int> moved_freedoms(const PassiveFreedom& one) {
  std::vector<int> moved;
  for (int f = 0; f < static_cast<int>(one.rates.size()); ++f) {
    if (one.moves(f)) {
      moved.push_back(f);
    }
  }
  return moved;
}

}  // namespace

std::vector<IdleFreedom> hold_idle_freedoms(const Mechanism& mechanism,
                                            const CoordinateBasis& basis,
                                            const KinematicSolution& open,
                                            Case& which) {
  const std::vector<PassiveFreedom> passive = passive_freedoms_beside(
      find_passive_freedoms(mechanism, basis), mechanism, felt_freedoms(mechanism, which));
  const std::vector<int> held = deciding_freedoms(passive, mechanism);
  if (static_cast<int>(held.size()) != open.check.missing) {
    return {};
  }
  std::vector<IdleFreedom> idle;
  for (const PassiveFreedom& one : passive) {
    idle.push_back({.bodies = one.bodies, .freedoms = moved_freedoms(one)});
  }
  for (const int f : held) {
    which.motions.push_back(
        {.index = f, .value = 0.0, .given = {}, .where = which.where, .is_assumed = true});
  }
  return idle;
}

}  // namespace kinestat
