#include "studies/motion/lanes/lane_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/lanes/internal/lane_vectors.hpp"

namespace kinestat {

namespace {

// Where the determinant is below this share of its columns, or changes by more than this share of
// itself from step to step, it may pass zero between.
constexpr double kLeastDeterminant = 0.02;
constexpr double kMostChange = 0.5;

constexpr int kMostCorrections = 6;

// Where a step misses, it is taken again in so many parts, and in as many of each of these.
constexpr int kParts = 4;
constexpr int kMostParts = 64;

constexpr LaneFollower::Group kAllLanes = [] {
  LaneFollower::Group all;
  std::ranges::fill(all.numbers, 1.0);
  return all;
}();

constexpr int kTrials = 8;  // of each dead point

}  // namespace

LaneFollower::LaneFollower(LaneLinkage linkage, LaneQuestion question, const Geometry& geometry)
    : linkage_(std::move(linkage)), question_(std::move(question)) {
  const auto unknowns = at(linkage_.unknown_count());
  const std::size_t joints = linkage_.joints.size();
  const double way = std::abs(question_.drive.to - question_.drive.from) /
                     (linkage_.joints[at(linkage_.driven_joint)].turns ? 1.0 : linkage_.length);
  parts_ = std::max(1, static_cast<int>(std::ceil(way / question_.steps / kStepToStart)));
  for (const int freedom : question_.places) {
    places_.push_back(place_of(freedom));
  }
  for (const int freedom : question_.watched) {
    watched_.push_back(place_of(freedom));
  }
  for (Groups* one : {&xs_, &ys_, &senses_}) {
    one->resize(geometry.motions.size());
  }
  for (Groups* one : {&cosines_, &sines_, &shifts_x_, &shifts_y_, &turns_}) {
    one->resize(joints + 1);
  }
  for (Groups* one : {&screws_x_, &screws_y_}) {
    one->resize(joints);
  }
  for (Groups* one : {&steps_, &rates_}) {
    one->resize(unknowns);
  }
  for (Point* one : {&now_, &before_, &earlier_, &part_before_}) {
    one->unknowns.resize(unknowns);
    one->rates.resize(unknowns);
  }
  matrix_.resize(unknowns * (unknowns + 2));
  kept_.assign(at(question_.steps + 1), now_);
  kept_rates_.assign(at(question_.steps + 1), Groups(watched_.size()));
  for (Groups* one : {&least_, &greatest_, &sums_}) {
    one->resize(places_.size());
  }
  counts_.resize(watched_.size());
  turn_rates_.resize(watched_.size());
  in(cosines_[0]) = LaneNumbers{} + 1.0;
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    set(lane, geometry);
  }
}

LaneFollower::Place LaneFollower::place_of(int freedom) const {
  const int joint = linkage_.joint_of(freedom);
  const auto closing = std::ranges::find(linkage_.closings, freedom, &LaneClosing::freedom);
  return {.joint = joint,
          .closing = joint >= 0 ? -1 : static_cast<int>(closing - linkage_.closings.begin())};
}

// A turn about p is the screw [ω; p x ω].

void LaneFollower::set(std::size_t lane, const Geometry& geometry) {
  for (std::size_t f = 0; f < geometry.motions.size(); ++f) {
    const Twist& motion = geometry.motions[f];
    const double sense = motion.angular.z();
    senses_[f].numbers[lane] = sense;
    const bool turns = sense != 0.0;
    xs_[f].numbers[lane] = turns ? -motion.linear.y() / sense / linkage_.length : motion.linear.x();
    ys_[f].numbers[lane] = turns ? motion.linear.x() / sense / linkage_.length : motion.linear.y();
  }
}

// Of the closure, what is missed and how it changes with each unknown, then with the drive.

// The correction and the rates of the unknowns, and the determinant as share of its columns.

// Takes what was solved for in the lanes that are not settled yet, and says which they are.

// Newton's corrections; a lane has no more of them than it needs, so that the others do not matter.

void LaneFollower::correct(const Group& which) {
  active_ = which;
  in(missed_) = LaneNumbers{};
  for (int i = 0; i < kMostCorrections; ++i) {
    find_frames();
    find_columns();
    solve();
    if (!take_correction(i == 0)) {
      return;
    }
  }
  in(missed_) += in(active_);
}

void LaneFollower::advance(double to, bool has_history) {
  const Step step = {.from = drive_at_, .to = to, .has_history = has_history};
  const Group determinant = now_determinant_;
  predict(step);
  drive_at_ = to;
  std::ranges::fill(drive_.numbers, to);
  correct(kAllLanes);
  judge_change(determinant);
  for (int parts = kParts; parts <= kMostParts && find_again(); parts *= kParts) {
    advance_in_parts(step, parts, determinant);
  }
  in(doubts_) += in(missed_);
}

void LaneFollower::judge_change(const Group& before) {
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    const double was = before.numbers[lane];
    const double is = now_determinant_.numbers[lane];
    const bool is_clear =
        std::abs(is) >= kLeastDeterminant && std::abs(is - was) <= kMostChange * std::abs(is);
    missed_.numbers[lane] += is_clear ? 0.0 : 1.0;
  }
}

