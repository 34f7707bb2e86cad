// Where the wheels of a scheme stand: radii of the half section, columns along the axis.
#pragma once

#include <vector>

#include "draw/train/scheme_train.hpp"

namespace kinestat {

/// In the unit of the wheels' radii. Wheels in mesh touch: of a wheel on the main axis and a planet
/// r + r_p = y_p, of a ring r = y_p + r_p, of two planets r + r' = |y - y'|.
struct SchemeRadii {
  std::vector<double> wheels;   ///< radius of each
  std::vector<double> planets;  ///< y of each: the distance of its pin from the main axis
};

/// The radii of the train where they fit in one plane, else the nearest that do: planets that mesh
/// beside the plane of the section are turned into it.
SchemeRadii find_radii(const SchemeTrain& train);

/// Columns in which wheels stand, none in one with another in its way.
struct SchemeColumns {
  int count = 0;
  std::vector<int> set_of;  ///< of each column: which connected set of wheels it belongs to
  std::vector<int> first;   ///< of each wheel: its first column
  std::vector<int> last;    ///< of each wheel: its last column
  std::vector<int> mesh;    ///< of each mesh: its column
};

/// Meshes in the order of their places, or of the file; sets one after the other.
SchemeColumns find_columns(const SchemeTrain& train, const SchemeRadii& radii);

}  // namespace kinestat
