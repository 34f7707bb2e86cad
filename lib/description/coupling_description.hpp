// A coupling as the user wrote it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

enum class Space { planar, spatial };

enum class CouplingType { revolute, prismatic, gear, clutch, brake, rigid };

/// The word of the file for a type.
std::string_view word_of(CouplingType type);

/// The type of a word, or empty.
std::optional<CouplingType> find_coupling_type(std::string_view word);

/// All words, in the order of the enumeration.
std::vector<std::string> coupling_type_words();

/// A point [length]: two coordinates in the plane, three in space.
struct PointDescription {
  std::vector<Value> coordinates;
  SourceRange where;
};

/// A direction: `x`, `-z`, … or a vector of plain numbers.
struct AxisDescription {
  char keyword = 0;   ///< 'x', 'y', 'z', or 0: then `components` hold the vector
  double sign = 1.0;  ///< of the keyword
  std::vector<Value> components;
  SourceRange where;
};

/// Edge tail -> head. Which geometry a type needs is checked when it is bound.
struct CouplingDescription {
  Name name;
  CouplingType type = CouplingType::revolute;
  Name tail;
  Name head;
  std::optional<PointDescription> at;
  std::optional<AxisDescription> axis;
  std::optional<AxisDescription> tangent;         ///< of a gear
  std::optional<AxisDescription> line_of_action;  ///< of a gear, instead of tangent and angle
  std::optional<Value> pressure_angle;            ///< of a gear
  bool internal = false;                          ///< of a gear: one of the two is a ring
  std::optional<std::vector<Name>> passive;       ///< the constraints that it keeps
};

}  // namespace kinestat
