// Findings about the actions of a case.
#pragma once

#include <string>
#include <string_view>

#include "cases/findings/case_findings.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// The name of a reaction that causes no friction, and the key that would make it count.
struct ReactionWords {
  std::string_view what;
  std::string_view key;
};

ReactionWords words_of(Reaction reaction);

/// What is wrong where teeth would pull on each other, and what to do.
struct ToothWords {
  std::string what;
  std::string hint;
};

/// `force` is that along the line of action that the file gives [N].
ToothWords words_of_pulling_teeth(const MechanismDescription& description,
                                  CouplingId coupling,
                                  double force);

/// What is wrong where a clutch or brake that slips would supply power, and what to do.
struct ClutchWords {
  std::string would;  ///< "'C' would have to drive"
  std::string how;    ///< "its torque of … acts along its slip of …"
  std::string hint;
};

/// `torque` [N·m] and `slip` [rad/s] have the same sign.
ClutchWords words_of_driving_clutch(const std::string& clutch,
                                    double torque,
                                    double slip,
                                    const FileUnits& units);

/// Adds why a case has no actions, or not all of them. The case must have an action solution.
void add_action_status_findings(const JudgedFile& file,
                                const CaseAnalysis& one,
                                CaseFindings& found);

/// Adds what is wrong with the actions of a case: reactions that cause no friction, contacts that
/// pull, cables in compression or slipping. The case must have an action solution.
void add_action_value_findings(const JudgedFile& file,
                               const CaseAnalysis& one,
                               CaseFindings& found);

/// Warns of teeth that the load presses on a flank whose line of action is not known.
void add_tooth_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

/// Warns of freewheels that a case lets hold a torque, or slip, of the other sign. The case may
/// have a motion alone.
void add_freewheel_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

/// Warns of clutches and brakes that supply power.
void add_clutch_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

/// Warns of segments that would be in compression, with the pretension that keeps them in tension,
/// and of cables that friction does not hold.
void add_cable_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

}  // namespace kinestat
