#include "studies/motion/internal/joint_errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
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

}  // namespace

// Along a path of joints: how far places and rates are off together, and how large they are.
struct JointErrors::Sums {
  double joints = 0.0;               // of where the joints stand
  double frames = kRoundingOfFrame;  // of the frames that are made from these
  double rate = 0.0;
  double rate_error = 0.0;
  double bend = 0.0;
  double bend_error = 0.0;

  double place() const { return joints + frames; }
};

JointErrors::JointErrors(const FactoredClosure& closure,
                         std::span<const double> coordinates,
                         bool is_singular)
    : closure_(closure), rows_(static_cast<int>(closure.residuals.size())) {
  const std::size_t count = at(closure.network.rate_count);
  for (auto* list : {&coordinates_, &places_, &rates_, &rate_errors_, &bends_, &bend_errors_}) {
    list->assign(count, 0.0);
  }
  invert();
  find_places(coordinates, is_singular);
}

bool JointErrors::is_rolling(int row) const {
  return row >= rows_ - static_cast<int>(closure_.network.rollings.size());
}

void JointErrors::invert() {
  const std::size_t columns = closure_.unknown.size();
  inverse_.assign(columns * at(rows_), 0.0);
  if (columns == 0) {
    return;
  }
  std::vector<double> unit(std::max(at(rows_), columns), 0.0);
  for (int r = 0; r < rows_; ++r) {
    unit[at(r)] = 1.0;
    const std::span<double> column(inverse_.data() + at(r) * columns, columns);
    closure_.qr.solve(unit, column);
    unit[at(r)] = 0.0;
  }
}

// What rows that are off by so much leave uncertain of the unknown, one a rate.
std::vector<double> JointErrors::carried(const std::vector<double>& rows) const {
  std::vector<double> result(places_.size(), 0.0);
  const std::size_t columns = closure_.unknown.size();
  for (int r = 0; r < rows_; ++r) {
    for (std::size_t i = 0; i < columns; ++i) {
      result[at(closure_.unknown[i])] += std::abs(inverse_[at(r) * columns + i]) * rows[at(r)];
    }
  }
  return result;
}

void JointErrors::find_places(std::span<const double> coordinates, bool is_singular) {
  for (const MotionJoint& joint : closure_.network.joints) {
    const bool is_ball = joint.motion.kind == ElementaryKind::ball;
    for (int i = 0; i < count_of_rates(joint); ++i) {
      coordinates_[at(joint.rate + i)] =
          is_ball ? 1.0 : std::abs(coordinates[at(joint.coordinate)]);
    }
  }
  std::vector<double> rounding(at(rows_), 0.0);
  for (int r = 0; r < rows_; ++r) {
    const RatesOfRow& rates = closure_.rates_of_rows[at(r)];
    for (const int rate : rates.all) {
      const double factor = std::ranges::count(rates.steady, rate) > 0
                                ? std::abs(closure_.jacobian[at(rate * rows_ + r)])
                                : closure_.spread;
      const double frame = is_rolling(r) ? 0.0 : closure_.reach * kRoundingOfFrame;
      rounding[at(r)] += factor * 2.0 * kEpsilon * coordinates_[at(rate)] + frame;
    }
  }
  places_ = carried(rounding);
  const std::size_t columns = closure_.unknown.size();
  std::vector<double> correction(columns, 0.0);
  for (int r = 0; r < rows_; ++r) {
    for (std::size_t i = 0; i < columns; ++i) {
      correction[i] += inverse_[at(r) * columns + i] * closure_.residuals[at(r)];
    }
  }
  for (std::size_t i = 0; i < columns; ++i) {
    double& place = places_[at(closure_.unknown[i])];
    place += std::abs(correction[i]) + (is_singular ? std::sqrt(kEpsilon) : 0.0);
  }
  for (std::size_t rate = 0; rate < places_.size(); ++rate) {
    places_[rate] += 2.0 * kEpsilon * coordinates_[rate];
  }
}

// Of the joints that change the levers of a row.
JointErrors::Sums JointErrors::sums_of(const RatesOfRow& rates) const {
  Sums sums;
  for (const int rate : rates.all) {
    if (std::ranges::count(rates.steady, rate) > 0) {
      continue;
    }
    sums.joints += places_[at(rate)];
    sums.frames += kRoundingOfFrame;
    sums.rate += rates_[at(rate)];
    sums.rate_error += rate_errors_[at(rate)];
    sums.bend += bends_[at(rate)];
    sums.bend_error += bend_errors_[at(rate)];
  }
  return sums;
}

// What rounds where the levers are constant: of teeth they are given, of pulleys found in frames.
double JointErrors::steady_part(int row, const std::vector<double>& values) const {
  const double frame = is_rolling(row) ? 0.0 : closure_.reach;
  double sum = 0.0;
  for (const int rate : closure_.rates_of_rows[at(row)].steady) {
    sum += (std::abs(closure_.jacobian[at(rate * rows_ + row)]) + frame) * values[at(rate)];
  }
  return kRoundingOfFrame * sum;
}

