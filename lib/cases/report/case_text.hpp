// One case of an analysis for people.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "report/in_units.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// The parts of the report of a case; those of passes that it did not ask for are empty.
struct CaseBlocks {
  std::string known;  ///< a line: the magnitudes that the case gives
  std::string ratio;  ///< a line: ratio and torque ratio, or why there is none
  TextBlocks motion;
  TextBlocks action;
  TextBlocks power;
  std::string affine;  ///< lines: the dependence on free parameters
};

CaseBlocks case_blocks(const Analysis& analysis, const CaseAnalysis& one);

/// All of it as text, below a line with the name of the case.
std::string case_text(const Analysis& analysis, const CaseAnalysis& one);

/// Its actions and powers: actuators, the wrench of every coupling, the loads, and the power
/// balance; where equilibrium leaves actions open, every action by itself instead. The case must
/// have an action solution.
TextBlocks statics_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

/// Its power flow: what the teeth roll, which power circulates, the input, the efficiency and the
/// balance; the case must have a power flow.
TextBlocks power_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

/// Its efficiencies with lossy meshes: a line for each model, and a word on what tells them apart
/// where the teeth do not roll. Empty without lossy meshes.
std::string losses_text(const Mechanism& mechanism, const CaseAnalysis& one);

/// "c.Tx [N*m] = 1.393 c_z - 3.831 h_z", a line for every magnitude that depends on a free
/// parameter; empty if none does.
std::string affine_text(const Analysis& analysis, const CaseAnalysis& one);

}  // namespace kinestat
