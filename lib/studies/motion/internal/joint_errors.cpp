#include "studies/motion/internal/joint_errors.hpp"

#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/internal/motion_limits.hpp"

namespace kinestat {

namespace {

double unit_of_motion(const MotionNetwork& network, bool is_turn) {
  return is_turn ? 1.0 : network.length;
}

void add_product(double factor, const double* values, double* sums, std::size_t count) {
  if (factor == 0.0) {
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    sums[i] += factor * values[i];
  }
}

}  // namespace

JointErrors::JointErrors(const MotionNetwork& network)
    : network_(network), screw_(network.space == Space::planar ? 3 : 6), paths_(1) {
  is_turn_.assign(at(network.rate_count), true);
  for (const MotionJoint& joint : network.joints) {
    for (int i = 0; i < count_of_rates(joint); ++i) {
      is_turn_[at(joint.rate + i)] = joint.motion.kind != ElementaryKind::slide;
    }
    FramePath path;
    path.rounding += paths_[at(joint.parent)].rounding;
    paths_.push_back(path);
  }
}

void JointErrors::stand_in(const FactoredClosure& closure,
                           std::span<const double> coordinates,
                           bool is_singular) {
  closure_.emplace(closure);
  rows_ = closure.residuals.size();
  sizes_.assign(is_turn_.size(), 0.0);
  for (const MotionJoint& joint : network_.joints) {
    const bool is_ball = joint.motion.kind == ElementaryKind::ball;
    for (int i = 0; i < count_of_rates(joint); ++i) {
      sizes_[at(joint.rate + i)] = is_ball ? 1.0 : std::abs(coordinates[at(joint.coordinate)]);
    }
  }
  find_shares(is_singular);
  find_places(is_singular);
}

void JointErrors::move_frames(const JointMotion& motion) {
  const std::size_t block = screw_ * columns_;
  for (std::size_t rate = 0; rate < sizes_.size(); ++rate) {
    shares_[rate * columns_ + sources_] = motion.rates[rate];
    shares_[rate * columns_ + sources_ + 1] = motion.bends[rate];
  }
  for (std::vector<double>& moved : moved_) {
    moved.resize(paths_.size() * block);
    std::fill_n(moved.begin(), block, 0.0);
  }
  for (std::size_t j = 0; j < network_.joints.size(); ++j) {
    const MotionJoint& joint = network_.joints[j];
    const FramePath& before = paths_[at(joint.parent)];
    FramePath& path = paths_[j + 1];
    path.all = before.all;
    path.turns = before.turns;
    for (std::size_t order = 0; order < orders_; ++order) {
      std::vector<double>& moved = moved_[order];
      std::copy_n(&moved[at(joint.parent) * block], block, &moved[(j + 1) * block]);
    }
    for (int k = 0; k < count_of_rates(joint); ++k) {
      const std::size_t rate = at(joint.rate + k);
      path.all.add(motion.rates[rate], motion.bends[rate]);
      if (is_turn_[rate]) {
        path.turns.add(motion.rates[rate], motion.bends[rate]);
      }
      for (std::size_t i = 0; i < screw_; ++i) {
        const Jet& lever = motion.levers.screws[rate * screw_ + i];
        const Orders factors = {lever.value, lever.first, lever.second};
        for (std::size_t order = 0; order < orders_; ++order) {
          add_product(factors[order],
                      &shares_[rate * columns_],
                      &moved_[order][(j + 1) * block + i * columns_],
                      columns_);
        }
      }
    }
  }
}

// What a wrench between two frames measures of each source.
void JointErrors::measure(const Jet* wrench, int tail_frame, int head_frame) {
  const std::size_t block = screw_ * columns_;
  for (std::size_t order = 0; order < orders_; ++order) {
    measured_[order].assign(sources_, 0.0);
  }
  apart_.resize(sources_);
  for (std::size_t i = 0; i < screw_; ++i) {
    const Jet& w = wrench[i];
    // (w g)'' = w'' g + 2 w' g' + w g''
    const std::array<Orders, kOrders> factors = {
        {{w.value, w.first, w.second}, {w.value, 2.0 * w.first, 0.0}, {w.value, 0.0, 0.0}}};
    for (std::size_t order = 0; order < orders_; ++order) {
      const double* tail = &moved_[order][at(tail_frame) * block + i * columns_];
      const double* head = &moved_[order][at(head_frame) * block + i * columns_];
      for (std::size_t s = 0; s < sources_; ++s) {
        apart_[s] = head[s] - tail[s];
      }
      for (std::size_t more = 0; order + more < orders_; ++more) {
        add_product(factors[order][more], apart_.data(), measured_[order + more].data(), sources_);
      }
    }
  }
}

// Of a position and its derivatives that change with the sources so: by g, g' and g''. The errors
// of rates count for the second derivative by g', twice.
JointErrors::Orders JointErrors::sum(const Changes& changes) const {
  using Values = Eigen::Map<const Eigen::ArrayXd>;
  const auto count = static_cast<Eigen::Index>(sources_);
  const auto of = [&](std::size_t order) { return Values(changes[order], count).abs(); };
  const auto amount = [&](std::size_t order) { return Values(amounts_[order].data(), count); };
  Orders result = {};
  result[0] = (of(0) * amount(0)).sum();
  if (orders_ > 1) {
    result[1] = (of(1) * amount(0) + of(0) * amount(1)).sum();
  }
  if (orders_ > 2) {
    const Values again(changes[3], count);
    result[2] = (of(2) * amount(0) + (Values(changes[1], count) + again).abs() * amount(1) +
                 of(0) * amount(2))
                    .sum();
  }
  return result;
}

// Open motions are found by reflections that mix the rows: what all of them round may be in each.
double JointErrors::mixed(std::span<const double> sizes) const {
  if (closure_->qr.rank() == closure_->qr.columns()) {
    return 0.0;
  }
  double sum = 0.0;
  for (std::size_t rate = 0; rate < sizes.size(); ++rate) {
    sum += sum_of_sizes(closure_->jacobian.subspan(rate * rows_, rows_)) * std::abs(sizes[rate]);
  }
  return kRoundingOfFrame * sum;
}

// What rounds in a row where rates or their derivatives are found.
double JointErrors::rounding(std::size_t r, const JointMotion& motion, int order) const {
  const RatesOfRow& row = closure_->rates_of_rows[r];
  const std::span<const double> values = order == 1 ? motion.rates : motion.bends;
  const double solved = 2.0 * kEpsilon * sum_of_sizes(values);
  if (row.rounds == 0.0) {
    double sum = solved;
    for (const int rate : row.all) {
      sum += kRoundingOfFrame * std::abs(factor(r, at(rate)) * values[at(rate)]);
    }
    return sum;
  }
  const FramePath& tail = paths_[at(row.tail_frame)];
  const FramePath& head = paths_[at(row.head_frame)];
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
  const double factors = tail.rounding + head.rounding;
  if (row.is_linear) {
    return row.rounds * (solved + factors * (order == 1 ? between.rate : between.bend));
  }
  const double second = place * place * between.of_order(order);
  if (order == 1) {
    return row.rounds * (solved + factors * between.rate + second);
  }
  return row.rounds *
         (solved + tail.rounded(order, row.is_angle) + head.rounded(order, row.is_angle) + second +
          2.0 * place * rate_error * between.rate + rate_error * rate_error);
}

// The errors of the joints balance in the row, as it stands, what they leave by its changes.
void JointErrors::find_rates(const JointMotion& motion) {
  for (std::vector<double>& changes : changes_) {  // those of no order that is asked for stay zero
    changes.assign(rows_ * sources_, 0.0);
  }
  for (std::size_t r = 0; orders_ > 1 && r < rows_; ++r) {
    const RatesOfRow& row = closure_->rates_of_rows[r];
    if (row.rounds > 0.0 && !row.is_linear) {
      measure(&motion.levers.rows[r * screw_], row.tail_frame, row.head_frame);
      for (std::size_t order = 1; order < orders_; ++order) {
        std::ranges::copy(measured_[order], &changes_[order][r * sources_]);
      }
    }
  }
  for (std::size_t order = 1; order < orders_; ++order) {
    const std::span<const double> values = order == 1 ? motion.rates : motion.bends;
    std::vector<double>& amounts = amounts_[order];
    std::fill(amounts.begin(), amounts.end(), 0.0);
    std::ranges::copy(order == 1 ? motion.driven_errors : motion.driven_bend_errors,
                      amounts.begin() + static_cast<std::ptrdiff_t>(drives_));
    const double mixed_rows = mixed(values);
    for (std::size_t r = 0; r < rows_; ++r) {
      const std::size_t first = r * sources_;
      const Orders left = sum(at_place(changes_, first));
      amounts[r] = mixed_rows + rounding(r, motion, static_cast<int>(order)) + left[order];
    }
    find_joints(static_cast<int>(order), values);
    add_open(static_cast<int>(order), values);
  }
}

// An open motion that meets given speeds is off by what these are off where it moves.
void JointErrors::add_open(int order, std::span<const double> values) {
  for (std::size_t s = open_; s < roots_; ++s) {
    double share = 0.0;
    for (const int rate : closure_->unknown) {
      share += std::abs(shares_[at(rate) * columns_ + s]) *
               (joints_[at(order)][at(rate)] + kRoundingOfFrame * std::abs(values[at(rate)]));
    }
    amounts_[at(order)][s] = share;
  }
  find_joints(order, values);
}

// x += the part of the bracket of two screws, the first of which is given.
void JointErrors::add_bracket(std::span<const double> screw,
                              const double* sources,
                              double* sums) const {
  const auto add = [&](std::size_t i, std::size_t j, double factor) {
    add_product(factor, sources + j * columns_, sums + i * columns_, sources_);
  };
  if (screw_ == 3) {
    add(1, 0, screw[2]);
    add(1, 2, -screw[0]);
    add(2, 0, -screw[1]);
    add(2, 1, screw[0]);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    add(i, k, screw[j]);
    add(i, j, -screw[k]);
    add(i + 3, k + 3, screw[j]);
    add(i + 3, j + 3, -screw[k]);
    add(i + 3, k, screw[j + 3]);
    add(i + 3, j, -screw[k + 3]);
  }
}

// With X the change of the pose of a body, its twist V changes by X' - V x X, and the derivative A
// of that by X'' - A x X - V x X'.
BodyBounds JointErrors::bounds_of(int frame) {
  const std::size_t block = screw_ * columns_;
  const std::size_t begin = at(frame) * block;
  std::array<double, 6> against = {};
  std::array<double, 6> bent_against = {};
  for (std::size_t i = 0; i < screw_ && orders_ > 1; ++i) {
    const std::size_t rates = begin + i * columns_ + sources_;
    against[i] = -moved_[0][rates];
    bent_against[i] = -moved_[1][rates] - moved_[0][rates + 1];
  }
  for (std::size_t order = 1; order < orders_; ++order) {
    changes_[order].assign(&moved_[order][begin], &moved_[order][begin] + block);
    add_bracket(against, &moved_[order - 1][begin], changes_[order].data());
  }
  if (orders_ > 2) {
    add_bracket(bent_against, &moved_[0][begin], changes_[2].data());
  }
  // Null of an order that is not asked for.
  const auto piece = [&](const std::vector<double>& values, std::size_t order, std::size_t first) {
    return order < orders_ ? values.data() + first : nullptr;
  };
  std::array<Orders, 2> errors = {};  // of angles and lengths
  for (std::size_t i = 0; i < screw_; ++i) {
    const std::size_t first = i * columns_;
    const Orders here = sum({&moved_[0][begin + first],
                             piece(changes_[1], 1, first),
                             piece(changes_[2], 2, first),
                             piece(moved_[1], 2, begin + first)});
    for (std::size_t order = 0; order < kOrders; ++order) {
      double& error = errors[i < screw_ / 2 ? 0 : 1][order];
      error = std::max(error, here[order]);
    }
  }
  const Orders& turn = errors[0];
  const Orders& shift = errors[1];
  const auto rounded = [&](int order) { return paths_[at(frame)].rounded(order, false); };
  const auto length_of = [&](int order) {
    return network_.length * (shift[at(order)] + closure_->reach * rounded(order));
  };
  return {.turn = turn[0] + rounded(0),
          .shift = length_of(0),
          .angular = turn[1] + rounded(1),
          .linear = length_of(1),
          .angular_rate = turn[2] + rounded(2),
          .linear_rate = length_of(2)};
}

StateBounds JointErrors::bounds(const JointMotion& motion, const Topology& topology) {
  const bool moves = sum_of_sizes(motion.rates) + sum_of_sizes(motion.driven_errors) > 0.0;
  orders_ = motion.is_bent ? 3 : moves ? 2 : 1;
  for (std::size_t order = 1; order < kOrders; ++order) {
    std::ranges::fill(joints_[order], 0.0);
  }
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
  result.reach = closure_->reach * network_.length;
  for (const int frame : network_.frame_of_body) {
    const BodyBounds one = bounds_of(frame);
    result.bodies.push_back(one);
    result.place = std::max(result.place, one.shift / network_.length + closure_->reach * one.turn);
  }
  fill_joints(motion, topology, result);
  fill_measures(motion, result);
  return result;
}

void JointErrors::fill_joints(const JointMotion& motion,
                              const Topology& topology,
                              StateBounds& result) const {
  const auto add = [&](std::size_t freedom, std::size_t rate, double unit) {
    result.positions[freedom] += unit * joints_[0][rate];
    result.rates[freedom] += unit * joints_[1][rate];
    result.rate_rates[freedom] += unit * joints_[2][rate];
  };
  for (const MotionJoint& joint : network_.joints) {
    if (joint.freedom >= 0 && joint.coordinate >= 0 && joint.motion.kind != ElementaryKind::ball) {
      add(at(joint.freedom),
          at(joint.rate),
          unit_of_motion(network_, joint.motion.kind != ElementaryKind::slide));
    }
  }
  for (const RollingRow& rolling : network_.rollings) {
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
  for (std::size_t m = 0; m < network_.measures.size(); ++m) {
    const MeasuredFreedom& one = network_.measures[m];
    measure(&motion.levers.measures[m * screw_], one.tail_frame, one.head_frame);
    Orders errors = sum(at_place(measured_, 0));
    const double arm = one.measure.is_turn ? 1.0 : closure_->reach;
    const double unit = unit_of_motion(network_, one.measure.is_turn);
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
  const auto body_of = [&](int frame) {
    const auto body = std::ranges::find(network_.frame_of_body, frame);
    return body == network_.frame_of_body.end()
               ? bounds_of(frame)
               : result.bodies[static_cast<std::size_t>(body - network_.frame_of_body.begin())];
  };
  for (const BallFreedoms& ball : network_.balls) {
    const BodyBounds tail = body_of(ball.tail_frame);
    const BodyBounds head = body_of(ball.head_frame);
    for (int i = 0; i < 3; ++i) {
      const std::size_t f = at(ball.first_freedom + i);
      result.rates[f] = tail.angular + head.angular;
      result.rate_rates[f] = tail.angular_rate + head.angular_rate;
    }
  }
}

}  // namespace kinestat
