// The section `sweep`.
#include <variant>

#include <fmt/format.h>

#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

constexpr const char* kVaryHint = "write {from: 15, to: 40, step: 1} or {values: [15, 17, 21]}";

// The list is called after the parameter, which is the owner of the key 'values'.
Form<std::vector<Value>> values(bool is_behind_key) {
  auto form = list_of(any_number(), "", kVaryHint);
  form.read = [read = form.read, is_behind_key](const FileValue& list) {
    FileValue called = list;
    called.what = Title("the values of {}", is_behind_key ? list.owner : &list.what);
    return read(called);
  };
  return form;
}

const Mapping<VariedParameter>& variation_mapping() {
  static const Mapping<VariedParameter> mapping("", "", "{from: 15, to: 40, step: 1}", [](auto& m) {
    m.key("values", "A list of values.")
        .may(&VariedParameter::values, values(true), "[14.5 deg, 20 deg, 25 deg]");
    m.key("from", "The first value.").needed(&VariedParameter::from, any_number(), "15");
    m.key("to", "The last value, inclusive.").needed(&VariedParameter::to, any_number(), "40");
    m.key("step",
          "The step from one value to the next, not zero. It may be left out only with 'sample': "
          "the parameter can then have any value in the range.")
        .may(&VariedParameter::step, increment(), "1");
    m.instead("values", {"from", "to", "step"}, kVaryHint);
  });
  return mapping;
}

VariedParameter of_values(std::vector<Value> values) {
  VariedParameter varied;
  varied.values = std::move(values);
  return varied;
}

Form<VariedParameter> variation() {
  const auto list = converted<VariedParameter>(
      values(false),
      [](std::vector<Value> values) { return of_values(std::move(values)); },
      [](const VariedParameter& one) { return one.values; });
  auto form = by_shape<VariedParameter>({list, variation_mapping().form()},
                                        [](const VariedParameter&) { return std::size_t{1}; });
  form.shape.definition = "variation";
  form.shape.meaning =
      "The values of a parameter: a list, {values: [...]}, or {from, to, step}; 'to' is inclusive. "
      "With 'sample' also {from, to}, the whole range.";
  form.shape.examples = {"{from: 15, to: 40, step: 1}", "[14.5 deg, 20 deg, 25 deg]"};
  return form;
}

std::string_view word_of(SampleMethod method) {
  return kSampleMethods[static_cast<std::size_t>(method)];
}

const Mapping<SampleDescription>& sample_mapping() {
  static const Mapping<SampleDescription> mapping(
      "sample",
      "Samples of the varied parameters instead of all their combinations.",
      "{count: 100000, method: sobol, seed: 1}",
      [](auto& m) {
        m.key("count",
              "Number of states sampled, including those that a requirement then excludes.")
            .needed(&SampleDescription::count, state_count(), "100000");
        m.key("method", "The sampling method.")
            .may(&SampleDescription::method,
                 choice_of<SampleMethod>(
                     {{word_of(SampleMethod::sobol),
                       "points that fill the space evenly; so does any initial part of them"},
                      {word_of(SampleMethod::random), "independent random values"},
                      {word_of(SampleMethod::latin),
                       "Latin hypercube: the range of every parameter in as many equal parts as "
                       "there are states, each part used once"}}),
                 "sobol")
            .usual(word_of(SampleMethod{}));
        m.key("seed",
              "Different numbers give different samples; the same number gives the same sample on "
              "every machine.")
            .may(&SampleDescription::seed, seed(), "1")
            .usual(usual_number<kUsualSeed>());
      });
  return mapping;
}

Form<Requirement> requirement(std::string_view key,
                              std::string_view definition,
                              std::string_view meaning,
                              std::string_view example) {
  return {
      .shape = {.kind = FormKind::name,
                .definition = definition,
                .meaning = meaning,
                .examples = {example}},
      .read = [key](const FileValue& value) -> std::optional<Requirement> {
        const YamlNode& node = value.node;
        const auto text = read_text(node, Title("a condition of '{}'", key), value.found);
        if (!text) {
          return std::nullopt;
        }
        auto parsed = parse_condition(*text);
        if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
          value.found.error(
              error->code,
              place_in(node.where, node.text_column, *text, error->offset, error->length),
              error->message,
              error->hint);
          return std::nullopt;
        }
        return Requirement{.condition = std::get<Condition>(std::move(parsed)),
                           .where = node.where,
                           .text_column = node.text_column};
      },
      .write = [](const Requirement& one) { return single_text(in_quotes(one.condition.text())); }};
}

void declare_report(Mapping<SweepDescription>& m) {
  m.key("report",
        "The quantities in each row: ratio, torque_ratio, step, efficiency, recirculation, "
        "limit_use, equivalent_inertia, an actuator, lossy.ACTUATOR (its action with mesh losses), "
        "or COUPLING.FREEDOM and COUPLING.ACTION; a number of the report of a case by its place, "
        "power/input; for a whole motion COLUMN.least, .greatest, "
        ".range, .mean, .rms or .peak, dead_points and overall_efficiency.")
      .may(&SweepDescription::report, one_or_more(quantity()), "[ratio, efficiency, h.Rc]")
      .offer("ratio", "input speed over output speed")
      .offer("torque_ratio", "input torque over output torque")
      .offer("efficiency", "output power over input power")
      .offer("step", "ratio of the next lower gear over that of this one")
      .offer("recirculation", "largest power between shafts over the input power")
      .offer("limit_use", "largest ratio of a gear's torques and speeds to their limits")
      .offer("equivalent_inertia", "moment of inertia, or mass, referred to the input");
}

}  // namespace

const Mapping<SweepDescription>& sweep_section() {
  static const Mapping<SweepDescription> mapping(
      "", "", "{vary: {N1: {from: 15, to: 40, step: 1}}, report: [ratio]}", [](auto& m) {
        m.key("vary", "The parameters to vary and their values.")
            .needed(&SweepDescription::vary,
                    named(&VariedParameter::name,
                          variation(),
                          {.item = "a parameter",
                           .elements = "parameters",
                           .name_definition = "parameter_name",
                           .least = 1},
                          "parameter '{0}' of 'vary'"),
                    "{N1: {from: 15, to: 40, step: 1}}");
        m.key(
             "sample",
             "Sample this number of states instead of taking every combination: each has one value "
             "of every parameter.")
            .may(&SweepDescription::sample,
                 sample_mapping().form(),
                 "{count: 100000, method: sobol, seed: 1}");
        m.key("require",
              "Conditions that a combination must meet to be analysed; those that fail are "
              "counted.")
            .may(&SweepDescription::require,
                 one_or_more(requirement("require",
                                         "condition",
                                         "A condition on parameters, with == != < <= > >= and or "
                                         "not mod floor gcd.",
                                         "N3 == N1 + 2*N2")),
                 "[N3 == N1 + 2*N2]");
        m.key("cases", "The cases and gears to analyse; default: all.")
            .may(&SweepDescription::cases, one_or_more(label()), "[M1, M2]");
        declare_report(m);
        m.key("keep",
              "Conditions on parameters and reported quantities that a row must meet to be "
              "written; rows that fail, or cannot be judged because a value is missing, are "
              "counted.")
            .may(&SweepDescription::keep,
                 one_or_more(requirement("keep",
                                         "row_condition",
                                         "A condition on parameters and on quantities named by "
                                         "'report', with == != < <= > >= and or not.",
                                         "efficiency > 0.95")),
                 "[efficiency > 0.95, abs(ratio - 4) < 0.1]");
      });
  return mapping;
}

}  // namespace kinestat