// Which lanes missed and are not given up.

bool LaneFollower::find_again() {
  bool is_any = false;
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    const bool is_again = missed_.numbers[lane] > 0.0 && doubts_.numbers[lane] == 0.0;
    again_.numbers[lane] = is_again ? 1.0 : 0.0;
    is_any = is_any || is_again;
  }
  return is_any;
}

// Takes the last step again in the lanes that missed, in smaller parts: the others must not differ.

void LaneFollower::advance_in_parts(const Step& step, int parts, const Group& determinant) {
  const double part = (step.to - step.from) / parts;
  Group missed = missed_;
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    if (again_.numbers[lane] > 0.0) {
      missed.numbers[lane] = 0.0;
      now_determinant_.numbers[lane] = determinant.numbers[lane];
      for (std::size_t k = 0; k < steps_.size(); ++k) {
        now_.unknowns[k].numbers[lane] = before_.unknowns[k].numbers[lane];
        now_.rates[k].numbers[lane] = before_.rates[k].numbers[lane];
        part_before_.unknowns[k].numbers[lane] = earlier_.unknowns[k].numbers[lane];
        part_before_.rates[k].numbers[lane] = earlier_.rates[k].numbers[lane];
      }
    }
  }
  double last = step.has_history ? step.to - step.from : 0.0;
  for (int i = 1; i <= parts; ++i) {
    predict_part(last, part);
    last = part;
    std::ranges::fill(drive_.numbers, i == parts ? step.to : step.from + part * i);
    const Group was = now_determinant_;
    correct(again_);
    judge_change(was);
    in(missed) += in(missed_);
  }
  missed_ = missed;
}

void LaneFollower::predict_part(double last, double part) {
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    if (again_.numbers[lane] == 0.0) {
      continue;
    }
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      double& x = now_.unknowns[k].numbers[lane];
      double& was = part_before_.unknowns[k].numbers[lane];
      double& rate = part_before_.rates[k].numbers[lane];
      const double now = x;
      const double now_rate = now_.rates[k].numbers[lane];
      x = last == 0.0 ? now + part * now_rate
                      : lane_cubic(was, now, last * rate, last * now_rate, 1.0 + part / last);
      was = now;
      rate = now_rate;
    }
  }
}

void LaneFollower::follow() {
  in(doubts_) = LaneNumbers{};
  for (std::vector<Group>* one : {&now_.unknowns, &sums_, &counts_}) {
    std::ranges::fill(*one, Group{});
  }
  std::ranges::fill(drive_.numbers, 0.0);
  drive_at_ = 0.0;
  correct(kAllLanes);
  in(doubts_) += in(missed_);
  const double unit = linkage_.joints[at(linkage_.driven_joint)].turns ? 1.0 : linkage_.length;
  const double from = question_.drive.from / unit;
  const double way = question_.drive.to / unit - from;
  const int lead = static_cast<int>(std::ceil(std::abs(from) / kStepToStart));
  for (int i = 1; i <= lead; ++i) {
    advance(from * i / lead, i > 1);
  }
  keep(0);
  const int parts = parts_ * question_.steps;
  for (int i = 1; i <= parts; ++i) {
    advance(i == parts ? from + way : from + way * i / parts, i > 1);
    if (i % parts_ == 0) {
      keep(at(i / parts_));
    }
  }
  find_turns();
  go_to_turns(from, way / question_.steps);
}

void LaneFollower::keep(std::size_t step) {
  find_frames();
  kept_[step] = now_;
  for (std::size_t w = 0; w < watched_.size(); ++w) {
    find_rate(watched_[w], kept_rates_[step][w]);
  }
  const bool is_first = step == 0;
  const double weight = is_first || step + 1 == kept_.size() ? 0.5 : 1.0;
  in(active_) = LaneNumbers{} + 1.0;
  for (std::size_t p = 0; p < places_.size(); ++p) {
    add_value(p, is_first);
    in(sums_[p]) += weight * in(value_);
  }
  if (question_.transmission) {
    add_transmission(is_first);
  }
}

// Where the lane is active.

// Of the squared sine, which grows with the angle.

void LaneFollower::find_turns() {
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    turns_of_lane_[lane].clear();
    for (std::size_t w = 0; w < watched_.size(); ++w) {
      for (std::size_t step = 0; step + 1 < kept_rates_.size(); ++step) {
        const LaneRates rates = rates_within(w, lane, step);
        const TurnWithin turns = rates.turns();
        if (turns == TurnWithin::one) {
          add_turn(w, lane, step, rates);
        } else if (turns == TurnWithin::at_high && step + 2 < kept_rates_.size()) {
          // On a step, where rounding decides before or behind it.
          const LaneRates next = rates_within(w, lane, step + 1);
          const bool is_one = next.turns() == TurnWithin::at_low &&
                              std::signbit(next.high) != std::signbit(rates.low);
          const bool is_behind = std::signbit(rates.high) == std::signbit(rates.low);
          if (is_one) {
            add_turn(w, lane, is_behind ? step + 1 : step, is_behind ? next : rates);
            ++step;
            continue;
          }
        }
        const bool is_known = turns == TurnWithin::none || turns == TurnWithin::one;
        doubts_.numbers[lane] += is_known ? 0.0 : 1.0;
      }
    }
  }
}

