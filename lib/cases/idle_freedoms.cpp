#include "cases/idle_freedoms.hpp"

#include <algorithm>

#include "kinematics/velocity.hpp"
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

Primary assumed(int freedom, double rate, const Case& which) {
  return {.index = freedom, .value = rate, .given = {}, .where = which.where, .is_assumed = true};
}

// What moves in one motion.
IdleFreedom moved_in(const KinematicSolution& motion) {
  IdleFreedom idle;
  for (std::size_t b = 0; b < motion.bodies.size(); ++b) {
    const Twist& twist = motion.bodies[b];
    if (!twist.angular.isZero(0.0) || !twist.linear.isZero(0.0)) {
      idle.bodies.push_back(BodyId{static_cast<int>(b)});
      idle.twists.push_back(twist);
    }
  }
  for (std::size_t f = 0; f < motion.rates.size(); ++f) {
    if (motion.rates[f] != 0.0) {
      idle.freedoms.push_back(static_cast<int>(f));
    }
  }
  return idle;
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
    idle.push_back({.bodies = one.bodies, .twists = one.twists, .freedoms = moved_freedoms(one)});
  }
  for (const int f : held) {
    which.motions.push_back(assumed(f, 0.0, which));
  }
  return idle;
}

std::vector<IdleFreedom> hold_beside_gear(const Mechanism& mechanism,
                                          const CoordinateBasis& basis,
                                          const KinematicSolution& open,
                                          Case& which) {
  const std::vector<std::vector<int>>& completions = open.check.completions;
  if (!which.is_gear || completions.empty()) {
    return {};
  }
  std::vector<Primary> known = which.motions;
  for (Primary& one : known) {
    one.value = 0.0;
  }
  for (const int f : completions.front()) {
    known.push_back(assumed(f, 0.0, which));
  }
  std::vector<IdleFreedom> idle;
  for (std::size_t i = which.motions.size(); i < known.size(); ++i) {
    known[i].value = 1.0;
    const KinematicSolution motion = solve_velocity(mechanism, basis, known);
    if (motion.status != SolveStatus::solved) {
      return {};
    }
    idle.push_back(moved_in(motion));
    known[i].value = 0.0;
  }
  for (const int f : completions.front()) {
    which.motions.push_back(assumed(f, 0.0, which));
  }
  return idle;
}

}  // namespace kinestat
