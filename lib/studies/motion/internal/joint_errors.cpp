#include "studies/motion/internal/joint_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/internal/motion_limits.hpp"

namespace kinestat {

namespace {

// A frame follows from the one before by some ten operations.
constexpr double kRoundingOfFrame = 8.0 * kEpsilon;

int count_of_rates(const MotionJoint& joint) {
  return joint.coordinate < 0 ? 0 : joint.motion.kind == ElementaryKind::ball ? 3 : 1;
}

double unit_of_motion(const MotionNetwork& network, bool is_turn) {
  return is_turn ? 1.0 : network.length;
}

double sum_of_sizes(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0, [](double sum, double value) {
    return sum + std::abs(value);
  });
}

// How fast frames move that follow each other.
struct Speeds {
  double rate = 0.0;
  double bend = 0.0;

  void add(double rate_here, double bend_here) {
    rate += std::abs(rate_here);
    bend += std::abs(bend_here);
  }

  // Of a first and of a second derivative.
  double of_order(int order) const { return order == 1 ? rate : bend + rate * rate; }
};

}  // namespace

// From the ground to a frame.
struct JointErrors::Path {
  double rounding = kRoundingOfFrame;
  Speeds all;
  Speeds turns;

  // Of a rate or its derivative, where a rounding of a frame counts by its `arm`.
  double rounded(int order, bool is_angle) const {
    return rounding * (order == 0 ? 1.0 : (is_angle ? turns : all).of_order(order));
  }
};

JointErrors::JointErrors(const FactoredClosure& closure,
                         std::span<const double> coordinates,
                         bool is_singular)
    : closure_(closure),
      rows_(closure.residuals.size()),
      screw_(closure.network.space == Space::planar ? 3 : 6) {
  const MotionNetwork& network = closure_.network;
  sizes_.assign(at(network.rate_count), 0.0);
  is_turn_.assign(sizes_.size(), true);
  paths_.resize(1);
  for (const MotionJoint& joint : network.joints) {
    const bool is_ball = joint.motion.kind == ElementaryKind::ball;
    for (int i = 0; i < count_of_rates(joint); ++i) {
      const std::size_t rate = at(joint.rate + i);
      sizes_[rate] = is_ball ? 1.0 : std::abs(coordinates[at(joint.coordinate)]);
      is_turn_[rate] = joint.motion.kind != ElementaryKind::slide;
    }
    Path path;
    path.rounding += paths_[at(joint.parent)].rounding;
    paths_.push_back(path);
  }
  find_shares(is_singular);
  find_places(is_singular);
}

JointErrors::~JointErrors() = default;

// What one of each source moves the joints by.
void JointErrors::find_shares(bool is_singular) {
  const std::size_t unknown = closure_.unknown.size();
  const std::vector<double>& open = closure_.qr.null_vectors();
  drives_ = rows_ + 1;
  open_ = drives_ + closure_.network.driven_rates.size();
  roots_ = open_ + (unknown == 0 ? 0 : open.size() / unknown);
  sources_ = roots_ + (is_singular ? unknown : 0);
  columns_ = sources_ + 2;
  shares_.assign(sizes_.size() * columns_, 0.0);
  std::vector<double> unit(std::max(rows_, unknown), 0.0);
  std::vector<double> answer(unknown);
  for (std::size_t r = 0; r < rows_ && unknown > 0; ++r) {
    unit[r] = 1.0;
    closure_.qr.solve(unit, answer);
    unit[r] = 0.0;
    for (std::size_t i = 0; i < unknown; ++i) {
      double* share = &shares_[at(closure_.unknown[i]) * columns_];
      share[r] = answer[i];
      share[rows_] += answer[i] * closure_.residuals[r];
      for (std::size_t s = drives_; s < open_; ++s) {
        share[s] -= answer[i] * factor(r, at(closure_.network.driven_rates[s - drives_]));
      }
    }
  }
  for (std::size_t s = drives_; s < open_; ++s) {
    shares_[at(closure_.network.driven_rates[s - drives_]) * columns_ + s] = 1.0;
  }
  for (std::size_t i = 0; i < unknown; ++i) {
    double* share = &shares_[at(closure_.unknown[i]) * columns_];
    for (std::size_t s = open_; s < roots_; ++s) {
      share[s] = open[(s - open_) * unknown + i];
    }
    if (is_singular) {
      share[roots_ + i] = 1.0;
    }
  }
}

