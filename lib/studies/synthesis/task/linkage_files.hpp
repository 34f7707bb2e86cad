// Linkages that were found, as mechanism files: described, written, and held against the task.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "files/output.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"
#include "studies/synthesis/task/synthesis_options.hpp"

namespace kinestat {

/// Writes <stem>.linkage_0.yaml, or <stem>.task_0.linkage_0.yaml where the file has lists of angles
/// or ranges, into the folder, all or none, and notes their paths in the tasks. Numbers are those
/// of the report. A file that this program wrote is replaced. False iff an error was added.
bool write_linkages(SynthesisAnalysis& analysis,
                    WrittenLinkages which,
                    const OutputOptions& output,
                    InputPaths inputs,
                    Diagnostics& found);

/// The linkage drawn in the first position of its task, in the units of the task. Its driven link
/// `driver` turns or slides on the frame at A0 and leads the `coupler` at A; the `follower` leads
/// it at B and moves on the frame at B0. The reference point of the coupler is the origin of the
/// moving frame, and the one case drives the linkage towards the other positions. An inverted
/// slider is a guide that turns on the frame, and A or B the prismatic coupling in it. Of a
/// function the actuators are `input` and `output`, and the coupler has no reference point.
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

/// Moves the linkages, all of them or those that will be written, and notes in the tasks what they
/// do. The motion is that of the mechanism which `describe_linkage` makes, and knows nothing of the
/// closed forms of the verdicts. Linkages whose positions leave no digits are passed over. A
/// verdict that does not hold is a warning, W0802.
void check_linkages(SynthesisAnalysis& analysis,
                    const SynthesisOptions& options,
                    Diagnostics& found);

}  // namespace kinestat
