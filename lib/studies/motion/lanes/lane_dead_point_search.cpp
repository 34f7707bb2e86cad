// How a follower finds the dead points between the positions that it knows.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/motion_tolerance.hpp"
#include "studies/motion/lanes/internal/lane_vectors.hpp"
#include "studies/motion/lanes/lane_follower.hpp"

namespace kinestat {

namespace {

// Farther than this no freedom moves where rates are cubics [rad, or sizes of the mechanism], to so
// many times what their means show.
constexpr double kLongestStretch = 0.2;
constexpr double kMeanShare = 4.0;

// What is doubtful is looked at in so many parts, and these once more.
constexpr std::size_t kCloserLooks = 8;
constexpr int kMostDepth = 2;

// At a dead point that is found the others are no farther off than this share of what may be.
constexpr double kFoundShare = 0.01;
constexpr int kTrials = 6;

}  // namespace

LaneLook& LaneFollower::add_look() {
  if (look_count_ == looks_.size()) {
    looks_.emplace_back();
    looks_.back().values.resize(watched_.size());
    looks_.back().rates.resize(watched_.size());
    looks_.back().bends.resize(watched_.size());
  }
  return looks_[look_count_++];
}

// At the position that was settled last.
void LaneFollower::look(LaneLook& at) {
  find_bends();
  at.drive = drive_;
  at.point = now_;
  for (std::size_t w = 0; w < watched_.size(); ++w) {
    find_value(watched_[w]);
    at.values[w] = value_;
    find_rate(watched_[w], at.rates[w], at.bends[w]);
  }
  find_fastest(at);
}

HermiteCubic LaneFollower::rate_in(std::size_t lane,
                                   const LaneStretch& stretch,
                                   std::size_t watched) const {
  const LaneLook& low = looks_[stretch.low];
  const LaneLook& high = looks_[stretch.high];
  const double way = high.drive.numbers[lane] - low.drive.numbers[lane];
  return {.low = low.rates[watched].numbers[lane],
          .high = high.rates[watched].numbers[lane],
          .low_slope = way * low.bends[watched].numbers[lane],
          .high_slope = way * high.bends[watched].numbers[lane]};
}

void LaneFollower::find_turns() {
  const std::size_t ends = look_count_;
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    doubtful_[lane].clear();
    turns_of_lane_[lane].clear();
    for (const LaneLook* end : {&looks_[0], &looks_[ends - 1]}) {
      for (const Group& rate : end->rates) {
        const bool is_clear =
            std::abs(rate.numbers[lane]) > kDoubtfulRate * end->fastest.numbers[lane];
        doubts_.numbers[lane] += is_clear ? 0.0 : 1.0;
      }
    }
    for (std::size_t i = 0; i + 1 < ends && is_certain(lane); ++i) {
      judge(lane, {.low = i, .high = i + 1});
    }
  }
  look_closer();
}

// Notes where rates turn back, or that one must look closer.
void LaneFollower::judge(std::size_t lane, const LaneStretch& stretch) {
  if (is_doubtful(lane, stretch)) {
    doubtful_[lane].push_back(stretch);
    doubts_.numbers[lane] += stretch.depth < kMostDepth ? 0.0 : 1.0;
    return;
  }
  for (std::size_t w = 0; w < watched_.size(); ++w) {
    const HermiteCubic rate = rate_in(lane, stretch, w);
    if ((rate.low < 0.0) != (rate.high < 0.0)) {
      turns_of_lane_[lane].emplace_back(stretch, w, rate);
      counts_[w].numbers[lane] += 1.0;
    }
  }
}

// Where a rate is zero at a look, rounding decides on which side of it, and its sign means nothing
// unless it changes there.
bool LaneFollower::is_doubtful(std::size_t lane, const LaneStretch& stretch) const {
  const LaneLook& low = looks_[stretch.low];
  const LaneLook& high = looks_[stretch.high];
  const double way = high.drive.numbers[lane] - low.drive.numbers[lane];
  const double fastest = std::max(low.fastest.numbers[lane], high.fastest.numbers[lane]);
  if (!(fastest * std::abs(way) <= kLongestStretch)) {
    return true;
  }
  const double least = kDoubtfulRate * fastest;
  for (std::size_t w = 0; w < watched_.size(); ++w) {
    const HermiteCubic rate = rate_in(lane, stretch, w);
    const double mean = (high.values[w].numbers[lane] - low.values[w].numbers[lane]) / way;
    const double error =
        rate.error(fastest * std::abs(way)) + kMeanShare * rate.error_by_mean(mean);
    if (!rate.is_told_by_ends(error) ||
        (std::abs(rate.low) <= least && !rate.is_clear_at_low(error)) ||
        (std::abs(rate.high) <= least && !rate.is_clear_at_high(error))) {
      return true;
    }
  }
  return false;
}