void LaneFollower::add_turn(std::size_t watched,
                            std::size_t lane,
                            std::size_t step,
                            const LaneRates& rates) {
  turns_of_lane_[lane].push_back({.step = step,
                                  .watched = watched,
                                  .is_there = true,
                                  .low_rate = rates.low,
                                  .high_rate = rates.high,
                                  .size = std::max(std::abs(rates.low), std::abs(rates.high))});
  counts_[watched].numbers[lane] += 1.0;
}

// Slopes are those of parabolas through three rates.

LaneRates LaneFollower::rates_within(std::size_t watched,
                                     std::size_t lane,
                                     std::size_t step) const {
  const std::size_t last = kept_rates_.size() - 1;
  const auto rate = [&](std::size_t i) { return kept_rates_[i][watched].numbers[lane]; };
  const auto slope = [&](std::size_t i) {
    if (last < 2) {
      return rate(1) - rate(0);
    }
    return i == 0      ? 2.0 * rate(1) - 1.5 * rate(0) - 0.5 * rate(2)
           : i == last ? 1.5 * rate(last) - 2.0 * rate(last - 1) + 0.5 * rate(last - 2)
                       : (rate(i + 1) - rate(i - 1)) / 2.0;
  };
  return {.low = rate(step),
          .high = rate(step + 1),
          .low_slope = slope(step),
          .high_slope = slope(step + 1)};
}

// To the dead points of all lanes, one of each after the other: where the rate is zero, between

// the two steps.

void LaneFollower::go_to_turns(double from, double step) {
  std::size_t most = 0;
  for (const std::vector<LaneTurn>& one : turns_of_lane_) {
    most = std::max(most, one.size());
  }
  for (std::size_t e = 0; e < most; ++e) {
    std::array<LaneTurn, kMotionLanes> turns;
    for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
      if (e < turns_of_lane_[lane].size()) {
        turns[lane] = turns_of_lane_[lane][e];
      }
    }
    for (int trial = 0; trial < kTrials; ++trial) {
      go_between(turns, from, step);
      for (std::size_t w = 0; w < watched_.size(); ++w) {
        find_rate(watched_[w], turn_rates_[w]);
      }
      for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
        if (turns[lane].is_there) {
          turns[lane].shrink(turn_rates_[turns[lane].watched].numbers[lane]);
        }
      }
    }
    for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
      const LaneTurn& one = turns[lane];
      active_.numbers[lane] = one.is_there ? 1.0 : 0.0;
      const bool is_found = !one.is_there || std::abs(one.rate) <= kDoubtfulRate * one.size;
      doubts_.numbers[lane] += is_found ? 0.0 : 1.0;
    }
    for (std::size_t p = 0; p < places_.size(); ++p) {
      add_value(p, false);
    }
  }
}

// Between two steps by a cubic, corrected.

void LaneFollower::go_between(const std::array<LaneTurn, kMotionLanes>& turns,
                              double from,
                              double step) {
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    const LaneTurn& one = turns[lane];
    const double t = one.is_there ? one.next() : 0.0;
    const Point& low = kept_[one.step];
    const Point& high = kept_[one.step + 1];
    drive_.numbers[lane] = from + (static_cast<double>(one.step) + t) * step;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      now_.unknowns[k].numbers[lane] = lane_cubic(low.unknowns[k].numbers[lane],
                                                  high.unknowns[k].numbers[lane],
                                                  step * low.rates[k].numbers[lane],
                                                  step * high.rates[k].numbers[lane],
                                                  t);
    }
  }
  correct(kAllLanes);
  in(doubts_) += in(missed_);
  find_frames();
}

LaneExtremes LaneFollower::extremes(std::size_t place, std::size_t lane) const {
  const LaneLinkage& all = linkage_;
  const int joint = places_[place].joint;
  const bool turns =
      joint >= 0 ? all.joints[at(joint)].turns : all.closings[at(places_[place].closing)].turns;
  const double unit = turns ? 1.0 : all.length;
  return {.least = unit * least_[place].numbers[lane],
          .greatest = unit * greatest_[place].numbers[lane],
          .mean = unit * sums_[place].numbers[lane] / question_.steps};
}

int LaneFollower::dead_points(std::size_t watched, std::size_t lane) const {
  return static_cast<int>(counts_[watched].numbers[lane]);
}

std::array<double, 2> LaneFollower::transmission_angles(std::size_t lane) const {
  const auto angle = [lane](const Angle& one) {
    return std::atan2(std::abs(one.along.numbers[lane]), std::abs(one.across.numbers[lane]));
  };
  return {angle(least_angle_), angle(greatest_angle_)};
}

}  // namespace kinestat