void JointErrors::find_places(bool is_singular) {
  for (int order = 0; order < kOrders; ++order) {
    amounts_[at(order)].assign(sources_, 0.0);
    joints_[at(order)].assign(sizes_.size(), 0.0);
  }
  std::vector<double>& amounts = amounts_[0];
  for (std::size_t r = 0; r < rows_; ++r) {
    const RatesOfRow& row = closure_.rates_of_rows[r];
    amounts[r] = row.rounds * (paths_[at(row.tail_frame)].rounding +
                               paths_[at(row.head_frame)].rounding);
    for (const int rate : row.all) {
      const double by_angle = is_turn_[at(rate)] ? row.by_angle : 0.0;
      amounts[r] += 2.0 * kEpsilon * (std::abs(factor(r, at(rate))) + by_angle) * sizes_[at(rate)];
    }
  }
  amounts[rows_] = 1.0;
  for (std::size_t s = drives_; s < open_; ++s) {
    amounts[s] = 2.0 * kEpsilon * sizes_[at(closure_.network.driven_rates[s - drives_])];
  }
  if (is_singular) {
    std::fill(amounts.begin() + static_cast<std::ptrdiff_t>(roots_),
              amounts.end(),
              std::sqrt(kEpsilon));
  }
  find_joints(0, sizes_);
}

// Of the sources, and of what rounds in the values themselves.
void JointErrors::find_joints(int order, std::span<const double> values) {
  for (std::size_t rate = 0; rate < sizes_.size(); ++rate) {
    double sum = 2.0 * kEpsilon * std::abs(values[rate]);
    for (std::size_t s = 0; s < sources_; ++s) {
      sum += std::abs(shares_[rate * columns_ + s]) * amounts_[at(order)][s];
    }
    joints_[at(order)][rate] = sum;
  }
}

void JointErrors::move_frames(const JointMotion& motion) {
  const MotionNetwork& network = closure_.network;
  const std::size_t block = screw_ * columns_;
  for (std::size_t rate = 0; rate < sizes_.size(); ++rate) {
    shares_[rate * columns_ + sources_] = motion.rates[rate];
    shares_[rate * columns_ + sources_ + 1] = motion.bends[rate];
  }
  moved_.assign(paths_.size() * block, Jet());
  for (std::size_t j = 0; j < network.joints.size(); ++j) {
    const MotionJoint& joint = network.joints[j];
    const Path& before = paths_[at(joint.parent)];
    Path& path = paths_[j + 1];
    path.all = before.all;
    path.turns = before.turns;
    Jet* moved = &moved_[(j + 1) * block];
    std::copy_n(&moved_[at(joint.parent) * block], block, moved);
    for (int k = 0; k < count_of_rates(joint); ++k) {
      const std::size_t rate = at(joint.rate + k);
      path.all.add(motion.rates[rate], motion.bends[rate]);
      if (is_turn_[rate]) {
        path.turns.add(motion.rates[rate], motion.bends[rate]);
      }
      for (std::size_t i = 0; i < screw_; ++i) {
        const Jet& lever = motion.levers.screws[rate * screw_ + i];
        for (std::size_t c = 0; c < columns_; ++c) {
          const double share = shares_[rate * columns_ + c];
          Jet& sum = moved[i * columns_ + c];
          sum.value += share * lever.value;
          sum.first += share * lever.first;
          sum.second += share * lever.second;
        }
      }
    }
  }
}

// What a wrench between two frames measures of each source.
void JointErrors::measure(const Jet* wrench, int tail_frame, int head_frame) {
  const std::size_t block = screw_ * columns_;
  measured_.assign(sources_, Jet());
  for (std::size_t i = 0; i < screw_; ++i) {
    const Jet w = wrench[i];
    const Jet* tail = &moved_[at(tail_frame) * block + i * columns_];
    const Jet* head = &moved_[at(head_frame) * block + i * columns_];
    for (std::size_t s = 0; s < sources_; ++s) {
      measured_[s] += w * (head[s] - tail[s]);
    }
  }
}

// Of a position and its derivatives that change with the sources so.
JointErrors::Orders JointErrors::sum(const Jet* changes) const {
  Orders result = {};
  for (std::size_t s = 0; s < sources_; ++s) {
    const double value = std::abs(changes[s].value);
    const double first = std::abs(changes[s].first);
    result[0] += value * amounts_[0][s];
    result[1] += first * amounts_[0][s] + value * amounts_[1][s];
    result[2] += std::abs(changes[s].second) * amounts_[0][s] + 2.0 * first * amounts_[1][s] +
                 value * amounts_[2][s];
  }
  return result;
}

// Open motions are found by reflections that mix the rows: what all of them round may be in each.
double JointErrors::mixed(std::span<const double> sizes) const {
  if (closure_.qr.rank() == closure_.qr.columns()) {
    return 0.0;
  }
  double sum = 0.0;
  for (std::size_t rate = 0; rate < sizes.size(); ++rate) {
    sum += sum_of_sizes(closure_.jacobian.subspan(rate * rows_, rows_)) * std::abs(sizes[rate]);
  }
  return kRoundingOfFrame * sum;
}

