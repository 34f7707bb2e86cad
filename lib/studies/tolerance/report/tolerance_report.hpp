// What tolerances do to positions, in the forms of a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "report/report_forms.hpp"
#include "studies/tolerance/tolerance_stack.hpp"

namespace kinestat {

/// A number in the unit of the file.
struct ShownValue {
  double value = 0.0;
  std::string unit;
};

/// Where the first drive of a motion stands, from the drawn position.
struct DrivePlace {
  std::string name;
  ShownValue value;
};

/// One case, or one step of a motion, with its drives held.
struct CaseTolerance {
  std::string label;
  std::optional<DrivePlace> drive;  ///< of a step
  std::vector<std::string> held;    ///< as the case names them; none at a singular position
  std::vector<ToleranceStack> positions;
  std::vector<std::string> loose;        ///< positions that the held drives leave open
  std::vector<std::string> not_fitting;  ///< actions that redundant constraints bear: no part can
                                         ///< deviate along or about them alone
  bool has_tolerances = false;           ///< some deviation may be more than zero
};

struct FoundTolerance {
  double place = 0.0;  ///< of what has no tolerance of its own [m]
  double angle = 0.0;  ///< likewise [rad]
  std::vector<CaseTolerance> cases;
  bool is_along = false;  ///< they are the steps of a motion
};

/// The influence of a share; the unit is that of the position per unit of the deviation, empty if
/// they are alike.
ShownValue shown_influence(const ToleranceShare& share,
                           QuantityKind position,
                           const FileUnits& units);

/// JSON `cases.<label>.positions.<position>.by.<coupling>/place`; texts with what moves most
/// first, of a motion where the position is off most.
FileReport make_tolerance_report(const std::string& file,
                                 const MechanismDescription& description,
                                 const FoundTolerance& answer,
                                 const ReportForms& forms,
                                 const Diagnostics& found);

}  // namespace kinestat
