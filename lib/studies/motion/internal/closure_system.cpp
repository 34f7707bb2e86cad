#include "studies/motion/internal/closure_system.hpp"

#include <algorithm>
#include <cmath>

#include "core/index.hpp"

namespace kinestat {

template <class Frames>
ClosureSystem<Frames>::ClosureSystem(const MotionNetwork& network)
    : length_(network.length),
      rate_count_(network.rate_count),
      coordinate_count_(network.coordinate_count),
      rollings_(network.rollings),
      coordinate_of_rate_(at(network.rate_count)),
      measures_(network.measures) {
  for (const MotionJoint& joint : network.joints) {
    const bool stands = joint.coordinate < 0;
    joints_.push_back({.kind = stands ? ElementaryKind::slide : joint.motion.kind,
                       .parent = joint.parent,
                       .direction = stands ? Vec3(joint.shift / length_) : joint.motion.direction,
                       .point = joint.motion.point / length_,
                       .pitch = joint.motion.pitch / length_,
                       .sense = joint.sense,
                       .coordinate = joint.coordinate,
                       .rate = joint.rate});
    if (!stands) {
      coordinate_of_rate_[at(joint.rate)] = joint.coordinate;
    }
  }
  for (MeasuredFreedom& one : measures_) {
    one = in_sizes(one);
  }
  for (const ClosureRow& closure : network.closures) {
    add_row(closure);
  }
  for (const RollingRow& rolling : rollings_) {
    row_couplings_.push_back(rolling.coupling.value);
    is_length_.push_back(false);
    ++row_count_;
  }
  frames_.resize(joints_.size() + 1);
  screws_.resize(at(rate_count_));
  residuals_.assign(at(row_count_), 0.0);
  jacobian_.assign(at(row_count_ * rate_count_), 0.0);
  place_rolling(network);
  first_angles_.assign(at(network.angle_count), 0.0);
  std::vector<double> drawn = drawn_coordinates();
  find_frames(drawn);
  follow_angles(first_angles_);
  for (Row& row : rows_) {
    if (row.kind == ClosureKind::cable) {
      row.value = 0.0;
      row.value = scalar_residual<double>(row, frames_, first_angles_);
    }
  }
}

template <class Frames>
void ClosureSystem<Frames>::add_row(const ClosureRow& closure) {
  const ClosureCondition& one = closure.condition;
  const TurnAxis turns = axis_between(closure.tail_frame, closure.head_frame);
  if (Frames::kDirections == 3 && one.kind == ClosureKind::meet && turns.is_oblique()) {
    ClosureRow part = closure;
    part.condition.kind = ClosureKind::along;
    part.condition.value = 0.0;
    const Vec3 across = turns.axis->unitOrthogonal();
    for (const Vec3& direction : {*turns.axis, across, Vec3(turns.axis->cross(across))}) {
      part.condition.tail = direction;
      add_row(part);
    }
    return;
  }
  const bool is_angle = one.kind == ClosureKind::across;
  Row row;
  row.kind = one.kind;
  row.tail_frame = closure.tail_frame;
  row.head_frame = closure.head_frame;
  row.tail_point = Frames::vector(one.tail_point) / length_;
  row.head_point = Frames::vector(one.head_point) / length_;
  row.tail = Frames::vector(one.tail);
  row.head = Frames::vector(one.head);
  row.value = is_angle ? one.value : one.value / length_;
  row.tail_radius = one.tail_radius / length_;
  row.head_radius = one.head_radius / length_;
  row.angle = closure.angle;
  row.first = row_count_;
  add_path(closure.tail_frame, closure.head_frame, row);
  row.is_linear = find_linear(one, turns);
  const int count = one.kind == ClosureKind::meet ? Frames::kDirections : 1;
  row_count_ += count;
  row_couplings_.insert(row_couplings_.end(), at(count), closure.coupling.value);
  is_length_.insert(is_length_.end(), at(count), !is_angle);
  rows_.push_back(std::move(row));
}

// The joints that only one of the two frames follows.
template <class Frames>
void ClosureSystem<Frames>::add_path(int from, int to, Row& row) const {
  const auto note = [&](int frame, double sign) {
    const ClosureJoint& joint = joints_[at(frame - 1)];
    const int count = joint.coordinate < 0 ? 0 : joint.kind == ElementaryKind::ball ? 3 : 1;
    for (int i = 0; i < count; ++i) {
      row.rates.push_back(joint.rate + i);
      row.signs.push_back(sign);
    }
    return joint.parent;
  };
  // Frames are numbered from the ground outwards.
  while (from != to) {
    if (from > to) {
      from = note(from, -1.0);
    } else {
      to = note(to, 1.0);
    }
  }
}

template <class Frames>
void ClosureSystem<Frames>::place_rolling(const MotionNetwork& network) {
  const int first = row_count_ - static_cast<int>(network.rollings.size());
  for (std::size_t k = 0; k < rollings_.size(); ++k) {
    const RollingRow& rolling = rollings_[k];
    for (std::size_t i = 0; i < rolling.rates.size(); ++i) {
      jacobian_[at(rolling.rates[i] * row_count_ + first + static_cast<int>(k))] +=
          rolling.factors[i];
    }
  }
}

template <class Frames>
std::vector<double> ClosureSystem<Frames>::drawn_coordinates() const {
  std::vector<double> result(at(coordinate_count_), 0.0);
  for (const ClosureJoint& joint : joints_) {
    if (joint.coordinate >= 0 && joint.kind == ElementaryKind::ball) {
      result[at(joint.coordinate)] = 1.0;
    }
  }
  return result;
}

template <class Frames>
void ClosureSystem<Frames>::find_frames(std::span<const double> coordinates) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const ClosureJoint& joint = joints_[j];
    const Frame<double>& parent = frames_[at(joint.parent)];
    if (joint.kind == ElementaryKind::ball) {
      const Mat3 turn = rotation_of(coordinates.data() + joint.coordinate);
      frames_[j + 1] = Frames::template rolled<double>(
          parent, joint.sense > 0.0 ? turn : Mat3(turn.transpose()), joint.point);
    } else {
      const double q = joint.coordinate < 0 ? 1.0 : joint.sense * coordinates[at(joint.coordinate)];
      frames_[j + 1] = joint.kind == ElementaryKind::turn
                           ? Frames::template turned<double>(
                                 parent, joint.direction, joint.point, joint.pitch, q)
                           : Frames::template shifted<double>(parent, joint.direction, q);
    }
    find_screws<double>(joint, static_cast<int>(j) + 1, frames_, screws_);
  }
}

