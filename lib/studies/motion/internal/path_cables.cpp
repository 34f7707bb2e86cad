#include <algorithm>
#include <cmath>

#include "studies/motion/internal/largest.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/path_tracker.hpp"

namespace kinestat {

template <class Frames>
LeastArc PathTracker<Frames>::least_arc(const PathPoint& point) const {
  LeastArc least;
  for (const ContactArc& one : arcs_) {
    const double arc = one.at(point.angles, system_.drawn_angles());
    if (least.contact < 0 || arc < least.arc) {
      least = {.arc = arc, .contact = one.contact};
    }
  }
  return least;
}

// In stretches so short that no cable leaves its pulley and comes back within one.
template <class Frames>
Arrival PathTracker<Frames>::follow_cables(PathPoint& now, PathPoint& before, double share) {
  double stretch = share - now.share;
  while (now.share < share) {
    Beginning& beginning = beginning_;
    beginning.point = now;
    beginning.resumption = resumption_;
    beginning.passed = special_.size();
    const double next = now.share + stretch < share ? now.share + stretch : share;
    const Arrival arrival = follow(now, before, next);
    const double arc = least_arc(now).arc;
    if (arc < -kStraightArc) {
      end_at_lift_off(beginning, now);
      return Arrival::lift_off;
    }
    double way = 0.0;
    for (std::size_t i = 0; i < now.coordinates.size(); ++i) {
      way = std::max(way, std::abs(now.coordinates[i] - beginning.point.coordinates[i]));
    }
    if (arrival == Arrival::reached && way > kLeastCableStep &&
        way > std::min(arc, least_arc(beginning.point).arc)) {
      return_to(beginning, now);
      stretch *= 0.5;
      continue;
    }
    if (arrival != Arrival::reached) {
      return arrival;
    }
    stretch *= 2.0;
  }
  return Arrival::reached;
}

template <class Frames>
void PathTracker<Frames>::return_to(const Beginning& beginning, PathPoint& now) {
  now = beginning.point;
  now.arrival_share = 0.0;
  resumption_ = beginning.resumption;
  special_.resize(beginning.passed);
  trail_.clear();
  flattening_ = kUnknownFall;
}

// Between the beginning of a stretch and its end, where the arc of a cable is zero.
template <class Frames>
void PathTracker<Frames>::end_at_lift_off(const Beginning& beginning, PathPoint& now) {
  Beginning low = beginning;
  double high = now.share;
  int contact = least_arc(now).contact;
  while ((high - low.point.share) * line_.scale > kDeadPointBracket) {
    const double middle = 0.5 * (low.point.share + high);
    if (middle <= low.point.share || middle >= high) {
      break;
    }
    return_to(low, now);
    PathPoint none = make_point();
    const bool is_reached = follow(now, none, middle) == Arrival::reached;
    const LeastArc least = least_arc(now);
    if (is_reached && least.arc >= -kStraightArc) {
      low = {.point = now, .resumption = resumption_, .passed = special_.size()};
    } else {
      high = middle;
      contact = is_reached ? least.contact : contact;
    }
  }
  return_to(low, now);
  special_.push_back({.kind = SpecialKind::lift_off,
                      .share = 0.5 * (now.share + high),
                      .uncertainty = 0.5 * (high - now.share),
                      .drive_values = {},
                      .configuration = {.coordinates = now.coordinates, .angles = now.angles},
                      .contact = contact});
}

template Arrival PathTracker<PlanarFrames>::follow_cables(PathPoint&, PathPoint&, double);
template Arrival PathTracker<SpatialFrames>::follow_cables(PathPoint&, PathPoint&, double);

}  // namespace kinestat
