// A synthesised linkage as a mechanism that every other pass takes.
#pragma once

#include <string>
#include <vector>

#include "description/mechanism_description.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// The linkage drawn in the first position of its task, in the units of the task. Its driven link
/// `driver` turns or slides on the frame at A0 and leads the `coupler` at A; the `follower` leads
/// it at B and moves on the frame at B0. The reference point of the coupler is the origin of the
/// moving frame, and the one case drives the linkage towards the other positions. An inverted
/// slider is a guide that turns on the frame, and A or B the prismatic coupling in it.
MechanismDescription describe_linkage(const SynthesisAnalysis& analysis,
                                      const SynthesisTask& task,
                                      const LinkageCandidate& candidate);

/// How far the drive has moved from the drawn position in each position, along the sense in which
/// the verdict passes them: the shorter way forwards where it passes them in none [rad or m].
std::vector<double> drive_travel(const LinkageCandidate& candidate);

/// Lines of comment for its file: which linkage of which task it is, where it is drawn, and how far
/// the drive moves from there to the other positions. `number` counts the linkages of the task.
std::vector<std::string> linkage_comment(const SynthesisAnalysis& analysis,
                                         const SynthesisTask& task,
                                         std::size_t number);

}  // namespace kinestat
