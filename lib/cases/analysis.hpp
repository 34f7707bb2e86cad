// The results of the analysis of one file, from which its report is made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/made_once.hpp"
#include "dynamics/case_dynamics.hpp"
#include "dynamics/curve_loads.hpp"
#include "dynamics/spring_force.hpp"
#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "power/power_flow.hpp"
#include "power/power_graph.hpp"
#include "power/ratio.hpp"
#include "power/transmission_efficiency.hpp"
#include "statics/cable_contact_state.hpp"
#include "statics/converter_state.hpp"
#include "statics/static_solution.hpp"
#include "studies/mobility/mobility_counts.hpp"
#include "studies/sensitivity/affine.hpp"
#include "studies/shift/shift_slip.hpp"
#include "studies/shift/shift_solution.hpp"

namespace kinestat {

/// The dependence of one rate or action [SI] on the free parameters, which are in their own units.
/// `value` is empty if the dependence is not affine.
struct AffineMagnitude {
  int index = 0;  ///< into Topology::freedoms or Topology::actions
  std::optional<AffineValue> value;
};

/// A parameter that the file leaves free; the unit is empty for a bare number.
struct FreeParameterLabel {
  std::string name;
  std::string unit;
};

/// A case whose motion a torque converter decides, by the torque that it takes.
struct ConverterSearch {
  CouplingId coupling;
  int action = 0;                   ///< the known action to be met: index into Topology::actions
  double least = 0.0;               ///< its least value at the speeds of the case [N·m]
  double greatest = 0.0;            ///< its greatest value there [N·m]
  std::vector<double> ratios = {};  ///< the speed ratios at which it is met
  std::optional<Case> which =
      {};  ///< the case with the slip as a known motion in its place, if one ratio is found
};

/// The results of a case, one for each pass. A pass that the case does not ask for is empty.
struct CaseAnalysis {
  Case which;
  std::optional<KinematicSolution> motion;
  std::optional<StaticSolution> action;
  std::vector<CableContactState>
      contacts;  ///< of cables with pulleys, in the order of Mechanism::contacts
  std::vector<ConverterState> converters;           ///< if the case has both motion and action
  std::optional<ConverterSearch> converter_search;  ///< if a torque converter decides the motion
  std::optional<VecX> pretension;  ///< of each action: keeps segments in tension that would push
  std::vector<int> coast_flanks;   ///< indices into Geometry::other_flanks: where teeth press
  std::optional<PowerFlow> power;
  std::optional<PowerGraph> power_graph;             ///< only with `power`
  std::optional<TransmissionEfficiency> efficiency;  ///< only with `power`, if meshes lose power
  std::optional<Ratios> ratios;
  std::vector<SpringState> springs;               ///< in the order of Mechanism::springs
  std::optional<SpringObstacle> spring_obstacle;  ///< why they are unknown; no `action` then
  std::optional<CurveObstacle> curve_obstacle;    ///< the same for what follows curves
  std::optional<CaseDynamics> dynamics;  ///< of a case with inertia and known accelerations
  std::optional<InertiaObstacle> inertia_obstacle;  ///< why they are unknown; no `action` then

  bool has_unknown_loads() const { return spring_obstacle || curve_obstacle || inertia_obstacle; }
};

/// The magnitudes of one case that depend on a free parameter.
struct AffineCase {
  std::vector<AffineMagnitude> rates;
  std::vector<AffineMagnitude> actions;
};

/// The dependence of all cases on the parameters that the file leaves free; empty if it has none.
struct AffineDependence {
  std::vector<FreeParameterLabel> parameters;
  std::vector<AffineCase> cases;  ///< in the order of Analysis::cases
};

/// The section `shift` and the states of the transmission.
struct ShiftAnalysis {
  ShiftPlan plan;
  ShiftSolution solution;
  std::vector<ShiftSlip> slips = {};                    ///< in the order of ShiftPlan::slips
  std::vector<SlipObstacle> slips_without_answer = {};  ///< in the same order
};

/// The analysis of one mechanism: its counts and its cases, in file order, followed by its gears.
struct Analysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  Mechanism mechanism;
  MobilityCounts mobility;
  std::vector<CaseAnalysis> cases;
  std::optional<ShiftAnalysis> shift;
  MadeOnce<AffineDependence> affine;  ///< to be read by affine_dependence
};

/// A mechanism file that was read and bound.
struct Loaded {
  MechanismDescription description;
  Mechanism mechanism;
  std::optional<ShiftAnalysis> shift;  ///< whose gears are among the cases
};

}  // namespace kinestat
