// The velocities or the actions of one case on a tape.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/elimination/elimination_tape.hpp"
#include "mechanism/bind/rebind.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

enum class NetworkSide { motion, action };

/// What is recorded.
struct TapedSystem {
  NetworkSide side = NetworkSide::motion;
  const Topology* topology = nullptr;
  const CoordinateBasis* basis = nullptr;
  std::span<const TapedScrew> screws;  ///< of each freedom or action
  std::span<const Geometry> samples;   ///< some states: where entries may be
  std::span<const Primary> primaries;  ///< known
  std::span<const TapeNumber> known;   ///< their magnitudes [SI]
  std::span<const int> wanted;         ///< freedoms or actions
};

/// The wanted magnitudes [SI], in their order, of the node system of network/node_system. Which
/// coordinates that move are zero in all states is read off the samples; a lane in which another
/// one is not has no answer. Empty where the system must be solved anew for every state.
std::optional<std::vector<TapeNumber>> record_network(const TapedSystem& system,
                                                      LaneRecorder& recorder);

}  // namespace kinestat
