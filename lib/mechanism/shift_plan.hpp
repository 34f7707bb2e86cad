// The section `shift` bound to numbers: what drives, what is driven, and what shifts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/source.hpp"
#include "description/shift_description.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// What engages or opens.
struct ShiftElement {
  int actuator = 0;  ///< index into Topology::actuators
  int one_way = 0;   ///< of a freewheel the sign of the torque that it holds; 0: a clutch or brake
};

/// An actuator that drives. The action is empty where it is not given: equilibrium finds it.
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

/// What a limit bounds: the torque or slip of elements, the speed of bodies seen from the ground,
/// or that of planets seen from their carriers.
enum class LimitKind { torque, slip, speed, planet_speed };

/// As the file has them.
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
  int index = -1;     ///< into ShiftPlan::elements or Topology::bodies; -1: it holds for all
  double most = 0.0;  ///< size [N·m or rad/s]
  SourceRange where;
};

/// A change in which one element slips. Gears are named: which there are, only their states tell.
struct SlipPlan {
  Name name;
  std::optional<Name> from;
  Name to;
  double input_speed = 0.0;                 ///< [rad/s]
  std::optional<double> output_speed = {};  ///< [rad/s]; without `from`
  double input_action = 0.0;                ///< [N·m]
  double output_action = 0.0;               ///< [N·m]
  std::optional<int> element = {};          ///< of ShiftPlan::elements: the one that is named
  double capacity = 0.0;                    ///< [N·m], a size
  SourceRange where_capacity = {};
};

struct ShiftPlan {
  std::vector<ShiftInput> inputs;
  std::vector<int> outputs;  ///< actuators
  std::vector<ShiftElement> elements;
  std::vector<int> others;    ///< actuators without a part in it: they bear nothing
  std::vector<int> reacting;  ///< of `others` those that bear what equilibrium asks of them
  std::vector<ShiftLabel> labels;
  std::vector<ShiftLimit> limits;
  std::vector<SlipPlan> slips = {};
  ShiftCombinations combinations = ShiftCombinations::all;
  std::optional<double> forward;  ///< the sign of the ratios of forward gears, where it is given
  bool asks_actions = false;      ///< an action of an input is given
  SourceRange where;

  /// Whether gears of fewer freedoms than inputs stand in the table too.
  bool is_hybrid() const { return !reacting.empty(); }

  /// Whether the speed of an output is told by shares of those of the inputs that move, given here,
  /// and not as a ratio: there are several, or where a machine reacts the first one does not.
  bool has_shares(const std::vector<int>& moving) const {
    return moving.size() > 1 || (is_hybrid() && moving.front() > 0);
  }
};

/// Of a description that has been bound to this topology without an error; empty if it has no
/// section `shift`.
std::optional<ShiftPlan> bind_shift(const MechanismDescription& description,
                                    const Topology& topology);

/// What acts on the bodies all along in every slip: the loads of the top level and the weights, as
/// a case has them.
Case bind_slip_loads(const MechanismDescription& description, const Mechanism& mechanism);

/// A case for a gear: names and values as the file would give them in a case written by hand.
struct GearCase {
  std::string label;
  SourceRange where;
  std::vector<int> moving;   ///< inputs whose speed is known, indices into ShiftPlan::inputs
  std::vector<int> engaged;  ///< elements without motion of which none follows from the others
  std::vector<int> open;     ///< elements whose action is given as none
  std::vector<int> others;   ///< indices into ShiftPlan::others, likewise: all but what reacts

  friend bool operator==(const GearCase&, const GearCase&) = default;
};

/// The gears as cases of the description: so they depend on its parameters as it does itself.
std::vector<CaseDescription> describe_gears(const MechanismDescription& description,
                                            const Topology& topology,
                                            const ShiftPlan& plan,
                                            const std::vector<GearCase>& gears);

/// The cases of a description, which has been bound to the mechanism, in numbers and with their
/// loads: of a copy that has but cases of describe_gears.
std::vector<Case> bind_described_cases(const MechanismDescription& description,
                                       const Mechanism& mechanism);

}  // namespace kinestat
