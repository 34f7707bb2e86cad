#include "studies/motion/task/figures/values_between.hpp"

#include <cmath>

#include "studies/motion/task/figures/motion_corners.hpp"

namespace kinestat {

namespace {

// Ends of values are looked at in some sixty positions, by one column after the other.
constexpr std::size_t kMostKept = 128;

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
  if (!value || !std::isfinite(*value)) {
    return std::nullopt;
  }
  const double result = units.from_si(readings[reading].kind, *value);
  return result == 0.0 ? 0.0 : result;
}

ValuesBetween::ValuesBetween(const Mechanism& mechanism,
                             const FoundMotion& motion,
                             const MotionDetail& detail,
                             const std::vector<MotionReading>& readings,
                             const FileUnits& units,
                             FollowedConfigurations& configurations,
                             UnboundedQuotients& quotients)
    : motion_(motion),
      readings_(readings),
      units_(units),
      configurations_(configurations),
      quotients_(quotients),
      positions_(mechanism, motion.plan, motion.network, motion.drawn, detail) {}

ValuesBetween::Known ValuesBetween::find(double share) {
  Known known;
  if (const std::optional<Configuration> there = configurations_.at(share)) {
    known.position = positions_.at(*there, share);
    if (known.position->without_friction) {
      known.without_friction = known.position->or_without_friction();
    }
    quotients_.look(readings_, *known.position, step_at_share(motion_, share));
  }
  return known;
}

std::optional<double> ValuesBetween::read(std::size_t reading, const Known& known) const {
  if (!known.position) {
    return std::nullopt;
  }
  const bool has_other = known.without_friction && !readings_[reading].is_of_friction;
  return read_column(
      readings_, reading, has_other ? *known.without_friction : *known.position, units_);
}

std::optional<double> ValuesBetween::at(std::size_t reading, double share) {
  return read(reading, find(share));
}

const ValuesBetween::Known& ValuesBetween::find_shared(double share) {
  const auto before = known_.find(share);
  if (before != known_.end()) {
    return before->second;
  }
  if (known_.size() == kMostKept) {
    known_.clear();
  }
  return known_.emplace(share, find(share)).first->second;
}

std::optional<double> ValuesBetween::at_shared(std::size_t reading, double share) {
  return read(reading, find_shared(share));
}

bool ValuesBetween::is_jammed(double share) {
  const std::optional<MotionPosition>& position = find_shared(share).position;
  const bool has_statics = position && position->solved && position->solved->action;
  const SolveStatus status =
      has_statics ? position->solved->action->status : SolveStatus::underdetermined;
  return status != SolveStatus::underdetermined && status != SolveStatus::solved;
}

}  // namespace kinestat
