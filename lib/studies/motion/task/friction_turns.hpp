// Where friction turns round on a motion.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "cases/findings/case_findings.hpp"
#include "mechanism/mechanism.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// How frictions slide beside a row is seen so many steps from it.
inline constexpr double kBesideRow = 0x1p-10;

/// How the frictions of a mechanism slide in one position.
struct FrictionSliding {
  /// Of each the motion against which it works [rad/s or m/s]: the rate of the one freedom of a
  /// bearing, guide or thread; the velocity along the freedoms that slide of a contact, whose turns
  /// have no friction. Zero where the friction has no direction; empty where no motion is known.
  std::vector<Vec3> rates;
  bool stands = false;  ///< a drive of a motion in time rests
};

FrictionSliding sliding_at(const Mechanism& mechanism,
                           const MotionPlan& plan,
                           const MotionPosition& position);

/// The same of one coupling with friction, by the rates of all freedoms [rad/s or m/s].
Vec3 sliding_of(const Topology& topology,
                CouplingId coupling,
                std::span<const std::optional<double>> rates);

/// How the frictions slide at a place between rows, which are at whole numbers; empty of what is
/// beyond the motion.
using SlidingBetween = std::function<FrictionSliding(double row)>;

/// Into how many parts the steps between the rows must be divided so that the rows see each turn:
/// no friction turns round twice within one, nor once just beside a rest. 1 if they see all, or if
/// it would take too many: turns that are over in a sixty-fourth of a step stay unseen, and so does
/// what moves between two rests, or turns three times within a step.
int parts_for_friction(const Mechanism& mechanism,
                       const std::vector<FrictionSliding>& sliding,
                       const SlidingBetween& between);

/// Adds to the table the couplings that slide one way and then the other, by the sliding of each of
/// its rows, and beside those that no other row is between. Rows between are at its reversal,
/// wherever the steps fall; so are the first and the last row where it rests in that one alone.
/// Where a drive rests there is no reversal.
void find_friction_turns(const Mechanism& mechanism,
                         const std::vector<FrictionSliding>& sliding,
                         const SlidingBetween& between,
                         MotionTable& table);

/// The findings of a row as a motion tells them. That a friction has no direction there is said of
/// its turn, wherever the steps fall; in a motion in time drives may rest, W0508 instead of E0606.
CaseFindings told_of_row(const CaseFindings& said,
                         const FrictionSliding& sliding,
                         const MotionRow& row,
                         const MotionTable& table);

}  // namespace kinestat
