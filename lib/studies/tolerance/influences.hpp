// How small errors of parts and drives move a mechanism whose drives are held.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "studies/tolerance/deviation.hpp"
#include "studies/tolerance/watched_position.hpp"

namespace kinestat {

/// Of one watched position, to first order, SI units.
struct Influence {
  std::vector<double> by_parts;   ///< how far each deviation of 1 rad or 1 m moves it
  std::vector<double> by_drives;  ///< likewise each of the known motions of the case
};

struct Influences {
  /// Of each watched position; empty of one that held drives leave loose.
  std::vector<std::optional<Influence>> of;
  /// Of each deviation: whether parts can deviate so alone. Not where redundant constraints bear
  /// it: others would bend, or need play.
  std::vector<bool> fits;
};

/// By the principle of virtual work: with a unit action at the watched position and the drives of
/// the case held, the action that a coupling bears is the way that the position goes by a unit of
/// the deviation which that action holds, but for the sign. So each position is one equilibrium.
/// A value is zero where its error bound says so.
Influences find_influences(const Mechanism& mechanism,
                           const Case& which,
                           std::span<const Deviation> deviations,
                           std::span<const WatchedPosition> watched);

}  // namespace kinestat
