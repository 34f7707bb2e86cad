#include "studies/motion/task/friction_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/solve_status.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"
#include "studies/motion/task/friction_places.hpp"
#include "studies/motion/task/friction_turns.hpp"

namespace kinestat {

FrictionWatch::FrictionWatch(const MechanismDescription& description,
                             const Mechanism& mechanism,
                             const FoundMotion& motion)
    : description_(description),
      mechanism_(mechanism),
      motion_(motion),
      configurations_(mechanism, motion.network, motion.solution) {}

void FrictionWatch::add_row(double step, FrictionSliding sliding) {
  places_.push_back({.step = step, .row = places_.size(), .sliding = std::move(sliding)});
}

std::optional<MotionPosition> FrictionWatch::position_at(double step, MotionPositions& positions) {
  const double share = share_at_step(motion_, step);
  const std::optional<Configuration> there = configurations_.at(share);
  const auto time = motion_.plan.schedule ? std::optional(step / motion_.plan.steps) : std::nullopt;
  return there ? std::optional(positions.at(*there, share, time)) : std::nullopt;
}

void FrictionWatch::look_between(std::span<const CaseFindings> said, MotionPositions& positions) {
  if (std::ranges::all_of(mechanism_.frictions, vanishes_at_rest)) {
    return;
  }
  MotionDetail of_speeds;
  of_speeds.velocity = true;
  MotionPositions moving(mechanism_, motion_.plan, motion_.network, motion_.drawn, of_speeds);
  const auto speeds = [&](double step) {
    const auto position = position_at(step, moving);
    return position ? sliding_speeds(mechanism_, *position) : std::vector<Vec3>();
  };
  const auto place = [&](double step) -> std::optional<FrictionSliding> {
    const auto position = position_at(step, positions);
    if (!position) {
      return std::nullopt;
    }
    FrictionSliding sliding = sliding_at(mechanism_, motion_.plan, *position);
    Between& found = between_[step];
    found.said = judge_position(description_,
                                motion_.plan,
                                *position,
                                positions.moved(),
                                &said[static_cast<std::size_t>(step)]);
    found.status = status_of_position(motion_.plan, *position, positions.moved());
    if (found.status == word_of(SolveStatus::at_rest) && !sliding.stands) {
      found.status = kFrictionReversalEvent;
    }
    return sliding;
  };
  add_places_between(mechanism_, motion_.plan, {.speeds = speeds, .place = place}, places_);
}

void FrictionWatch::find_turns(MotionPositions& positions, MotionTable& table) {
  const SlidingBetween between = [&](double step) {
    const auto position = position_at(step, positions);
    return position ? sliding_at(mechanism_, motion_.plan, *position) : FrictionSliding{};
  };
  turns_ = find_friction_turns(mechanism_, places_, between, table);
  for (const auto& [step, here] : between_) {
    if (here.status != word_of(SolveStatus::solved) &&
        std::ranges::find(table.between, here.status) == table.between.end()) {
      table.between.push_back(here.status);
    }
  }
  table.friction_turns = turns_;
  std::vector<double> steps;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    steps.push_back(step_of_row(motion_, r));
  }
  for (FrictionTurn& turn : table.friction_turns) {
    for (PlacesAround& one : turn.turns) {
      one = {.before = row_at(steps, one.before), .after = row_at(steps, one.after)};
    }
  }
}

void FrictionWatch::tell(std::span<const CaseFindings> said,
                         const MotionTable& table,
                         PositionFindings& found) const {
  const FileUnits& units = description_.units;
  const PlannedDrive& drive = motion_.plan.drives.front();
  const QuantityKind kind = position_kind(
      mechanism_.topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation);
  const auto place_of = [&](const FrictionPlace& one) {
    const double position = motion_.solution.drive_at(0, share_at_step(motion_, one.step));
    FoundPlace place{.row = one.row,
                     .drive = one.row ? table.rows[*one.row].values.front().value_or(0.0)
                                      : units.from_si(kind, position) + 0.0,
                     .time = {}};
    if (motion_.plan.schedule) {
      const double time = one.step / motion_.plan.steps * motion_.plan.schedule->duration();
      place.time = units.from_si(QuantityKind::time, time);
    }
    return place;
  };
  for (const FrictionPlace& one : places_) {
    if (one.row) {
      const std::size_t r = *one.row;
      found.add(place_of(one), told_of_row(said[r], one.sliding, table.rows[r].status, table));
    } else {
      const Between& here = between_.at(one.step);
      found.add(place_of(one), told_of_row(here.said, one.sliding, here.status, table));
    }
  }
}

}  // namespace kinestat
