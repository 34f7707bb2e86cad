#include "studies/motion/motion_state.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/internal/closure_parts.hpp"
#include "studies/motion/internal/closure_system.hpp"
#include "studies/motion/internal/freedom_places.hpp"
#include "studies/motion/internal/joint_errors.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/pivoted_qr.hpp"

namespace kinestat {

namespace {

constexpr double kOpenRoundings = 64.0;  // of sums over some ten rates

struct MovingTwist {
  Twist twist;
  Twist rate;
};

// From a frame that moves: ω from dR/dt Rᵀ, and the velocity of its point at the origin.
MovingTwist twist_of(const PlanarFrames::Frame<Jet>& f, double length) {
  const double turn = f.c.value * f.s.first - f.s.value * f.c.first;
  const double turn_rate = f.c.value * f.s.second - f.s.value * f.c.second;
  const Vec3 angular(0.0, 0.0, turn);
  const Vec3 angular_rate(0.0, 0.0, turn_rate);
  const Vec3 shift(f.shift[0].value, f.shift[1].value, 0.0);
  const Vec3 speed(f.shift[0].first, f.shift[1].first, 0.0);
  const Vec3 bend(f.shift[0].second, f.shift[1].second, 0.0);
  return {.twist = {.angular = angular, .linear = length * (speed - angular.cross(shift))},
          .rate = {.angular = angular_rate,
                   .linear = length * (bend - angular_rate.cross(shift) - angular.cross(speed))}};
}

Vec3 vector_of(const Mat3& skew) {
  return 0.5 * Vec3(skew(2, 1) - skew(1, 2), skew(0, 2) - skew(2, 0), skew(1, 0) - skew(0, 1));
}

MovingTwist twist_of(const SpatialFrames::Frame<Jet>& f, double length) {
  Mat3 R;
  Mat3 first;
  Mat3 second;
  Vec3 shift;
  Vec3 speed;
  Vec3 bend;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      R(i, j) = f.rotation(i, j).value;
      first(i, j) = f.rotation(i, j).first;
      second(i, j) = f.rotation(i, j).second;
    }
    shift[i] = f.shift[i].value;
    speed[i] = f.shift[i].first;
    bend[i] = f.shift[i].second;
  }
  const Vec3 angular = vector_of(first * R.transpose());
  // d/dt (dR/dt Rᵀ) = d²R/dt² Rᵀ + dR/dt dRᵀ/dt, whose last term is symmetric.
  const Vec3 angular_rate = vector_of(second * R.transpose());
  return {.twist = {.angular = angular, .linear = length * (speed - angular.cross(shift))},
          .rate = {.angular = angular_rate,
                   .linear = length * (bend - angular_rate.cross(shift) - angular.cross(speed))}};
}

// Makes zero what the bounds do not tell from it, as far as they are rounding.
void settle(const Topology& topology, MotionState& state) {
  const StateBounds& all = state.bounds;
  for (std::size_t f = 0; f < state.rates.size(); ++f) {
    const double unit = topology.freedoms[f].is_rotation ? 1.0 : all.reach;
    if (state.rates[f]) {
      state.rates[f] = settled_rate(*state.rates[f], all.rates[f], unit * all.rate_rounding);
    }
    if (f < state.rate_rates.size() && state.rate_rates[f]) {
      state.rate_rates[f] =
          settled_rate(*state.rate_rates[f], all.rate_rates[f], unit * all.rate_rate_rounding);
    }
  }
  for (std::size_t b = 0; b < state.twists.size(); ++b) {
    const BodyBounds& bounds = all.bodies[b];
    Twist& twist = state.twists[b];
    twist = {.angular = settled_rates(twist.angular, bounds.angular, all.rate_rounding),
             .linear = settled_rates(twist.linear, bounds.linear, all.reach * all.rate_rounding)};
    if (!state.twist_rates.empty()) {
      Twist& rate = state.twist_rates[b];
      rate = {.angular = settled_rates(rate.angular, bounds.angular_rate, all.rate_rate_rounding),
              .linear = settled_rates(
                  rate.linear, bounds.linear_rate, all.reach * all.rate_rate_rounding)};
    }
  }
}

