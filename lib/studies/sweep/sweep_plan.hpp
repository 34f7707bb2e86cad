// What a sweep runs through: its axes, what follows from them, and what it leaves out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "expression/slots.hpp"
#include "studies/sweep/state_sampler.hpp"
#include "studies/sweep/sweep_axis.hpp"

namespace kinestat {

/// A parameter that follows from varied ones.
struct DependentParameter {
  int parameter = 0;  ///< index in the description, and its slot
  SlotExpression value;
  int depth = 0;  ///< the last axis on which it depends
};

/// A condition that a state must meet to be analysed.
struct PlannedRequirement {
  std::string text;  ///< as typed
  SlotCondition condition;
  int depth = -1;  ///< the last axis on which it depends; -1: none
};

/// States are numbered in the order of the file: the last axis turns fastest. They are worked off
/// in chunks, whose size depends on the plan alone, so that shards and resumed runs agree on them.
/// Where the axes run together, state i has value i of each; of a sample, what is drawn for it.
class SweepPlan {
 public:
  /// The description must have passed bind and hold a sweep.
  explicit SweepPlan(const MechanismDescription& description);

  /// From now on the axes run together through rows, one behind the other: a number for each axis,
  /// counted in its unit.
  void run_through(std::span<const double> rows);

  /// Whether the states are all combinations, and neither rows nor a sample.
  bool is_product() const { return is_product_; }

  const std::optional<StateSampler>& draw() const { return draw_; }

  std::span<const SweepAxis> axes() const { return axes_; }

  /// Which value of an axis a state has.
  std::uint64_t place_of(std::uint64_t state, std::size_t axis) const {
    return draw_ ? draw_->place_of(state, axis, axes_[axis])
                 : state / strides_[axis] % axes_[axis].size();
  }

  /// In the order in which they need each other.
  std::span<const DependentParameter> dependents() const { return dependents_; }

  std::span<const PlannedRequirement> requirements() const { return requirements_; }

  /// The parameters as the file gives them, slot by slot.
  const Slots& slots() const { return slots_; }

  /// Works out the parameters that depend on this axis or one behind it; what its formula gives no
  /// value has none.
  void evaluate_dependents(int axis, Slots& slots, std::vector<Quantity>& scratch) const;

  std::uint64_t state_count() const { return state_count_; }

  /// How many states in turn share their values on the axes up to this one.
  std::uint64_t stride(int axis) const { return strides_[static_cast<std::size_t>(axis)]; }

  std::uint64_t chunk_size() const;
  std::uint64_t chunk_count() const;

 private:
  void add_axes(const MechanismDescription& description);
  void count_states(const MechanismDescription& description);
  void add_dependents(const MechanismDescription& description);
  void add_requirements(const MechanismDescription& description);
  int depth_of(std::span<const int> slots) const;

  std::vector<SweepAxis> axes_;
  std::vector<DependentParameter> dependents_;
  std::vector<PlannedRequirement> requirements_;
  Slots slots_;
  std::vector<int> depths_;  ///< of each parameter: the last axis on which it depends, or -1
  std::vector<std::uint64_t> strides_;
  std::uint64_t state_count_ = 1;
  bool is_product_ = true;
  std::optional<StateSampler> draw_;
};

}  // namespace kinestat
