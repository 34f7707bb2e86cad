// What the report of one file is made of.
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

/// The dependence of one rate or action on the free parameters, the magnitude in SI, the parameters
/// in their units; empty if it is not affine.
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
  int action = 0;                   ///< the one that must fit: index into Topology::actions
  double least = 0.0;               ///< what it may be at the speeds of the case [N·m]
  double greatest = 0.0;            ///< likewise
  bool has_any = false;             ///< whether it may be anything
  std::vector<double> ratios = {};  ///< speed ratios at which it fits
  std::optional<Case> which =
      {};  ///< with the slip as a known motion instead of it, where one fits
};

/// The passes that a case asked for; a pass that it did not ask for is empty.
struct CaseAnalysis {
  Case which;
  std::optional<KinematicSolution> motion;
  std::optional<StaticSolution> action;
  std::vector<CableContactState>
      contacts;  ///< of cables with pulleys, in the order of the mechanism's
  std::vector<ConverterState> converters;           ///< beside `action`, where the case has motion
  std::optional<ConverterSearch> converter_search;  ///< where the motion lacks what that decides
  std::optional<VecX> pretension;  ///< of each action, which keeps pushed segments in tension
  std::vector<int> coast_flanks;   ///< of geometry.other_flanks: those on which the teeth press
  std::optional<PowerFlow> power;
  std::optional<PowerGraph> power_graph;             ///< beside `power`
  std::optional<TransmissionEfficiency> efficiency;  ///< beside `power`, where meshes lose any
  std::optional<Ratios> ratios;
  std::vector<SpringState> springs;               ///< in the order of the mechanism's
  std::optional<SpringObstacle> spring_obstacle;  ///< why they are not known; then no `action`
  std::optional<CurveObstacle> curve_obstacle;    ///< likewise, of what follows curves
  std::optional<CaseDynamics> dynamics;  ///< of a case with inertia whose accelerations are known
  std::optional<InertiaObstacle> inertia_obstacle;  ///< why they are not; then it has no `action`

  bool has_unknown_loads() const { return spring_obstacle || curve_obstacle || inertia_obstacle; }
};

/// The magnitudes of one case that depend on a free parameter.
struct AffineCase {
  std::vector<AffineMagnitude> rates;
  std::vector<AffineMagnitude> actions;
};

/// How the cases depend on the parameters that the file leaves free; empty without any.
struct AffineDependence {
  std::vector<FreeParameterLabel> parameters;
  std::vector<AffineCase> cases;  ///< as those of the analysis
};

/// The section `shift` and the states of the transmission.
struct ShiftAnalysis {
  ShiftPlan plan;
  ShiftSolution solution;
  std::vector<ShiftSlip> slips = {};                    ///< in the order of the plan
  std::vector<SlipObstacle> slips_without_answer = {};  ///< likewise
};

/// One mechanism with its counts and its cases, in file order, then its gears.
struct Analysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  Mechanism mechanism;
  MobilityCounts mobility;
  std::vector<CaseAnalysis> cases;
  std::optional<ShiftAnalysis> shift;
  MadeOnce<AffineDependence> affine;  ///< affine_dependence says it
};

/// A mechanism file that was read and bound.
struct Loaded {
  MechanismDescription description;
  Mechanism mechanism;
  std::optional<ShiftAnalysis> shift;  ///< whose gears are among the cases
};

}  // namespace kinestat
