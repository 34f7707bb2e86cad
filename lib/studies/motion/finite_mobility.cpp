#include "studies/motion/finite_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/index.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/path_tracker.hpp"

namespace kinestat {

namespace {

// Without drives: every joint is unknown.
template <class Frames>
class FreedomTester {
 public:
  FreedomTester(const MotionNetwork& network, const Mechanism& mechanism)
      : network_(network), mechanism_(mechanism), tracker_(network) {}

  FiniteMobility test(std::span<const FreeMotion> motions) {
    FiniteMobility result;
    PathPoint drawn = tracker_.make_point();
    double moved = 0.0;
    if (!tracker_.close(drawn, moved)) {
      result.is_known = false;
      return result;
    }
    result.drawn_freedom = tracker_.open_count();
    // Then the closed positions are a smooth surface, which has every motion as a tangent.
    const int rank = network_.rate_count - result.drawn_freedom;
    is_regular_ = tracker_.system().row_count() == rank;
    for (const FreeMotion& motion : motions) {
      result.trials.push_back(follow(drawn, motion));
    }
    result.nearby_freedom = least_open_.value_or(0);
    if (result.is_singular()) {
      note_gained(motions, result);
    }
    return result;
  }

 private:
  // The rates of the joints, the fastest of which is 1.
  VecX rates_of(const FreeMotion& motion) const {
    VecX rates = VecX::Zero(network_.rate_count);
    for (const MotionJoint& joint : network_.joints) {
      if (joint.coordinate < 0 || joint.freedom < 0) {
        continue;
      }
      const bool is_slide = joint.motion.kind == ElementaryKind::slide;
      const int count = joint.motion.kind == ElementaryKind::ball ? 3 : 1;
      for (int i = 0; i < count; ++i) {
        rates[joint.rate + i] =
            motion.rates[joint.freedom + i] / (is_slide ? network_.length : 1.0);
      }
    }
    add_floating(motion, rates);
    const double fastest = rates.size() > 0 ? rates.cwiseAbs().maxCoeff() : 0.0;
    return fastest > 0.0 ? VecX(rates / fastest) : rates;
  }

  // Bodies that hang on the ground by joints of no coupling move as their twist says.
  void add_floating(const FreeMotion& motion, VecX& rates) const {
    for (std::size_t b = 1; b < network_.frame_of_body.size(); ++b) {
      const Twist& twist = motion.bodies[b];
      Vec3 centre = Vec3::Zero();
      for (int frame = network_.frame_of_body[b]; frame != 0;) {
        const MotionJoint& joint = network_.joints[at(frame - 1)];
        if (joint.freedom >= 0 || joint.coordinate < 0) {
          break;
        }
        if (joint.motion.kind != ElementaryKind::slide) {
          centre = joint.motion.point;
        }
        for (int i = 0; joint.motion.kind == ElementaryKind::ball && i < 3; ++i) {
          rates[joint.rate + i] = twist.angular[i];
        }
        if (joint.motion.kind == ElementaryKind::turn) {
          rates[joint.rate] = twist.angular.dot(joint.motion.direction);
        } else if (joint.motion.kind == ElementaryKind::slide) {
          rates[joint.rate] =
              velocity_at(twist, centre).dot(joint.motion.direction) / network_.length;
        }
        frame = joint.parent;
      }
    }
  }

  // The nearest closed point among those that are as far in this direction.
  PathPoint stepped(const PathPoint& from, double step, const VecX& along) {
    PathPoint there = from;
    const VecX by = step * along;
    std::copy(by.begin(), by.end(), there.arrival.begin());
    tracker_.system().move(there.arrival, there.coordinates);
    tracker_.find_nearest(there, false, there.arrival);
    return there;
  }

  static VecX arrival_of(const PathPoint& point) {
    return Eigen::Map<const VecX>(point.arrival.data(),
                                  static_cast<Eigen::Index>(point.arrival.size()));
  }

  // Closing may lead back to where the step began, which is closed itself.
  static bool falls_back(const PathPoint& there, double step) {
    return arrival_of(there).cwiseAbs().maxCoeff() < kLeastTrialWay * step;
  }

  static VecX scaled(const VecX& direction) { return direction / direction.cwiseAbs().maxCoeff(); }

