#include "studies/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/path_tracker.hpp"
#include "studies/motion/path_leg.hpp"

namespace kinestat {

namespace {

template <class Frames>
class MotionSolver {
 public:
  MotionSolver(const MotionNetwork& network, const MotionTask& task)
      : network_(network), task_(task), tracker_(network) {
    solution_.drives = task.drives;
    solution_.path = task.path;
    solution_.turns = task.turns;
    solution_.coordinate_count = network.coordinate_count;
    solution_.angle_count = network.angle_count;
    for (const MotionDrive& drive : task.drives) {
      units_.push_back(unit_of(drive.freedom));
      from_.push_back(drive.from / units_.back());
      to_.push_back(drive.to / units_.back());
    }
  }

  MotionSolution solve() {
    PathPoint now = tracker_.make_point();
    if (!assemble(now)) {
      solution_.status = MotionStatus::not_assembled;
    } else if (is_determined(now) && go_to_start(now)) {
      follow(now);
    }
    return std::move(solution_);
  }

  std::optional<Configuration> follow_between(const Configuration& start,
                                              double start_share,
                                              double share) {
    (void)tracker_.take_special();
    passed_.clear();
    if (tracker_.is_beside_change_point()) {
      tracker_ = PathTracker<Frames>(network_);  // There the last way would go on.
    }
    tracker_.leave_out_touches();
    PathPoint now = tracker_.make_point();
    now.coordinates = start.coordinates;
    now.angles = start.angles;
    if (task_.path) {
      return go_on(now, start_share, share) == Arrival::reached
                 ? std::optional(configuration_of(now))
                 : std::nullopt;
    }
    tracker_.set_range(from_, to_);
    now.share = start_share;
    double moved = 0.0;
    if (!tracker_.close(now, moved)) {
      return std::nullopt;
    }
    tracker_.find_rates(now);
    PathPoint before = tracker_.make_point();
    return tracker_.advance(now, before, share) == Arrival::reached
               ? std::optional(configuration_of(now))
               : std::nullopt;
  }

 private:
  double unit_of(int freedom) const {
    for (const MotionJoint& joint : network_.joints) {
      if (joint.freedom == freedom && joint.motion.kind == ElementaryKind::slide) {
        return network_.length;
      }
    }
    return 1.0;
  }

  static Configuration configuration_of(const PathPoint& point) {
    return {.coordinates = point.coordinates, .angles = point.angles};
  }

  // On a path, from turn to turn; shares of the point are of the path.
  Arrival go_on(PathPoint& now, double start_share, double share) {
    double from = start_share;
    Arrival arrival = Arrival::reached;
    for (const double turn : task_.turns) {
      if (arrival == Arrival::reached && turn > from && turn < share) {
        arrival = go_on(now, PathLeg(task_.path, units_, from, turn));
        from = turn;
      }
    }
    return arrival == Arrival::reached ? go_on(now, PathLeg(task_.path, units_, from, share))
                                       : arrival;
  }

  // By the straight line between its ends. What happens on it happens on the path where the line
  // is the path, to rounding; a leg is halved until it is.
  Arrival go_on(PathPoint& now, const PathLeg& leg) {
    const double bow = leg.bow();
    if (bow > kMostBow && leg.can_be_halved()) {
      return go_by_halves(now, leg);
    }
    if (!leg.moves()) {
      now.share = leg.to();
      return Arrival::reached;
    }
    const bool is_exact = bow <= kStraightWay || !leg.can_be_halved();
    std::optional<PathTracker<Frames>> tracker_before;
    std::optional<PathPoint> point_before;
    if (!is_exact) {
      tracker_before = tracker_;
      point_before = now;
    }
    tracker_.set_range(leg.low(), leg.high());
    now.share = 0.0;
    now.arrival_share = 0.0;
    double moved = 0.0;
    if (!tracker_.close(now, moved)) {
      return Arrival::lost;
    }
    tracker_.find_rates(now);
    PathPoint before = tracker_.make_point();
    const Arrival arrival = tracker_.advance(now, before, 1.0);
    if (!is_exact && (arrival != Arrival::reached || tracker_.has_special())) {
      tracker_ = *std::move(tracker_before);
      now = *std::move(point_before);
      return go_by_halves(now, leg);
    }
    for (SpecialPosition& one : tracker_.take_special()) {
      const double low = leg.share(std::max(one.share - one.uncertainty, 0.0));
      const double high = leg.share(std::min(one.share + one.uncertainty, 1.0));
      one.share = leg.share(one.share);
      one.uncertainty = std::max(high - one.share, one.share - low);
      passed_.push_back(std::move(one));
    }
    now.share = leg.share(now.share);
    return arrival;
  }

