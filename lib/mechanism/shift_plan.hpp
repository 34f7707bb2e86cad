// The section `shift` bound to numbers: inputs, outputs and shift elements.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/source.hpp"
#include "description/shift_description.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A clutch, brake or freewheel, which is engaged or open.
struct ShiftElement {
  int actuator = 0;  ///< index into Topology::actuators
  int one_way = 0;   ///< sign of the torque that a freewheel holds; 0: a clutch or brake
};

/// An actuator that drives. An action that is not given is empty, and follows from equilibrium.
struct ShiftInput {
  int actuator = 0;
  double speed = 1.0;            ///< [rad/s or m/s]; 1 where the file gives none
  std::optional<double> action;  ///< [N·m or N]
};

/// A combination of elements that has a label.
struct ShiftLabel {
  std::string text;
  std::vector<int> engaged;  ///< indices into ShiftPlan::elements, ascending
  SourceRange where;
};

/// The quantity that a limit bounds: torque or slip of elements, speed of bodies relative to the
/// ground, or speed of planets relative to their carriers.
enum class LimitKind { torque, slip, speed, planet_speed };

/// The word of the file.
constexpr std::string_view word_of(LimitKind kind) {
  switch (kind) {
    case LimitKind::torque:
      return "torque";
    case LimitKind::slip:
      return "slip";
    case LimitKind::speed:
      return "speed";
    case LimitKind::planet_speed:
      return "planet_speed";
  }
  return "";
}

constexpr QuantityKind quantity_of(LimitKind kind) {
  return kind == LimitKind::torque ? QuantityKind::moment : QuantityKind::angular_velocity;
}

struct ShiftLimit {
  LimitKind kind = LimitKind::torque;
  int index = -1;     ///< into ShiftPlan::elements or Topology::bodies; -1: the limit holds for all
  double most = 0.0;  ///< largest absolute value [N·m or rad/s]
  SourceRange where;
};

/// A gear change in which one element slips. Gears are given by name, because which gears exist is
/// only known once their states are found.
struct SlipPlan {
  Name name;
  std::optional<Name> from;
  Name to;
  double input_speed = 0.0;                 ///< [rad/s]
  std::optional<double> output_speed = {};  ///< [rad/s], if there is no `from`
  double input_action = 0.0;                ///< [N·m]
  double output_action = 0.0;               ///< [N·m]
  std::optional<int> element = {};          ///< the slipping one, index into ShiftPlan::elements
  double capacity = 0.0;                    ///< torque capacity [N·m], not negative
  SourceRange where_capacity = {};
};

/// The name of the combination that engages no element; others are joined from theirs: "C1+B2".
inline constexpr std::string_view kNothingEngaged = "none";

struct ShiftPlan {
  std::vector<ShiftInput> inputs;
  std::vector<int> outputs;  ///< actuators
  std::vector<ShiftElement> elements;
  std::vector<int> others;    ///< actuators that take no part in shifting: they bear nothing
  std::vector<int> reacting;  ///< of `others` those that bear what equilibrium requires
  std::vector<ShiftLabel> labels;
  std::vector<ShiftLimit> limits;
  std::vector<SlipPlan> slips = {};
  ShiftCombinations combinations = ShiftCombinations::all;
  std::optional<double> forward;  ///< sign of the ratios of forward gears, if it is given
  bool asks_actions = false;      ///< whether the action of an input is given
  SourceRange where;

  /// Whether the table also contains gears with fewer freedoms than inputs.
  bool is_hybrid() const { return !reacting.empty(); }

  /// Whether the speed of an output is given as shares of the speeds of the moving inputs instead
  /// of a ratio. So it is if several inputs move or, in a hybrid, if the first input does not move.
  bool has_shares(const std::vector<int>& moving) const {
    return moving.size() > 1 || (is_hybrid() && moving.front() > 0);
  }
};

/// Binds the section `shift` of a description that was bound to this topology without an error.
/// Empty if there is no such section.
std::optional<ShiftPlan> bind_shift(const MechanismDescription& description,
                                    const Topology& topology);

/// The loads during every slip, as a case: the loads of the top level and the weights.
Case bind_slip_loads(const MechanismDescription& description, const Mechanism& mechanism);

/// A gear to be described as a case, as it would be written by hand in the file.
struct GearCase {
  std::string label;
  SourceRange where;
  std::vector<int> moving;   ///< inputs whose speed is known, indices into ShiftPlan::inputs
  std::vector<int> engaged;  ///< elements whose rate is given as zero; all independent
  std::vector<int> open;     ///< elements whose action is given as zero
  std::vector<int> others;   ///< indices into ShiftPlan::others whose action is given as zero

  friend bool operator==(const GearCase&, const GearCase&) = default;
};

/// Describes gears as cases of the description, so that they depend on its parameters too.
std::vector<CaseDescription> describe_gears(const MechanismDescription& description,
                                            const Topology& topology,
                                            const ShiftPlan& plan,
                                            const std::vector<GearCase>& gears);

/// Binds the cases of a description, with their loads. The description must be a copy of the one
/// that was bound to the mechanism, with the cases of describe_gears in place of its own.
std::vector<Case> bind_described_cases(const MechanismDescription& description,
                                       const Mechanism& mechanism);

}  // namespace kinestat