  // Steps along the motion and closes. What closing takes away shrinks with the square of the step
  // if the motion is finite, with the step if the way turns off.
  FreedomTrial follow(const PathPoint& drawn, const FreeMotion& motion) {
    const VecX along = rates_of(motion);
    FreedomTrial trial;
    PathPoint there;
    double shares[2] = {0.0, 0.0};
    double ways[2] = {0.0, 0.0};
    for (const int half : {1, 0}) {
      trial.step = half == 0 ? kTrialStep : 0.5 * kTrialStep;
      there = stepped(drawn, trial.step, along);
      trial.closure_error = there.closure_error;
      if (!(there.closure_error <= kTrialClosure) || falls_back(there, trial.step)) {
        trial.persistence = Persistence::instantaneous;
        return trial;
      }
      const VecX way = arrival_of(there);
      shares[half] = (way - trial.step * along).cwiseAbs().maxCoeff() / trial.step;
      ways[half] = way.cwiseAbs().maxCoeff() / trial.step;
    }
    if (ways[1] > kGrowingShare * ways[0] || !lasts(there, trial)) {
      trial.persistence = Persistence::instantaneous;
      return trial;
    }
    const bool shrinks = shares[1] <= kShrinks * shares[0] || shares[0] <= kStraightEnough;
    trial.persistence = shrinks ? Persistence::finite : Persistence::deflected;
    return trial;
  }

  // Whether the way from the drawn position to this one goes on.
  bool lasts(PathPoint& there, FreedomTrial& trial) {
    tracker_.stand_at(there);
    int open = tracker_.open_count();
    VecX direction = scaled(arrival_of(there));
    const double end = is_regular_ ? trial.step : kFarTrial;
    for (double step = kTrialStep; end - trial.step > kLeastTrialStep;) {
      step = std::min(step, end - trial.step);
      direction = led_on(direction);
      PathPoint next = stepped(there, step, direction);
      const bool is_closed = next.closure_error <= kTrialClosure;
      const double off = (arrival_of(next) - step * direction).cwiseAbs().maxCoeff();
      if ((!is_closed || off > kMostTrialTurn * step) && step > kLeastTrialStep) {
        step *= 0.5;
        continue;
      }
      trial.closure_error = next.closure_error;
      if (!is_closed || falls_back(next, step)) {
        return false;
      }
      trial.step += step;
      direction = scaled(arrival_of(next));
      there = std::move(next);
      tracker_.stand_at(there);
      step = std::min(2.0 * step, kLongestTrialStep);
    }
    open = std::min(open, tracker_.open_count());
    least_open_ = std::min(least_open_.value_or(open), open);
    return true;
  }

  // Of the directions that are open where the tracker stands, the one that goes on.
  VecX led_on(const VecX& direction) {
    VecX open = VecX::Zero(direction.size());
    for (const VecX& one : tracker_.open_directions()) {
      open += one.dot(direction) * one;
    }
    return open.norm() >= kLeadsOn * direction.norm() ? scaled(open) : direction;
  }

  // Couplings that move in some instantaneous motion and in none that lasts.
  void note_gained(std::span<const FreeMotion> motions, FiniteMobility& result) const {
    const Topology& topology = mechanism_.topology;
    std::vector<bool> moves(topology.couplings.size());
    std::vector<bool> lasts(topology.couplings.size());
    for (std::size_t m = 0; m < motions.size(); ++m) {
      for (int f = 0; f < topology.freedom_count(); ++f) {
        const auto e = at(topology.freedoms[at(f)].coupling.value);
        if (std::abs(motions[m].rates[f]) > kSilentCorrection) {
          const bool persists = result.trials[m].persistence == Persistence::finite;
          moves[e] = moves[e] || !persists;
          lasts[e] = lasts[e] || persists;
        }
      }
    }
    for (int e = 0; e < topology.coupling_count(); ++e) {
      if (moves[at(e)] && !lasts[at(e)]) {
        result.gained.push_back(CouplingId{e});
      }
    }
  }

  const MotionNetwork& network_;
  const Mechanism& mechanism_;
  PathTracker<Frames> tracker_;
  bool is_regular_ = false;        ///< no condition follows from others
  std::optional<int> least_open_;  ///< freedoms at the positions of motions that last
};

}  // namespace

std::string_view word_of(Persistence persistence) {
  switch (persistence) {
    case Persistence::finite:
      return "finite";
    case Persistence::deflected:
      return "deflected";
    case Persistence::instantaneous:
      return "instantaneous";
  }
  return "";
}

FiniteMobility find_finite_mobility(const MotionNetwork& network,
                                    const Mechanism& mechanism,
                                    std::span<const FreeMotion> motions) {
  if (!network.is_movable() || !network.driven_freedoms.empty()) {
    FiniteMobility unknown;
    unknown.is_known = false;
    return unknown;
  }
  return network.space == Space::planar
             ? FreedomTester<PlanarFrames>(network, mechanism).test(motions)
             : FreedomTester<SpatialFrames>(network, mechanism).test(motions);
}

}  // namespace kinestat