template <class Frames>
class StateSolver {
 public:
  StateSolver(const MotionNetwork& network, const Mechanism& mechanism)
      : network_(network),
        mechanism_(mechanism),
        system_(network),
        parts_(network, system_.is_length(), system_.rates_of_rows()),
        errors_(network) {
    for (int rate = 0; rate < network.rate_count; ++rate) {
      if (std::ranges::find(network.driven_rates, rate) == network.driven_rates.end()) {
        unknown_.push_back(rate);
      }
    }
  }

  MotionState solve_in(const Configuration& configuration,
                       const GivenSpeeds& speeds,
                       StateDetail detail) {
    stand_in(configuration);
    return solve(speeds, detail, false);
  }

  std::vector<std::optional<double>> freedom_positions_in(const Configuration& configuration) {
    stand_in(configuration);
    return freedom_positions_of(system_, network_, mechanism_, configuration);
  }

  MotionState solve_bounded_in(const Configuration& configuration,
                               const GivenSpeeds& speeds,
                               StateDetail detail) {
    stand_in(configuration);
    if (!has_errors_) {
      errors_.stand_in({.rates_of_rows = system_.rates_of_rows(),
                        .residuals = system_.residuals(),
                        .jacobian = system_.jacobian(),
                        .unknown = unknown_,
                        .qr = qr_,
                        .reach = system_.reach()},
                       configuration_.coordinates,
                       is_singular());
      has_errors_ = true;
    }
    MotionState state = solve(speeds, detail, true);
    allow_rounding(speeds.passive, state);
    settle(mechanism_.topology, state);
    return state;
  }

 private:
  using MovingFrames = std::vector<typename Frames::template Frame<Jet>>;

  // One configuration serves several speeds.
  void stand_in(const Configuration& configuration) {
    const bool is_there = has_stood_ && configuration.coordinates == configuration_.coordinates &&
                          configuration.angles == configuration_.angles;
    if (!is_there) {
      configuration_ = configuration;
      system_.evaluate(configuration_.coordinates, configuration_.angles);
      factor();
      has_errors_ = false;
      has_stood_ = true;
    }
  }

  MotionState solve(const GivenSpeeds& speeds, StateDetail detail, bool is_bounded) {
    MotionState state;
    for (const int frame : network_.frame_of_body) {
      BodyPose pose = Frames::pose(system_.frames()[at(frame)]);
      pose.shift = network_.length * pose.shift;
      state.poses.push_back(pose);
    }
    state.is_singular = is_singular();
    std::vector<double> rates(at(network_.rate_count), 0.0);
    std::vector<double> bends = rates;
    if (state.is_singular) {
      if (is_bounded) {
        state.bounds = bounds_of(speeds,
                                 rates,
                                 bends,
                                 StateDetail::velocity,
                                 system_.moving_frames(configuration_.coordinates, rates, bends));
      }
      return state;
    }
    for (std::size_t d = 0; d < speeds.drives.size(); ++d) {
      const double unit = unit_of_rate(network_.driven_rates[d]);
      rates[at(network_.driven_rates[d])] = speeds.drives[d].speed / unit;
      bends[at(network_.driven_rates[d])] = speeds.drives[d].acceleration / unit;
    }
    complete(rates, std::vector<double>(at(system_.row_count()), 0.0));
    const bool has_open = open_count() > 0;
    if (has_open) {
      find_effects(speeds.passive);
      meet_speeds(speeds.passive, rates);
    }
    if (detail == StateDetail::acceleration) {
      // What is left of the second derivative while the unknown rates do not change.
      const auto frames = system_.moving_frames(configuration_.coordinates, rates, bends);
      const std::vector<double> left = system_.residual_bends(frames, bends, configuration_.angles);
      solve_unknown(left, bends);
      if (has_open) {
        hold_speeds(speeds.passive, rates, bends);
      }
    }
    const auto frames = fill(rates, bends, detail, state);
    if (is_bounded) {
      state.bounds = bounds_of(speeds, rates, bends, detail, frames);
    }
    return state;
  }

