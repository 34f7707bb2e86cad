#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "core/text.hpp"
#include "description/gear_expansion.hpp"
#include "math/sampling/sobol_sequence.hpp"
#include "mechanism/check/report_name_check.hpp"
#include "mechanism/check/section_checks.hpp"
#include "mechanism/gears/planet_question.hpp"
#include "mechanism/shift_plan.hpp"

namespace kinestat {

namespace {

constexpr NumberRule kCount = {.kind = QuantityKind::dimensionless,
                               .range = kStates,
                               .allowed = "a whole number from 1 to 1e12"};
constexpr NumberRule kAnySeed = {.kind = QuantityKind::dimensionless,
                                 .range = kSeed,
                                 .allowed = "a whole number from 0 to 4294967295"};

class SweepCheck {
 public:
  SweepCheck(const SectionContext& context, const SweepDescription& sweep)
      : context_(context), sweep_(sweep) {}

  void run() {
    for (const VariedParameter& varied : sweep_.vary) {
      check_varied(varied);
    }
    if (sweep_.sample) {
      check_sample(*sweep_.sample);
    } else {
      check_size();
    }
    for (const Requirement& requirement : sweep_.require) {
      if (check_names(requirement)) {
        check_dimensions(requirement);
      }
      check_questions(requirement);
    }
    for (const Requirement& condition : sweep_.keep) {
      check_row_names(condition);
    }
    for (const Name& label : sweep_.cases) {
      check_state(label);
    }
    context_.repeats(sweep_.cases, "'cases' of 'sweep'");
    check_report_names(sweep_.report, sweep_report_words(), "sweep", context_);
  }

 private:
  void check_varied(const VariedParameter& varied) {
    const bool is_known =
        context_.names.parameters.check(varied.name, "'sweep' varies", context_.found);
    kind_ = is_known ? dimension_of_parameter(varied.name.text) : std::nullopt;
    for (const Value& value : varied.values) {
      number(value, varied);
    }
    if (varied.values.empty()) {
      check_range(varied);
    } else {
      state_count_ *= static_cast<double>(varied.values.size());
    }
  }

  // What the parameter measures as it stands under `parameters`; empty if that is in error.
  std::optional<Dimension> dimension_of_parameter(const std::string& name) {
    const Quantity* quantity = parameters_.table.find(name);
    return quantity != nullptr ? std::optional(quantity->dimension) : std::nullopt;
  }

  const std::string& typed(const std::string& name) const {
    const auto index = static_cast<std::size_t>(context_.names.parameters.find(name));
    return context_.description.parameters[index].value.expression.text();
  }

  // A value must measure what the parameter does, or the formulas that use it would break.
  std::optional<double> number(const Value& value, const VariedParameter& varied) {
    const std::optional<Quantity> quantity = context_.evaluator.quantity(value);
    if (!quantity) {
      return std::nullopt;
    }
    if (kind_ && quantity->dimension != *kind_) {
      context_.found.error(
          "E0309",
          value.where,
          fmt::format("parameter '{}' is {}, but this value is {}",
                      varied.name.text,
                      phrase_of(*kind_),
                      phrase_of(quantity->dimension)),
          fmt::format("write it as under 'parameters:', where it is {}", typed(varied.name.text)));
      return std::nullopt;
    }
    return quantity->value;
  }

  void check_range(const VariedParameter& varied) {
    const std::optional<double> from = number(*varied.from, varied);
    const std::optional<double> to = number(*varied.to, varied);
    if (!varied.step) {
      check_interval(varied);
      return;
    }
    const std::optional<double> step = number(*varied.step, varied);
    if (!from || !to || !step) {
      return;
    }
    const double ways = (*to - *from) / *step;
    if (*step == 0.0 || ways < 0.0) {
      context_.found.error(
          "E0305",
          varied.step->where,
          *step == 0.0 ? fmt::format("the step of '{}' is zero", varied.name.text)
                       : fmt::format("the step of '{}' leads away from 'to'", varied.name.text),
          *step == 0.0 ? "write a step above zero, or below it if 'to' is less than 'from'"
                       : "change the sign of 'step', or exchange 'from' and 'to'");
      return;
    }
    state_count_ *= std::floor(ways) + 1.0;
    if (sweep_.sample && std::floor(ways) >= *kStates.most) {
      context_.found.error("E0305",
                           varied.step->where,
                           fmt::format("'{}' has {:.3g} values; at most {:.0e} can be numbered",
                                       varied.name.text,
                                       std::floor(ways) + 1.0,
                                       *kStates.most),
                           "leave 'step' out: then the sample draws from the whole range");
    }
  }

