#include "studies/motion/task/figures/values_between.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "studies/motion/task/figures/motion_steps.hpp"

namespace kinestat {

namespace {

// Ends of values are looked at in some sixty positions, by one column after the other.
constexpr std::size_t kMostKept = 4096;

std::optional<double> in_unit(const MotionReading& reading,
                              const std::optional<double>& value,
                              const FileUnits& units) {
  if (!value || !std::isfinite(*value)) {
    return std::nullopt;
  }
  const double result = units.from_si(reading.kind, *value);
  return result == 0.0 ? 0.0 : result;
}

}  // namespace

std::optional<double> read_column(const std::vector<MotionReading>& readings,
                                  std::size_t reading,
                                  const MotionPosition& position,
                                  const FileUnits& units) {
  std::size_t first = reading;
  while (first > 0 && readings[first - 1].column.element == readings[reading].column.element) {
    --first;
  }
  std::optional<double> value;
  for (std::size_t r = first; r <= reading; ++r) {
    value = readings[r].value(position);
  }
  return in_unit(readings[reading], value, units);
}

std::vector<FigureColumn> figure_columns(
    const std::vector<MotionReading>& readings,
    std::size_t drives,
    const FileUnits& units,
    const std::function<bool(const MotionColumn& column)>& is_climbed) {
  std::vector<FigureColumn> columns(drives);
  for (const MotionReading& one : readings) {
    columns.push_back({.is_climbed = is_climbed(one.column),
                       .is_bounded = one.is_bounded,
                       .is_of_motion = one.is_of_motion || one.needs.has_value(),
                       .is_checked = one.is_checked});
    if (one.folds) {
      columns.back().folds = {.least = *in_unit(one, one.folds->least, units),
                              .greatest = *in_unit(one, one.folds->greatest, units)};
    }
  }
  return columns;
}

ValuesBetween::ValuesBetween(const Mechanism& mechanism,
                             const FoundMotion& motion,
                             const MotionDetail& detail,
                             const std::vector<MotionReading>& readings,
                             const FileUnits& units,
                             FollowedConfigurations& configurations,
                             UnboundedQuotients& quotients)
    : mechanism_(mechanism),
      motion_(motion),
      readings_(readings),
      units_(units),
      configurations_(configurations),
      quotients_(quotients),
      detail_(detail),
      positions_(mechanism, motion.plan, motion.network, motion.drawn, detail) {}

// Statics and accelerations cost more than all else, and most peaks are of places and speeds.
MotionPositions& ValuesBetween::positions_for(const std::optional<MotionDetail>& needs) {
  MotionDetail detail = needs.value_or(detail_);
  detail.closure_error = detail_.closure_error;
  if (detail == detail_) {
    return positions_;
  }
  const auto known = std::ranges::find(plain_, detail, [](const auto& one) { return one.first; });
  return known != plain_.end()
             ? known->second
             : plain_
                   .emplace_back(
                       std::piecewise_construct,
                       std::forward_as_tuple(detail),
                       std::forward_as_tuple(
                           mechanism_, motion_.plan, motion_.network, motion_.drawn, detail))
                   .second;
}

ValuesBetween::Found ValuesBetween::find(double share, MotionPositions& positions) {
  Found found;
  if (const std::optional<Configuration> there = configurations_.at(share)) {
    found.position = positions.at(*there, share);
    if (found.position->without_friction) {
      found.without_friction = found.position->or_without_friction();
    }
    if (&positions == &positions_) {
      quotients_.look(readings_,
                      *found.position,
                      step_at_share(motion_, share),
                      has_drive_at_rest(motion_.plan, *found.position));
    }
  }
  return found;
}

std::optional<double> ValuesBetween::read(std::size_t reading, const Found& found) const {
  if (!found.position) {
    return std::nullopt;
  }
  const bool has_other = found.without_friction && !readings_[reading].is_of_friction;
  return read_column(
      readings_, reading, has_other ? *found.without_friction : *found.position, units_);
}

const ValuesBetween::Known& ValuesBetween::known_at(double share) {
  const auto before = known_.find(share);
  if (before != known_.end()) {
    return before->second;
  }
  if (known_.size() == kMostKept) {
    known_.clear();
  }
  Known& known = known_[share];
  const Found found = find(share, positions_);
  const std::optional<MotionPosition>& position = found.position;
  for (std::size_t r = 0; position && r < readings_.size(); ++r) {
    const std::optional<double> value = readings_[r].value(*position);
    known.moving.push_back(in_unit(readings_[r], value, units_));
  }
  for (std::size_t r = 0; found.without_friction && r < readings_.size(); ++r) {
    known.at_rest.push_back(read(r, found));
  }
  const bool has_statics = position && position->solved && position->solved->action;
  const SolveStatus status =
      has_statics ? position->solved->action->status : SolveStatus::underdetermined;
  known.is_jammed = status != SolveStatus::underdetermined && status != SolveStatus::solved;
  return known;
}

std::optional<double> ValuesBetween::at(std::size_t reading, double share, Look look) {
  if (look == Look::peak) {
    return read(reading, find(share, positions_for(readings_[reading].needs)));
  }
  const Known& known = known_at(share);
  const auto& values = look == Look::end || known.at_rest.empty() ? known.moving : known.at_rest;
  return values.empty() ? std::nullopt : values[reading];
}

bool ValuesBetween::is_jammed(double share) {
  return known_at(share).is_jammed;
}

}  // namespace kinestat
