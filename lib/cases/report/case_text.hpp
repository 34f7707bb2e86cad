// One case of an analysis for people.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "report/in_units.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// The parts of the report of a case; those of passes that it did not ask for are empty.
struct CaseBlocks {
  std::string known;    ///< a line: the magnitudes that the case gives
  std::string results;  ///< lines: what results_text has
  TextBlocks motion;
  TextBlocks action;
  TextBlocks power;
  TextBlocks dynamics;
  std::string affine;  ///< lines: the dependence on free parameters
};

CaseBlocks case_blocks(const Analysis& analysis, const CaseAnalysis& one);

/// All of it, below a line with the name of the case.
TextBlocks case_text(const Analysis& analysis, const CaseAnalysis& one);

/// Its actions and powers: actuators, the wrench of every coupling, the loads, and the power
/// balance; where equilibrium leaves actions open, every action by itself instead. The case must
/// have an action solution.
TextBlocks statics_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

/// The largest of the forces or moments of a case, and the couplings that bear it.
struct LargestAction {
  bool is_couple = false;
  double size = 0.0;      ///< [N or N*m]
  bool is_open = false;   ///< equilibrium leaves others open, which may be larger
  bool is_borne = false;  ///< by any coupling whose wrench is determined
  std::vector<std::string> couplings = {};

  bool is_known() const { return is_borne && !is_open; }
};

struct LargestActions {
  LargestAction force;
  LargestAction moment;        ///< about the point of each coupling, as in the table of couplings
  bool is_per_planet = false;  ///< some of them are those of one of several planets
  bool has_central_hinges = false;  ///< whose planets cancel
};

/// Of the couplings whose wrench equilibrium determines; zero where there is none. What several
/// equal planets share counts as that of the most loaded one, central hinges (find_central_hinges)
/// along and about their axis.
LargestActions largest_actions(const Mechanism& mechanism, const CaseAnalysis& one);

/// A line a case with what people ask first, "-" where there is no number; columns without any are
/// left out. Empty without cases.
TextBlocks overview_blocks(const Analysis& analysis);

/// What people ask first: ratio and torque ratio, or why there is none; efficiencies, and what the
/// inputs or outputs take or give with the losses of meshes; the power of the inputs and the
/// balance of all powers; why it lacks what other cases have; the largest force and moment, and in
/// which couplings.
std::string results_text(const Analysis& analysis, const CaseAnalysis& one);

/// Cells of a table with a line a case, "-" where there is no number: the ratio with its unit; the
/// efficiency with the losses of meshes where there are any, by the model that the file chooses, or
/// that the case is self-locking;
/// the input power with them, which the model of what rolls knows.
std::string ratio_cell(const CaseAnalysis& one, const Mechanism& mechanism, const InUnits& in);
std::string efficiency_cell(const CaseAnalysis& one, const Mechanism& mechanism);
std::string input_power_cell(const CaseAnalysis& one,
                             const Mechanism& mechanism,
                             const InUnits& in);

/// Its power flow: what the teeth roll, and which power circulates; the case must have one.
TextBlocks power_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

/// Its inertia: accelerations and forces of the bodies, what the drives have to speed up; the case
/// must have its dynamics.
TextBlocks dynamics_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

/// "c.Tx [N*m] = 1.393 c_z - 3.831 h_z", a line for every magnitude that depends on a free
/// parameter; empty if none does.
std::string affine_text(const Analysis& analysis, const CaseAnalysis& one);

}  // namespace kinestat
