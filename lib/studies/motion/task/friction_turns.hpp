// Where friction turns round on a motion.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cases/findings/case_findings.hpp"
#include "mechanism/mechanism.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/friction_sliding.hpp"

namespace kinestat {

/// How the frictions slide at a step, whole or not; empty of what is beyond the motion.
using SlidingBetween = std::function<FrictionSliding(double step)>;

/// The couplings that slide one way and then the other, by the sliding at places in order, the rows
/// of the table among them, and beside rows that rest and that no two places are about. Rows
/// between get the status of its reversal, wherever the steps fall; so do the first and the last
/// row where it rests in that one alone. Where a drive rests there is no reversal.
std::vector<FrictionTurn> find_friction_turns(const Mechanism& mechanism,
                                              std::span<const FrictionPlace> places,
                                              const SlidingBetween& between,
                                              MotionTable& table);

/// The findings of a row of that status, or of a place between rows, as a motion tells them. That a
/// friction has no direction there is said of its turn, wherever the steps fall; in a motion in
/// time drives may rest, W0508 instead of E0606.
CaseFindings told_of_row(const CaseFindings& said,
                         const FrictionSliding& sliding,
                         const std::string& status,
                         const MotionTable& table);

}  // namespace kinestat
