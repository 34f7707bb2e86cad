#include "run/internal/sweep_notes.hpp"

#include "sweep/sweep_plan.hpp"

namespace kinestat {

namespace {

void take_parameter(const Slots& slots, int parameter, const TapeRange& range, SweepNotes& notes) {
  const auto i = static_cast<std::size_t>(parameter);
  notes.slots[i].reset();
  if (slots.has_value[i]) {
    const Quantity& value = slots.values[i];
    const SweepInput input{
        .from = SweepInput::From::parameter, .index = i, .part = 0, .dimension = value.dimension};
    notes.slots[i] = {notes.take(input, value.value, range), value.dimension};
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
  for (const SweepAxis& axis : plan.axes()) {
    const auto [least, most] = axis.bounds();
    take_parameter(slots, axis.parameter(), {least, most}, notes);
  }
  for (const DependentParameter& one : plan.dependents()) {
    if (const auto quantity = record_quantity(one.value, notes.slots, notes.recorder)) {
      notes.slots[static_cast<std::size_t>(one.parameter)] = quantity;
    } else {
      take_parameter(slots, one.parameter, {}, notes);
    }
  }
  return notes;
}

}  // namespace kinestat
