// From state to state of a sweep, past those that its requirements exclude.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "studies/sweep/sweep_plan.hpp"

namespace kinestat {

/// Walks the states from `begin` up to, not including, `end`. Where a requirement fails because of
/// the outer axes alone, all states that share them are passed over at once. A state counts for the
/// first requirement of the file that it violates.
class StateWalk {
 public:
  /// The plan must outlive it.
  StateWalk(const SweepPlan& plan, std::uint64_t begin, std::uint64_t end);

  /// Goes to the first or the next state to be analysed; false at the end.
  bool next();

  /// How many states follow that differ by their place on the last axis alone, where nothing else
  /// hangs on that place: no parameter and no requirement.
  std::uint64_t alike() const;

  /// Goes on by so many of these, as next does one by one.
  void pass(std::uint64_t count);

  /// Its number.
  std::uint64_t state() const { return state_; }

  /// Its place on each axis.
  std::span<const std::uint64_t> places() const { return places_; }

  /// All parameters in this state; one that its formula gives no value has none.
  const Slots& slots() const { return slots_; }

  /// Whether a requirement has no answer in this state, or a parameter no value.
  bool is_undefined() const { return is_undefined_; }

  /// How many states each requirement has excluded so far.
  std::span<const std::uint64_t> excluded() const { return excluded_; }

 private:
  void enter(std::uint64_t state);
  void set_place(std::size_t axis, std::uint64_t place);
  std::size_t step_on();
  std::size_t jump_to(std::uint64_t state);
  std::uint64_t states_excluded();

  const SweepPlan& plan_;
  std::uint64_t state_ = 0;
  std::uint64_t following_ = 0;  ///< the state to look at next
  std::uint64_t end_ = 0;
  bool is_first_ = true;
  bool is_last_alone_ = false;  ///< nothing depends on the last axis
  bool is_undefined_ = false;
  std::vector<std::uint64_t> places_;
  Slots slots_;
  std::vector<std::uint64_t> excluded_;
  std::vector<Quantity> scratch_;
};

}  // namespace kinestat
