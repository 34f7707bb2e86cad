#include <algorithm>
#include <cmath>
#include <optional>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/internal/closure_system.hpp"

namespace kinestat {

namespace {

bool is_along(const Vec3& direction, const Vec3& axis) {
  return direction.cross(axis).norm() <= 4.0 * kEpsilon;
}

}  // namespace

template <class Frames>
double ClosureSystem<Frames>::reach() const {
  double reach = 1.0;
  const auto include = [&](int frame, const Plain& point) {
    reach = std::max(reach, frames_[at(frame)].point(point).norm());
  };
  for (const ClosureJoint& joint : joints_) {
    include(joint.parent, Frames::vector(joint.point));
    reach = std::max(reach, std::abs(joint.pitch));
  }
  for (const Row& row : rows_) {
    include(row.tail_frame, row.tail_point);
    include(row.head_frame, row.head_point);
  }
  return reach;
}

// Turns about one direction change nothing along it, and slides keep what they have along it.
template <class Frames>
TurnAxis ClosureSystem<Frames>::axis_between(int tail_frame, int head_frame) const {
  Row path;
  add_path(tail_frame, head_frame, path);
  Row below;
  add_path(0, tail_frame, below);
  TurnAxis result;
  const auto turns_in = [](const ClosureJoint& joint, const Row& row) {
    return joint.kind != ElementaryKind::slide && std::ranges::count(row.rates, joint.rate) > 0;
  };
  for (const ClosureJoint& joint : joints_) {
    if (turns_in(joint, path)) {
      result.axis = result.axis.value_or(joint.direction);
      if (joint.kind == ElementaryKind::ball || !is_along(joint.direction, *result.axis)) {
        return {.is_one = false};
      }
    }
  }
  for (const ClosureJoint& joint : joints_) {
    const bool is_other = joint.kind == ElementaryKind::ball || !result.axis ||
                          !is_along(joint.direction, *result.axis);
    result.stays = result.stays && !(is_other && turns_in(joint, below));
  }
  return result;
}

template <class Frames>
std::array<bool, 3> ClosureSystem<Frames>::find_linear(const ClosureCondition& condition,
                                                       const TurnAxis& turns) const {
  if (!turns.is_one) {
    return {};
  }
  const std::optional<Vec3>& axis = turns.axis;
  const auto keeps = [&axis](const Vec3& direction) { return !axis || is_along(direction, *axis); };
  switch (condition.kind) {
    case ClosureKind::meet:  // along axes of the world
      if (!turns.stays) {
        return {};
      }
      return {keeps(Vec3::UnitX()), keeps(Vec3::UnitY()), keeps(Vec3::UnitZ())};
    case ClosureKind::along:
    case ClosureKind::screw:
      return {keeps(condition.tail)};
    case ClosureKind::across:
      return {keeps(condition.tail) || keeps(condition.head)};
    case ClosureKind::reach:
    case ClosureKind::cable:
      return {};
  }
  return {};
}

template <class Frames>
std::vector<RatesOfRow> ClosureSystem<Frames>::rates_of_rows() const {
  std::vector<RatesOfRow> result;
  const double reach = this->reach();
  for (const Row& row : rows_) {
    RatesOfRow rates{.all = row.rates,
                     .tail_frame = row.tail_frame,
                     .head_frame = row.head_frame,
                     .rounds = reach};
    if (row.kind == ClosureKind::across) {
      rates.is_angle = true;
      rates.rounds = 1.0;
    } else if (row.kind == ClosureKind::screw) {
      rates.by_angle = std::abs(row.value);
    } else if (row.kind == ClosureKind::reach) {
      // Directions of short lines round more, and so do those of short tangents.
      const Plain between = frames_[at(row.head_frame)].point(row.head_point) -
                            frames_[at(row.tail_frame)].point(row.tail_point);
      rates.rounds += 2.0 * reach * reach / between.norm();
    } else if (row.kind == ClosureKind::cable) {
      rates.rounds += 2.0 * reach * reach / span_of<double>(row, frames_).length;
      rates.by_angle = std::abs(row.tail_radius) + std::abs(row.head_radius);
    }
    const std::size_t count = row.kind == ClosureKind::meet ? Frames::kDirections : 1;
    for (std::size_t i = 0; i < count; ++i) {
      rates.is_linear = row.is_linear[i];
      result.push_back(rates);
    }
  }
  for (const RollingRow& rolling : rollings_) {
    result.push_back({.all = rolling.rates});
  }
  return result;
}

template double ClosureSystem<PlanarFrames>::reach() const;
template double ClosureSystem<SpatialFrames>::reach() const;
template TurnAxis ClosureSystem<PlanarFrames>::axis_between(int, int) const;
template TurnAxis ClosureSystem<SpatialFrames>::axis_between(int, int) const;
template std::array<bool, 3> ClosureSystem<PlanarFrames>::find_linear(const ClosureCondition&,
                                                                      const TurnAxis&) const;
template std::array<bool, 3> ClosureSystem<SpatialFrames>::find_linear(const ClosureCondition&,
                                                                       const TurnAxis&) const;
template std::vector<RatesOfRow> ClosureSystem<PlanarFrames>::rates_of_rows() const;
template std::vector<RatesOfRow> ClosureSystem<SpatialFrames>::rates_of_rows() const;

}  // namespace kinestat
