#include "studies/sweep/task/sweep_notes.hpp"

#include <optional>

#include "studies/sweep/sweep_plan.hpp"

namespace kinestat {

namespace {

void take_parameter(const Slots& slots,
                    const SweepInput& input,
                    const TapeRange& range,
                    SweepNotes& notes) {
  std::optional<TapeQuantity>& slot = notes.slots[input.index];
  slot.reset();
  if (slots.has_value[input.index]) {
    const Quantity& value = slots.values[input.index];
    SweepInput fitting = input;
    fitting.dimension = value.dimension;
    slot = {notes.take(fitting, value.value, range), value.dimension};
  }
}

}  // namespace

TapeNumber SweepNotes::take(const SweepInput& input, double value, const TapeRange& range) {
  inputs.push_back(input);
  return recorder.input(value, range);
}

std::size_t SweepNotes::add_output(TapeNumber number) {
  outputs.push_back(number);
  return outputs.size() - 1;
}

SweepNotes note_parameters(const SweepPlan& plan) {
  SweepNotes notes;
  const Slots& slots = plan.slots();
  for (std::size_t i = 0; i < slots.values.size(); ++i) {
    notes.slots.emplace_back();
    if (slots.has_value[i]) {
      notes.slots.back() = {notes.recorder.constant(slots.values[i].value),
                            slots.values[i].dimension};
    }
  }
  for (std::size_t a = 0; a < plan.axes().size(); ++a) {
    const SweepAxis& axis = plan.axes()[a];
    const auto [least, most] = axis.bounds();
    const SweepInput input{.from = SweepInput::From::axis,
                           .index = static_cast<std::size_t>(axis.parameter()),
                           .part = a,
                           .dimension = {}};
    take_parameter(slots, input, {least, most}, notes);
  }
  for (const DependentParameter& one : plan.dependents()) {
    const auto slot = static_cast<std::size_t>(one.parameter);
    if (const auto quantity = record_quantity(one.value, notes.slots, notes.recorder)) {
      notes.slots[slot] = quantity;
    } else {
      take_parameter(slots, {.from = SweepInput::From::parameter, .index = slot}, {}, notes);
    }
  }
  return notes;
}

}  // namespace kinestat