  Arrival go_by_halves(PathPoint& now, const PathLeg& leg) {
    const double middle = 0.5 * (leg.from() + leg.to());
    const Arrival arrival = go_on(now, PathLeg(task_.path, units_, leg.from(), middle));
    return arrival == Arrival::reached ? go_on(now, PathLeg(task_.path, units_, middle, leg.to()))
                                       : arrival;
  }

  // Closes the drawn position with the drives at zero.
  bool assemble(PathPoint& now) {
    const std::vector<double> still(task_.drives.size(), 0.0);
    tracker_.set_range(still, still);
    const PathPoint drawn = now;
    Assembly& assembly = solution_.assembly;
    assembly.drawn_misses = network_.drawn_misses;
    double moved = 0.0;
    if (!tracker_.close(now, moved)) {
      now = drawn;
      tracker_.find_nearest(now, false);
      assembly.closes = tracker_.close(now, moved);
    }
    if (!assembly.closes) {
      PathPoint free = drawn;
      tracker_.find_nearest(free, true);
      assembly.closes_elsewhere = free.closure_error <= kMotionClosure;
      now = free;
    }
    assembly.nearest = configuration_of(now);
    if (!assembly.closes) {
      assembly.nearest_misses = find_misses(network_, assembly.nearest, kSilentCorrection);
    }
    if (!assembly.drawn_misses.empty()) {
      assembly.corrections = body_poses(network_, assembly.nearest);
    }
    return assembly.closes;
  }

  // Whether the drives leave nothing open that other bodies feel.
  bool is_determined(PathPoint& now) {
    solution_.passive_freedoms = network_.passive_freedoms;
    tracker_.set_range(from_, to_);
    tracker_.find_rates(now);
    const bool can_move = tracker_.missed_rate(now) <= kAcceptedRateMiss;
    const int surplus = tracker_.open_count() - static_cast<int>(network_.passive_motions.size());
    if (surplus <= 0) {
      solution_.status = can_move ? MotionStatus::completed : MotionStatus::drives_locked;
      return can_move;
    }
    if (!can_move) {
      note_dead_start(now);
      return false;
    }
    // A rank that only drops where it was drawn is a singular position.
    PathPoint near = now;
    PathPoint none = tracker_.make_point();
    for (std::size_t i = 0; i < near.rates.size(); ++i) {
      near.arrival[i] = kNearby * near.rates[i];
    }
    const std::vector<VecX> open = tracker_.open_directions();
    tracker_.system().move(near.arrival, near.coordinates);
    double moved = 0.0;
    const bool closes = tracker_.close(near, moved);
    if (closes && tracker_.open_count() >= surplus) {
      solution_.status = MotionStatus::undetermined;
      note_open(open);
    } else {
      solution_.status = MotionStatus::singular;
    }
    return false;
  }

  // The drawn position is a limit itself.
  void note_dead_start(const PathPoint& now) {
    solution_.status = MotionStatus::limit;
    solution_.special.push_back({.kind = SpecialKind::limit,
                                 .step = -1,
                                 .drive_values = std::vector<double>(task_.drives.size(), 0.0),
                                 .configuration = configuration_of(now)});
  }

