#include "couplings/internal/law_writer.hpp"

#include <cmath>

#include "couplings/internal/catalogue_row.hpp"

namespace kinestat {

LawWriter::LawWriter(Space space, const DrawnCoupling& drawn)
    : is_planar_(space == Space::planar),
      drawn_(drawn),
      at_(drawn.geometry.at),
      at_head_(drawn.at_head.value_or(drawn.geometry.at)) {
  take_axis(drawn.geometry.axis.direction);
}

void LawWriter::take_axis(const Vec3& axis) {
  axis_ = axis;
  const auto [first, second] = transverse_to<double>(axis_);
  first_ = is_planar_ ? Vec3(Vec3::UnitZ().cross(axis_)) : first;
  second_ = second;
}

void LawWriter::take_place(const Vec3& at) {
  at_ = at;
  at_head_ = at;
}

void LawWriter::add(ElementaryKind kind, const Vec3& direction, int freedom, double pitch) {
  law_.chain.push_back(
      {.kind = kind, .direction = direction, .point = at_, .pitch = pitch, .freedom = freedom});
}

ClosureCondition& LawWriter::require(ClosureKind kind) {
  law_.conditions.push_back({.kind = kind, .tail_point = at_, .head_point = at_head_});
  return law_.conditions.back();
}

void LawWriter::keep_along_in_head(const Vec3& normal) {
  ClosureCondition& condition = require(ClosureKind::along);
  condition.is_reversed = true;
  condition.tail = normal;
  std::swap(condition.tail_point, condition.head_point);
}

void LawWriter::keep_angle(const Vec3& tail, const Vec3& head) {
  ClosureCondition& condition = require(ClosureKind::across);
  condition.tail = tail;
  condition.head = head;
  condition.value = tail.dot(head);
}

void LawWriter::keep_axis() {
  if (!is_planar_) {
    keep_angle(first_, axis_);
    keep_angle(second_, axis_);
  }
}

void LawWriter::keep_orientation() {
  if (is_planar_) {
    keep_angle(Vec3::UnitX(), Vec3::UnitY());
  } else {
    keep_axis();
    keep_angle(first_, second_);
  }
}

FreedomMeasure& LawWriter::measure(int freedom, const Vec3& axis) {
  law_.measures.push_back(
      {.freedom = freedom, .axis = axis, .tail_point = at_, .head_point = at_head_});
  return law_.measures.back();
}

void LawWriter::measure_turn(int freedom, const Vec3& axis) {
  FreedomMeasure& one = measure(freedom, axis);
  one.from = transverse_to<double>(axis).first;
  one.to = one.from;
}

void LawWriter::hinge() {
  add(ElementaryKind::turn, axis_, 0);
  meet();
  keep_axis();
  measure_turn(0, axis_);
}

void LawWriter::prism() {
  add(ElementaryKind::slide, axis_, 0);
  keep_along(first_);
  if (!is_planar_) {
    keep_along(second_);
  }
  keep_orientation();
  measure_slide(0, axis_);
}

void LawWriter::thread(double pitch) {
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

void LawWriter::touching() {
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

}  // namespace kinestat