template <class Frames>
template <class S>
S ClosureSystem<Frames>::scalar_residual(const Row& row,
                                         const std::vector<Frame<S>>& frames,
                                         std::span<const double> angles) const {
  using std::sqrt;
  const Frame<S>& tail = frames[at(row.tail_frame)];
  const Frame<S>& head = frames[at(row.head_frame)];
  if (row.kind == ClosureKind::across) {
    return dot(tail.direction(row.tail), head.direction(row.head)) - S(row.value);
  }
  if (row.kind == ClosureKind::cable) {
    const Span<S> span = span_of<S>(row, frames);
    return span.length + S(row.tail_radius) * counted_turn(span.tail_angle, angles[at(row.angle)]) -
           S(row.head_radius) * counted_turn(span.head_angle, angles[at(row.angle + 1)]) -
           S(row.value);
  }
  const Vector<S> between = head.point(row.head_point) - tail.point(row.tail_point);
  if (row.kind == ClosureKind::reach) {
    return sqrt(dot(between, between)) - S(row.value);
  }
  const Vector<S> normal = tail.direction(row.tail);
  if (row.kind == ClosureKind::screw) {
    const S angle =
        Frames::template angle<S>(normal, tail.direction(row.head), head.direction(row.head));
    return dot(normal, between) - S(row.value) * counted_turn(angle, angles[at(row.angle)]);
  }
  return dot(normal, between) - S(row.value);
}

template <class Frames>
void ClosureSystem<Frames>::write_gradient(const Row& row, int r, const Screw<double>& wrench) {
  for (std::size_t i = 0; i < row.rates.size(); ++i) {
    const int rate = row.rates[i];
    jacobian_[at(rate * row_count_ + r)] = row.signs[i] * wrench.dot(screws_[at(rate)]);
  }
}

