// Rates and their derivatives by the drive, in all lanes at once.
#include <utility>

#include "core/index.hpp"
#include "math/tapes/for_each_machine.hpp"
#include "studies/motion/lanes/internal/lane_vectors.hpp"
#include "studies/motion/lanes/lane_follower.hpp"

namespace kinestat {

namespace {

using Group = LaneGroup;
using Numbers = LaneNumbers;

}  // namespace

// How the frames move, and how their motion changes while all rates are constant.
KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_swings() {
  for (std::size_t j = 0; j < linkage_.joints.size(); ++j) {
    const LaneJoint& joint = linkage_.joints[j];
    const auto p = at(joint.parent);
    const bool is_driven = joint.unknown < 0;
    const Numbers rate =
        joint.sense * (is_driven ? Numbers{} + 1.0 : in(now_.rates[at(joint.unknown)]));
    const Numbers& swing = in(swings_[p]);
    const Numbers& x = in(screws_x_[j]);
    const Numbers& y = in(screws_y_[j]);
    if (!joint.turns) {
      const Numbers way =
          joint.sense * (is_driven ? in(drive_) : in(now_.unknowns[at(joint.unknown)]));
      const Numbers across = rate + rate;
      in(swings_[j + 1]) = swing;
      in(moves_x_[j + 1]) = in(moves_x_[p]) + rate * x - way * swing * y;
      in(moves_y_[j + 1]) = in(moves_y_[p]) + rate * y + way * swing * x;
      in(curves_x_[j + 1]) = in(curves_x_[p]) - swing * (across * y + way * swing * x);
      in(curves_y_[j + 1]) = in(curves_y_[p]) + swing * (across * x - way * swing * y);
      continue;
    }
    // The centre moves with the frame before; the shift is seen from it.
    const Numbers all = swing + in(senses_[at(joint.freedom)]) * rate;
    const Numbers from_x = x - in(shifts_x_[p]);
    const Numbers from_y = y - in(shifts_y_[p]);
    const Numbers to_x = x - in(shifts_x_[j + 1]);
    const Numbers to_y = y - in(shifts_y_[j + 1]);
    in(swings_[j + 1]) = all;
    in(moves_x_[j + 1]) = in(moves_x_[p]) - swing * from_y + all * to_y;
    in(moves_y_[j + 1]) = in(moves_y_[p]) + swing * from_x - all * to_x;
    in(curves_x_[j + 1]) = in(curves_x_[p]) - swing * swing * from_x + all * all * to_x;
    in(curves_y_[j + 1]) = in(curves_y_[p]) - swing * swing * from_y + all * all * to_y;
  }
}

// The second derivative of what a closing misses with all rates constant; of a slide, across it and
// along it.
KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_swing(const LaneClosing& closing,
                                                        Group& first,
                                                        Group& second) {
  const auto tail = at(closing.tail_frame);
  const auto head = at(closing.head_frame);
  const auto f = at(closing.freedom);
  const Numbers px = closing.turns ? in(xs_[f]) : Numbers{} + closing.point.x() / linkage_.length;
  const Numbers py = closing.turns ? in(ys_[f]) : Numbers{} + closing.point.y() / linkage_.length;
  const Numbers& head_swing = in(swings_[head]);
  const Numbers& tail_swing = in(swings_[tail]);
  const Numbers hx = in(cosines_[head]) * px - in(sines_[head]) * py;
  const Numbers hy = in(sines_[head]) * px + in(cosines_[head]) * py;
  const Numbers tx = in(cosines_[tail]) * px - in(sines_[tail]) * py;
  const Numbers ty = in(sines_[tail]) * px + in(cosines_[tail]) * py;
  const Numbers curve_x = in(curves_x_[head]) - in(curves_x_[tail]) - head_swing * head_swing * hx +
                          tail_swing * tail_swing * tx;
  const Numbers curve_y = in(curves_y_[head]) - in(curves_y_[tail]) - head_swing * head_swing * hy +
                          tail_swing * tail_swing * ty;
  if (closing.turns) {
    in(first) = curve_x;
    in(second) = curve_y;
    return;
  }
  const Numbers dx = hx + in(shifts_x_[head]) - tx - in(shifts_x_[tail]);
  const Numbers dy = hy + in(shifts_y_[head]) - ty - in(shifts_y_[tail]);
  const Numbers move_x =
      in(moves_x_[head]) - in(moves_x_[tail]) - head_swing * hy + tail_swing * ty;
  const Numbers move_y =
      in(moves_y_[head]) - in(moves_y_[tail]) + head_swing * hx - tail_swing * tx;
  // As a frame that turns with the tail sees the way between the two.
  const Numbers x = curve_x + tail_swing * (2.0 * move_y - tail_swing * dx);
  const Numbers y = curve_y - tail_swing * (2.0 * move_x + tail_swing * dy);
  const Numbers ux = in(cosines_[tail]) * in(xs_[f]) - in(sines_[tail]) * in(ys_[f]);
  const Numbers uy = in(sines_[tail]) * in(xs_[f]) + in(cosines_[tail]) * in(ys_[f]);
  in(first) = ux * y - uy * x;
  in(second) = ux * x + uy * y;
}

// Where the frames are known and closed: the rates there, and their derivatives.
KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_bends() {
  const std::size_t count = steps_.size();
  const std::size_t width = count + 2;
  find_swings();
  find_columns();
  for (std::size_t e = 0; e < linkage_.closings.size(); ++e) {
    const LaneClosing& closing = linkage_.closings[e];
    Group* const first = &matrix_[2 * e * width];
    Group* const second = first + width;
    Group across;
    Group along;
    find_swing(closing, across, along);
    in(first[count]) = closing.turns ? in(across) : Numbers{};
    in(second[count]) = closing.turns ? in(along) : in(across);
  }
  solve();
  bends_.swap(steps_);
  now_.rates.swap(rates_);
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_fastest(LaneLook& at) const {
  Numbers fastest = Numbers{} + 1.0;
  for (const Groups* rates : {&now_.rates, &std::as_const(at.rates)}) {
    for (const Group& rate : *rates) {
      Numbers size;
      set_size(in(rate), size);
      choose(size > fastest, size, fastest, fastest);
    }
  }
  in(at.fastest) = fastest;
}

KINESTAT_FOR_EACH_MACHINE void LaneFollower::find_rate(const Place& place,
                                                       Group& rate,
                                                       Group& bend) {
  const auto set = [&](int joint, Numbers& speed, Numbers& change) __attribute__((always_inline)) {
    const int unknown = linkage_.joints[at(joint)].unknown;
    speed = unknown < 0 ? Numbers{} + 1.0 : in(now_.rates[at(unknown)]);
    change = unknown < 0 ? Numbers{} : in(bends_[at(unknown)]);
  };
  if (place.joint >= 0) {
    set(place.joint, in(rate), in(bend));
    return;
  }
  const LaneClosing& closing = linkage_.closings[at(place.closing)];
  const auto tail = at(closing.tail_frame);
  const auto head = at(closing.head_frame);
  const auto f = at(closing.freedom);
  const double px = closing.point.x() / linkage_.length;
  const double py = closing.point.y() / linkage_.length;
  const Numbers hx = in(cosines_[head]) * px - in(sines_[head]) * py + in(shifts_x_[head]);
  const Numbers hy = in(sines_[head]) * px + in(cosines_[head]) * py + in(shifts_y_[head]);
  const Numbers ux = in(cosines_[tail]) * in(xs_[f]) - in(sines_[tail]) * in(ys_[f]);
  const Numbers uy = in(sines_[tail]) * in(xs_[f]) + in(cosines_[tail]) * in(ys_[f]);
  Numbers sum = {};
  Numbers changes = {};
  for (const LaneClosing::Term& term : closing.terms) {
    const LaneJoint& joint = linkage_.joints[at(term.joint)];
    Numbers speed;
    Numbers change;
    set(term.joint, speed, change);
    const Numbers turn = in(senses_[at(joint.freedom)]);
    const Numbers& sx = in(screws_x_[at(term.joint)]);
    const Numbers& sy = in(screws_y_[at(term.joint)]);
    Numbers share;
    if (closing.turns) {
      share = joint.turns ? in(senses_[f]) * turn : Numbers{};
    } else {
      const Numbers vx = joint.turns ? turn * (sy - hy) : sx;
      const Numbers vy = joint.turns ? turn * (hx - sx) : sy;
      share = ux * vx + uy * vy;
    }
    share *= term.sign * joint.sense;
    sum += share * speed;
    changes += share * change;
  }
  if (!closing.turns) {
    Group across;
    Group along;
    find_swing(closing, across, along);
    changes += in(along);
  }
  in(rate) = sum;
  in(bend) = changes;
}

}  // namespace kinestat
