#include <cmath>

#include "core/index.hpp"
#include "studies/motion/internal/closure_system.hpp"

namespace kinestat {

// The straight part of a cable in the plane, and its angle in the frames of both pulleys.
template <class Frames>
template <class S>
typename ClosureSystem<Frames>::template Span<S> ClosureSystem<Frames>::span_of(
    const Row& row, const std::vector<Frame<S>>& frames) const {
  using std::sqrt;
  Span<S> span;
  if constexpr (Frames::kDirections == 2) {
    const Frame<S>& tail = frames[at(row.tail_frame)];
    const Frame<S>& head = frames[at(row.head_frame)];
    const Vector<S> centre = tail.point(row.tail_point);
    const Vector<S> c = head.point(row.head_point) - centre;
    const S c2 = dot(c, c);
    const S s = row.head_radius - row.tail_radius;
    span.length = sqrt(c2 - s * s);
    const S lc = span.length / c2;
    const S sc = s / c2;
    span.along = Vector<S>(lc * c[0] + sc * c[1], lc * c[1] - sc * c[0]);
    const S radius = row.tail_radius;
    span.from = Vector<S>(centre[0] + radius * span.along[1], centre[1] - radius * span.along[0]);
    const auto angle_in = [&](const Frame<S>& frame) {
      return Frames::template angle<S>(span.along, frame.direction(Plain::Unit(0)), span.along);
    };
    span.tail_angle = angle_in(tail);
    span.head_angle = angle_in(head);
  }
  return span;
}

template <class Frames>
template <class S>
typename ClosureSystem<Frames>::template Screw<S> ClosureSystem<Frames>::gradient(
    const Row& row, int direction, const std::vector<Frame<S>>& frames) const {
  using std::sqrt;
  const Frame<S>& tail = frames[at(row.tail_frame)];
  const Frame<S>& head = frames[at(row.head_frame)];
  switch (row.kind) {
    case ClosureKind::meet:
      return Frames::template force<S>(Vector<S>::Unit(direction), head.point(row.head_point));
    case ClosureKind::along:
      return Frames::template force<S>(tail.direction(row.tail), head.point(row.head_point));
    case ClosureKind::across:
      return Frames::template couple_across<S>(head.direction(row.head), tail.direction(row.tail));
    case ClosureKind::screw: {
      const Vector<S> axis = tail.direction(row.tail);
      return Frames::template force<S>(axis, head.point(row.head_point)) -
             S(row.value) * Frames::template couple<S>(axis);
    }
    case ClosureKind::reach: {
      const Vector<S> to = head.point(row.head_point);
      const Vector<S> between = to - tail.point(row.tail_point);
      return Frames::template force<S>(between / sqrt(dot(between, between)), to);
    }
    case ClosureKind::cable: {
      const Span<S> span = span_of<S>(row, frames);
      return Frames::template force<S>(span.along, span.from);
    }
  }
  return Screw<S>::Zero();
}

// Of the joint that makes a frame.
template <class Frames>
template <class S>
void ClosureSystem<Frames>::find_screws(const ClosureJoint& joint,
                                        int frame,
                                        const std::vector<Frame<S>>& frames,
                                        std::vector<Screw<S>>& screws) const {
  if (joint.rate < 0) {
    return;
  }
  const Frame<S>& parent = frames[at(joint.parent)];
  const S sense = joint.sense;
  Screw<S>* first = &screws[at(joint.rate)];
  switch (joint.kind) {
    case ElementaryKind::turn:
      *first =
          sense * Frames::template turn_screw<S>(parent, joint.direction, joint.point, joint.pitch);
      return;
    case ElementaryKind::slide:
      *first = sense * Frames::template slide_screw<S>(parent, joint.direction);
      return;
    case ElementaryKind::ball: {
      const Frame<S>& tail = joint.sense > 0.0 ? parent : frames[at(frame)];
      for (int i = 0; i < 3; ++i) {
        first[i] = sense * Frames::template turn_screw<S>(tail, Vec3::Unit(i), joint.point, 0.0);
      }
      return;
    }
  }
}

template <class Frames>
ClosureLevers ClosureSystem<Frames>::levers(const std::vector<Frame<Jet>>& frames) const {
  ClosureLevers result;
  const auto add = [](const Screw<Jet>& one, std::vector<Jet>& list) {
    list.insert(list.end(), one.data(), one.data() + one.size());
  };
  std::vector<Screw<Jet>> screws(at(rate_count_));
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    find_screws<Jet>(joints_[j], static_cast<int>(j) + 1, frames, screws);
  }
  for (const Screw<Jet>& one : screws) {
    add(one, result.screws);
  }
  for (const Row& row : rows_) {
    const int count = row.kind == ClosureKind::meet ? Frames::kDirections : 1;
    for (int i = 0; i < count; ++i) {
      add(gradient<Jet>(row, i, frames), result.rows);
    }
  }
  for (const MeasuredFreedom& one : measures_) {
    const FreedomMeasure& m = one.measure;
    const Frame<Jet>& tail = frames[at(one.tail_frame)];
    const Frame<Jet>& head = frames[at(one.head_frame)];
    const Vector<Jet> axis = (m.is_in_head ? head : tail).direction(Frames::vector(m.axis));
    // An axis fixed in the head sees the point of the tail move.
    const Vector<Jet> point = m.is_in_head ? tail.point(Frames::vector(m.tail_point))
                                           : head.point(Frames::vector(m.head_point));
    add(m.is_turn ? Frames::template couple<Jet>(axis) : Frames::template force<Jet>(axis, point),
        result.measures);
  }
  return result;
}

template typename PlanarFrames::Screw<double> ClosureSystem<PlanarFrames>::gradient(
    const Row&, int, const std::vector<PlanarFrames::Frame<double>>&) const;
template typename SpatialFrames::Screw<double> ClosureSystem<SpatialFrames>::gradient(
    const Row&, int, const std::vector<SpatialFrames::Frame<double>>&) const;
template void ClosureSystem<PlanarFrames>::find_screws(
    const ClosureJoint&,
    int,
    const std::vector<PlanarFrames::Frame<double>>&,
    std::vector<PlanarFrames::Screw<double>>&) const;
template void ClosureSystem<SpatialFrames>::find_screws(
    const ClosureJoint&,
    int,
    const std::vector<SpatialFrames::Frame<double>>&,
    std::vector<SpatialFrames::Screw<double>>&) const;
template ClosureSystem<PlanarFrames>::Span<double> ClosureSystem<PlanarFrames>::span_of(
    const Row&, const std::vector<PlanarFrames::Frame<double>>&) const;
template ClosureSystem<PlanarFrames>::Span<Jet> ClosureSystem<PlanarFrames>::span_of(
    const Row&, const std::vector<PlanarFrames::Frame<Jet>>&) const;
template ClosureSystem<SpatialFrames>::Span<double> ClosureSystem<SpatialFrames>::span_of(
    const Row&, const std::vector<SpatialFrames::Frame<double>>&) const;
template ClosureSystem<SpatialFrames>::Span<Jet> ClosureSystem<SpatialFrames>::span_of(
    const Row&, const std::vector<SpatialFrames::Frame<Jet>>&) const;
template ClosureLevers ClosureSystem<PlanarFrames>::levers(
    const std::vector<PlanarFrames::Frame<Jet>>&) const;
template ClosureLevers ClosureSystem<SpatialFrames>::levers(
    const std::vector<SpatialFrames::Frame<Jet>>&) const;

}  // namespace kinestat
