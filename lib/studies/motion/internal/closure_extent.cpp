#include <algorithm>
#include <cmath>
#include <optional>

#include "core/index.hpp"
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
  }
  for (const Row& row : rows_) {
    include(row.tail_frame, row.tail_point);
    include(row.head_frame, row.head_point);
  }
  return reach;
}

// Twice the radius of a sphere about one of them holds all. Where a slide is drawn says nothing.
template <class Frames>
double ClosureSystem<Frames>::spread() const {
  std::optional<Plain> centre;
  double radius = 0.5;
  const auto include = [&](int frame, const Plain& point, double around) {
    const Plain place = frames_[at(frame)].point(point);
    centre = centre.value_or(place);
    radius = std::max(radius, (place - *centre).norm() + std::abs(around));
  };
  for (const ClosureJoint& joint : joints_) {
    if (joint.kind != ElementaryKind::slide) {
      include(joint.parent, Frames::vector(joint.point), joint.pitch);
    }
  }
  for (const Row& row : rows_) {
    include(row.tail_frame, row.tail_point, row.tail_radius);
    include(row.head_frame, row.head_point, row.head_radius);
  }
  return 2.0 * radius;
}

template double ClosureSystem<PlanarFrames>::reach() const;
template double ClosureSystem<SpatialFrames>::reach() const;
template double ClosureSystem<PlanarFrames>::spread() const;
template double ClosureSystem<SpatialFrames>::spread() const;

}  // namespace kinestat