  // The freedoms that move most in what is open and not passive.
  void note_open(const std::vector<VecX>& directions) {
    std::vector<VecX> known = network_.passive_motions;
    for (VecX& one : known) {
      one.normalize();
    }
    for (VecX direction : directions) {
      for (const VecX& one : known) {
        direction -= one.dot(direction) * one;
      }
      if (direction.norm() <= kSilentCorrection) {
        continue;
      }
      known.push_back(direction.normalized());
      Eigen::Index most = 0;
      direction.cwiseAbs().maxCoeff(&most);
      for (const MotionJoint& joint : network_.joints) {
        const int count = joint.motion.kind == ElementaryKind::ball ? 3 : 1;
        if (joint.rate >= 0 && joint.freedom >= 0 && most >= joint.rate &&
            most < joint.rate + count) {
          solution_.open_freedoms.push_back(joint.freedom + static_cast<int>(most) - joint.rate);
        }
      }
    }
  }

  // To where all drives begin, in steps of its own.
  bool go_to_start(PathPoint& now) {
    const std::vector<double> zero(task_.drives.size(), 0.0);
    double farthest = 0.0;
    for (const double one : from_) {
      farthest = std::max(farthest, std::abs(one));
    }
    if (farthest == 0.0) {
      return true;
    }
    tracker_.set_range(zero, from_);
    tracker_.find_rates(now);
    PathPoint before = tracker_.make_point();
    const int steps = static_cast<int>(std::ceil(farthest / kStepToStart));
    for (int k = 1; k <= steps; ++k) {
      const Arrival arrival = tracker_.advance(now, before, static_cast<double>(k) / steps);
      note_special(-1, true);
      if (arrival != Arrival::reached) {
        solution_.status =
            arrival == Arrival::lift_off ? MotionStatus::lift_off : MotionStatus::limit;
        if (arrival == Arrival::lost) {
          note_lost(drive_values(now.share, true));
        }
        return false;
      }
    }
    now.share = 0.0;
    now.arrival_share = 0.0;
    return true;
  }

  // On the way to where the motion begins, or in it.
  std::vector<double> drive_values(double share, bool is_on_the_way) const {
    std::vector<double> values;
    for (std::size_t d = 0; d < solution_.drives.size(); ++d) {
      values.push_back(is_on_the_way ? share * solution_.drives[d].from
                                     : solution_.drive_at(d, share));
    }
    return values;
  }

  void note_lost(std::vector<double> drive_values) {
    solution_.status = MotionStatus::lost_branch;
    solution_.lost_at = std::move(drive_values);
  }

  void note_special(int step, bool is_on_the_way) {
    std::vector<SpecialPosition> passed = std::exchange(passed_, {});
    std::ranges::move(tracker_.take_special(), std::back_inserter(passed));
    for (SpecialPosition& one : passed) {
      one.step = step;
      one.drive_values = drive_values(one.share, is_on_the_way);
      solution_.special.push_back(std::move(one));
    }
  }

  void keep(const PathPoint& point) {
    solution_.shares.push_back(point.share);
    solution_.closure_errors.push_back(point.closure_error);
    if (tracker_.closes_by_least_squares(point)) {
      solution_.closes_by_least_squares = true;
    }
    solution_.coordinates.insert(
        solution_.coordinates.end(), point.coordinates.begin(), point.coordinates.end());
    solution_.angles.insert(solution_.angles.end(), point.angles.begin(), point.angles.end());
  }

  // The share at which the way ends, of what lies before it; 1 where it does not.
  double find_end(PathPoint now) const {
    PathTracker<Frames> ahead = tracker_;
    PathPoint before = ahead.make_point();
    return ahead.advance(now, before, 1.0) == Arrival::reached ? 1.0 : now.share;
  }

  // Makes the end of the way, where it is before that of the ranges, that of the ranges.
  void end_ranges_at(double end) {
    if (!(end > 0.0) || end == 1.0) {
      return;
    }
    for (MotionDrive& drive : solution_.drives) {
      drive.to = drive.from + end * (drive.to - drive.from);
    }
    for (std::size_t p = 0; p < solution_.shares.size(); ++p) {
      double& share = solution_.shares[p];
      share = share == end ? 1.0 : static_cast<double>(p) / task_.steps;
    }
    for (SpecialPosition& one : solution_.special) {
      if (one.step >= 0) {
        one.share /= end;
        one.uncertainty /= end;
      }
    }
  }

