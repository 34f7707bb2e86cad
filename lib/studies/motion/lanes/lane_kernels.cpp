// What is worked out in all lanes at once. Vectors are passed by reference, for how they are passed
// by value depends on the machine.
#include <array>
#include <cmath>
#include <cstdint>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "math/tapes/for_each_machine.hpp"
#include "studies/motion/lanes/internal/lane_vectors.hpp"
#include "studies/motion/lanes/lane_follower.hpp"

namespace kinestat {

namespace {

using Group = LaneGroup;
using Numbers = LaneNumbers;
using Flags = LaneFlags;

// A first correction above this may lead to another branch [rad or sizes].
constexpr double kMostFirstCorrection = 0.03;

// Of sine and cosine: the powers' coefficients, alternating in sign.
constexpr std::array<double, 19> kSeries = [] {
  std::array<double, 19> series = {1.0, 1.0};
  for (std::size_t i = 2; i < series.size(); ++i) {
    series[i] = -series[i - 2] / static_cast<double>(i * (i - 1));
  }
  return series;
}();

// The Taylor series of an eighth of a turn, after quarters are taken away.
[[gnu::always_inline]] inline void set_sine_and_cosine(const Numbers& angle,
                                                       Numbers& sine,
                                                       Numbers& cosine) {
  constexpr double kQuartersPerRadian = 0x1.45f306dc9c883p-1;
  constexpr double kQuarter = 0x1.921fb544p+0;  // times a whole number without rounding
  constexpr double kQuarterRest = 0x1.0b4611a626331p-34;
  constexpr double kRounding = 0x1.8p+52;  // what is added to it is rounded to a whole number
  const Numbers shifted = angle * kQuartersPerRadian + kRounding;
  const Flags quarter = reinterpret_cast<const Flags&>(shifted);
  const Numbers count = shifted - kRounding;
  const Numbers rest = (angle - count * kQuarter) - count * kQuarterRest;
  const Numbers square = rest * rest;
  Numbers s = Numbers{} + kSeries[17];
  Numbers c = Numbers{} + kSeries[18];
  for (std::size_t i = 15; i >= 3; i -= 2) {
    s = s * square + kSeries[i];
    c = c * square + kSeries[i + 1];
  }
  s = rest + rest * square * s;
  c = 1.0 + square * (square * c - 0.5);
  // Odd quarters exchange the two; signs are the highest bit.
  const Flags is_odd = -(quarter & 1);
  Numbers first;
  Numbers second;
  choose(is_odd, c, s, first);
  choose(is_odd, s, c, second);
  const Flags sine_bits = reinterpret_cast<const Flags&>(first) ^ ((quarter & 2) << 62);
  const Flags cosine_bits = reinterpret_cast<const Flags&>(second) ^ (((quarter + 1) & 2) << 62);
  sine = reinterpret_cast<const Numbers&>(sine_bits);
  cosine = reinterpret_cast<const Numbers&>(cosine_bits);
}

// The larger of two rows in each lane goes first.
[[gnu::always_inline]] inline void order(
    Group* upper, Group* lower, std::size_t column, std::size_t width, Numbers& sign) {
  Numbers high;
  Numbers low;
  set_size(in(upper[column]), high);
  set_size(in(lower[column]), low);
  const Flags is_less = high < low;
  for (std::size_t i = column; i < width; ++i) {
    const Numbers one = in(upper[i]);
    const Numbers other = in(lower[i]);
    choose(is_less, other, one, in(upper[i]));
    choose(is_less, one, other, in(lower[i]));
  }
  choose(is_less, -sign, sign, sign);
}

}  // namespace

KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_frames() {
  for (std::size_t j = 0; j < linkage_.joints.size(); ++j) {
    const LaneJoint& joint = linkage_.joints[j];
    const auto p = at(joint.parent);
    const auto f = at(joint.freedom);
    const Numbers coordinate =
        joint.sense * in(joint.unknown < 0 ? drive_ : now_.unknowns[at(joint.unknown)]);
    const Numbers& c = in(cosines_[p]);
    const Numbers& s = in(sines_[p]);
    const Numbers x = c * in(xs_[f]) - s * in(ys_[f]);
    const Numbers y = s * in(xs_[f]) + c * in(ys_[f]);
    Numbers& shift_x = in(shifts_x_[j + 1]);
    Numbers& shift_y = in(shifts_y_[j + 1]);
    if (!joint.turns) {
      in(screws_x_[j]) = x;
      in(screws_y_[j]) = y;
      in(cosines_[j + 1]) = c;
      in(sines_[j + 1]) = s;
      in(turns_[j + 1]) = in(turns_[p]);
      shift_x = in(shifts_x_[p]) + coordinate * x;
      shift_y = in(shifts_y_[p]) + coordinate * y;
      continue;
    }
    const Numbers angle = in(turns_[p]) + in(senses_[f]) * coordinate;
    in(turns_[j + 1]) = angle;
    Numbers cosine;
    Numbers sine;
    set_sine_and_cosine(angle, sine, cosine);
    in(cosines_[j + 1]) = cosine;
    in(sines_[j + 1]) = sine;
    const Numbers screw_x = x + in(shifts_x_[p]);
    const Numbers screw_y = y + in(shifts_y_[p]);
    in(screws_x_[j]) = screw_x;
    in(screws_y_[j]) = screw_y;
    // The centre keeps its place.
    shift_x = screw_x - (cosine * in(xs_[f]) - sine * in(ys_[f]));
    shift_y = screw_y - (sine * in(xs_[f]) + cosine * in(ys_[f]));
  }
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_columns() {
  const std::size_t count = steps_.size();
  const std::size_t width = count + 2;
  for (Group& one : matrix_) {
    in(one) = Numbers{};
  }
  for (std::size_t e = 0; e < linkage_.closings.size(); ++e) {
    const LaneClosing& closing = linkage_.closings[e];
    const auto tail = at(closing.tail_frame);
    const auto head = at(closing.head_frame);
    const auto f = at(closing.freedom);
    Group* const first = &matrix_[2 * e * width];
    Group* const second = first + width;
    const Numbers px = closing.turns ? in(xs_[f]) : Numbers{} + closing.point.x() / linkage_.length;
    const Numbers py = closing.turns ? in(ys_[f]) : Numbers{} + closing.point.y() / linkage_.length;
    const Numbers hx = in(cosines_[head]) * px - in(sines_[head]) * py + in(shifts_x_[head]);
    const Numbers hy = in(sines_[head]) * px + in(cosines_[head]) * py + in(shifts_y_[head]);
    const Numbers dx = hx - (in(cosines_[tail]) * px - in(sines_[tail]) * py + in(shifts_x_[tail]));
    const Numbers dy = hy - (in(sines_[tail]) * px + in(cosines_[tail]) * py + in(shifts_y_[tail]));
    // Across the slide, as its tail has it.
    const Numbers nx = -(in(sines_[tail]) * in(xs_[f]) + in(cosines_[tail]) * in(ys_[f]));
    const Numbers ny = in(cosines_[tail]) * in(xs_[f]) - in(sines_[tail]) * in(ys_[f]);
    in(first[count]) = closing.turns ? dx : in(turns_[head]) - in(turns_[tail]);
    in(second[count]) = closing.turns ? dy : nx * dx + ny * dy;
    for (const LaneClosing::Term& term : closing.terms) {
      const LaneJoint& joint = linkage_.joints[at(term.joint)];
      const std::size_t column = joint.unknown < 0 ? count + 1 : at(joint.unknown);
      const double sign = term.sign * joint.sense;
      const Numbers turn = joint.turns ? sign * in(senses_[at(joint.freedom)]) : Numbers{};
      const Numbers& sx = in(screws_x_[at(term.joint)]);
      const Numbers& sy = in(screws_y_[at(term.joint)]);
      const Numbers vx = joint.turns ? turn * (sy - hy) : sign * sx;
      const Numbers vy = joint.turns ? turn * (hx - sx) : sign * sy;
      in(first[column]) = closing.turns ? vx : turn;
      in(second[column]) = closing.turns ? vy : nx * vx + ny * vy;
    }
  }
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::solve() {
  const std::size_t count = steps_.size();
  const std::size_t width = count + 2;
  Numbers columns = Numbers{} + 1.0;
  for (std::size_t column = 0; column < count; ++column) {
    Numbers square = {};
    for (std::size_t row = 0; row < count; ++row) {
      const Numbers& one = in(matrix_[row * width + column]);
      square += one * one;
    }
    columns *= square;
  }
  Numbers determinant = Numbers{} + 1.0;
  for (std::size_t k = 0; k < count; ++k) {
    Group* const pivots = &matrix_[k * width];
    for (std::size_t row = k + 1; row < count; ++row) {
      order(pivots, &matrix_[row * width], k, width, determinant);
    }
    determinant *= in(pivots[k]);
    const Numbers inverse = 1.0 / in(pivots[k]);
    for (std::size_t row = 0; row < count; ++row) {
      if (row == k) {
        continue;
      }
      Group* const others = &matrix_[row * width];
      const Numbers factor = in(others[k]) * inverse;
      for (std::size_t column = k + 1; column < width; ++column) {
        in(others[column]) -= factor * in(pivots[column]);
      }
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    const Numbers inverse = -1.0 / in(matrix_[k * width + k]);
    in(steps_[k]) = in(matrix_[k * width + count]) * inverse;
    in(rates_[k]) = in(matrix_[k * width + count + 1]) * inverse;
  }
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    columns[lane] = std::sqrt(columns[lane]);
  }
  in(determinant_) = determinant / columns;
}

KINESTAT_FOR_EACH_MACHINE bool LaneFollower::take_correction(bool is_first) {
  const Flags is_active = in(active_) > 0.0;
  Numbers largest = {};
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    Numbers size;
    set_size(in(steps_[k]), size);
    choose(size > largest, size, largest, largest);
    Numbers& unknown = in(now_.unknowns[k]);
    choose(is_active, unknown + in(steps_[k]), unknown, unknown);
    choose(is_active, in(rates_[k]), in(now_.rates[k]), in(now_.rates[k]));
  }
  choose(is_active, in(determinant_), in(now_determinant_), in(now_determinant_));
  if (is_first) {
    choose(
        is_active & ~(largest <= kMostFirstCorrection), Numbers{} + 1.0, in(missed_), in(missed_));
  }
  const Flags goes_on = is_active & (largest > kSilentCorrection);
  choose(goes_on, Numbers{} + 1.0, Numbers{}, in(active_));
  bool is_any = false;
  for (const double one : active_.numbers) {
    is_any = is_any || one > 0.0;
  }
  return is_any;
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::predict(const Step& of_drive) {
  const double step = of_drive.to - of_drive.from;
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const Numbers x = in(now_.unknowns[k]);
    const Numbers rate = in(now_.rates[k]);
    Numbers next = x + step * rate;
    if (of_drive.has_history) {
      next = 5.0 * in(before_.unknowns[k]) - 4.0 * x +
             step * (4.0 * rate + 2.0 * in(before_.rates[k]));
    }
    in(earlier_.unknowns[k]) = in(before_.unknowns[k]);
    in(earlier_.rates[k]) = in(before_.rates[k]);
    in(before_.unknowns[k]) = x;
    in(before_.rates[k]) = rate;
    in(now_.unknowns[k]) = next;
  }
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_value(const Place& place) {
  if (place.joint >= 0) {
    const int unknown = linkage_.joints[at(place.joint)].unknown;
    in(value_) = in(unknown < 0 ? drive_ : now_.unknowns[at(unknown)]);
    return;
  }
  const LaneClosing& closing = linkage_.closings[at(place.closing)];
  const auto tail = at(closing.tail_frame);
  const auto head = at(closing.head_frame);
  const auto f = at(closing.freedom);
  if (closing.turns) {
    in(value_) = in(senses_[f]) * (in(turns_[head]) - in(turns_[tail]));
    return;
  }
  const double px = closing.point.x() / linkage_.length;
  const double py = closing.point.y() / linkage_.length;
  const Numbers& c = in(cosines_[tail]);
  const Numbers& s = in(sines_[tail]);
  const Numbers x = in(shifts_x_[head]) - in(shifts_x_[tail]) + (in(cosines_[head]) - c) * px -
                    (in(sines_[head]) - s) * py;
  const Numbers y = in(shifts_y_[head]) - in(shifts_y_[tail]) + (in(sines_[head]) - s) * px +
                    (in(cosines_[head]) - c) * py;
  in(value_) = (c * in(xs_[f]) - s * in(ys_[f])) * x + (s * in(xs_[f]) + c * in(ys_[f])) * y;
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::add_value(std::size_t place, bool is_first) {
  find_value(places_[place]);
  const Numbers& value = in(value_);
  Numbers& least = in(least_[place]);
  Numbers& greatest = in(greatest_[place]);
  const Flags is_active = in(active_) > 0.0;
  choose(is_active & ((value < least) | (is_first ? ~Flags{} : Flags{})), value, least, least);
  choose(is_active & ((value > greatest) | (is_first ? ~Flags{} : Flags{})),
         value,
         greatest,
         greatest);
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_transmission() {
  const LaneTransmission& one = *question_.transmission;
  const auto place = [&](int frame, int freedom, Numbers& x, Numbers& y)
      __attribute__((always_inline)) {
    const auto i = at(frame);
    const auto f = at(freedom);
    x = in(cosines_[i]) * in(xs_[f]) - in(sines_[i]) * in(ys_[f]) + in(shifts_x_[i]);
    y = in(sines_[i]) * in(xs_[f]) + in(cosines_[i]) * in(ys_[f]) + in(shifts_y_[i]);
  };
  Numbers near_x;
  Numbers near_y;
  Numbers far_x;
  Numbers far_y;
  Numbers arm_x;
  Numbers arm_y;
  place(one.near_frame, one.near, near_x, near_y);
  place(one.far_frame, one.far, far_x, far_y);
  if (one.turns) {  // the motion is across the arm
    place(one.holding_frame, one.output, arm_x, arm_y);
    const Numbers x = near_x - arm_x;
    arm_x = -(near_y - arm_y);
    arm_y = x;
  } else {
    const auto i = at(one.holding_frame);
    const auto f = at(one.output);
    arm_x = in(cosines_[i]) * in(xs_[f]) - in(sines_[i]) * in(ys_[f]);
    arm_y = in(sines_[i]) * in(xs_[f]) + in(cosines_[i]) * in(ys_[f]);
  }
  const Numbers force_x = far_x - near_x;
  const Numbers force_y = far_y - near_y;
  const Numbers along = force_x * arm_x + force_y * arm_y;
  const Numbers across = force_x * arm_y - force_y * arm_x;
  in(angle_.share) = along * along / (along * along + across * across);
  in(angle_.along) = along;
  in(angle_.across) = across;
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::add_transmission(bool is_first) {
  const Numbers& share = in(angle_.share);
  const Flags first = is_first ? ~Flags{} : Flags{};
  const auto take = [&](const Flags& which, LaneAngle& to) __attribute__((always_inline)) {
    choose(which, share, in(to.share), in(to.share));
    choose(which, in(angle_.along), in(to.along), in(to.along));
    choose(which, in(angle_.across), in(to.across), in(to.across));
  };
  take((share < in(least_angle_.share)) | first, least_angle_);
  take((share > in(greatest_angle_.share)) | first, greatest_angle_);
}

}  // namespace kinestat
