// Which magnitudes may be given, in the forms of a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "math/elimination/rank.hpp"
#include "report/report_forms.hpp"
#include "studies/inputs/cable_tension.hpp"
#include "studies/inputs/input_sets.hpp"

namespace kinestat {

/// The sets of one side, motions or actions; indices are into `names`.
struct InputSide {
  std::string key;                 ///< "motion" or "action"
  std::vector<std::string> names;  ///< of all magnitudes
  InputSets sets;
  RankEvidence evidence;
};

/// What is said of a set that the user proposes.
struct ChoiceVerdict {
  std::string key;  ///< of the side
  std::vector<std::string> names;
  bool is_valid = false;
  double conditioning = 0.0;
  std::string reason;  ///< why it is not valid
  std::string hint;    ///< what would be
};

struct InputsAnalysis {
  std::vector<InputSide> sides;  ///< motions, then actions
  std::vector<ChoiceVerdict> choices;
  std::optional<CableTension> cables;
};

/// JSON `inputs.<side>.groups/<i>/sets`, `inputs.cables` and `choices`; tables with the best
/// conditioned set first.
FileReport make_inputs_report(const std::string& file,
                              const MechanismDescription& description,
                              const InputsAnalysis& inputs,
                              const ReportForms& forms,
                              const Diagnostics& found);

}  // namespace kinestat