// How far the levers of a row are off.
double JointErrors::misplaced(const Sums& sums) const {
  return closure_.spread * sums.joints + closure_.reach * sums.frames;
}

// Open motions are found by reflections that mix the rows: what all of them round may be in each.
double JointErrors::mixed(const std::vector<double>& sizes) const {
  if (closure_.qr.rank() == closure_.qr.columns()) {
    return 0.0;
  }
  double sum = 0.0;
  for (std::size_t rate = 0; rate < sizes.size(); ++rate) {
    for (const double factor : closure_.jacobian.subspan(rate * at(rows_), at(rows_))) {
      sum += std::abs(factor) * sizes[rate];
    }
  }
  return kRoundingOfFrame * sum;
}

// J φ = 0 and J ψ = -dJ/dt φ, whose coefficients are off as far as the joints between the sides of
// a row are; those of steady rates are constant.
void JointErrors::follow(std::span<const double> rates,
                         std::span<const double> bends,
                         std::span<const double> driven_errors,
                         std::span<const double> driven_bend_errors) {
  const auto sizes = [](std::span<const double> values, std::vector<double>& result) {
    std::ranges::transform(values, result.begin(), [](double x) { return std::abs(x); });
  };
  sizes(rates, rates_);
  sizes(bends, bends_);
  const auto driven_part = [&](int r, std::span<const double> errors) {
    double sum = 0.0;
    for (std::size_t d = 0; d < errors.size(); ++d) {
      sum +=
          errors[d] * std::abs(closure_.jacobian[at(closure_.network.driven_rates[d] * rows_ + r)]);
    }
    return sum;
  };
  std::vector<double> of_rows(at(rows_));
  const double mixed_rates = mixed(rates_);
  for (int r = 0; r < rows_; ++r) {
    const Sums sums = sums_of(closure_.rates_of_rows[at(r)]);
    of_rows[at(r)] = mixed_rates + driven_part(r, driven_errors) + steady_part(r, rates_) +
                     misplaced(sums) * sums.rate;
  }
  rate_errors_ = carried(of_rows);
  add_open(rate_errors_, rates_);
  for (std::size_t d = 0; d < driven_errors.size(); ++d) {
    rate_errors_[at(closure_.network.driven_rates[d])] = driven_errors[d];
  }
  const double mixed_bends = mixed(bends_);
  std::vector<double> squares;
  std::ranges::transform(rates_, std::back_inserter(squares), [](double x) { return x * x; });
  for (int r = 0; r < rows_; ++r) {
    const Sums sums = sums_of(closure_.rates_of_rows[at(r)]);
    of_rows[at(r)] = mixed_bends + driven_part(r, driven_bend_errors) + steady_part(r, bends_) +
                     (is_rolling(r) ? 0.0 : steady_part(r, squares)) +
                     misplaced(sums) * (sums.bend + sums.rate * sums.rate) +
                     closure_.spread * 2.0 * sums.rate * sums.rate_error;
  }
  bend_errors_ = carried(of_rows);
  add_open(bend_errors_, bends_);
  for (std::size_t d = 0; d < driven_bend_errors.size(); ++d) {
    bend_errors_[at(closure_.network.driven_rates[d])] = driven_bend_errors[d];
  }
}

// An open motion that meets given speeds is off by what these are off where it moves.
void JointErrors::add_open(std::vector<double>& errors, const std::vector<double>& sizes) const {
  const std::size_t columns = closure_.unknown.size();
  const std::vector<double>& open = closure_.qr.null_vectors();
  std::vector<double> more(errors.size(), 0.0);
  for (std::size_t first = 0; first < open.size(); first += columns) {
    double share = 0.0;
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t rate = at(closure_.unknown[i]);
      share += std::abs(open[first + i]) * (errors[rate] + kRoundingOfFrame * sizes[rate]);
    }
    for (std::size_t i = 0; i < columns; ++i) {
      more[at(closure_.unknown[i])] += std::abs(open[first + i]) * share;
    }
  }
  std::ranges::transform(errors, more, errors.begin(), std::plus());
}

std::vector<JointErrors::Sums> JointErrors::sums_of_frames() const {
  std::vector<Sums> frames(1);
  for (const MotionJoint& joint : closure_.network.joints) {
    Sums sums = frames[at(joint.parent)];
    sums.frames += kRoundingOfFrame;
    for (int i = 0; i < count_of_rates(joint); ++i) {
      const std::size_t rate = at(joint.rate + i);
      sums.joints += places_[rate];
      sums.rate += rates_[rate];
      sums.rate_error += rate_errors_[rate];
      sums.bend += bends_[rate];
      sums.bend_error += bend_errors_[rate];
    }
    frames.push_back(sums);
  }
  return frames;
}