// One doubtful stretch of each lane after the other, in parts.
void LaneFollower::look_closer() {
  for (std::size_t round = 0;; ++round) {
    Group which;
    std::array<LaneStretch, kMotionLanes> stretches;
    for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
      if (is_certain(lane) && round < doubtful_[lane].size()) {
        which.numbers[lane] = 1.0;
        stretches[lane] = doubtful_[lane][round];
      }
    }
    if (which.is_zero()) {
      return;
    }
    const std::size_t first = look_count_;
    std::array<LaneStretch, kMotionLanes> rest = stretches;
    for (std::size_t left = kCloserLooks; left > 1; --left) {
      for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
        go_between(lane, rest[lane], 1.0 / static_cast<double>(left));
        rest[lane].low = look_count_;
      }
      settle(which);
      look(add_look());
    }
    for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
      for (std::size_t i = 0; i < kCloserLooks && which.numbers[lane] > 0.0; ++i) {
        judge(lane,
              {.low = i == 0 ? stretches[lane].low : first + i - 1,
               .high = i + 1 == kCloserLooks ? stretches[lane].high : first + i,
               .depth = stretches[lane].depth + 1});
      }
    }
  }
}

// To the dead points of all lanes, one of each after the other.
void LaneFollower::go_to_turns() {
  std::size_t most = 0;
  for (const std::vector<LaneDeadPoint>& one : turns_of_lane_) {
    most = std::max(most, one.size());
  }
  for (std::size_t e = 0; e < most; ++e) {
    Group which;
    for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
      const bool is_there = is_certain(lane) && e < turns_of_lane_[lane].size();
      which.numbers[lane] = is_there ? 1.0 : 0.0;
    }
    for (int trial = 1; trial <= kTrials && !which.is_zero(); ++trial) {
      go_to_turn(e, trial == kTrials, which);
    }
    in(doubts_) += in(which);
  }
}

// The next trial of the lanes of which `which` is above zero; those that are there leave it.
void LaneFollower::go_to_turn(std::size_t index, bool is_last, Group& which) {
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    if (which.numbers[lane] > 0.0) {
      const LaneDeadPoint& turn = turns_of_lane_[lane][index];
      go_between(lane, turn.stretch(), turn.part());
    }
  }
  settle(which);
  const LaneLook& there = turn_;
  look(turn_);
  Group found;
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    if (which.numbers[lane] > 0.0) {
      LaneDeadPoint& turn = turns_of_lane_[lane][index];
      const double way = looks_[turn.stretch().high].drive.numbers[lane] -
                         looks_[turn.stretch().low].drive.numbers[lane];
      const double off = (is_last ? 1.0 : kFoundShare) * kDeadPointBracket;
      const bool is_found = turn.take(there.rates[turn.watched()].numbers[lane],
                                      way * there.bends[turn.watched()].numbers[lane],
                                      off / std::abs(there.fastest.numbers[lane] * way));
      found.numbers[lane] = is_found ? 1.0 : 0.0;
      which.numbers[lane] = is_found ? 0.0 : 1.0;
    }
  }
  active_ = found;
  for (std::size_t p = 0; p < places_.size(); ++p) {
    add_value(p, false);
  }
}

// By a cubic, not yet corrected.
void LaneFollower::go_between(std::size_t lane, const LaneStretch& stretch, double part) {
  const LaneLook& low = looks_[stretch.low];
  const LaneLook& high = looks_[stretch.high];
  const double way = high.drive.numbers[lane] - low.drive.numbers[lane];
  drive_.numbers[lane] = low.drive.numbers[lane] + part * way;
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const HermiteCubic unknown = {.low = low.point.unknowns[k].numbers[lane],
                                  .high = high.point.unknowns[k].numbers[lane],
                                  .low_slope = way * low.point.rates[k].numbers[lane],
                                  .high_slope = way * high.point.rates[k].numbers[lane]};
    now_.unknowns[k].numbers[lane] = unknown.at(part);
  }
}

}  // namespace kinestat
