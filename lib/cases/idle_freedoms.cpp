#include "cases/idle_freedoms.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "studies/mobility/passive_freedom.hpp"

namespace kinestat {

namespace {

std::vector<int> moved_freedoms(const PassiveFreedom& one) {
  std::vector<int> moved;
  const double least = kRankZero * one.rates.cwiseAbs().maxCoeff();
  for (Eigen::Index f = 0; f < one.rates.size(); ++f) {
    if (std::abs(one.rates[f]) > least) {
      moved.push_back(static_cast<int>(f));
    }
  }
  return moved;
}

bool is_known(const Case& which, const std::vector<int>& freedoms) {
  return std::ranges::any_of(which.motions, [&](const Primary& known) {
    return std::ranges::find(freedoms, known.index) != freedoms.end();
  });
}

bool rubs(const Mechanism& mechanism, const std::vector<int>& freedoms) {
  return std::ranges::any_of(mechanism.frictions, [&](const CouplingFriction& friction) {
    return std::ranges::any_of(freedoms, [&](int f) {
      return mechanism.topology.freedoms[static_cast<std::size_t>(f)].coupling == friction.coupling;
    });
  });
}

// The freedom that it turns or shifts fastest, and none before has.
int fastest(const PassiveFreedom& one, const std::vector<int>& freedoms, const Case& which) {
  int best = -1;
  for (const int f : freedoms) {
    const bool is_faster = best < 0 || std::abs(one.rates[f]) > std::abs(one.rates[best]);
    if (is_faster && !is_known(which, {f})) {
      best = f;
    }
  }
  return best;
}

}  // namespace

std::vector<IdleFreedom> hold_idle_freedoms(const Mechanism& mechanism,
                                            const CoordinateBasis& basis,
                                            const KinematicSolution& open,
                                            Case& which) {
  std::vector<IdleFreedom> idle;
  Case held = which;
  for (const PassiveFreedom& one : find_passive_freedoms(mechanism, basis)) {
    std::vector<int> freedoms = moved_freedoms(one);
    if (is_known(which, freedoms) || rubs(mechanism, freedoms)) {
      continue;
    }
    if (const int f = fastest(one, freedoms, held); f >= 0) {
      held.motions.push_back(
          {.index = f, .value = 0.0, .given = {}, .where = which.where, .is_assumed = true});
      idle.push_back({.bodies = one.bodies, .freedoms = std::move(freedoms)});
    }
  }
  if (static_cast<int>(idle.size()) != open.check.missing) {
    return {};
  }
  which = std::move(held);
  return idle;
}

}  // namespace kinestat
