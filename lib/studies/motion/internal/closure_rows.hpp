// The joints of a network and its conditions between frames, as its closure needs them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "couplings/finite_law.hpp"
#include "studies/motion/internal/jet.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// Lengths in sizes of the mechanism. One without a coordinate slides by its direction, once.
struct ClosureJoint {
  ElementaryKind kind = ElementaryKind::turn;
  int parent = 0;
  Vec3 direction = Vec3::UnitZ();
  Vec3 point = Vec3::Zero();
  double pitch = 0.0;
  double sense = 1.0;
  int coordinate = -1;
  int rate = -1;
};

/// Points and directions in the frames, lengths in sizes of the mechanism.
template <class Vector>
struct FramedRow {
  ClosureKind kind = ClosureKind::meet;
  int tail_frame = 0;
  int head_frame = 0;
  Vector tail_point = Vector::Zero();
  Vector head_point = Vector::Zero();
  Vector tail = Vector::Zero();
  Vector head = Vector::Zero();
  double value = 0.0;
  double tail_radius = 0.0;
  double head_radius = 0.0;
  int angle = -1;
  int first = 0;                       ///< row of the system
  std::vector<int> rates;              ///< of the joints between the two frames
  std::vector<double> signs;           ///< +1: the joint moves the head
  std::array<bool, 3> is_linear = {};  ///< each of its rows: see RatesOfRow
};

/// Of the joints between two frames.
struct TurnAxis {
  bool is_one = true;             ///< all that turn have one direction
  std::optional<Vec3> axis = {};  ///< it; empty if none turns
  bool stays = true;              ///< in the world: nothing below the first turns about another

  /// Whether it is no axis of the world.
  bool is_oblique() const { return axis && axis->cwiseAbs().maxCoeff() < 1.0; }
};

/// The rates of the joints that a row depends on, and how it rounds.
struct RatesOfRow {
  std::span<const int> all;
  int tail_frame = 0;
  int head_frame = 0;
  bool is_linear = false;  ///< along the one axis about which joints turn: its factors are constant
  bool is_angle = false;   ///< slides count for nothing in it
  double rounds = 0.0;  ///< one rounding of the frames moves it, and its factors, by so many; 0: of
                        ///< teeth, whose factors are constant
  double by_angle = 0.0;  ///< by so much it follows turns of its joints themselves
};

/// Screws and wrenches as they move, one after the other: of the plane [ω; vx, vy] and [T; Fx, Fy].
/// Lengths in sizes of the mechanism.
struct ClosureLevers {
  std::vector<Jet> screws;    ///< of each rate
  std::vector<Jet> rows;      ///< of the rows but those of teeth
  std::vector<Jet> measures;  ///< of the measured freedoms
};

}  // namespace kinestat