  void follow(PathPoint& now) {
    tracker_.set_range(from_, to_);
    if (!tracker_.is_beside_change_point()) {
      double moved = 0.0;
      if (!tracker_.close(now, moved)) {
        note_lost(drive_values(0.0, false));
        return;
      }
      tracker_.find_rates(now);
    }
    const double end = task_.until_limit ? find_end(now) : 1.0;
    const auto positions = at(task_.steps + 1);
    solution_.shares.reserve(positions);
    solution_.closure_errors.reserve(positions);
    solution_.coordinates.reserve(positions * now.coordinates.size());
    solution_.angles.reserve(positions * now.angles.size());
    keep(now);
    PathPoint before = tracker_.make_point();
    for (int k = 1; k <= task_.steps; ++k) {
      // Beyond the end, where it is a limit: there the last step stops.
      const double share = k == task_.steps ? 1.0 : end * share_of(k);
      const Arrival arrival = task_.path ? go_on(now, solution_.shares.back(), share)
                                         : tracker_.advance(now, before, share);
      if (tracker_.has_special() || !passed_.empty()) {
        note_special(k - 1, false);
      }
      if (arrival == Arrival::lost) {
        note_lost(drive_values(now.share, false));
        end_ranges_at(end);
        return;
      }
      keep(now);
      if (arrival != Arrival::reached) {
        solution_.status =
            arrival == Arrival::lift_off ? MotionStatus::lift_off : MotionStatus::limit;
        end_ranges_at(task_.until_limit ? now.share : 1.0);
        return;
      }
    }
  }

  double share_of(int step) const {
    if (step == task_.steps) {
      return 1.0;
    }
    return task_.shares.empty() ? static_cast<double>(step) / task_.steps : task_.shares[at(step)];
  }

  const MotionNetwork& network_;
  const MotionTask& task_;
  std::vector<SpecialPosition> passed_;  // on a path, since the last that were noted
  PathTracker<Frames> tracker_;
  MotionSolution solution_;
  std::vector<double> units_;  // of each drive: 1 rad, or the size of the mechanism
  std::vector<double> from_;
  std::vector<double> to_;
};

}  // namespace

MotionSolution solve_motion(const MotionNetwork& network, const MotionTask& task) {
  KINESTAT_EXPECTS(task.drives.size() == network.driven_freedoms.size() && task.steps > 0);
  if (!network.is_movable()) {
    MotionSolution solution;
    solution.status = MotionStatus::not_movable;
    solution.drives = task.drives;
    return solution;
  }
  return network.space == Space::planar ? MotionSolver<PlanarFrames>(network, task).solve()
                                        : MotionSolver<SpatialFrames>(network, task).solve();
}

struct WayBetween::Solver {
  Solver(const MotionNetwork& network, const MotionSolution& motion)
      : task{.drives = motion.drives,
             .steps = 1,
             .shares = {},
             .path = motion.path,
             .turns = motion.turns} {
    if (network.space == Space::planar) {
      planar.emplace(network, task);
    } else {
      spatial.emplace(network, task);
    }
  }

  MotionTask task;
  std::optional<MotionSolver<PlanarFrames>> planar;
  std::optional<MotionSolver<SpatialFrames>> spatial;
};

WayBetween::WayBetween(const MotionNetwork& network, const MotionSolution& motion)
    : solver_(std::make_unique<Solver>(network, motion)) {}

WayBetween::~WayBetween() = default;

std::optional<Configuration> WayBetween::follow(const Configuration& start,
                                                double start_share,
                                                double share) {
  return solver_->planar ? solver_->planar->follow_between(start, start_share, share)
                         : solver_->spatial->follow_between(start, start_share, share);
}

}  // namespace kinestat
