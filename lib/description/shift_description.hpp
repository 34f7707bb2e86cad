// The section `shift`: which elements make which gear.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// A magnitude for all that the key is about, or for what `target` names alone.
struct InputValue {
  std::optional<Name> target;
  Value value;
};

/// A label for one combination of engaged elements.
struct GearLabel {
  Name label;
  std::vector<Name> elements;
};

/// Which combinations of elements are tried: all of the size that a gear needs and whatever has a
/// label, or the latter alone.
enum class ShiftCombinations { all, named };

/// The sign of the ratios of forward gears.
enum class ForwardRatios { positive, negative };

/// The largest sizes that gears may have.
struct ShiftLimitsDescription {
  std::vector<InputValue> torque;        ///< of elements
  std::vector<InputValue> slip;          ///< of open elements
  std::vector<InputValue> speed;         ///< of bodies, seen from the ground
  std::vector<InputValue> planet_speed;  ///< of planets, seen from their carriers
};

/// A change between two gears, or into one, in which one element slips at a steady torque.
struct SlipDescription {
  Name name;
  std::optional<Name> from;  ///< the gear before; without it `output_speed`
  Name to;
  std::optional<Value> input_speed;
  std::optional<Value> output_speed;
  std::optional<Value> input_action;
  std::optional<Value> output_action;
  std::vector<InputValue> capacity;  ///< of the element that slips
};

struct ShiftDescription {
  std::vector<Name> inputs;    ///< actuators
  std::vector<Name> outputs;   ///< actuators
  std::vector<Name> elements;  ///< clutches and brakes
  std::vector<Name> reacts;    ///< actuators whose torque follows from that of the others
  std::vector<InputValue> input_motion;
  std::vector<InputValue> input_action;
  std::vector<InputValue> input_acceleration = {};  ///< then the gears have inertia
  std::vector<GearLabel> names;
  std::vector<SlipDescription> slips = {};
  ShiftCombinations combinations = ShiftCombinations::all;
  std::optional<ShiftLimitsDescription> limits;
  std::optional<ForwardRatios> forward;  ///< default: the sign that most gears have
  SourceRange where;

  /// Whether anything that it asks for follows from the inertia of the bodies.
  bool has_inertia() const { return !input_acceleration.empty() || !slips.empty(); }
};

}  // namespace kinestat
