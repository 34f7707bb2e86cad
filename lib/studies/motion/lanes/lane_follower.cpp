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

constexpr LaneGroup kAllLanes = [] {
  LaneGroup all;
  std::ranges::fill(all.numbers, 1.0);
  return all;
}();

}  // namespace

LaneFollower::LaneFollower(LaneLinkage linkage, LaneQuestion question, const Geometry& geometry)
    : linkage_(std::move(linkage)),
      question_(std::move(question)),
      means_(question_),
      climbs_(question_) {
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
  for (Groups* one : {&cosines_,
                      &sines_,
                      &shifts_x_,
                      &shifts_y_,
                      &turns_,
                      &swings_,
                      &moves_x_,
                      &moves_y_,
                      &curves_x_,
                      &curves_y_}) {
    one->resize(joints + 1);
  }
  for (Groups* one : {&screws_x_, &screws_y_}) {
    one->resize(joints);
  }
  for (Groups* one : {&steps_, &rates_, &bends_}) {
    one->resize(unknowns);
  }
  for (Point* one : {&now_, &before_, &earlier_, &part_before_}) {
    one->unknowns.resize(unknowns);
    one->rates.resize(unknowns);
  }
  matrix_.resize(unknowns * (unknowns + 2));
  for (Groups* one : {&turn_.values, &turn_.rates, &turn_.bends}) {
    one->resize(watched_.size());
  }
  for (Groups* one : {&least_, &greatest_}) {
    one->resize(places_.size() + 1);
  }
  counts_.resize(watched_.size());
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

// Takes what was solved for in the lanes that are not settled yet, and says which they
// are.

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
                      : HermiteCubic{was, now, last * rate, last * now_rate}.at(1.0 + part / last);
      was = now;
      rate = now_rate;
    }
  }
}

void LaneFollower::follow() {
  in(doubts_) = LaneNumbers{};
  for (std::vector<Group>* one : {&now_.unknowns, &counts_}) {
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
  look_count_ = 0;
  keep(0);
  const int parts = parts_ * question_.steps;
  for (int i = 1; i <= parts; ++i) {
    advance(i == parts ? from + way : from + way * i / parts, i > 1);
    keep(i);
  }
  means_.find();
  if (!watched_.empty()) {
    find_turns();
    go_to_turns();
  }
  if (question_.transmission) {
    find_transmission_angles();
  }
  if (!climbs_.targets.empty()) {
    go_to_peaks();
  }
}

void LaneFollower::keep(int part) {
  const bool is_step = part % parts_ == 0;
  if (is_step || !watched_.empty()) {
    find_frames();
  }
  if (!watched_.empty()) {
    look(add_look());
  } else if (!climbs_.targets.empty()) {
    LaneLook& here = add_look();
    here.drive = drive_;
    here.point = now_;
  }
  if (!is_step) {
    return;
  }
  const std::size_t step = at(part / parts_);
  const bool is_first = part == 0;
  in(active_) = LaneNumbers{} + 1.0;
  for (std::size_t p = 0; p < places_.size(); ++p) {
    add_value(p, is_first);
    means_.keep(p, step, value_);
    if (!climbs_.values[p].empty()) {
      climbs_.values[p][step] = value_;
    }
  }
  if (question_.transmission) {
    find_transmission();
    add_transmission(is_first);
    if (!climbs_.angles.empty()) {
      climbs_.angles[step] = angle_;
    }
  }
}

// Where the lane is active.

// Of the squared sine, which grows with the angle.

// Between positions that are known, in lanes that are not lost there.
void LaneFollower::settle(const Group& which) {
  correct(which);
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    const bool is_clear = missed_.numbers[lane] == 0.0 &&
                          std::abs(now_determinant_.numbers[lane]) >= kLeastDeterminant;
    doubts_.numbers[lane] += which.numbers[lane] == 0.0 || is_clear ? 0.0 : 1.0;
  }
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
          .mean = unit * means_.of(place, lane)};
}

int LaneFollower::dead_points(std::size_t watched, std::size_t lane) const {
  return static_cast<int>(counts_[watched].numbers[lane]);
}

std::array<double, 2> LaneFollower::transmission_angles(std::size_t lane) const {
  return {least_.back().numbers[lane], greatest_.back().numbers[lane]};
}

}  // namespace kinestat
