// Whether a linkage really moves through its positions: circuit, branch, order, transmission.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "studies/synthesis/linkages/drive_curve.hpp"
#include "studies/synthesis/linkages/linkage.hpp"

namespace kinestat {

/// The transmission angle over a motion [rad], in [0, π]; π/2 is best.
struct TransmissionRange {
  double least = 0.0;
  double most = 0.0;

  /// The smallest distance from the dead points [rad], in [0, π/2].
  double margin() const;
};

/// In which sense the input passes the positions.
enum class Passage {
  none,        ///< in no order, or not on one branch
  increasing,  ///< the coordinate grows from position to position
  decreasing
};

/// The word in reports.
std::string_view word_of(Passage passage);

/// (pt: defeitos de circuito, ramo e ordem) A linkage is assembled in one circuit and cannot leave
/// it; a circuit has branches that dead points of the input separate. A position in a dead point
/// ends more than one of them: it counts to that of the position before it, or behind it.
struct DriveVerdict {
  Drive drive = Drive::one;
  std::vector<double> coordinates;   ///< of the positions, see DriveCurve::coordinate_of
  std::vector<int> circuits;         ///< equal numbers: the same circuit
  std::vector<int> branches;         ///< equal numbers: the same branch
  std::vector<double> transmission;  ///< μ in the positions [rad]
  bool turns_fully = false;          ///< the input meets no dead point on this circuit

  /// Of two circuits, that of the first position: 1 or -1, the side of the dead points where the
  /// input turns fully, the sign of its coordinate elsewhere. Zero where there are not two.
  int mirror = 0;

  bool same_circuit = false;
  bool same_branch = false;
  Passage passage = Passage::none;

  TransmissionRange full;                        ///< over all that the first branch can reach
  std::optional<TransmissionRange> working_arc;  ///< from the first to the last position
  double arc = 0.0;  ///< what the input moves from first to last [rad or length], with its sign
};

/// Positions in their order: of each group of coincident ones the pose counts, and its sense if its
/// parameter grows along the motion (PositionJets::is_directed): the input must pass all of them in
/// the sense in which it goes from position to position. With a full turn any sense of rotation is
/// in order that passes the positions within one turn; two positions without a sense always are, by
/// the way that transmits better, and of equal ones by the shorter. With a sense, 1 or -1, the
/// coordinate must grow or fall.
DriveVerdict find_verdict(const Linkage& linkage,
                          Drive drive,
                          std::span<const PositionJets> positions,
                          int sense = 0);

}  // namespace kinestat
