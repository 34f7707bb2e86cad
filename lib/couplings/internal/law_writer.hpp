// Writes down the law of a coupling that holds in every position.
#pragma once

#include <utility>

#include "couplings/drawn_coupling.hpp"
#include "couplings/finite_law.hpp"
#include "description/coupling_description.hpp"

namespace kinestat {

/// The parts of which the laws of kinds are put together.
class LawWriter {
 public:
  LawWriter(Space space, const DrawnCoupling& drawn);

  bool is_planar() const { return is_planar_; }

  const DrawnCoupling& drawn() const { return drawn_; }

  const CouplingGeometry& geometry() const { return drawn_.geometry; }

  const Vec3& at() const { return at_; }

  const Vec3& axis() const { return axis_; }

  const Vec3& first() const { return first_; }  ///< across the axis

  const Vec3& second() const { return second_; }

  /// The law is about another axis than that of the geometry.
  void take_axis(const Vec3& axis);

  /// And in another place.
  void take_place(const Vec3& at);

  void set_kind(LawKind kind) { law_.kind = kind; }

  void add(ElementaryKind kind, const Vec3& direction, int freedom, double pitch = 0.0);
  ClosureCondition& require(ClosureKind kind);

  void meet() { require(ClosureKind::meet); }

  void keep_along(const Vec3& normal) { require(ClosureKind::along).tail = normal; }

  /// The same with the plane fixed in the head.
  void keep_along_in_head(const Vec3& normal);

  void keep_angle(const Vec3& tail, const Vec3& head);

  /// The axis keeps its direction.
  void keep_axis();

  void keep_orientation();

  FreedomMeasure& measure(int freedom, const Vec3& axis);
  void measure_turn(int freedom, const Vec3& axis);

  void measure_slide(int freedom, const Vec3& axis) { measure(freedom, axis).is_turn = false; }

  /// A turn about the axis, a slide along it, both with that pitch.
  void hinge();
  void prism();
  void thread(double pitch);

  /// Round bodies keep the distance of their centres, a round and a flat one that of the centre
  /// from the plane. The normal points from the tail to the head or the other way.
  void touching();

  FiniteLaw take() { return std::move(law_); }

 private:
  bool is_planar_;
  const DrawnCoupling& drawn_;
  Vec3 at_;
  Vec3 at_head_;
  Vec3 axis_;
  Vec3 first_ = Vec3::UnitX();
  Vec3 second_ = Vec3::UnitY();
  FiniteLaw law_;
};

}  // namespace kinestat
