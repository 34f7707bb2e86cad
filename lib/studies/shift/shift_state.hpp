// What becomes of a transmission with some of its elements engaged.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mechanism/shift_plan.hpp"
#include "studies/shift/shift_network.hpp"

namespace kinestat {

enum class ShiftClass { gear, neutral, locked_by_elements, tie_up };

/// The word in reports.
constexpr std::string_view word_of(ShiftClass kind) {
  switch (kind) {
    case ShiftClass::gear:
      return "gear";
    case ShiftClass::neutral:
      return "neutral";
    case ShiftClass::locked_by_elements:
      return "locked";
    case ShiftClass::tie_up:
      return "tie-up";
  }
  return "";
}

/// Why a state is no gear.
enum class ShiftCause {
  none,
  input_held,          ///< the input `which` cannot move
  inputs_coupled,      ///< the input `which` cannot have its speed beside those before it
  output_free,         ///< the output `which` moves while the inputs rest
  outputs_held,        ///< no output moves
  redundant,           ///< an element more than needed, and it follows from the others
  freewheel_overruns,  ///< the element `which` would have to hold what it does not hold
  freewheel_locks      ///< the element `which` would have to slip in the sense in which it holds
};

/// What a machine does that reacts. The shares are those of inputs: its speed is the sum of theirs
/// times `speed_shares`, its torque that of their torques times `torque_shares`.
struct ShiftReaction {
  int other = 0;  ///< index into ShiftPlan::others
  std::optional<double> rate = {};
  std::optional<double> torque = {};  ///< tail on head; 0 where other elements hold what it held
  std::vector<double> speed_shares = {};   ///< empty where its speed is not determined
  std::vector<double> torque_shares = {};  ///< empty where it bears nothing
};

/// Numbers in SI, in the order of the plan. A rate is empty where it is not determined; of a state
/// that is no gear there are none, but where a freewheel decides that, those it would have. Torques
/// are those of frictionless equilibrium without loads: the powers of inputs, outputs and engaged
/// elements vanish in sum for every motion that the open train has (virtual power). They are empty
/// where that does not determine them.
struct ShiftState {
  ShiftClass kind = ShiftClass::gear;
  ShiftCause cause = ShiftCause::none;
  int which = -1;                ///< index into the plan's inputs, outputs or elements; -1: none
  int freedom = 0;               ///< what is left of the net degree of freedom with these elements
  int idle = 0;                  ///< of it, what is left while the inputs rest
  std::vector<int> surplus;      ///< engaged elements whose rest follows from those before them
  std::vector<int> overrunning;  ///< engaged freewheels that slip all the same, ascending
  std::vector<int> open_freewheels;  ///< engaged elements of a gear that hold one sign of torque,
                                     ///< and equilibrium does not tell which they have
  std::vector<int> unloaded;         ///< open elements that bear nothing by equilibrium alone
  std::vector<int> unloaded_others;  ///< others likewise
  std::vector<int> moving;           ///< inputs whose speed does not follow from those before them
  std::vector<double> inputs;        ///< rate of each input
  std::vector<std::optional<double>> outputs;  ///< rate of each output
  /// Of each output the rate that it has for each input, per unit of that one, while the others
  /// that can have a speed of their own rest; zero for an input that follows from them. Empty
  /// unless there are several of the former.
  std::vector<std::vector<double>> shares;
  std::vector<std::optional<double>> slips;  ///< rate of each element, head minus tail
  std::vector<double> input_torques;         ///< of each input, tail on head
  std::vector<double> output_torques;        ///< of each output
  std::vector<double> torques;               ///< of each element; 0 of an open one
  std::vector<ShiftReaction> reactions;      ///< of each of ShiftPlan::reacting
  /// Of each output of a plan with reactions its torque by those of the inputs; else empty.
  std::vector<std::vector<double>> torque_shares;
};

/// The state in which exactly `engaged` (indices of elements, ascending) are engaged. The classes
/// are decided in this order: an input cannot move (locked); an output is not determined by the
/// inputs (neutral); no output moves (locked); more elements are engaged than the mobility asks
/// for, and one of them follows from the others (tie-up); a freewheel is on the wrong side (neutral
/// where it overruns, tie-up where it locks); gear. Engaged freewheels that would hold an input or
/// a torque in the sense in which they overrun let the others decide: what they make with these
/// open, a gear for example, is the state. Where a machine reacts, inputs may follow from
/// those before them and rest, as long as one moves. Costs a few small dense products: names are
/// nowhere, so that sweeps may ask for millions of states.
[[nodiscard]] ShiftState solve_shift_state(const ShiftNetwork& network,
                                           const ShiftPlan& plan,
                                           std::span<const int> engaged);

}  // namespace kinestat
