// The section `synthesis`. It is planar, whatever the space of the file is; a transmission has a
// mapping of its own.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "format/sections/sections.hpp"
#include "format/sections/synthesis_function.hpp"
#include "format/sections/synthesis_limits.hpp"
#include "format/sections/transmission.hpp"
#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"
#include "io/field_values.hpp"

namespace kinestat {

namespace {

using Task = SynthesisDescription;

constexpr const char* kOrdersHint =
    "the orders are pole, curvature, stationary, burmester; each needs the one before";

const Mapping<PoseDerivative>& derivative() {
  static const Mapping<PoseDerivative> mapping(
      "derivative",
      "One derivative; the parameter is the angle unless angles are given.",
      "{at: [1, 0], angle: 0}",
      [](auto& m) {
        m.key("at", "Derivative of the origin, in lengths per unit of the parameter.")
            .needed(&PoseDerivative::at, point_in_plane());
        m.key("angle",
              "Derivative of the angle by the parameter, in all or in none: a number counts in the "
              "angle unit of the file, or has a unit of its own (\"-15.5 deg\"). The parameter "
              "grows along the motion, so that the derivatives have a sense.")
            .may(&PoseDerivative::angle, angle(), "1");
      });
  return mapping;
}

// Either the parameter of the motion is the angle, or every derivative says how the angle moves.
Form<std::vector<PoseDerivative>> derivatives() {
  const FormRule rule{
      .kind = FormRule::Kind::all_or_none,
      .key = "angle",
      .message = "only some derivatives of {} have an 'angle'",
      .hint = "give 'angle' in all of them, or in none if the parameter is the angle itself"};
  auto form =
      list_of(derivative().form(),
              "derivative {0} of {1}",
              "write derivatives: [{at: [x, y], angle: 1 rad}, …], the first derivative first",
              {.least = 1, .most = 4});
  form.shape.rules.push_back(rule);
  using List = std::vector<PoseDerivative>;
  form.read = [rule, read = form.read](const FileValue& value) -> std::optional<List> {
    auto list = read(value);
    const auto has_angle = [](const PoseDerivative& one) { return one.angle.has_value(); };
    if (list && std::ranges::any_of(*list, has_angle) && !std::ranges::all_of(*list, has_angle)) {
      value.found.error("E0303",
                        value.node.where,
                        fmt::format(fmt::runtime(rule.message), *value.owner),
                        std::string(rule.hint));
      return std::nullopt;
    }
    return list;
  };
  return form;
}

const Mapping<CurvatureDescription>& curvature() {
  static const Mapping<CurvatureDescription> mapping(
      "", "", "{centre: [3, 2.6], free_point: [0.75, 2], m: 0.58}", [](auto& m) {
        m.key("centre", "The centre of curvature of the path of 'at', on its line with the pole.")
            .needed(&CurvatureDescription::centre, point_in_plane());
        m.key("free_point", "A second point of the plane; may be left to 'vary'.")
            .may(&CurvatureDescription::free_point, point_in_plane());
        m.key("m",
              "Ratio that fixes the curvature of the path of the free point, not 0; may be left to "
              "'vary'.")
            .may(&CurvatureDescription::m, not_zero(), "0.58");
      });
  return mapping;
}

// Each order of contact needs the one before; derivatives say all of them in another way.
void declare_orders(Mapping<PositionDescription>& m) {
  using enum FormRule::Kind;
  m.key("pole", "The pole: the instant centre of the plane's motion in this position (PP).")
      .may(&PositionDescription::pole, point_in_plane());
  m.key("curvature",
        "Curvature of the paths of 'at' and of a free point, which fixes the second order (PPP); "
        "needs 'pole'.")
      .may(&PositionDescription::curvature,
           curvature().form(),
           "{centre: [3, 2.6], free_point: [0.75, 2], m: 0.58}");
  m.key("stationary",
        "true makes the curvature stationary (PPPP); needs 'curvature'. Default false.")
      .may(&PositionDescription::stationary, flag(), "true");
  m.key("burmester",
        "true makes 'at' and the free point Burmester points (PPPPP); needs 'stationary'. Default "
        "false.")
      .may(&PositionDescription::burmester, flag(), "true");
  m.key("derivatives",
        "Derivatives of the position by a parameter, first to fourth, instead of pole and "
        "curvature.")
      .may(&PositionDescription::derivatives, derivatives(), "[{at: [1, 0], angle: 0}]");
  m.instead("derivatives",
            {"pole", "curvature", "stationary", "burmester"},
            "keep one of the two: both say how the plane moves there");
  m.rule({.kind = together,
          .key = "curvature",
          .others = {"pole"},
          .message = "'curvature' of {} needs 'pole' too",
          .hint = kOrdersHint});
  m.rule({.kind = together,
          .key = "stationary",
          .others = {"curvature"},
          .message = "'stationary' of {} needs 'curvature' too",
          .hint = kOrdersHint});
  m.rule({.kind = together,
          .key = "burmester",
          .others = {"stationary"},
          .message = "'burmester' of {} needs 'stationary' too",
          .hint = kOrdersHint});
  m.rule({.kind = needs_true,
          .key = "burmester",
          .others = {"stationary"},
          .message = "'burmester' of {} needs 'stationary: true'",
          .hint = "write stationary: true, or burmester: false"});
}

const Mapping<PositionDescription>& position() {
  static const Mapping<PositionDescription> mapping(
      "position",
      "A position of the moving plane. To the point alone (P), a pole adds the velocity (PP), then "
      "curvature (PPP), stationary (PPPP) and burmester (PPPPP) each add an order of contact; "
      "derivatives may replace all of these.",
      "{at: [0.49, 0.0], angle: 30 deg}",
      [](auto& m) {
        m.example("{at: [0.424, 0.245], angle: 30 deg, pole: [0.6, 2.019]}");
        m.key("at", "Where the origin of the moving plane is.")
            .needed(&PositionDescription::at, point_in_plane());
        m.key("angle",
              "The angle of the moving plane, counterclockwise; a list makes one task of each "
              "value.")
            .needed(&PositionDescription::angles,
                    one_or_more(angle(), 1, "write angle: 30 deg, or a list of angles to try each"),
                    "30 deg")
            .example("[30 deg, 40 deg]")
            .add_hint("for example 'angle: 30 deg'");
        declare_orders(m);
      });
  return mapping;
}

const Mapping<DyadDescription>& dyad() {
  static const Mapping<DyadDescription> mapping(
      "dyad", "A dyad with a given point.", "{centre_point: [0, 0]}", [](auto& m) {
        m.key("circle_point", "Its moving pivot, in the moving frame.")
            .may(&DyadDescription::circle_point, point_in_plane(), "[1, 0]");
        m.key("centre_point", "Its fixed pivot, in the fixed frame.")
            .may(&DyadDescription::centre_point, point_in_plane(), "[0, 0]");
        m.rule({.kind = FormRule::Kind::any_of, .others = {"circle_point", "centre_point"}});
        m.check([](const DyadDescription& one, const FileValue& value) {
          if (!one.circle_point && !one.centre_point && value.node.entries.empty()) {
            value.found.error(
                "E0303",
                value.node.where,
                fmt::format("{} has neither 'circle_point' nor 'centre_point'", value.what),
                "write {centre_point: [x, y]}, or {circle_point: [x, y]}");
          }
        });
      });
  return mapping;
}

Form<std::vector<DyadDescription>> dyads() {
  auto one = dyad().form();
  one.read = [read = one.read](const FileValue& value) {
    auto result = read(value);
    if (result) {
      result->where = value.node.where;
    }
    return result;
  };
  return list_of(one,
                 "dyad {0}",
                 "write dyads: [{centre_point: [x, y]}, {circle_point: [x, y]}], two at most",
                 {.least = 1, .most = 2});
}

using RangeEnd = Form<std::vector<Value>>;

RangeEnd number_end(const Form<Value>& number) {
  return converted<std::vector<Value>>(
      number,
      [](Value value) { return std::vector{std::move(value)}; },
      [](const std::vector<Value>& values) { return values.front(); });
}

RangeEnd corner() {
  return converted<std::vector<Value>>(
      point_in_plane(),
      [](PointDescription point) { return std::move(point.coordinates); },
      [](const std::vector<Value>& values) {
        return PointDescription{.coordinates = values, .where = {}};
      });
}

// What may be free: `from` and `to` are examples of a number; those of points have their own.
struct FreeRange {
  FreeNumber which = FreeNumber::m;
  std::string_view meaning;
  RangeEnd end;
  std::string_view example;
  std::string_view from = {};
  std::string_view to = {};
};

using RangeMapping = Mapping<SynthesisRange>;

std::shared_ptr<const RangeMapping> range_mapping(const FreeRange& free) {
  return std::make_shared<const RangeMapping>("", "", free.example, [&free](auto& m) {
    const bool has_corners = is_point(free.which);
    m.key("from", has_corners ? "One corner of the range." : "Its least value.")
        .needed(&SynthesisRange::from, free.end, free.from);
    m.key("to", has_corners ? "The opposite corner." : "Its largest value.")
        .needed(&SynthesisRange::to, free.end, free.to);
  });
}

void declare_range(const FreeRange& free, Mapping<Task>& m) {
  const auto range = range_mapping(free);
  const FreeNumber which = free.which;
  m.key(word_of(which), free.meaning)
      .by(
          range->shape(),
          [range, which](const FileValue& value, Task& task) {
            FileValue renamed = value;
            renamed.what = Title("'{}' of 'vary'", std::string_view(word_of(which)));
            if (auto one = range->read(renamed)) {
              one->which = which;
              task.vary.push_back(*std::move(one));
            }
          },
          [range, which](const Task& task) {
            const auto one = std::ranges::find(task.vary, which, &SynthesisRange::which);
            return one != task.vary.end() ? std::optional(range->text(*one)) : std::nullopt;
          },
          free.example);
}

void declare_ranges(Mapping<Task>& vary) {
  using enum FreeNumber;
  const RangeEnd number = number_end(bare_number());
  const RangeEnd distance = number_end(length());
  const std::vector<FreeRange> ranges = {
      {m, "Range of the ratio m of the curvature.", number, "{from: 0.2, to: 3}", "0.2", "3"},
      {free_point,
       "Range of the free point of the curvature.",
       corner(),
       "{from: [-1, -1], to: [1, 1]}"},
      {s,
       "Range of the effective freedom of the curvature, instead of the free point and m: the "
       "distance, a length, of the inflection pole to the left of the line from the pole to 'at'.",
       distance,
       "{from: -20, to: 20}",
       "-20",
       "20"},
      {tau,
       "Range of the effective freedom of stationary curvature, in addition to s; a plain number.",
       number,
       "{from: -1, to: 1}",
       "-1",
       "1"},
      {tau_2,
       "Range of the effective freedom of a Burmester point, in addition to s and tau; a plain "
       "number.",
       number,
       "{from: -1, to: 1}",
       "-1",
       "1"},
      {circle_points,
       "The area for moving pivots, in the moving frame; for three and four positions. Of a "
       "function generator for that of the input, in the first position.",
       corner(),
       "{from: [-1, -1], to: [1, 1]}"},
      {centre_points,
       "Instead, the area for fixed pivots, in the fixed frame; for three and four positions.",
       corner(),
       "{from: [-1, -1], to: [1, 1]}"},
  };
  for (const FreeRange& free : ranges) {
    declare_range(free, vary);
  }
}

// What says the same cannot vary twice. tau and tau_2 need more than the range before, which is
// judged with the positions.
void declare_togetherness(Mapping<Task>& m) {
  using enum FormRule::Kind;
  constexpr const char* kHint = "keep s, tau and tau_2, or m and free_point: both say the same";
  m.rule({.kind = excludes,
          .key = "s",
          .others = {"m", "free_point"},
          .message = "'vary' cannot have 's' together with 'm' or 'free_point'",
          .hint = kHint});
  m.rule({.kind = excludes,
          .key = "tau",
          .others = {"m", "free_point"},
          .message = "'vary' cannot have 'tau' together with 'm' or 'free_point'",
          .hint = kHint});
  m.rule({.kind = excludes,
          .key = "tau_2",
          .others = {"m", "free_point"},
          .message = "'vary' cannot have 'tau_2' together with 'm' or 'free_point'",
          .hint = kHint});
  m.rule({.kind = excludes,
          .key = "circle_points",
          .others = {"m", "free_point", "s", "tau", "tau_2"},
          .message = "'vary' cannot have 'circle_points' together with other ranges",
          .hint = "keep one of them, and give numbers for what the others leave free"});
  m.rule({.kind = excludes,
          .key = "centre_points",
          .others = {"m", "free_point", "s", "tau", "tau_2", "circle_points"},
          .message = "'vary' cannot have 'centre_points' together with other ranges",
          .hint = "keep one of them; 'limits' takes areas of both kinds of points"});
  m.rule({.kind = together, .key = "tau", .others = {"s"}});
  m.rule({.kind = together, .key = "tau_2", .others = {"tau"}});
  m.rule({.kind = any_of, .others = {"m", "free_point", "s", "circle_points", "centre_points"}});
  m.check([](const Task& task, const FileValue& value) {
    if (task.vary.empty()) {
      value.found.error("E0303",
                        value.where,
                        "'vary' names nothing that is free",
                        "write for example vary: {m: {from: 0.2, to: 3}}");
    }
  });
}

const Mapping<Task>& vary() {
  static const Mapping<Task> mapping("", "", "{m: {from: 0.2, to: 3}}", [](auto& m) {
    declare_ranges(m);
    m.key("samples",
          "Minimum number of combinations tried: a grid with the same number of steps for every "
          "free number.")
        .may(&Task::samples, point_count(), "100000")
        .usual(usual_number<kUsualSamples>());
    declare_togetherness(m);
  });
  return mapping;
}

const Mapping<Task>& curves() {
  static const Mapping<Task> mapping("", "", "{count: 400}", [](auto& m) {
    m.key("count", "Number of points of each curve.")
        .may(&Task::curve_count, point_count(), "400")
        .usual(usual_number<kUsualCurvePoints>());
  });
  return mapping;
}

// To ask for curves is enough.
void read_curves(const FileValue& value, Task& task) {
  curves().read_into(task, value);
  if (value.node.kind == YamlKind::mapping && value.node.entries.empty()) {
    task.curve_count = {
        .expression = std::get<Expression>(parse_expression(usual_number<kUsualCurvePoints>())),
        .where = value.node.where,
        .text_column = 0};
  }
}

void read_vary(const FileValue& value, Task& task) {
  vary().read_into(task, value);
  for (SynthesisRange& range : task.vary) {
    range.name_where = place_of_key(value.node, word_of(range.which));
  }
}

void declare_free(Mapping<Task>& m) {
  m.key("vary",
        "Free numbers of the task and their ranges, from which the best linkage is selected: with "
        "five positions what 'curvature' leaves free, with three and four the circle points.")
      .by(
          vary().shape(),
          read_vary,
          [](const Task& task) { return vary().text_if_any(task); },
          "{m: {from: 0.2, to: 3}}");
  m.key("curves",
        "The circle-point and centre-point curves of four positions. With five positions: the "
        "coupler curve of every linkage.")
      .by(
          curves().shape(),
          read_curves,
          [](const Task& task) { return curves().text_if_any(task); },
          "{count: 400}");
  m.rule(
      {.kind = FormRule::Kind::instead_of_any,
       .key = "positions/curvature/free_point",
       .others = {"vary/free_point", "vary/s"},
       .hint = "Either 'free_point' of the curvature has a number, or 'vary' lets it or s vary."});
  m.rule({.kind = FormRule::Kind::instead_of_any,
          .key = "positions/curvature/m",
          .others = {"vary/m", "vary/s"},
          .hint = "Either 'm' of the curvature has a number, or 'vary' lets it or s vary."});
}

}  // namespace

const Mapping<SynthesisDescription>& synthesis_section() {
  static const Mapping<Task> mapping(
      "",
      "",
      "{linkage: four_bar, positions: [{at: [0.424, 0.245], angle: 30 deg, pole: [0.6, 2.019]}, "
      "{at: [0.49, 0.0], angle: 70 deg}]}",
      [](auto& m) {
        m.key("linkage",
              "The type of linkage to find. Usable linkages of other types are counted, and listed "
              "with 'any'.")
            .may(&Task::linkage,
                 choice_of<LinkageKind>(
                     {{"any", "all of them"},
                      {"four_bar", "four revolute couplings"},
                      {"slider_crank", "one of the dyads is a slider"},
                      {"inverted_slider_crank", "one of the dyads is an inverted slider"}}),
                 "four_bar")
            .usual("four_bar");
        m.key("positions",
              "The positions of the moving plane: two to five in all, counted by their orders.")
            .needed(&Task::positions,
                    list_of(position().form(),
                            "position {0}",
                            "begin each position with '- {at: [x, y], angle: 30 deg}'"),
                    "[{at: [0.424, 0.245], angle: 30 deg, pole: [0.6, 2.019]}, {at: [0.49, 0.0], "
                    "angle: 70 deg}]")
            .add_hint("'positions:' and below it lines '- {at: [x, y], angle: 30 deg}'");
        m.key("function",
              "Instead of positions: the angles of two links of a four-bar that generates a "
              "function.")
            .may(&Task::function, synthesis_function().form(), kFunctionExample);
        m.instead("function",
                  {"positions", "dyads", "digits"},
                  "a function generator has angles and given pivots in 'function': keep one of the "
                  "two");
        m.key("dyads",
              "Dyads with a given pivot, two at most, where the positions leave them free: with "
              "three positions the other pivot follows; with four the given one must lie on its "
              "curve; with two both pivots are given, and the second lies on a line.")
            .may(&Task::dyads, dyads(), "[{centre_point: [0, 0]}, {circle_point: [1, 0]}]");
        m.key("limits",
              "Requirements on a linkage; those that do not meet them are listed as rejected.")
            .group(&Task::limits, synthesis_limits())
            .example("{transmission_angle: 30 deg, link_ratio: 12, size: 20}");
        declare_free(m);
        m.key("digits",
              "Decimal digits of the typed positions to use, 17 to 100, where 16 leave too few of "
              "the dyads; also --digits. For tasks with five positions.")
            .may(&Task::digits, digit_count(), "40");
        m.key("transmission", "Finds planetary transmissions instead of linkages.")
            .may(&Task::transmission,
                 transmission_mapping().form(),
                 "{sets: 2, elements: 4, engaged: 2, gears: {forward: 3}, ratios: {step: [1.3, "
                 "2]}}");
        m.instead(
            "transmission",
            {"linkage", "positions", "function", "dyads", "limits", "vary", "curves", "digits"},
            "a file is about linkages or about transmissions: keep one of the two");
        m.rule(
            {.kind = FormRule::Kind::any_of, .others = {"positions", "function", "transmission"}});
      });
  return mapping;
}

}  // namespace kinestat