  StateBounds bounds_of(const GivenSpeeds& speeds,
                        const std::vector<double>& rates,
                        const std::vector<double>& bends,
                        StateDetail detail,
                        const MovingFrames& frames) {
    std::vector<double> driven_errors;
    std::vector<double> driven_bend_errors;
    for (std::size_t d = 0; d < speeds.drives.size(); ++d) {
      const double unit = unit_of_rate(network_.driven_rates[d]);
      driven_errors.push_back(speeds.drives[d].speed_bound / unit);
      driven_bend_errors.push_back(speeds.drives[d].acceleration_bound / unit);
    }
    const ClosureLevers levers = system_.levers(frames);
    StateBounds bounds = errors_.bounds({.levers = levers,
                                         .is_bent = detail == StateDetail::acceleration,
                                         .rates = rates,
                                         .bends = bends,
                                         .driven_errors = driven_errors,
                                         .driven_bend_errors = driven_bend_errors},
                                        mechanism_.topology);
    // Followed angles are those of the point before its last correction.
    for (const MeasuredFreedom& one : network_.measures) {
      if (one.measure.is_turn) {
        const double angle = configuration_.angles[at(one.angle)];
        const double now = system_.template position<double>(one, system_.frames());
        bounds.positions[at(one.freedom)] += std::abs(counted_turn(now, angle) - angle);
      }
    }
    return bounds;
  }

  // Open motions bring freedoms to their given speeds but for the rounding of what they are added
  // to.
  void allow_rounding(const std::vector<PassiveSpeed>& given, MotionState& state) const {
    double most = 0.0;
    for (int f = 0; f < std::ssize(state.rates); ++f) {
      most = std::max(most, std::abs(state.rates[at(f)].value_or(0.0)) / unit_of({.freedom = f}));
    }
    for (const PassiveSpeed& one : given) {
      state.bounds.rates[at(one.freedom)] += kOpenRoundings * kEpsilon * most * unit_of(one);
    }
  }

  int open_count() const { return static_cast<int>(unknown_.size()) - qr_.rank(); }

  int passive_count() const { return static_cast<int>(network_.passive_motions.size()); }

  bool is_singular() const { return open_count() > passive_count() || is_too_flat(); }

  void factor() {
    const int rows = system_.row_count();
    matrix_.clear();
    for (const int column : unknown_) {
      const auto first = system_.jacobian().begin() + column * rows;
      matrix_.insert(matrix_.end(), first, first + rows);
    }
    const int columns = static_cast<int>(unknown_.size());
    qr_.factor(matrix_, rows, columns, kSize);
    reciprocal_condition_ = qr_.reciprocal_condition_beside(passive_count());
    largest_residual_ = system_.largest_residual();
    if (!parts_.are_whole()) {
      parts_.measure(matrix_, unknown_);
      PivotedQr in_parts;
      in_parts.factor(matrix_, rows, columns, kSize);
      reciprocal_condition_ = in_parts.reciprocal_condition_beside(passive_count());
      largest_residual_ = parts_.largest(system_.residuals());
    }
  }

  // A closure by least squares misses something everywhere.
  bool is_too_flat() const {
    const bool is_square = system_.row_count() == static_cast<int>(unknown_.size());
    const double least = std::sqrt(largest_residual_ / kMostVelocityError);
    return reciprocal_condition_ < (is_square ? std::max(kFlatVelocity, least) : kFlatVelocity);
  }

  double unit_of_rate(int rate) const {
    const bool slides = std::ranges::any_of(network_.joints, [&](const MotionJoint& joint) {
      return joint.rate == rate && joint.motion.kind == ElementaryKind::slide;
    });
    return slides ? network_.length : 1.0;
  }

  // The unknown rates that answer the known ones.
  void complete(std::vector<double>& rates, std::vector<double> left) {
    const int rows = system_.row_count();
    for (const int driven : network_.driven_rates) {
      for (int r = 0; r < rows; ++r) {
        left[at(r)] += system_.jacobian()[at(driven * rows + r)] * rates[at(driven)];
      }
    }
    solve_unknown(left, rates);
  }

