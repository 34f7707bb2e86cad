#include "format/sections/synthesis_function.hpp"

#include "forms/collections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

constexpr const char* kFunctionLink = "{centre_point: [0, 0], angles: [0 deg, 40 deg, 80 deg]}";

const Mapping<FunctionLink>& function_link() {
  static const Mapping<FunctionLink> mapping(
      "function_link",
      "A link of a function generator and its angles.",
      kFunctionLink,
      [](auto& m) {
        m.key("centre_point", "The fixed pivot about which the link turns.")
            .needed(&FunctionLink::centre_point, point_in_plane(), "[0, 0]");
        m.key("angles",
              "Its angles at the precision points, counterclockwise, two to five. Only their "
              "differences from the first matter, without whole turns of the output.")
            .needed(
                &FunctionLink::angles,
                list_of(angle(),
                        "angle {0} of {1}",
                        "write angles: [0 deg, 40 deg, 80 deg], one a precision point, two to five",
                        {.least = 2, .most = 5}),
                "[0 deg, 40 deg, 80 deg]");
        m.key(
             "circle_point",
             "Its pivot on the coupler in the first position, if it is given: with three precision "
             "points, or four, of one link; with two of both.")
            .may(&FunctionLink::circle_point, point_in_plane(), "[30, 40]");
      });
  return mapping;
}

}  // namespace

const Mapping<FunctionDescription>& synthesis_function() {
  static const Mapping<FunctionDescription> mapping("", "", kFunctionExample, [](auto& m) {
    m.key("input", "The link that is driven. Its angles rise, or fall, by less than a full turn.")
        .needed(&FunctionDescription::input, function_link().form(), kFunctionLink);
    m.key("output", "The link that follows it.")
        .needed(&FunctionDescription::output, function_link().form(), kFunctionLink);
  });
  return mapping;
}

}  // namespace kinestat