template <class Frames>
void ClosureSystem<Frames>::evaluate(std::span<const double> coordinates,
                                     std::span<const double> angles) {
  find_frames(coordinates);
  for (const Row& row : rows_) {
    if (row.kind == ClosureKind::meet) {
      const Plain between = frames_[at(row.head_frame)].point(row.head_point) -
                            frames_[at(row.tail_frame)].point(row.tail_point);
      for (int i = 0; i < Frames::kDirections; ++i) {
        residuals_[at(row.first + i)] = between[i];
        write_gradient(row, row.first + i, gradient(row, i, frames_));
      }
    } else {
      residuals_[at(row.first)] = scalar_residual<double>(row, frames_, angles);
      write_gradient(row, row.first, gradient(row, 0, frames_));
    }
  }
  int r = row_count_ - static_cast<int>(rollings_.size());
  for (const RollingRow& rolling : rollings_) {
    double sum = 0.0;
    for (std::size_t i = 0; i < rolling.rates.size(); ++i) {
      sum += rolling.factors[i] * coordinates[at(coordinate_of_rate_[at(rolling.rates[i])])];
    }
    residuals_[at(r++)] = sum;
  }
}

template <class Frames>
double ClosureSystem<Frames>::largest_residual() const {
  double largest = 0.0;
  for (const double one : residuals_) {
    largest = std::isnan(one) ? one : std::max(largest, std::abs(one));
    if (std::isnan(one)) {
      break;
    }
  }
  return largest;
}

template <class Frames>
void ClosureSystem<Frames>::move(std::span<const double> step,
                                 std::span<double> coordinates) const {
  for (const ClosureJoint& joint : joints_) {
    if (joint.coordinate < 0) {
      continue;
    }
    if (joint.kind != ElementaryKind::ball) {
      coordinates[at(joint.coordinate)] += step[at(joint.rate)];
      continue;
    }
    double* q = coordinates.data() + joint.coordinate;
    const Vec3 turn(step[at(joint.rate)], step[at(joint.rate + 1)], step[at(joint.rate + 2)]);
    const double angle = turn.norm();
    if (angle == 0.0) {
      continue;
    }
    const Vec3 axis = turn / angle;
    const Eigen::Quaterniond rotated = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) *
                                        Eigen::Quaterniond(q[0], q[1], q[2], q[3]))
                                           .normalized();
    q[0] = rotated.w();
    q[1] = rotated.x();
    q[2] = rotated.y();
    q[3] = rotated.z();
  }
}

template <class Frames>
void ClosureSystem<Frames>::follow_angles(std::span<double> angles) const {
  if (angles.empty()) {
    return;
  }
  for (const Row& row : rows_) {
    if (row.kind == ClosureKind::cable) {
      const Span<double> span = span_of<double>(row, frames_);
      angles[at(row.angle)] = counted_turn(span.tail_angle, angles[at(row.angle)]);
      angles[at(row.angle + 1)] = counted_turn(span.head_angle, angles[at(row.angle + 1)]);
    } else if (row.kind == ClosureKind::screw) {
      const Frame<double>& tail = frames_[at(row.tail_frame)];
      const Frame<double>& head = frames_[at(row.head_frame)];
      angles[at(row.angle)] = counted_turn(
          Frames::template angle<double>(
              tail.direction(row.tail), tail.direction(row.head), head.direction(row.head)),
          angles[at(row.angle)]);
    }
  }
  for (const MeasuredFreedom& one : measures_) {
    if (one.angle >= 0) {
      angles[at(one.angle)] = counted_turn(position<double>(one, frames_), angles[at(one.angle)]);
    }
  }
}

template <class Frames>
double ClosureSystem<Frames>::total_turn(std::span<const double> step) const {
  double sum = 0.0;
  for (const ClosureJoint& joint : joints_) {
    if (joint.rate >= 0 && joint.kind != ElementaryKind::slide) {
      const int count = joint.kind == ElementaryKind::ball ? 3 : 1;
      for (int i = 0; i < count; ++i) {
        sum += std::abs(step[at(joint.rate + i)]);
      }
    }
  }
  return sum;
}

