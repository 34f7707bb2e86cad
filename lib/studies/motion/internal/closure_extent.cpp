#include <algorithm>
#include <cmath>
#include <optional>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/internal/closure_system.hpp"

namespace kinestat {

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

// Where all turns between two frames are about one direction, nothing changes along it.
template <class Frames>
TurnAxis ClosureSystem<Frames>::axis_between(int tail_frame, int head_frame) const {
  Row path;
  add_path(tail_frame, head_frame, path);
  TurnAxis result;
  for (const ClosureJoint& joint : joints_) {
    if (joint.kind != ElementaryKind::slide && std::ranges::count(path.rates, joint.rate) > 0) {
      result.axis = result.axis.value_or(joint.direction);
      if (joint.kind == ElementaryKind::ball ||
          joint.direction.cross(*result.axis).norm() > 4.0 * kEpsilon) {
        return {.is_one = false};
      }
    }
  }
  return result;
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
    result.insert(result.end(), count, rates);
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
template std::vector<RatesOfRow> ClosureSystem<PlanarFrames>::rates_of_rows() const;
template std::vector<RatesOfRow> ClosureSystem<SpatialFrames>::rates_of_rows() const;

}  // namespace kinestat
