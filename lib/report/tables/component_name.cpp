#include "report/tables/component_name.hpp"

#include <variant>

#include "core/axis_name.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kOfVector = 3;
constexpr std::size_t kOfScrew = 6;

char letter_of(const Measure& measure) {
  const auto* kind = std::get_if<QuantityKind>(&measure);
  if (kind == nullptr) {
    return '\0';
  }
  switch (*kind) {
    case QuantityKind::angular_velocity:
      return 'w';
    case QuantityKind::velocity:
      return 'v';
    case QuantityKind::moment:
      return 'T';
    case QuantityKind::force:
      return 'R';
    default:
      return '\0';
  }
}

// Two numbers may be a range, three those of something else.
bool is_vector(const Shape& tuple) {
  const Measure& measure = tuple.items.front().measure;
  const auto* kind = std::get_if<QuantityKind>(&measure);
  const bool is_direction = measure == Measure(Bare::direction);
  return tuple.items.size() == 2
             ? is_direction || (kind != nullptr && *kind == QuantityKind::length)
             : tuple.items.size() == kOfVector && (is_direction || kind);
}

}  // namespace

std::string axis_name(std::size_t index) {
  return kAxisNames[index];
}

std::string component_name(const Shape& tuple, std::size_t index) {
  if (tuple.form == Shape::Form::tuple && index < tuple.items.size()) {
    if (is_vector(tuple)) {
      return axis_name(index);
    }
    const char letter = letter_of(tuple.items[index].measure);
    if (tuple.items.size() == kOfScrew && letter != '\0') {
      return letter + axis_name(index % kOfVector);
    }
  }
  return std::to_string(index);
}

}  // namespace kinestat
