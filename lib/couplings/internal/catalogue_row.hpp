// Builds the screws of one coupling, with their names.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "couplings/coupling_geometry.hpp"
#include "description/coupling_description.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

/// "wx" along a world axis, "w" along a vector or against a world axis: a positive wx of an axis -x
/// would turn the other way about x.
template <class Scalar>
std::string name_along(char kind, const AxisOf<Scalar>& axis) {
  const bool is_along_world =
      axis.keyword != 0 && value_of(axis.direction[axis.keyword - 'x']) > 0.0;
  return is_along_world ? std::string{kind, axis.keyword} : std::string(1, kind);
}

/// t1 = normalised(k - (k·a)a) with k the first of x, y, z of least |k·a|, and t2 = a x t1.
template <class Scalar>
std::pair<Vec3Of<Scalar>, Vec3Of<Scalar>> transverse_to(const Vec3Of<Scalar>& a);

/// The direction perpendicular to two, along the third world axis where both are along one.
template <class Scalar>
AxisOf<Scalar> third_of(const AxisOf<Scalar>& a, const AxisOf<Scalar>& b) {
  if (a.keyword == 0 || b.keyword == 0) {
    return {.direction = unit_along<Scalar>(a.direction.cross(b.direction)), .keyword = 0};
  }
  const int third = 3 - (a.keyword - 'x') - (b.keyword - 'x');
  return {.direction = Vec3Of<Scalar>::Unit(third), .keyword = static_cast<char>('x' + third)};
}

/// A row of the catalogue while it is written down.
template <class Scalar>
class CatalogueRow {
 public:
  using Vector = Vec3Of<Scalar>;

  /// Directions count as many as the space has.
  explicit CatalogueRow(Space space) : is_planar_(space == Space::planar) {}

  bool is_planar() const { return is_planar_; }

  void turn(std::string name, const Vector& direction, const Vector& at) {
    screws_.freedoms.push_back({.name = std::move(name),
                                .is_rotation = true,
                                .screw = unit_rotation<Scalar>(direction, at)});
  }

  void slide(std::string name, const Vector& direction) {
    screws_.freedoms.push_back({.name = std::move(name),
                                .is_rotation = false,
                                .screw = unit_translation<Scalar>(direction)});
  }

  void bear_force(std::string name, const Vector& direction, const Vector& at) {
    screws_.constraints.push_back(
        {.name = std::move(name), .is_couple = false, .screw = unit_force<Scalar>(direction, at)});
  }

  void bear_couple(std::string name, const Vector& direction) {
    screws_.constraints.push_back(
        {.name = std::move(name), .is_couple = true, .screw = unit_couple<Scalar>(direction)});
  }

  void turn_along(const AxisOf<Scalar>& axis, const Vector& at) {
    turn(name_along('w', axis), axis.direction, at);
  }

  void slide_along(const AxisOf<Scalar>& axis) { slide(name_along('v', axis), axis.direction); }

  void bear_force_along(const AxisOf<Scalar>& axis, const Vector& at) {
    bear_force(name_along('R', axis), axis.direction, at);
  }

  /// About all directions that the space has.
  void turn_freely(const Vector& at);

  void bear_all_forces(const Vector& at);
  void bear_all_couples();
  void slide_across(const AxisOf<Scalar>& axis);
  void bear_forces_across(const AxisOf<Scalar>& axis, const Vector& at);

  /// Only in space.
  void bear_couples_across(const AxisOf<Scalar>& axis);

  void add(NamedTwistOf<Scalar> freedom) { screws_.freedoms.push_back(std::move(freedom)); }

  void add(NamedWrenchOf<Scalar> constraint) {
    screws_.constraints.push_back(std::move(constraint));
  }

  const CouplingScrewsOf<Scalar>& screws() const { return screws_; }

  /// The row, those of the same name numbered.
  CouplingScrewsOf<Scalar> take();

 private:
  // The directions perpendicular to an axis with the ends of their names; in the plane only the one
  // in it.
  std::vector<std::pair<std::string, Vector>> across(const AxisOf<Scalar>& axis) const;

  bool is_planar_;
  CouplingScrewsOf<Scalar> screws_;
};

}  // namespace kinestat