// In the plane axes do not turn.
BodyBounds JointErrors::bounds_of(const Sums& sums) const {
  const bool is_planar = closure_.network.space == Space::planar;
  const double place = sums.place();
  const double axes = is_planar ? kRoundingOfFrame : place;
  const double lever = closure_.reach * closure_.network.length;
  const double squared = is_planar ? 0.0 : sums.rate * sums.rate;
  const double cross = is_planar ? 0.0 : 2.0 * sums.rate * sums.rate_error;
  return {.turn = place,
          .shift = lever * place,
          .angular = sums.rate_error + axes * sums.rate,
          .linear = lever * (sums.rate_error + place * sums.rate),
          .angular_rate = sums.bend_error + cross + axes * (sums.bend + squared),
          .linear_rate = lever * (sums.bend_error + 2.0 * sums.rate * sums.rate_error +
                                  place * (sums.bend + sums.rate * sums.rate))};
}

StateBounds JointErrors::bounds(const Topology& topology) const {
  StateBounds result;
  for (auto* list : {&result.positions, &result.rates, &result.rate_rates}) {
    list->assign(topology.freedoms.size(), 0.0);
  }
  const double rates = std::accumulate(rates_.begin(), rates_.end(), 0.0);
  const double bends = std::accumulate(bends_.begin(), bends_.end(), 0.0);
  result.rate_rounding = kRoundingOfRates * rates;
  result.rate_rate_rounding = kRoundingOfRates * (bends + rates * rates);
  result.reach = closure_.reach * closure_.network.length;
  const std::vector<Sums> frames = sums_of_frames();
  for (const int frame : closure_.network.frame_of_body) {
    result.bodies.push_back(bounds_of(frames[at(frame)]));
    result.place = std::max(result.place, closure_.reach * frames[at(frame)].place());
  }
  fill_joints(result);
  fill_measures(frames, topology, result);
  return result;
}

void JointErrors::fill_joints(StateBounds& result) const {
  for (const MotionJoint& joint : closure_.network.joints) {
    if (joint.freedom < 0 || joint.coordinate < 0 || joint.motion.kind == ElementaryKind::ball) {
      continue;
    }
    const double unit =
        unit_of_motion(closure_.network, joint.motion.kind != ElementaryKind::slide);
    result.positions[at(joint.freedom)] = unit * places_[at(joint.rate)];
    result.rates[at(joint.freedom)] = unit * rate_errors_[at(joint.rate)];
    result.rate_rates[at(joint.freedom)] = unit * bend_errors_[at(joint.rate)];
  }
}

void JointErrors::fill_measures(const std::vector<Sums>& frames,
                                const Topology& topology,
                                StateBounds& result) const {
  const MotionNetwork& network = closure_.network;
  for (const RollingRow& rolling : network.rollings) {
    const CouplingTopology& coupling = topology.coupling(rolling.coupling);
    for (std::size_t i = 0; coupling.freedom_count == 1 && i < rolling.rates.size(); ++i) {
      const double factor = std::abs(rolling.freedom_factors[i]);
      const std::size_t rate = at(rolling.rates[i]);
      const std::size_t freedom = at(coupling.first_freedom);
      result.positions[freedom] += factor * (places_[rate] + kEpsilon * coordinates_[rate]);
      result.rates[freedom] += factor * (rate_errors_[rate] + kRoundingOfFrame * rates_[rate]);
      result.rate_rates[freedom] += factor * (bend_errors_[rate] + kRoundingOfFrame * bends_[rate]);
    }
  }
  // Distances change with both ends, and with the axis along which they are measured.
  for (const MeasuredFreedom& one : network.measures) {
    const BodyBounds tail = bounds_of(frames[at(one.tail_frame)]);
    const BodyBounds head = bounds_of(frames[at(one.head_frame)]);
    const std::size_t f = at(one.freedom);
    const bool is_turn = one.measure.is_turn;
    result.positions[f] = is_turn ? tail.turn + head.turn : 2.0 * (tail.shift + head.shift);
    result.rates[f] = is_turn ? tail.angular + head.angular : 2.0 * (tail.linear + head.linear);
    result.rate_rates[f] = is_turn ? tail.angular_rate + head.angular_rate
                                   : 2.0 * (tail.linear_rate + head.linear_rate);
  }
  for (const BallFreedoms& ball : network.balls) {
    const BodyBounds tail = bounds_of(frames[at(ball.tail_frame)]);
    const BodyBounds head = bounds_of(frames[at(ball.head_frame)]);
    for (int i = 0; i < 3; ++i) {
      const std::size_t f = at(ball.first_freedom + i);
      result.rates[f] = tail.angular + head.angular;
      result.rate_rates[f] = tail.angular_rate + head.angular_rate;
    }
  }
}

}  // namespace kinestat
