// What stands where in a developed section: axes one above the other, columns beside each other.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "draw/train/scheme_radii.hpp"

namespace kinestat {

/// Axes from the lowest upwards: those with meshes next to each other as far as that can be, the
/// main axis in the middle, the first other axis above it, and that of the output outermost.
std::vector<int> find_axis_order(const SchemeTrain& train);

/// From where to where a shaft reaches, in columns; beyond them to a port.
struct SchemeExtent {
  int axis = 0;
  double low = 0.0;
  double high = 0.0;
  int level = 0;            ///< how many shafts run within it
  bool is_on_axis = false;  ///< it has a wheel or bears one, not only pins of planets
};

/// Pairs of bodies on one axis of which the first bears the second: what bears more is within.
std::vector<std::pair<int, int>> find_bearing_pairs(const SchemeTrain& train);

/// Of each body with a wheel, a planet's pin or a port. What bears another body reaches under it.
std::map<int, SchemeExtent> find_extents(const SchemeTrain& train, const SchemeColumns& columns);

/// Puts sets of columns in an order in which hollow shafts end beside what they join and no wheel
/// stands in the way of another shaft; as they are where the file places its meshes.
SchemeColumns order_columns(const SchemeTrain& train,
                            const SchemeRadii& radii,
                            const SchemeColumns& columns);

}  // namespace kinestat
