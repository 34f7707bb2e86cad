#include "studies/motion/finite_mobility.hpp"

#include <algorithm>
#include <cmath>

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
    result.nearby_freedom = 0;
    bool has_moved = false;
    for (const FreeMotion& motion : motions) {
      const FreedomTrial trial = follow(drawn, motion);
      if (trial.persistence != Persistence::instantaneous) {
        result.nearby_freedom = has_moved ? std::min(result.nearby_freedom, tracker_.open_count())
                                          : tracker_.open_count();
        has_moved = true;
      }
      result.trials.push_back(trial);
    }
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

  // Steps along the motion and closes; leaves the tracker at the closed point. What closing takes
  // away shrinks with the square of the step if the motion is finite, with the step if the way
  // turns off.
  FreedomTrial follow(const PathPoint& drawn, const FreeMotion& motion) {
    const VecX along = rates_of(motion);
    FreedomTrial trial;
    double shares[2] = {0.0, 0.0};
    double ways[2] = {0.0, 0.0};
    for (const int half : {0, 1}) {
      PathPoint there = drawn;
      trial.step = half == 0 ? kTrialStep : 0.5 * kTrialStep;
      const VecX step = trial.step * along;
      std::copy(step.begin(), step.end(), there.arrival.begin());
      tracker_.system().move(there.arrival, there.coordinates);
      double moved = 0.0;
      if (!tracker_.close(there, moved)) {
        tracker_.find_nearest(there, false);
        tracker_.close(there, moved);
      }
      trial.closure_error = there.closure_error;
      if (!(there.closure_error <= kTrialClosure)) {
        trial.persistence = Persistence::instantaneous;
        return trial;
      }
      double off = 0.0;
      double way = 0.0;
      for (std::size_t i = 0; i < there.arrival.size(); ++i) {
        const double difference = there.coordinates.size() == there.arrival.size()
                                      ? there.coordinates[i] - drawn.coordinates[i]
                                      : there.arrival[i];
        off = std::max(off, std::abs(difference - step[static_cast<Eigen::Index>(i)]));
        way = std::max(way, std::abs(difference));
      }
      shares[half] = off / trial.step;
      ways[half] = way / trial.step;
      if (ways[half] < kLeastWay || (half == 1 && ways[1] > kGrowingShare * ways[0])) {
        trial.persistence = Persistence::instantaneous;  // it only closes where it was drawn
        return trial;
      }
    }
    trial.step = kTrialStep;
    const bool shrinks = shares[1] <= kShrinks * shares[0] || shares[0] <= kStraightEnough;
    trial.persistence = shrinks ? Persistence::finite : Persistence::deflected;
    return trial;
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
