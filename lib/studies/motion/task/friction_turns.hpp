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

/// How the frictions slide just before a row or just behind it; empty of what is beyond the motion.
using SlidingBeside = std::function<FrictionSliding(std::size_t row, bool is_behind)>;

/// Adds to the table the couplings that slide one way and then the other, by the sliding of each of
/// its rows, and beside those that no other row is between. Rows between are at its reversal,
/// wherever the steps fall; so are the first and the last row where it rests in that one alone.
/// Where a drive rests there is no reversal.
void find_friction_turns(const Mechanism& mechanism,
                         const std::vector<FrictionSliding>& sliding,
                         const SlidingBeside& beside,
                         MotionTable& table);

/// The findings of a row as a motion tells them. That a friction has no direction there is said of
/// its turn, wherever the steps fall; in a motion in time drives may rest, W0508 instead of E0606.
CaseFindings told_of_row(const CaseFindings& said,
                         const FrictionSliding& sliding,
                         const MotionRow& row,
                         const MotionTable& table);

}  // namespace kinestat
