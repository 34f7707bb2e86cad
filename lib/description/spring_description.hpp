// Springs, dampers and gas springs.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// Which way a spring acts, in the order of the words in files.
enum class SpringSense { both, push, pull };

/// Of a gas spring: its force where it is extended, its length there, how far it can be pushed in,
/// by which the force grows over the whole stroke, and the exponent of the gas.
struct GasSpringDescription {
  Value force;
  Value length;
  Value stroke;
  Value ratio;
  std::optional<Value> exponent;
};

/// Between a point of one body and one of another, or about or along a freedom of a coupling.
struct SpringDescription {
  Name name;
  std::vector<Name> bodies;                           ///< two: tail and head; empty of a freedom
  std::vector<std::pair<Name, PointDescription>> at;  ///< of each of them, as drawn
  std::optional<Name> coupling;
  std::optional<Name> freedom;  ///< needed where the coupling has several
  std::optional<Value> stiffness;
  std::optional<Value> damping;
  std::optional<Value> free;         ///< where a freedom has no force, from the drawn position
  std::optional<Value> free_length;  ///< of the distance of the points
  std::optional<Value> drawn;        ///< instead: the force as drawn; pushing is positive
  std::optional<Value> force;        ///< beside these, pushing is positive; may follow curves
  SpringSense acts = SpringSense::both;
  std::optional<GasSpringDescription> gas;
  SourceRange where;
};

}  // namespace kinestat
