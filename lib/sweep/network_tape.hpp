// The velocities or the actions of one case, worked out once and played for each state.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/elimination_tape.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

enum class NetworkSide { motion, action };

/// What a tape is recorded from.
struct TapedSystem {
  NetworkSide side = NetworkSide::motion;
  const Mechanism* mechanism = nullptr;
  const CoordinateBasis* basis = nullptr;
  const std::vector<bool>* moves = nullptr;  ///< of each coupling: whether its screws may change
  std::span<const Geometry> samples;         ///< of other states: where entries may be
  std::span<const Primary> primaries;        ///< known, in their order
  std::span<const int> wanted;               ///< freedoms or actions
};

/// The node system of network/node_system as a tape. Which entries are zero is read off the
/// mechanism and the samples; a state in which another one is not has no answer here.
class NetworkTape {
 public:
  /// Empty where the system must be solved anew for every state.
  static std::optional<NetworkTape> record(const TapedSystem& system);

  EliminationTape::Workspace make_workspace() const { return tape_.make_workspace(); }

  /// Eliminates for the geometry of a state; false where it has no answer here.
  bool eliminate(const Geometry& geometry, EliminationTape::Workspace& workspace) const;

  /// The wanted magnitudes [SI], in their order, for known ones [SI]. False if one is not finite.
  bool solve(std::span<const Primary> primaries,
             EliminationTape::Workspace& workspace,
             std::vector<double>& known,
             std::vector<double>& wanted) const;

 private:
  // A coordinate of a screw that stands in the matrix, or must be zero.
  struct Slot {
    int screw = 0;
    int coordinate = 0;
    std::size_t entry = 0;
    double factor = 0.0;
    double unit = 1.0;
  };

  // A wanted magnitude.
  struct Output {
    int column = 0;
    double unit = 1.0;
  };

  NetworkTape(NetworkSide side, EliminationTape tape) : side_(side), tape_(std::move(tape)) {}

  friend class NetworkTapeRecorder;

  NetworkSide side_;
  EliminationTape tape_;
  std::vector<Slot> varying_;
  std::vector<Slot> zeros_;
  std::vector<double> known_units_;
  std::vector<Output> outputs_;
};

}  // namespace kinestat
