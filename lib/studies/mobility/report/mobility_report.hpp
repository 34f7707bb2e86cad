// The mobility of one file in the forms of a report.
#pragma once

#include <optional>
#include <string>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "report/report_forms.hpp"
#include "studies/mobility/mobility.hpp"
#include "studies/motion/finite_mobility.hpp"

namespace kinestat {

/// A mechanism, the same in space, and what was found.
struct MobilityAnalysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  Mechanism mechanism;
  Mechanism in_space;
  Mobility mobility;
  std::optional<FiniteMobility> finite;  ///< of its motions; empty where it cannot be moved
};

FileReport make_mobility_report(const MobilityAnalysis& analysis,
                                const ReportForms& forms,
                                const Diagnostics& found);

}  // namespace kinestat
