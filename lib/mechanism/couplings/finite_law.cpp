#include "mechanism/couplings/finite_law.hpp"

#include <cmath>
#include <utility>

#include "mechanism/couplings/internal/catalogue_row.hpp"

namespace kinestat {

namespace {

// Writes down one law.
class LawWriter {
 public:
  LawWriter(Space space, const DrawnCoupling& drawn)
      : is_planar_(space == Space::planar),
        geometry_(drawn.geometry),
        at_(drawn.geometry.at),
        at_head_(drawn.at_head.value_or(drawn.geometry.at)),
        axis_(drawn.geometry.axis.direction),
        drawn_(drawn) {
    const auto [first, second] = transverse_to<double>(axis_);
    first_ = is_planar_ ? Vec3(Vec3::UnitZ().cross(axis_)) : first;
    second_ = second;
  }

  FiniteLaw write(CouplingType type) {
    using enum CouplingType;
    switch (type) {
      case revolute:
      case clutch:
      case brake:
        hinge();
        break;
      case spherical:
        is_planar_ ? hinge() : ball();
        break;
      case prismatic:
        prism();
        break;
      case helical:
        thread(geometry_.pitch);
        break;
      case cylindrical:
        cylinder();
        break;
      case universal:
        cross();
        break;
      case planar:
        plane();
        break;
      case pin_in_slot:
        pin();
        break;
      case sphere_in_tube:
        tube();
        break;
      case rigid:
        weld();
        break;
      case screws:
        listed();
        break;
      case gear:
      case bevel_gear:
      case worm:
      case rack:
        law_.kind = LawKind::rolling;
        break;
      case point_contact:
      case cam:
        touching();
        break;
      case line_contact:
        touching_along_line();
        break;
      case cable:
        cable_path();
        break;
    }
    return std::move(law_);
  }

 private:
  void add(ElementaryKind kind, const Vec3& direction, int freedom, double pitch = 0.0) {
    law_.chain.push_back(
        {.kind = kind, .direction = direction, .point = at_, .pitch = pitch, .freedom = freedom});
  }

  ClosureCondition& require(ClosureKind kind) {
    law_.conditions.push_back({.kind = kind, .tail_point = at_, .head_point = at_head_});
    return law_.conditions.back();
  }

  void meet() { require(ClosureKind::meet); }

  void keep_along(const Vec3& normal) { require(ClosureKind::along).tail = normal; }

  // The same with the plane fixed in the head.
  void keep_along_in_head(const Vec3& normal) {
    ClosureCondition& condition = require(ClosureKind::along);
    condition.is_reversed = true;
    condition.tail = normal;
    std::swap(condition.tail_point, condition.head_point);
  }

  void keep_angle(const Vec3& tail, const Vec3& head) {
    ClosureCondition& condition = require(ClosureKind::across);
    condition.tail = tail;
    condition.head = head;
    condition.value = tail.dot(head);
  }

  // The axis keeps its direction.
  void keep_axis() {
    if (!is_planar_) {
      keep_angle(first_, axis_);
      keep_angle(second_, axis_);
    }
  }

  void keep_orientation() {
    if (is_planar_) {
      keep_angle(Vec3::UnitX(), Vec3::UnitY());
    } else {
      keep_axis();
      keep_angle(first_, second_);
    }
  }

  FreedomMeasure& measure(int freedom, const Vec3& axis) {
    law_.measures.push_back(
        {.freedom = freedom, .axis = axis, .tail_point = at_, .head_point = at_head_});
    return law_.measures.back();
  }

  void measure_turn(int freedom, const Vec3& axis) {
    FreedomMeasure& one = measure(freedom, axis);
    one.from = transverse_to<double>(axis).first;
    one.to = one.from;
  }

  void measure_slide(int freedom, const Vec3& axis) { measure(freedom, axis).is_turn = false; }

  void hinge() {
    add(ElementaryKind::turn, axis_, 0);
    meet();
    keep_axis();
    measure_turn(0, axis_);
  }

  void prism() {
    add(ElementaryKind::slide, axis_, 0);
    keep_along(first_);
    if (!is_planar_) {
      keep_along(second_);
    }
    keep_orientation();
    measure_slide(0, axis_);
  }

  void thread(double pitch) {
    add(ElementaryKind::turn, axis_, 0, pitch);
    keep_along(first_);
    keep_along(second_);
    keep_axis();
    ClosureCondition& condition = require(ClosureKind::screw);
    condition.tail = axis_;
    condition.head = first_;
    condition.value = pitch;
    measure_turn(0, axis_);
  }

  void cylinder() {
    add(ElementaryKind::turn, axis_, 0);
    add(ElementaryKind::slide, axis_, 1);
    keep_along(first_);
    keep_along(second_);
    keep_axis();
    measure_turn(0, axis_);
    measure_slide(1, axis_);
  }

  void cross() {
    const Vec3 second = geometry_.second.direction;
    add(ElementaryKind::turn, axis_, 0);
    add(ElementaryKind::turn, second, 1);
    meet();
    keep_angle(axis_, second);
    FreedomMeasure& about_first = measure(0, axis_);
    about_first.from = second;
    about_first.to = second;
    FreedomMeasure& about_second = measure(1, second);
    about_second.is_in_head = true;
    about_second.sense = -1.0;
    about_second.from = axis_;
    about_second.to = axis_;
  }

  void ball() {
    add(ElementaryKind::ball, axis_, 0);
    meet();
  }