  void solve_unknown(std::vector<double> left, std::vector<double>& rates) {
    std::ranges::transform(left, left.begin(), std::negate());
    left.resize(std::max(left.size(), unknown_.size()));
    std::vector<double> x(unknown_.size());
    qr_.solve(left, x);
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
      rates[at(unknown_[i])] = x[i];
    }
  }

  // How much each open motion changes the rates of the freedoms whose speed is given.
  void find_effects(const std::vector<PassiveSpeed>& given) {
    const std::vector<double>& open = qr_.null_vectors();
    const std::vector<double> none(at(network_.rate_count), 0.0);
    std::vector<double> effects;
    for (std::size_t first = 0; first < open.size(); first += unknown_.size()) {
      std::vector<double> rates = none;
      for (std::size_t i = 0; i < unknown_.size(); ++i) {
        rates[at(unknown_[i])] = open[first + i];
      }
      MotionState motion;
      fill_freedoms(rates, none, motion);
      for (const PassiveSpeed& one : given) {
        effects.push_back(motion.rates[at(one.freedom)].value_or(0.0) / unit_of(one));
      }
    }
    const auto count = static_cast<int>(given.size());
    effects_.factor(effects, count, static_cast<int>(open.size() / unknown_.size()), kSize);
  }

  void meet_speeds(const std::vector<PassiveSpeed>& given, std::vector<double>& rates) {
    MotionState motion;
    fill_freedoms(rates, std::vector<double>(rates.size(), 0.0), motion);
    std::vector<double> missed;
    for (const PassiveSpeed& one : given) {
      missed.push_back((one.speed - motion.rates[at(one.freedom)].value_or(0.0)) / unit_of(one));
    }
    add_open(missed, rates);
  }

  void hold_speeds(const std::vector<PassiveSpeed>& given,
                   const std::vector<double>& rates,
                   std::vector<double>& bends) {
    MotionState motion;
    fill_freedoms(rates, bends, motion);
    std::vector<double> missed;
    for (const PassiveSpeed& one : given) {
      missed.push_back(-motion.rate_rates[at(one.freedom)].value_or(0.0) / unit_of(one));
    }
    add_open(missed, bends);
  }

  // Open motions that make up for what the freedoms miss.
  void add_open(const std::vector<double>& missed, std::vector<double>& rates) {
    std::vector<double> shares(at(effects_.columns()));
    effects_.solve(missed, shares);
    const std::vector<double>& open = qr_.null_vectors();
    for (std::size_t k = 0; k < shares.size(); ++k) {
      for (std::size_t i = 0; i < unknown_.size(); ++i) {
        rates[at(unknown_[i])] += shares[k] * open[k * unknown_.size() + i];
      }
    }
  }

  double unit_of(const PassiveSpeed& given) const {
    return mechanism_.topology.freedoms[at(given.freedom)].is_rotation ? 1.0 : network_.length;
  }

  MovingFrames fill(const std::vector<double>& rates,
                    const std::vector<double>& bends,
                    StateDetail detail,
                    MotionState& state) const {
    MovingFrames frames = fill_freedoms(rates, bends, state);
    for (const int frame : network_.frame_of_body) {
      const MovingTwist moving = twist_of(frames[at(frame)], network_.length);
      state.twists.push_back(moving.twist);
      state.twist_rates.push_back(moving.rate);
    }
    if (detail == StateDetail::velocity || reciprocal_condition_ < kFlatAcceleration) {
      state.twist_rates.clear();
      state.rate_rates.clear();
    }
    return frames;
  }

  // Their rates and the derivatives of these.
  MovingFrames fill_freedoms(const std::vector<double>& rates,
                             const std::vector<double>& bends,
                             MotionState& state) const {
    auto frames = system_.moving_frames(configuration_.coordinates, rates, bends);
    state.rates.resize(mechanism_.topology.freedoms.size());
    state.rate_rates.resize(mechanism_.topology.freedoms.size());
    fill_joints(rates, bends, state);
    for (const MeasuredFreedom& one : network_.measures) {
      const Jet position = system_.template position<Jet>(system_.in_sizes(one), frames);
      const double unit = one.measure.is_turn ? 1.0 : network_.length;
      state.rates[at(one.freedom)] = unit * position.first;
      state.rate_rates[at(one.freedom)] = unit * position.second;
    }
    for (const BallFreedoms& ball : network_.balls) {
      const MovingTwist tail = twist_of(frames[at(ball.tail_frame)], network_.length);
      const MovingTwist head = twist_of(frames[at(ball.head_frame)], network_.length);
      for (int i = 0; i < 3; ++i) {
        state.rates[at(ball.first_freedom + i)] = head.twist.angular[i] - tail.twist.angular[i];
        state.rate_rates[at(ball.first_freedom + i)] = head.rate.angular[i] - tail.rate.angular[i];
      }
    }
    return frames;
  }

  void fill_joints(const std::vector<double>& rates,
                   const std::vector<double>& bends,
                   MotionState& state) const {
    for (const MotionJoint& joint : network_.joints) {
      if (joint.freedom >= 0 && joint.coordinate >= 0) {
        const double unit = joint.motion.kind == ElementaryKind::slide ? network_.length : 1.0;
        state.rates[at(joint.freedom)] = unit * rates[at(joint.rate)];
        state.rate_rates[at(joint.freedom)] = unit * bends[at(joint.rate)];
      }
    }
    for (const RollingRow& rolling : network_.rollings) {
      const CouplingTopology& coupling = mechanism_.topology.coupling(rolling.coupling);
      if (coupling.freedom_count != 1) {
        continue;
      }
      double rate = 0.0;
      double bend = 0.0;
      for (std::size_t i = 0; i < rolling.rates.size(); ++i) {
        rate += rolling.freedom_factors[i] * rates[at(rolling.rates[i])];
        bend += rolling.freedom_factors[i] * bends[at(rolling.rates[i])];
      }
      state.rates[at(coupling.first_freedom)] = rate;
      state.rate_rates[at(coupling.first_freedom)] = bend;
    }
  }

  const MotionNetwork& network_;
  const Mechanism& mechanism_;
  ClosureSystem<Frames> system_;
  ClosureParts parts_;
  double reciprocal_condition_ = 1.0;
  double largest_residual_ = 0.0;
  Configuration configuration_;  // in which it stands
  bool has_stood_ = false;
  std::vector<double> matrix_;
  PivotedQr qr_;
  JointErrors errors_;
  bool has_errors_ = false;  // of this configuration, once asked for
  PivotedQr effects_;        // of the open motions on what is given of them
  std::vector<int> unknown_;
};

}  // namespace

