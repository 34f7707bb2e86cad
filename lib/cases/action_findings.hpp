// What is to be said of the statics of a case.
#pragma once

#include <string_view>

#include "cases/case_findings.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// What a reaction is called, and the key of a friction that would count it.
struct ReactionWords {
  std::string_view what;
  std::string_view key;
};

ReactionWords words_of(Reaction reaction);

/// Why a case has no actions, or not all of them. It must have an action solution.
void add_action_status_findings(const JudgedFile& file,
                                const CaseAnalysis& one,
                                CaseFindings& found);

/// What the actions that it has cannot be: reactions without friction, contacts that pull, cables
/// in compression or slip. Likewise.
void add_action_value_findings(const JudgedFile& file,
                               const CaseAnalysis& one,
                               CaseFindings& found);

/// Warns of segments that would be in compression, with the pretension that keeps them in tension,
/// and of cables that friction does not hold.
void add_cable_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

}  // namespace kinestat