template <class Frames>
std::vector<typename Frames::template Frame<Jet>> ClosureSystem<Frames>::moving_frames(
    std::span<const double> coordinates,
    std::span<const double> rates,
    std::span<const double> rate_rates) const {
  std::vector<Frame<Jet>> frames(joints_.size() + 1);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const ClosureJoint& joint = joints_[j];
    const Frame<Jet>& parent = frames[at(joint.parent)];
    if (joint.kind == ElementaryKind::ball) {
      const auto r = at(joint.rate);
      const auto turn = moving_rotation(rotation_of(coordinates.data() + joint.coordinate),
                                        {rates[r], rates[r + 1], rates[r + 2]},
                                        {rate_rates[r], rate_rates[r + 1], rate_rates[r + 2]});
      frames[j + 1] = Frames::template rolled<Jet>(
          parent, joint.sense > 0.0 ? turn : transposed(turn), joint.point);
      continue;
    }
    Jet q(1.0);
    if (joint.coordinate >= 0) {
      const auto r = at(joint.rate);
      q = Jet(joint.sense) * Jet(coordinates[at(joint.coordinate)], rates[r], rate_rates[r]);
    }
    frames[j + 1] =
        joint.kind == ElementaryKind::turn
            ? Frames::template turned<Jet>(parent, joint.direction, joint.point, joint.pitch, q)
            : Frames::template shifted<Jet>(parent, joint.direction, q);
  }
  return frames;
}

template <class Frames>
std::vector<double> ClosureSystem<Frames>::residual_bends(const std::vector<Frame<Jet>>& frames,
                                                          std::span<const double> rate_rates,
                                                          std::span<const double> angles) const {
  std::vector<double> result(at(row_count_), 0.0);
  for (const Row& row : rows_) {
    if (row.kind == ClosureKind::meet) {
      const Vector<Jet> between = frames[at(row.head_frame)].point(row.head_point) -
                                  frames[at(row.tail_frame)].point(row.tail_point);
      for (int i = 0; i < Frames::kDirections; ++i) {
        result[at(row.first + i)] = between[i].second;
      }
    } else {
      result[at(row.first)] = scalar_residual<Jet>(row, frames, angles).second;
    }
  }
  // Turns about the axis of a linear row leave it alone: what derivatives make of them is rounding.
  for (const Row& row : rows_) {
    const int count = row.kind == ClosureKind::meet ? Frames::kDirections : 1;
    for (int i = 0; i < count; ++i) {
      if (row.is_linear[at(i)]) {
        double& bend = result[at(row.first + i)];
        bend = 0.0;
        for (const int rate : row.rates) {
          bend += jacobian_[at(rate * row_count_ + row.first + i)] * rate_rates[at(rate)];
        }
      }
    }
  }
  int r = row_count_ - static_cast<int>(rollings_.size());
  for (const RollingRow& rolling : rollings_) {
    for (std::size_t i = 0; i < rolling.rates.size(); ++i) {
      result[at(r)] += rolling.factors[i] * rate_rates[at(rolling.rates[i])];
    }
    ++r;
  }
  return result;
}

template <class Frames>
template <class S>
S ClosureSystem<Frames>::position(const MeasuredFreedom& measured,
                                  const std::vector<Frame<S>>& frames) const {
  const FreedomMeasure& m = measured.measure;
  const Frame<S>& tail = frames[at(measured.tail_frame)];
  const Frame<S>& head = frames[at(measured.head_frame)];
  const Frame<S>& fixed = m.is_in_head ? head : tail;
  const Vector<S> axis = fixed.direction(Frames::vector(m.axis));
  if (!m.is_turn) {
    const Vector<S> between =
        head.point(Frames::vector(m.head_point)) - tail.point(Frames::vector(m.tail_point));
    return S(m.sense) * dot(axis, between);
  }
  const Vector<S> from = fixed.direction(Frames::vector(m.from));
  const Vector<S> to = (m.is_in_head ? tail : head).direction(Frames::vector(m.to));
  const double sense = Frames::kDirections == 2 ? m.sense * m.axis[2] : m.sense;
  return S(sense) * Frames::template angle<S>(axis, from, to);
}

template class ClosureSystem<PlanarFrames>;
template class ClosureSystem<SpatialFrames>;
template double ClosureSystem<PlanarFrames>::position(
    const MeasuredFreedom&, const std::vector<PlanarFrames::Frame<double>>&) const;
template Jet ClosureSystem<PlanarFrames>::position(
    const MeasuredFreedom&, const std::vector<PlanarFrames::Frame<Jet>>&) const;
template double ClosureSystem<SpatialFrames>::position(
    const MeasuredFreedom&, const std::vector<SpatialFrames::Frame<double>>&) const;
template Jet ClosureSystem<SpatialFrames>::position(
    const MeasuredFreedom&, const std::vector<SpatialFrames::Frame<Jet>>&) const;

}  // namespace kinestat