struct MotionStates::Solver {
  Solver(const MotionNetwork& network, const Mechanism& mechanism) {
    if (network.space == Space::planar) {
      planar.emplace(network, mechanism);
    } else {
      spatial.emplace(network, mechanism);
    }
  }

  std::optional<StateSolver<PlanarFrames>> planar;
  std::optional<StateSolver<SpatialFrames>> spatial;
};

MotionStates::MotionStates(const MotionNetwork& network, const Mechanism& mechanism)
    : drive_count_(network.driven_rates.size()),
      solver_(std::make_unique<Solver>(network, mechanism)) {}

MotionStates::~MotionStates() = default;

MotionState MotionStates::solve(const Configuration& configuration,
                                const GivenSpeeds& speeds,
                                StateDetail detail) {
  KINESTAT_EXPECTS(speeds.drives.size() == drive_count_);
  return solver_->planar ? solver_->planar->solve_in(configuration, speeds, detail)
                         : solver_->spatial->solve_in(configuration, speeds, detail);
}

std::vector<std::optional<double>> MotionStates::freedom_positions(
    const Configuration& configuration) {
  return solver_->planar ? solver_->planar->freedom_positions_in(configuration)
                         : solver_->spatial->freedom_positions_in(configuration);
}

MotionState MotionStates::solve_bounded(const Configuration& configuration,
                                        const GivenSpeeds& speeds,
                                        StateDetail detail) {
  KINESTAT_EXPECTS(speeds.drives.size() == drive_count_);
  return solver_->planar ? solver_->planar->solve_bounded_in(configuration, speeds, detail)
                         : solver_->spatial->solve_bounded_in(configuration, speeds, detail);
}

}  // namespace kinestat
