// Motions of linkages that are known, from which tasks are made whose dyads are known.
#pragma once

#include <optional>
#include <vector>

#include "studies/synthesis/dyads/dyad.hpp"
#include "support/random.hpp"

namespace kinestat {

/// Two dyads. Given the angle of the plane, each leaves its origin a circle or a line, so that the
/// poses follow without any of the equations that the library solves.
struct KnownLinkage {
  Dyad one;
  Dyad other;

  /// Both poses at this angle; empty if the dyads cannot reach it.
  std::vector<Point> origins(double angle) const;

  /// Derivatives of the origin for given derivatives of the angle, by differentiating what the
  /// dyads keep constant. Empty in a singular position.
  std::optional<PositionJets> jets(const Point& at, const std::vector<double>& angle) const;
};

/// Dyads of the given kinds that meet a random pose, of sizes about 1.
KnownLinkage random_linkage(Random& random, DyadKind one, DyadKind other);

/// Positions of the linkage in groups of the given orders, clearly apart; the derivatives are by a
/// parameter that is the angle, or any other one. Empty if the linkage cannot move that far.
std::vector<PositionJets> random_positions(Random& random,
                                           const KnownLinkage& linkage,
                                           const std::vector<int>& orders);

}  // namespace kinestat