  // Neither a list of values nor a sample, which needs none.
  void check_interval(const VariedParameter& varied) {
    if (!sweep_.sample) {
      context_.found.error(
          "E0303",
          varied.name.where,
          fmt::format("parameter '{}' of 'vary' lacks the key 'step'", varied.name.text),
          "add for example 'step: 1', or to 'sweep' for example 'sample: {count: "
          "10000}', which draws from the whole range");
    }
  }

  void check_sample(const SampleDescription& sample) {
    context_.number(sample.count, kCount, "'count' of 'sample'");
    context_.number(sample.seed, kAnySeed, "'seed' of 'sample'");
    if (sample.method == SampleMethod::sobol &&
        sweep_.vary.size() > SobolSequence::kMostDimensions) {
      context_.found.error("E0305",
                           sample.where,
                           fmt::format("the sweep varies {} parameters; 'method: sobol' knows "
                                       "points of {} numbers",
                                       sweep_.vary.size(),
                                       SobolSequence::kMostDimensions),
                           "write 'method: latin', or vary fewer parameters");
    }
  }

  void check_size() {
    if (state_count_ > *kStates.most) {
      context_.found.error("E0305",
                           sweep_.where,
                           fmt::format("the sweep has {:.3g} states; at most {:.0e} can be run",
                                       state_count_,
                                       *kStates.most),
                           "vary fewer parameters, take larger steps, or draw some of the states: "
                           "'sample: {count: 100000}'");
    }
  }

  // Every name of a condition is a parameter, which thereby is used.
  bool check_names(const Requirement& requirement) {
    bool is_good = true;
    for (const ConditionValue& value : requirement.condition.values()) {
      for (const Node& node : value.expression.nodes()) {
        const bool is_name = node.kind == NodeKind::name;
        is_good = (!is_name || check_name(requirement, value, node)) && is_good;
      }
    }
    return is_good;
  }

  // Where the train is wrong, that has been said.
  void check_questions(const Requirement& requirement) {
    for (const ConditionQuestion& question : requirement.condition.questions()) {
      if (context_.description.gears && !has_all_meshes(context_.description)) {
        continue;
      }
      const auto asked = PlanetQuestion::make(question.word, question.of, context_.description);
      if (const auto* fault = std::get_if<PlanetQuestion::Fault>(&asked)) {
        context_.found.error("E0313",
                             place_of(requirement, question.offset, question.length),
                             fault->message,
                             fault->hint);
      }
    }
  }

  bool check_name(const Requirement& requirement, const ConditionValue& value, const Node& node) {
    const std::string text(value.expression.text_of(node));
    const std::vector<Node> nodes = {{.kind = NodeKind::name, .length = node.length, .name = 0}};
    const Value name = {.expression = Expression(text, nodes, {text}),
                        .where = place_of(requirement, value.offset + node.offset, node.length)};
    return context_.evaluator.quantity(name).has_value();
  }

