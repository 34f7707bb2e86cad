// How a follower finds extremes between the steps that it knows.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/index.hpp"
#include "studies/motion/lanes/internal/lane_vectors.hpp"
#include "studies/motion/lanes/lane_follower.hpp"

namespace kinestat {

namespace {

double angle_in(std::size_t lane, const LaneAngle& angle) {
  return std::atan2(std::abs(angle.along.numbers[lane]), std::abs(angle.across.numbers[lane]));
}

}  // namespace

void LaneFollower::find_transmission_angles() {
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    least_.back().numbers[lane] = angle_in(lane, least_angle_);
    greatest_.back().numbers[lane] = angle_in(lane, greatest_angle_);
  }
}

// Of angles the squared sines are compared, for they rise and fall with them.
PeakSearch LaneFollower::search_for(const LaneTarget& target, std::size_t lane) const {
  const Groups& known = target.sign < 0.0 ? least_ : greatest_;
  const bool is_angle = target.place == places_.size();
  const double fold = target.sign > 0.0 ? std::numbers::pi / 2.0 : 0.0;
  PeakSearch search(target.sign * known[target.place].numbers[lane],
                    is_angle ? std::optional(fold) : std::nullopt);
  const auto height = [&](std::size_t step) {
    return target.sign * (is_angle ? climbs_.angles[step].share.numbers[lane]
                                   : climbs_.values[target.place][step].numbers[lane]);
  };
  const auto sample = [&](std::size_t step) {
    return PeakSample{
        .share = static_cast<double>(step) / question_.steps,
        .value = is_angle ? target.sign * angle_in(lane, climbs_.angles[step]) : height(step)};
  };
  search.add_run(at(question_.steps) + 1, height, sample);
  return search;
}

// In each lane one position after the other, in all of them at once.
void LaneFollower::go_to_peaks() {
  for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
    climbs_.of_lane[lane].clear();
    for (const LaneTarget& target : climbs_.targets) {
      if (is_certain(lane)) {
        climbs_.of_lane[lane].push_back({.target = target, .search = search_for(target, lane)});
      }
    }
  }
  for (;;) {
    Group which;
    for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
      std::vector<LaneExtremeTargets::Climb>& climbs = climbs_.of_lane[lane];
      while (is_certain(lane) && !climbs.empty() && which.numbers[lane] == 0.0) {
        LaneExtremeTargets::Climb& climb = climbs.back();
        if (const std::optional<double> share = climb.search.next()) {
          go_to(*share, lane);
          which.numbers[lane] = 1.0;
          continue;
        }
        if (const std::optional<PeakSample> top = climb.search.better()) {
          const LaneTarget& target = climb.target;
          Groups& found = target.sign < 0.0 ? least_ : greatest_;
          found[target.place].numbers[lane] = target.sign * top->value;
        }
        climbs.pop_back();
      }
    }
    if (which.is_zero()) {
      return;
    }
    settle(which);
    take_values(which);
  }
}

void LaneFollower::go_to(double share, std::size_t lane) {
  const int parts = parts_ * question_.steps;
  const double place = share * parts;
  const int part = std::min(static_cast<int>(place), parts - 1);
  go_between(lane, {.low = at(part), .high = at(part) + 1}, place - part);
}

void LaneFollower::take_values(const Group& which) {
  for (std::size_t place = 0; place <= places_.size(); ++place) {
    const auto is_there = [&](std::size_t lane) {
      return which.numbers[lane] > 0.0 && climbs_.of_lane[lane].back().target.place == place;
    };
    bool is_found = false;
    for (std::size_t lane = 0; lane < kMotionLanes; ++lane) {
      if (!is_there(lane)) {
        continue;
      }
      if (!is_found && place < places_.size()) {
        find_value(places_[place]);
      } else if (!is_found) {
        find_transmission();
      }
      is_found = true;
      LaneExtremeTargets::Climb& climb = climbs_.of_lane[lane].back();
      const double value = place < places_.size() ? value_.numbers[lane] : angle_in(lane, angle_);
      climb.search.take(climb.target.sign * value);
    }
  }
}

}  // namespace kinestat
