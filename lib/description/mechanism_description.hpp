// What a mechanism file says, section by section, each number still an expression with its place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/body_description.hpp"
#include "description/cable_description.hpp"
#include "description/case_description.hpp"
#include "description/coupling_description.hpp"
#include "description/curve_description.hpp"
#include "description/duty_description.hpp"
#include "description/dynamics_description.hpp"
#include "description/gear_description.hpp"
#include "description/load_description.hpp"
#include "description/loss_description.hpp"
#include "description/motion_description.hpp"
#include "description/shift_description.hpp"
#include "description/simulation_description.hpp"
#include "description/spring_description.hpp"
#include "description/sweep_description.hpp"
#include "description/synthesis_description.hpp"
#include "expression/file_units.hpp"
#include "expression/parameters.hpp"

namespace kinestat {

/// How many coordinates a pass works in; minimal: only those that the screws of the mechanism need.
enum class OrderChoice { minimal, planar, spatial };

/// What to say of actions that equilibrium leaves open.
enum class IndeterminateChoice { report, minimum_norm, stiffness };

/// `h_z: {free: 0}` leaves the value open: reports give the dependence on it as well.
struct ParameterDescription {
  Name name;
  Value value;
  bool is_free = false;
  std::string set_by =
      {};  ///< NAME=VALUE of the command line that replaced the value; empty if none did
};

/// An active coupling; `freedom` is needed where the coupling has several.
struct ActuatorDescription {
  Name name;
  Name coupling;
  std::optional<Name> freedom;
};

/// A number that the source prints, checked against the report.
struct PublishedValue {
  Name pointer;            ///< JSON Pointer into the report
  double is = 0.0;         ///< the right value, in the report's units
  double tolerance = 0.0;  ///< absolute; 0 where none is given
  std::string where;       ///< place in the source
  SourceRange is_where;
};

/// One mechanism file. Sections that are absent are empty; a file may hold a synthesis task alone,
/// and then has no bodies.
struct MechanismDescription {
  std::string name;
  std::string source;
  Space space = Space::spatial;
  FileUnits units;
  std::vector<ParameterDescription> parameters;
  std::optional<std::vector<Name>> tree;
  SourceRange tree_where;
  OrderChoice kinematic_order = OrderChoice::minimal;
  OrderChoice static_order = OrderChoice::minimal;
  SourceRange order_where;
  Name ground;
  std::vector<BodyDescription> bodies;
  std::vector<CouplingDescription> couplings;
  std::optional<GearsDescription> gears;
  std::vector<CableDescription> cables;
  SourceRange cables_where;
  std::vector<ActuatorDescription> actuators;
  std::vector<LoadDescription> loads;
  SourceRange loads_where;
  std::vector<SpringDescription> springs;
  std::vector<CurveDescription> curves;
  std::optional<PointDescription> gravity;  ///< vector [acceleration]
  std::optional<LossDescription> losses;
  IndeterminateChoice indeterminate = IndeterminateChoice::report;
  SourceRange statics_where;
  std::vector<CaseDescription> cases;
  std::optional<ShiftDescription> shift;
  std::optional<DutyDescription> duty;
  std::optional<MotionDescription> motion;
  std::optional<DynamicsDescription> dynamics;
  std::optional<SimulationDescription> simulation;
  std::optional<SweepDescription> sweep;
  std::optional<SynthesisDescription> synthesis;
  std::vector<PublishedValue> published;

  /// False for a file that holds only a synthesis task.
  bool has_mechanism() const { return !ground.text.empty(); }
};

/// The parameters as the expression module evaluates them.
std::vector<Parameter> parameters_of(const MechanismDescription& description);

/// 1 or -1 where the end of a drive is no place but its limit, forwards or backwards; 0 where it is
/// a place, also that of a parameter called `limit`.
int limit_sense(const std::optional<Value>& end, const MechanismDescription& description);

/// Whether the value of any parameter is but an example.
bool has_free_parameters(const MechanismDescription& description);

}  // namespace kinestat
