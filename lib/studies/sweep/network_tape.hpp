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

/// A couple of one body on another [N·m], which follows from actions: couple · speed + Σ action ·
/// share = 0.
struct TapedCouple {
  struct Share {
    int action = 0;
    TapeNumber per_action;
  };

  BodyId tail;
  BodyId head;         ///< on which it acts
  int coordinate = 2;  ///< of the wrench
  TapeNumber speed;
  std::vector<Share> shares;
};

/// What is recorded.
struct TapedSystem {
  NetworkSide side = NetworkSide::motion;
  const Topology* topology = nullptr;
  const CoordinateBasis* basis = nullptr;
  std::span<const TapedScrew> screws;         ///< of each freedom or action
  std::span<const Geometry> samples;          ///< some states: where entries may be
  std::span<const Primary> primaries;         ///< known
  std::span<const TapeNumber> known;          ///< their magnitudes [SI]
  std::span<const int> wanted;                ///< freedoms or actions
  bool wants_bodies = false;                  ///< their motions too
  std::span<const TapedCouple> couples = {};  ///< beside actions
};

/// All in SI.
struct TapedNetwork {
  std::vector<TapeNumber> wanted;   ///< in their order
  std::vector<TapedScrew> bodies;   ///< twists, the ground first; empty if they are not wanted
  std::vector<TapeNumber> couples;  ///< parallel to those given
};

/// What follows from the known ones in the node system of network/node_system. Which coordinates
/// that move are zero in all states is read off the samples; a lane in which another one is not has
/// no answer. Empty where the system must be solved anew for every state.
std::optional<TapedNetwork> record_network(const TapedSystem& system, LaneRecorder& recorder);

}  // namespace kinestat
