// The layout of the gears of `gears`: centres, pitch points and tangents from numbers of teeth.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "math/numbers/dual_vector.hpp"
#include "mechanism/gears/gear_train.hpp"

namespace kinestat {

/// The place of a mesh in the world frame [m].
template <class Scalar>
struct MeshLayoutOf {
  Vec3Of<Scalar> pitch_point = Vec3Of<Scalar>::Zero();
  Vec3Of<Scalar> tangent = Vec3Of<Scalar>::UnitX();  ///< c × z, c from first to second centre
  Scalar distance = 0.0;                             ///< working distance of the centres
  std::optional<Scalar> asked;  ///< (z_1 + z_2)/2 times the module, z being negative for a ring
};

/// The layout of a train. `Scalar` is double or Dual.
template <class Scalar>
struct GearLayoutOf {
  GearTrain train;
  std::vector<Vec3Of<Scalar>> centres;  ///< of each planet of the train, at z = 0 [m]
  std::vector<MeshLayoutOf<Scalar>> meshes;

  /// The point at z = 0 of the axis of a coupling between the two bodies: the axis of the planet if
  /// one of them is a planet, else the main axis.
  Vec3Of<Scalar> axis_of(std::string_view tail, std::string_view head) const;
};

using GearLayout = GearLayoutOf<double>;

/// The numbers from which a layout follows, in SI. Lists are parallel to those of the section or of
/// the train.
template <class Scalar>
struct GearNumbersOf {
  std::vector<Scalar> teeth;                    ///< of each member; negative for a ring
  std::vector<std::optional<Scalar>> module;    ///< of each mesh [m]
  std::vector<std::optional<Scalar>> distance;  ///< of each planet, if it is given [m]
  std::vector<Scalar> at;                       ///< of each mesh: place along the axis [m]
};

using GearNumbers = GearNumbersOf<double>;

/// Whether every ring has more teeth than the gear inside it.
bool rings_fit(const GearTrain& train, const GearNumbers& numbers);

/// Finds the layout of a train. A planet is at its given distance or, without one, at the mean of
/// the distances that its meshes with gears on the main axis require. A planet beside another one
/// is placed by the triangle of their two distances and that of their mesh. If the triangle does
/// not close, the two are in line with the main axis, and remain so when numbers change. A pitch
/// point divides the distance of the centres in the ratio of the teeth. Empty if a planet has no
/// distance, because there is neither a given one nor a module.
template <class Scalar>
std::optional<GearLayoutOf<Scalar>> find_layout(GearTrain train,
                                                const GearNumbersOf<Scalar>& numbers);

}  // namespace kinestat
