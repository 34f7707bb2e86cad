// The columns of a sweep, each with its unit: from the name in the file to a number of a case.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"

namespace kinestat {

enum class SweepColumnKind {
  ratio,
  torque_ratio,
  step,
  efficiency,
  recirculation,
  limit_use,           ///< of a gear: the largest of its torques and speeds over their limits
  equivalent_inertia,  ///< or mass, at the input of the case
  rate,
  action,
  lossy_action,  ///< as meshes with their losses by the carrier model leave it
  reported,      ///< the number of the report of a case at the place that is its name
  motion         ///< a figure of the whole motion
};

/// A column of a sweep, resolved once for all states.
struct SweepColumn {
  SweepColumnKind kind = SweepColumnKind::ratio;
  int index = -1;    ///< into Topology::freedoms or Topology::actions, or of the figure
  std::string name;  ///< as the file has it
  std::string unit;  ///< of its values, as its title has it; empty for a bare number
};

/// Whether it needs the actions of the case; otherwise its velocities are enough.
bool needs_statics(SweepColumnKind kind);

/// Whether it needs the power flow of the case.
bool needs_power(SweepColumnKind kind);

/// Whether a column of that kind is among them.
bool asks(std::span<const SweepColumn> columns, SweepColumnKind kind);

/// Whether any of them needs the power flow.
bool asks_power(std::span<const SweepColumn> columns);

/// Answers a name that is a figure of the motion with its column; empty iff it added an error.
using FindOfMotion = std::function<std::optional<SweepColumn>(const Name&)>;

/// The quantities that `report` of the sweep names; if it names none, ratio and torque ratio where
/// cases have them in one unit, and all rates and actions. A ratio that is named, but whose unit
/// differs from case to case, is E0305, and so are a step without gears and a use without limits.
/// Empty iff an error was added.
std::optional<std::vector<SweepColumn>> find_sweep_columns(const MechanismDescription& description,
                                                           const Mechanism& mechanism,
                                                           std::span<const Case> cases,
                                                           const FindOfMotion& of_motion,
                                                           Diagnostics& found);

/// Whether two states have the same freedoms and actions. Screws that are given may bear more in
/// one state than in another.
bool has_same_magnitudes(const Topology& a, const Topology& b);

/// The columns, found with the topology of the file, in that of a state: by their names. What the
/// state does not have has no value there.
std::vector<SweepColumn> columns_in(const std::vector<SweepColumn>& columns,
                                    const Topology& file,
                                    const Topology& state);

/// Its value in its unit; empty where the case has none. A step and a figure of the motion are not
/// of one case in one position, and limits are those of a gear: see limit_use_of.
std::optional<double> value_of(const SweepColumn& column,
                               const CaseAnalysis& one,
                               const Mechanism& mechanism,
                               const FileUnits& units);

/// Of a gear in a state, with the limits of this plan.
std::optional<double> limit_use_of(const Mechanism& mechanism,
                                   const ShiftPlan& plan,
                                   const ShiftState& state,
                                   const CaseAnalysis& one);

}  // namespace kinestat
