// A body as the user wrote it.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// About the centre of mass: one number about z in the plane; in space the three moments about axes
/// parallel to those of the world, as drawn, or the nine entries of the tensor row by row, products
/// of inertia being negative (Jxy = -∫xy dm); with an axis the moment about that alone.
struct InertiaDescription {
  std::vector<Value> entries;
  std::optional<AxisDescription> axis;
  SourceRange where;
};

/// A body, or a virtual link that the section `cables` makes.
struct BodyDescription {
  Name name;
  std::optional<PointDescription> reference;  ///< default: the first coupling's point
  std::optional<Value> mass;
  std::optional<PointDescription> centre_of_mass;
  std::vector<InertiaDescription> inertia;  ///< one, or none: few of many bodies have any
  std::vector<PointDescription> outline;    ///< for pictures
  bool is_virtual = false;                  ///< made by `cables`
};

}  // namespace kinestat
