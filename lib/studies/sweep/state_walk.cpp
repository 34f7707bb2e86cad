#include "studies/sweep/state_walk.hpp"

#include <algorithm>

namespace kinestat {

StateWalk::StateWalk(const SweepPlan& plan, std::uint64_t begin, std::uint64_t end)
    : plan_(plan),
      following_(begin),
      end_(end),
      places_(plan.axes().size(), 0),
      slots_(plan.slots()),
      excluded_(plan.requirements().size(), 0) {
  const auto last = static_cast<int>(plan.axes().size()) - 1;
  const auto depends = [&](const auto& one) { return one.depth == last; };
  is_last_alone_ = plan.is_product() && std::ranges::none_of(plan.dependents(), depends) &&
                   std::ranges::none_of(plan.requirements(), depends);
  for (const SweepAxis& axis : plan.axes()) {
    slots_.has_value[static_cast<std::size_t>(axis.parameter())] = true;
  }
}

bool StateWalk::next() {
  while (following_ < end_) {
    enter(following_);
    const std::uint64_t skipped = states_excluded();
    if (skipped == 0) {
      following_ = state_ + 1;
      return true;
    }
    following_ = state_ + skipped;
  }
  return false;
}

std::uint64_t StateWalk::alike() const {
  return is_last_alone_ && !is_undefined_
             ? std::min(plan_.axes().back().size() - places_.back(), end_ - state_) - 1
             : 0;
}

void StateWalk::pass(std::uint64_t count) {
  if (count > 0) {
    state_ += count;
    following_ = state_ + 1;
    set_place(places_.size() - 1, places_.back() + count);
  }
}

void StateWalk::set_place(std::size_t i, std::uint64_t place) {
  const SweepAxis& axis = plan_.axes()[i];
  const auto slot = static_cast<std::size_t>(axis.parameter());
  places_[i] = place;
  slots_.values[slot] = axis.value_at(place);
}

// The first axis that moves on the way to the next state.
std::size_t StateWalk::step_on() {
  std::size_t i = places_.size();
  bool is_through = true;
  while (is_through && i > 0) {
    --i;
    is_through = places_[i] + 1 == plan_.axes()[i].size();
    set_place(i, is_through ? 0 : places_[i] + 1);
  }
  return i;
}

// Likewise on the way to any other.
std::size_t StateWalk::jump_to(std::uint64_t state) {
  std::size_t moved = places_.size();
  for (std::size_t i = places_.size(); i > 0; --i) {
    const std::uint64_t place = plan_.place_of(state, i - 1);
    if (is_first_ || place != places_[i - 1]) {
      moved = i - 1;
      set_place(i - 1, place);
    }
  }
  return moved;
}

// Only what depends on an axis that has moved is evaluated again.
void StateWalk::enter(std::uint64_t state) {
  const bool is_next = !is_first_ && state == state_ + 1 && plan_.is_product();
  const auto moved = static_cast<int>(is_next ? step_on() : jump_to(state));
  state_ = state;
  is_first_ = false;
  plan_.evaluate_dependents(moved, slots_, scratch_);
  is_undefined_ = std::ranges::any_of(plan_.dependents(), [&](const DependentParameter& one) {
    return !slots_.has_value[static_cast<std::size_t>(one.parameter)];
  });
}

// 0 if all requirements are met, or if one has no answer: then no state is left out for it.
std::uint64_t StateWalk::states_excluded() {
  int depth = -1;
  for (std::size_t i = 0; i < plan_.requirements().size(); ++i) {
    const PlannedRequirement& requirement = plan_.requirements()[i];
    depth = std::max(depth, requirement.depth);
    const std::optional<bool> holds = requirement.condition.holds(slots_, scratch_);
    if (!holds) {
      is_undefined_ = true;
      return 0;
    }
    if (!*holds) {
      const std::uint64_t alike = depth < 0 ? plan_.state_count() : plan_.stride(depth);
      const std::uint64_t count = std::min(alike - state_ % alike, end_ - state_);
      excluded_[i] += count;
      return count;
    }
  }
  return 0;
}

}  // namespace kinestat
