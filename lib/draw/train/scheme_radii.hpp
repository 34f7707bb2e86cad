// Where the wheels of a scheme stand: radii of the half section, columns along the axis.
#pragma once

#include <span>
#include <vector>

#include "draw/train/scheme_train.hpp"

namespace kinestat {

/// In the unit of the wheels' radii. Wheels in mesh touch: of a wheel on the main axis and a planet
/// r + r_p = y_p, of a ring r = y_p + r_p, of two planets r + r' = |y - y'|.
struct SchemeRadii {
  std::vector<double> wheels;        ///< radius of each
  std::vector<double> planets;       ///< y of each: the distance of its pin from its axis
  std::vector<double> axes = {0.0};  ///< height of each above the main axis
};

/// The radii of the train where they fit in one plane, else the nearest that do: planets that mesh
/// beside the plane of the section are turned into it.
SchemeRadii find_radii(const SchemeTrain& train);

/// Likewise of a developed section, whose axes stand one above the other in this order, the lowest
/// first: wheels of neighbours touch. Neighbours without a mesh stand clear of each other.
SchemeRadii find_radii(const SchemeTrain& train, std::span<const int> order);

/// Whether a wheel is drawn on both sides of its axis, not in half as the sets of planets.
bool is_whole(const SchemeTrain& train, int wheel);

/// What a wheel fills of the section, as heights above the main axis.
struct WheelSpan {
  double low = 0.0;
  double high = 0.0;
};

/// From its axis outwards on the side that is drawn; a ring just beyond its radius.
WheelSpan span_of(const SchemeTrain& train, const SchemeRadii& radii, int wheel);

/// Columns in which wheels stand, none in one with another in its way.
struct SchemeColumns {
  int count = 0;
  std::vector<int> set_of;  ///< of each column: which connected set of wheels it belongs to
  std::vector<int> first;   ///< of each wheel: its first column
  std::vector<int> last;    ///< of each wheel: its last column
  std::vector<int> mesh;    ///< of each mesh: its column
  std::vector<int> links;   ///< of each column: how many broken lines run beside it
};

/// Meshes in the order of their places, or of the file; sets one after the other. Wheels that stand
/// apart share a column if there is room.
SchemeColumns find_columns(const SchemeTrain& train, const SchemeRadii& radii);

}  // namespace kinestat
