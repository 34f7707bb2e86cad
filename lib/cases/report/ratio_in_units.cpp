#include "cases/report/ratio_in_units.hpp"

#include <string_view>

#include <fmt/format.h>

#include "expression/unit_quotient.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

RatioInUnits converted(const std::optional<double>& value,
                       QuantityKind input,
                       QuantityKind output,
                       const FileUnits& units) {
  RatioInUnits result;
  if (value) {
    result.value = input == output ? *value : *value * units.factor(output) / units.factor(input);
  }
  if (input != output) {
    result.unit = unit_quotient(units.text(input), units.text(output));
  }
  return result;
}

bool turns(const Mechanism& mechanism, int actuator) {
  const int freedom = mechanism.topology.actuators[static_cast<std::size_t>(actuator)].freedom;
  return mechanism.topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation;
}

}  // namespace

RatiosInUnits ratios_in_units(const Ratios& ratios,
                              const RatioEnds& ends,
                              const Mechanism& mechanism,
                              const FileUnits& units) {
  const bool input_turns = turns(mechanism, ends.input);
  const bool output_turns = turns(mechanism, ends.output);
  return {.ratio = converted(ratios.ratio, rate_kind(input_turns), rate_kind(output_turns), units),
          .torque_ratio = converted(
              ratios.torque_ratio, action_kind(input_turns), action_kind(output_turns), units)};
}

RatiosInUnits ratios_in_units(const CaseAnalysis& one,
                              const Mechanism& mechanism,
                              const FileUnits& units) {
  return ratios_in_units(*one.ratios,
                         {.input = one.which.inputs.front(), .output = one.which.outputs.front()},
                         mechanism,
                         units);
}

std::string fraction_behind(const std::optional<Ratios>& ratios) {
  constexpr std::size_t kReadable = 12;
  const std::string_view fraction = ratios ? std::string_view(ratios->fraction) : "";
  const bool is_shown =
      fraction.find('/') != std::string_view::npos && fraction.size() <= kReadable;
  return is_shown ? fmt::format(" = {}", fraction) : "";
}

}  // namespace kinestat