// What rounds in a row where rates or their derivatives are found.
double JointErrors::rounding(std::size_t r, const JointMotion& motion, int order) const {
  const RatesOfRow& row = closure_.rates_of_rows[r];
  const std::span<const double> values = order == 1 ? motion.rates : motion.bends;
  const double solved = 2.0 * kEpsilon * sum_of_sizes(values);
  if (row.rounds == 0.0) {
    double sum = solved;
    for (const int rate : row.all) {
      sum += kRoundingOfFrame * std::abs(factor(r, at(rate)) * values[at(rate)]);
    }
    return sum;
  }
  const Path& tail = paths_[at(row.tail_frame)];
  const Path& head = paths_[at(row.head_frame)];
  Speeds between;
  double place = 0.0;
  double rate_error = 0.0;
  for (const int rate : row.all) {
    if (is_turn_[at(rate)] || !row.is_angle) {
      between.add(motion.rates[at(rate)], motion.bends[at(rate)]);
    }
    place += joints_[0][at(rate)];
    rate_error += joints_[1][at(rate)];
  }
  const double second = place * place * between.of_order(order);
  if (order == 1) {
    return row.rounds * (solved + (tail.rounding + head.rounding) * between.rate + second);
  }
  return row.rounds *
         (solved + tail.rounded(order, row.is_angle) + head.rounded(order, row.is_angle) + second +
          2.0 * place * rate_error * between.rate + rate_error * rate_error);
}

void JointErrors::find_rates(const JointMotion& motion) {
  std::vector<Jet> changes;
  for (std::size_t r = 0; r < rows_; ++r) {
    const RatesOfRow& row = closure_.rates_of_rows[r];
    if (row.rounds > 0.0) {
      measure(&motion.levers.rows[r * screw_], row.tail_frame, row.head_frame);
      changes.insert(changes.end(), measured_.begin(), measured_.end());
    } else {
      changes.insert(changes.end(), sources_, Jet());
    }
  }
  for (int order = 1; order < kOrders; ++order) {
    const std::span<const double> values = order == 1 ? motion.rates : motion.bends;
    std::vector<double>& amounts = amounts_[at(order)];
    std::fill(amounts.begin(), amounts.end(), 0.0);
    std::ranges::copy(order == 1 ? motion.driven_errors : motion.driven_bend_errors,
                      amounts.begin() + static_cast<std::ptrdiff_t>(drives_));
    const double mixed_rows = mixed(values);
    std::vector<double> of_rows;
    for (std::size_t r = 0; r < rows_; ++r) {
      // The row as it stands balances the errors that are looked for.
      Jet* change = &changes[r * sources_];
      for (std::size_t s = 0; s < sources_; ++s) {
        change[s].value = 0.0;
      }
      of_rows.push_back(mixed_rows + rounding(r, motion, order) + sum(change)[at(order)]);
    }
    std::ranges::copy(of_rows, amounts.begin());
    find_joints(order, values);
    add_open(order, values);
  }
}

// An open motion that meets given speeds is off by what these are off where it moves.
void JointErrors::add_open(int order, std::span<const double> values) {
  for (std::size_t s = open_; s < roots_; ++s) {
    double share = 0.0;
    for (const int rate : closure_.unknown) {
      share += std::abs(shares_[at(rate) * columns_ + s]) *
               (joints_[at(order)][at(rate)] + kRoundingOfFrame * std::abs(values[at(rate)]));
    }
    amounts_[at(order)][s] = share;
  }
  find_joints(order, values);
}

// The twist of a body follows from how its pose changes: it is off by what that is off, seen from
// the body. In the plane axes do not turn.
BodyBounds JointErrors::bounds_of(int frame) const {
  const std::size_t turns = screw_ / 2;
  const Path& path = paths_[at(frame)];
  std::array<Orders, 2> errors = {};   // of angles and lengths
  std::array<Orders, 2> speeds = {};   // likewise, the first being nothing
  for (std::size_t i = 0; i < screw_; ++i) {
    const std::size_t kind = i < turns ? 0 : 1;
    const Jet* changes = &moved_[(at(frame) * screw_ + i) * columns_];
    const Orders here = sum(changes);
    const double speed = changes[sources_].value;
    const double bend = changes[sources_].first + changes[sources_ + 1].value;
    for (std::size_t order = 0; order < kOrders; ++order) {
      errors[kind][order] = std::max(errors[kind][order], here[order]);
    }
    speeds[kind][1] += std::abs(speed);
    speeds[kind][2] += std::abs(bend);
  }
  const auto& [turn, shift] = errors;
  const auto& [angular, linear] = speeds;
  const double turning = turns == 1 ? 0.0 : 1.0;
  const auto frames = [&](int order) { return path.rounded(order, false); };
  const double reach = closure_.reach;
  const double length = closure_.network.length;
  return {
      .turn = turn[0] + frames(0),
      .shift = length * (shift[0] + reach * frames(0)),
      .angular = turn[1] + turning * angular[1] * turn[0] + frames(1),
      .linear =
          length * (shift[1] + angular[1] * shift[0] + linear[1] * turn[0] + reach * frames(1)),
      .angular_rate =
          turn[2] + turning * (angular[2] * turn[0] + angular[1] * turn[1]) + frames(2),
      .linear_rate = length * (shift[2] + angular[2] * shift[0] + linear[2] * turn[0] +
                               angular[1] * shift[1] + linear[1] * turn[1] + reach * frames(2))};
}

