// Where the gears of `gears` stand: centres, pitch points and tangents from numbers of teeth.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "math/numbers/dual_vector.hpp"
#include "mechanism/gears/gear_train.hpp"

namespace kinestat {

/// A mesh in numbers [m]. World frame.
template <class Scalar>
struct MeshLayoutOf {
  Vec3Of<Scalar> pitch_point = Vec3Of<Scalar>::Zero();
  Vec3Of<Scalar> tangent = Vec3Of<Scalar>::UnitX();  ///< c x z, c from first to second centre
  Scalar distance = 0.0;                             ///< at which its gears work
  std::optional<Scalar> asked;  ///< (z_1 + z_2)/2 times the module, - for a ring; needs a module
};

/// `Scalar` is double or Dual.
template <class Scalar>
struct GearLayoutOf {
  GearTrain train;
  std::vector<Vec3Of<Scalar>> centres;  ///< of each planet of the train, at z = 0 [m]
  std::vector<MeshLayoutOf<Scalar>> meshes;

  /// Where the axis of a coupling between the two bodies is, at z = 0: that of the planet if one of
  /// the two is one, else the main axis.
  Vec3Of<Scalar> axis_of(std::string_view tail, std::string_view head) const;
};

using GearLayout = GearLayoutOf<double>;

/// The numbers that a layout needs, in SI. Parallel to the lists of the section or of the train.
template <class Scalar>
struct GearNumbersOf {
  std::vector<Scalar> teeth;                    ///< of each member; negative of a ring
  std::vector<std::optional<Scalar>> module;    ///< of each mesh [m]
  std::vector<std::optional<Scalar>> distance;  ///< of each planet, where it is given [m]
  std::vector<Scalar> at;                       ///< of each mesh along the axis [m]
};

using GearNumbers = GearNumbersOf<double>;

/// Whether every ring has more teeth than the gear inside it.
bool rings_fit(const GearTrain& train, const GearNumbers& numbers);

/// Each planet stands at the distance that is given, or at the mean of what its meshes with gears
/// on the main axis ask for; a planet beside another by the triangle of their two distances and
/// that of their mesh. Where the triangle does not close, the two stand in line with the main axis,
/// and stay so when numbers move. Each pitch point divides the distance of the centres in the ratio
/// of teeth. Empty if a planet has no distance: no module and none given.
template <class Scalar>
std::optional<GearLayoutOf<Scalar>> find_layout(GearTrain train,
                                                const GearNumbersOf<Scalar>& numbers);

}  // namespace kinestat
