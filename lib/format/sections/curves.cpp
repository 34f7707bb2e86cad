// The section `curves`.
#include "format/sections/expression_names.hpp"
#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/collections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

constexpr const char* kPointHint = "write a point as [PLACE, VALUE]: [15 deg, -1500 N]";

Form<CurvePointDescription> curve_point() {
  return converted<CurvePointDescription>(
      list_of(any_number(), "{0}", kPointHint, {2, 2}),
      [](std::vector<Value> pair) {
        return CurvePointDescription{.at = std::move(pair[0]), .value = std::move(pair[1])};
      },
      [](const CurvePointDescription& one) {
        return std::vector<Value>{one.at, one.value};
      });
}

const Mapping<CurveDescription>& curve() {
  static const Mapping<CurveDescription> mapping(
      "curve",
      "A value that changes: through points, over time or over an actuator.",
      "{over: motor, period: 360 deg, points: [[0 deg, -900 N], [180 deg, -200 N]]}",
      [](auto& m) {
        m.key("over",
              "The independent variable: time, an actuator, meaning its position from the drawn "
              "one, or ACTUATOR.speed.")
            .needed(&CurveDescription::over, target(), "motor")
            .offer("time", "since the motion began; 0 in the drawn position");
        m.key("points",
              "Points of the variable, increasing, and values. Values have a unit, or are in the "
              "file's unit for the quantity where the curve is used.")
            .needed(&CurveDescription::points,
                    list_of(curve_point(), "point {0} of {1}", kPointHint),
                    "[[0 deg, -900 N], [90 deg, -1500 N], [180 deg, -200 N]]");
        m.key("period",
              "Period of repetition. The last point is one period after the first and has the same "
              "value, or is earlier and continues to the first.")
            .may(&CurveDescription::period, any_number(), "720 deg");
        m.key("between", "Interpolation between the points.")
            .may(&CurveDescription::between,
                 choice_of<CurveCourse>(
                     {{"linear", "straight lines"},
                      {"monotone", "cubics that rise and fall as the points do"},
                      {"cubic", "a spline whose second derivative is continuous"}}),
                 "linear")
            .usual("linear");
        m.key("ends", "For cubic: the end conditions; periodic if there is a period.")
            .may(&CurveDescription::ends,
                 choice_of<CurveEnds>({{"natural", "no second derivative"},
                                       {"rest", "no slope"},
                                       {"periodic", "it repeats; the last value is the first"}}),
                 "rest")
            .usual("natural");
      });
  return mapping;
}

}  // namespace

Form<std::vector<CurveDescription>> curves() {
  auto form = named_in_expressions(named(&CurveDescription::name,
                                         curve().form(),
                                         {.item = "a curve", .name_definition = "parameter_name"},
                                         "curve '{0}'"),
                                   "curve");
  form.shape.definition = "curves";
  form.shape.meaning = "Values that change, by name.";
  form.shape.examples = {
      "{gas: {over: motor, period: 360 deg, points: [[0 deg, -900 N], [180 deg, -200 N]]}}"};
  return form;
}

}  // namespace kinestat