StateBounds JointErrors::bounds(const JointMotion& motion, const Topology& topology) {
  move_frames(motion);
  find_rates(motion);
  StateBounds result;
  for (auto* list : {&result.positions, &result.rates, &result.rate_rates}) {
    list->assign(topology.freedoms.size(), 0.0);
  }
  const double rates = sum_of_sizes(motion.rates);
  const double bends = sum_of_sizes(motion.bends);
  result.rate_rounding = kRoundingOfRates * rates;
  result.rate_rate_rounding = kRoundingOfRates * (bends + rates * rates);
  result.reach = closure_.reach * closure_.network.length;
  for (const int frame : closure_.network.frame_of_body) {
    const BodyBounds one = bounds_of(frame);
    result.bodies.push_back(one);
    result.place =
        std::max(result.place, one.shift / closure_.network.length + closure_.reach * one.turn);
  }
  fill_joints(motion, topology, result);
  fill_measures(motion, result);
  return result;
}

void JointErrors::fill_joints(const JointMotion& motion,
                              const Topology& topology,
                              StateBounds& result) const {
  const MotionNetwork& network = closure_.network;
  const auto add = [&](std::size_t freedom, std::size_t rate, double unit) {
    result.positions[freedom] += unit * joints_[0][rate];
    result.rates[freedom] += unit * joints_[1][rate];
    result.rate_rates[freedom] += unit * joints_[2][rate];
  };
  for (const MotionJoint& joint : network.joints) {
    if (joint.freedom >= 0 && joint.coordinate >= 0 &&
        joint.motion.kind != ElementaryKind::ball) {
      add(at(joint.freedom),
          at(joint.rate),
          unit_of_motion(network, joint.motion.kind != ElementaryKind::slide));
    }
  }
  for (const RollingRow& rolling : network.rollings) {
    const CouplingTopology& coupling = topology.coupling(rolling.coupling);
    for (std::size_t i = 0; coupling.freedom_count == 1 && i < rolling.rates.size(); ++i) {
      const double size = std::abs(rolling.freedom_factors[i]);
      const std::size_t rate = at(rolling.rates[i]);
      const std::size_t freedom = at(coupling.first_freedom);
      add(freedom, rate, size);
      result.positions[freedom] += size * kRoundingOfFrame * sizes_[rate];
      result.rates[freedom] += size * kRoundingOfFrame * std::abs(motion.rates[rate]);
      result.rate_rates[freedom] += size * kRoundingOfFrame * std::abs(motion.bends[rate]);
    }
  }
}

void JointErrors::fill_measures(const JointMotion& motion, StateBounds& result) {
  const MotionNetwork& network = closure_.network;
  for (std::size_t m = 0; m < network.measures.size(); ++m) {
    const MeasuredFreedom& one = network.measures[m];
    measure(&motion.levers.measures[m * screw_], one.tail_frame, one.head_frame);
    Orders errors = sum(measured_.data());
    const double arm = one.measure.is_turn ? 1.0 : closure_.reach;
    const double unit = unit_of_motion(network, one.measure.is_turn);
    for (int order = 0; order < kOrders; ++order) {
      const auto rounded = [&](int frame) {
        return paths_[at(frame)].rounded(order, one.measure.is_turn);
      };
      errors[at(order)] =
          unit * (errors[at(order)] + arm * (rounded(one.tail_frame) + rounded(one.head_frame)));
    }
    const std::size_t f = at(one.freedom);
    result.positions[f] = errors[0];
    result.rates[f] = errors[1];
    result.rate_rates[f] = errors[2];
  }
  for (const BallFreedoms& ball : network.balls) {
    const BodyBounds tail = bounds_of(ball.tail_frame);
    const BodyBounds head = bounds_of(ball.head_frame);
    for (int i = 0; i < 3; ++i) {
      const std::size_t f = at(ball.first_freedom + i);
      result.rates[f] = tail.angular + head.angular;
      result.rate_rates[f] = tail.angular_rate + head.angular_rate;
    }
  }
}

}  // namespace kinestat