  // The freedoms of the catalogue: the turn about the normal, then the slides across it.
  void plane() {
    const auto keyword = geometry_.axis.keyword;
    const Vec3 u = keyword == 0 ? first_ : Vec3(Vec3::Unit(keyword == 'x' ? 1 : 0));
    const Vec3 v = keyword == 0 ? second_ : Vec3(Vec3::Unit(keyword == 'z' ? 1 : 2));
    add(ElementaryKind::slide, u, 1);
    add(ElementaryKind::slide, v, 2);
    add(ElementaryKind::turn, axis_, 0);
    keep_along(axis_);
    keep_axis();
    measure_turn(0, axis_);
    measure_slide(1, u);
    measure_slide(2, v);
  }

  void pin() {
    const Vec3 slot = axis_;
    add(ElementaryKind::turn, Vec3::UnitZ(), 0);
    add(ElementaryKind::slide, slot, 1);
    keep_along_in_head(Vec3::UnitZ().cross(slot));
    if (!is_planar_) {
      keep_along_in_head(Vec3::UnitZ());
      keep_angle(Vec3::UnitX(), Vec3::UnitZ());
      keep_angle(Vec3::UnitY(), Vec3::UnitZ());
    }
    measure_turn(0, Vec3::UnitZ());
    FreedomMeasure& slide = measure(1, slot);
    slide.is_turn = false;
    slide.is_in_head = true;
  }

  void tube() {
    add(ElementaryKind::ball, axis_, 0);
    add(ElementaryKind::slide, axis_, 3);
    keep_along_in_head(first_);
    keep_along_in_head(second_);
    FreedomMeasure& slide = measure(3, axis_);
    slide.is_turn = false;
    slide.is_in_head = true;
  }

  void weld() {
    meet();
    keep_orientation();
  }

  // One freedom is a turn, a slide or a thread; of several the order is not known.
  void listed() {
    if (geometry_.freedoms.size() != 1) {
      law_.kind = LawKind::unknown;
      return;
    }
    const ScrewGeometry& screw = geometry_.freedoms.front();
    axis_ = screw.direction.direction;
    const auto [first, second] = transverse_to<double>(axis_);
    first_ = is_planar_ ? Vec3(Vec3::UnitZ().cross(axis_)) : first;
    second_ = second;
    if (screw.kind == ScrewWord::translation) {
      prism();
    } else {
      at_ = screw.at;
      at_head_ = screw.at;
      screw.pitch == 0.0 ? hinge() : thread(screw.pitch);
    }
  }

  // Round bodies keep the distance of their centres, a round and a flat one that of the centre from
  // the plane. The normal points from the tail to the head or the other way.
  void touching() {
    if (!drawn_.tail_shape || !drawn_.head_shape) {
      law_.kind = LawKind::unknown;
      return;
    }
    law_.kind = LawKind::contact;
    const double tail = drawn_.tail_shape->curvature;
    const double head = drawn_.head_shape->curvature;
    if (tail == 0.0 && head == 0.0) {
      law_.kind = LawKind::unknown;
    } else if (tail != 0.0 && head != 0.0) {
      ClosureCondition& condition = require(ClosureKind::reach);
      condition.tail_point = at_ - axis_ / tail;
      condition.head_point = at_ + axis_ / head;
      condition.value = (condition.head_point - condition.tail_point).norm();
    } else {
      ClosureCondition& condition = require(ClosureKind::along);
      condition.is_reversed = tail != 0.0;
      condition.tail_point = at_;
      condition.tail = axis_;
      condition.head_point = tail == 0.0 ? Vec3(at_ + axis_ / head) : Vec3(at_ - axis_ / tail);
      condition.value = axis_.dot(condition.head_point - condition.tail_point);
    }
  }

  // A cylinder on a plane.
  void touching_along_line() {
    const bool is_flat =
        drawn_.tail_shape && drawn_.head_shape &&
        (drawn_.tail_shape->curvature == 0.0) != (drawn_.head_shape->curvature == 0.0);
    if (!is_flat) {
      law_.kind = LawKind::unknown;
      return;
    }
    touching();
    const Vec3 line = geometry_.second.direction;
    const bool is_tail_flat = drawn_.tail_shape->curvature == 0.0;
    keep_angle(is_tail_flat ? axis_ : line, is_tail_flat ? line : axis_);
  }

  // Without pulleys it is a rod between two points.
  void cable_path() {
    law_.kind = LawKind::contact;
    const CableStationGeometry tail = drawn_.from.value_or(
        CableStationGeometry{.centre = geometry_.from, .meets = {}, .leaves = {}});
    const CableStationGeometry head =
        drawn_.to.value_or(CableStationGeometry{.centre = geometry_.to, .meets = {}, .leaves = {}});
    const bool has_points = tail.leaves || head.meets;
    const bool is_wrapped = tail.radius != 0.0 || head.radius != 0.0;
    if (has_points || (is_wrapped && !is_planar_)) {
      law_.kind = LawKind::unknown;
      return;
    }
    ClosureCondition& condition = require(is_wrapped ? ClosureKind::cable : ClosureKind::reach);
    condition.tail_point = tail.centre;
    condition.head_point = head.centre;
    condition.tail_radius = tail.radius;
    condition.head_radius = head.radius;
    condition.value = (geometry_.to - geometry_.from).norm();
  }

  bool is_planar_;
  const CouplingGeometry& geometry_;
  Vec3 at_;
  Vec3 at_head_;
  Vec3 axis_;
  const DrawnCoupling& drawn_;
  Vec3 first_ = Vec3::UnitX();
  Vec3 second_ = Vec3::UnitY();
  FiniteLaw law_;
};

}  // namespace

FiniteLaw finite_law(CouplingType type, Space space, const DrawnCoupling& drawn) {
  return LawWriter(space, drawn).write(type);
}

}  // namespace kinestat
