// A number of the report as a formula of the unknowns and the dimensions, by its name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expression/quantity.hpp"
#include "studies/sensitivity/dual_case.hpp"

namespace kinestat {

/// `value` has derivatives towards all rates, then all actions, all frictions and the parameters,
/// as if these were independent of each other.
struct ReportedValue {
  std::string name;  ///< the path below the case: "kinematics/freedoms/d.wz"
  QuantityKind kind = QuantityKind::dimensionless;
  std::optional<QuantityKind> per;  ///< of a ratio, which is of `kind` per this
  Dual value;
};

/// The value of a name: a path of the JSON report below the case, or in short "ratio",
/// "torque_ratio", a freedom "d.wz" or an action "c.Rx", "drive". Empty if there is no such number
/// in the case, or none that has derivatives (the axis and pitch of a screw, counts).
std::optional<ReportedValue> find_reported_value(const DualCase& values, std::string_view name);

/// Whether it depends on actions that equilibrium leaves open and something else completes.
bool is_completed(const DualCase& values, const ReportedValue& value);

/// Short names and paths that have a value, for a hint.
std::vector<std::string> reported_value_names(const DualCase& values);

/// What one wants to know if nothing is named: the ratios, and of every actuator the rate and the
/// action unless they are primary. Everything, if there are no actuators.
std::vector<std::string> usual_value_names(const DualCase& values);

}  // namespace kinestat
