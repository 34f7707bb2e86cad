// The tape of a sweep: from the parameters of a state to what its rows hold.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "math/lane_tape.hpp"
#include "mechanism/rebind.hpp"

namespace kinestat {

struct SweepTask;

/// A number that a state gives to the tape.
struct SweepInput {
  enum class From {
    parameter,       ///< `index` is its slot
    motion,          ///< coordinate `part` of the unit screw of a freedom
    action,          ///< likewise of an action
    primary_motion,  ///< `part` of the motions of the case of that index in the file
    primary_action   ///< likewise
  };

  From from = From::parameter;
  std::size_t index = 0;
  std::size_t part = 0;
  Dimension dimension;  ///< of a parameter
};

/// A column of rows that is an output of the tape, in the unit of the file.
struct TapedColumn {
  std::size_t column = 0;  ///< which quantity
  std::size_t cell = 0;
};

/// What one case asks of the tape, by cells of outputs.
struct TapedCase {
  std::vector<TapedColumn> columns;
  std::vector<std::size_t> input_rates;  ///< [SI] of each input of the case, where needed
  std::vector<std::size_t> output_rates;
  std::vector<std::size_t> input_actions;
  std::vector<std::size_t> output_actions;
  bool has_ratios = false;          ///< and a quantity asks for them
  std::vector<TapedColumn> ratios;  ///< where one input drives: right if they are finite
  double ratio_unit = 1.0;          ///< of the output's rate [SI], over:
  double ratio_per = 1.0;           ///< that of the input's
  double torque_ratio_unit = 1.0;   ///< likewise of actions
  double torque_ratio_per = 1.0;
};

/// Shared by the workers.
struct SweepTapes {
  Rebinder rebinder;
  LaneTape tape;
  std::vector<SweepInput> inputs;  ///< of the tape, parallel to its own
  bool needs_geometry = false;     ///< some of them are coordinates
  bool needs_primaries = false;    ///< or magnitudes of primaries
  std::vector<TapedCase> cases;  ///< of each case of the task; empty where a combination is no gear
};

/// Empty where the states of a sweep must be analysed one by one: a quantity needs the power flow,
/// a case has no answer with the parameters of the file, or the parameters move more than couplings
/// and primaries, or freewheels shift. What was recorded is compared with mechanisms bound as a
/// whole in some states before it is trusted.
std::optional<SweepTapes> record_tapes(const SweepTask& task);

}  // namespace kinestat