  // Names of a condition of rows are parameters, which thereby are used, and what rows hold; what
  // they hold where 'report' is left out is known once the mechanism is bound.
  void check_row_names(const Requirement& requirement) {
    for (const ConditionQuestion& question : requirement.condition.questions()) {
      context_.found.error(
          "E0308",
          place_of(requirement, question.offset, question.length),
          fmt::format("'{}({})' is not allowed in 'keep'", question.word, question.of),
          "write it under 'require': it is known before a state is analysed");
    }
    for (const ConditionValue& value : requirement.condition.values()) {
      for (const Node& node : value.expression.nodes()) {
        const std::string name(value.expression.text_of(node));
        const SourceRange where = place_of(requirement, value.offset + node.offset, node.length);
        const bool is_reported =
            std::ranges::find(sweep_.report, name, &Name::text) != sweep_.report.end();
        const bool is_parameter = context_.names.parameters.contains(name);
        if (is_reported && (node.kind == NodeKind::unit || is_parameter)) {
          refuse_two_meanings(name, is_parameter ? "a parameter" : "a unit", where);
        } else if (node.kind == NodeKind::name && is_parameter) {
          check_name(requirement, value, node);
        } else if (node.kind == NodeKind::name && !sweep_.report.empty() && !is_reported) {
          refuse_row_name(name, where);
        }
      }
    }
  }

  void refuse_two_meanings(const std::string& name, const std::string& other, SourceRange where) {
    context_.found.error("E0306",
                         where,
                         fmt::format("'{}' is {} and a quantity that the rows hold", name, other),
                         "give the actuator or the parameter another name");
  }

  void refuse_row_name(const std::string& name, SourceRange where) {
    std::vector<std::string> held;
    for (const Name& one : sweep_.report) {
      held.push_back(one.text);
    }
    const std::string guess = did_you_mean(name, held);
    const auto by_place = std::ranges::find_if(
        held, [&name](const std::string& one) { return one.starts_with(name + "/"); });
    context_.found.error(
        "E0313",
        where,
        fmt::format(
            "'keep' of 'sweep' names '{}', which is neither a parameter nor in its 'report'", name),
        by_place != held.end()
            ? fmt::format("a number by its place, such as {}, cannot stand in a formula, where '/' "
                          "divides",
                          *by_place)
        : guess.empty() ? fmt::format("add '{}' to 'report', which has {}", name, plain_list(held))
                        : guess);
  }

  // As far as the values under `parameters` show; that they give no result says nothing, for the
  // sweep puts others in their place.
  void check_dimensions(const Requirement& requirement) {
    const Condition& condition = requirement.condition;
    const ParameterTable& table = parameters_.table;
    const auto holds = evaluate_condition(condition, table.lookup(), table.names());
    const auto* error = std::get_if<ExpressionError>(&holds);
    if (error != nullptr && error->code != "E0316") {
      context_.found.error(error->code,
                           place_of(requirement, error->offset, error->length),
                           error->message,
                           error->hint);
    }
  }

  static SourceRange place_of(const Requirement& requirement, int offset, int length) {
    return place_in(
        requirement.where, requirement.text_column, requirement.condition.text(), offset, length);
  }

  // A case, a labelled gear, or a combination of elements such as C1+B2, or of none.
  void check_state(const Name& label) {
    if (context_.names.states.contains(label.text) || is_combination(label.text)) {
      return;
    }
    context_.names.states.check(label, "'sweep' runs", context_.found);
  }

  bool is_combination(std::string_view text) const {
    if (!context_.description.shift || text.empty()) {
      return false;
    }
    if (text == kNothingEngaged) {
      return true;
    }
    const std::vector<Name>& elements = context_.description.shift->elements;
    std::size_t begin = 0;
    while (begin <= text.size()) {
      const std::size_t end = std::min(text.find('+', begin), text.size());
      const std::string_view part = text.substr(begin, end - begin);
      if (std::ranges::none_of(elements, [&](const Name& one) { return one.text == part; })) {
        return false;
      }
      begin = end + 1;
    }
    return true;
  }

  const SectionContext& context_;
  const SweepDescription& sweep_;
  const ParameterValues parameters_ = evaluate_parameters(parameters_of(context_.description));
  std::optional<Dimension> kind_;
  double state_count_ = 1.0;
};

}  // namespace

void check_sweep(const SectionContext& context) {
  if (context.description.sweep) {
    SweepCheck(context, *context.description.sweep).run();
  }
}

}  // namespace kinestat
