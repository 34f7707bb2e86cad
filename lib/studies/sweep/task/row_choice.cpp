#include "studies/sweep/task/row_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"

namespace kinestat {

namespace {

// What lies beyond the values of the file says nothing: rows have others.
constexpr std::string_view kNoFiniteValue = "E0316";

Expression expression_named(const std::string& name) {
  const std::vector<Node> nodes = {
      {.kind = NodeKind::name, .length = static_cast<int>(name.size()), .name = 0}};
  return Expression(name, nodes, {name});
}

class ChoiceSearch {
 public:
  ChoiceSearch(const MechanismDescription& description,
               const SweepPlan& plan,
               std::span<const SweepColumn> columns,
               Diagnostics& found)
      : names_(description, columns), scope_(plan, columns), found_(found) {
    for (const SweepColumn& column : columns) {
      quantities_.push_back(column.name);
    }
  }

  void add_condition(const Requirement& one, RowChoice& choice) {
    for (const ConditionValue& value : one.condition.values()) {
      if (const auto wrong = find_wrong_name(value.expression)) {
        refuse_condition(one, value.offset, *wrong);
        return;
      }
    }
    const auto holds = evaluate_condition(one.condition, lookup(), names_.names());
    const auto* error = std::get_if<ExpressionError>(&holds);
    if (error != nullptr && error->code != kNoFiniteValue) {
      refuse_condition(one, 0, *error);
      return;
    }
    choice.keep.emplace_back(one.condition, slot_of());
  }

  // `option` is what was typed before it.
  void add_rank(const Criterion& one, std::string_view option, RowChoice& choice) {
    const auto refuse = [&](const ExpressionError& error) {
      found_.error("E0101",
                   {},
                   fmt::format("{} '{}': {}", option, printable(one.by), error.message),
                   error.hint);
    };
    // Whatever else has its name: what ranks rows is a quantity first.
    if (std::ranges::find(quantities_, one.by) != quantities_.end()) {
      const SlotOf slot = [this](const std::string& name) { return names_.quantity_slot(name); };
      choice.ranks.push_back(
          {.value = SlotExpression(expression_named(one.by), slot), .order = one.order});
      return;
    }
    const auto parsed = parse_expression(one.by);
    if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
      refuse(*error);
      return;
    }
    const auto& formula = std::get<Expression>(parsed);
    if (const auto wrong = find_wrong_name(formula)) {
      refuse(*wrong);
      return;
    }
    const auto value = evaluate(formula, lookup(), names_.names());
    const auto* error = std::get_if<ExpressionError>(&value);
    if (error != nullptr && error->code != kNoFiniteValue) {
      refuse(*error);
      return;
    }
    const bool has_terms = std::ranges::any_of(formula.nodes(), [](const Node& node) {
      return node.kind == NodeKind::add || node.kind == NodeKind::subtract;
    });
    choice.ranks.push_back(
        {.value = SlotExpression(formula, slot_of()), .order = one.order, .has_terms = has_terms});
  }

 private:
  NameLookup lookup() const {
    return [this](std::string_view name) -> const Quantity* {
      const int slot = names_.slot_of(std::string(name));
      return slot < 0 ? nullptr : &scope_.slots().values[static_cast<std::size_t>(slot)];
    };
  }

  SlotOf slot_of() const {
    return [this](const std::string& name) { return names_.slot_of(name); };
  }

  static ExpressionError two_meanings(const Expression& formula,
                                      const Node& node,
                                      std::string_view other) {
    return {.offset = node.offset,
            .length = node.length,
            .code = "E0306",
            .message = fmt::format("'{}' is {} and a quantity that the rows hold",
                                   printable(formula.text_of(node)),
                                   other),
            .hint = "give the actuator or the parameter another name"};
  }

  // The first name that nothing has, or two things have. Evaluation does not see all names: it
  // stops where a condition is decided.
  std::optional<ExpressionError> find_wrong_name(const Expression& formula) const {
    for (const Node& node : formula.nodes()) {
      if (node.kind == NodeKind::unit &&
          names_.quantity_slot(std::string(formula.text_of(node))) >= 0) {
        return two_meanings(formula, node, "a unit");
      }
      const std::string name(node.kind == NodeKind::name ? formula.text_of(node) : "");
      const int slot = name.empty() ? 0 : names_.slot_of(name);
      if (slot < 0) {
        return ExpressionError{
            .offset = node.offset,
            .length = node.length,
            .code = "E0311",
            .message = fmt::format("the rows have no quantity '{}'", printable(name)),
            .hint = guess_before(name, names_.names(), "they have " + plain_list(quantities_))};
      }
      const int quantity = name.empty() ? -1 : names_.quantity_slot(name);
      if (quantity >= 0 && quantity != slot) {
        return two_meanings(formula, node, "a parameter");
      }
    }
    return std::nullopt;
  }

  void refuse_condition(const Requirement& one, int offset, const ExpressionError& error) {
    found_.error(
        error.code,
        place_in(
            one.where, one.text_column, one.condition.text(), offset + error.offset, error.length),
        error.message,
        error.hint);
  }

  RowNames names_;
  RowScope scope_;
  std::vector<std::string> quantities_;
  Diagnostics& found_;
};

}  // namespace

std::optional<RowChoice> find_row_choice(const MechanismDescription& description,
                                         const SweepPlan& plan,
                                         std::span<const SweepColumn> columns,
                                         const std::optional<BestChoice>& best,
                                         Diagnostics& found) {
  const int errors_before = found.error_count();
  RowChoice choice;
  ChoiceSearch search(description, plan, columns, found);
  for (const Requirement& one : description.sweep->keep) {
    search.add_condition(one, choice);
  }
  for (const Criterion& one : best ? best->criteria : std::vector<Criterion>()) {
    search.add_rank(one, best->is_front() ? "--pareto" : "--by", choice);
  }
  const auto asks_parameters = [&](const auto& one) {
    const auto parameters = static_cast<int>(description.parameters.size());
    return std::ranges::any_of(one.slots(), [&](int slot) { return slot < parameters; });
  };
  choice.asks_parameters = std::ranges::any_of(choice.keep, asks_parameters) ||
                           std::ranges::any_of(choice.ranks, asks_parameters, &Rank::value);
  return found.error_count() == errors_before ? std::optional(std::move(choice)) : std::nullopt;
}

void RowJudge::enter(std::span<const std::uint64_t> places) {
  if (choice_.asks_parameters) {
    scope_.enter(places);
  }
}

std::optional<std::size_t> RowJudge::failing_condition(const SweepRow& row) {
  if (!choice_.keep.empty() || !choice_.ranks.empty()) {
    scope_.show(row);
  }
  const auto fails = [&](const SlotCondition& one) {
    return !one.holds(scope_.slots(), scratch_).value_or(false);
  };
  const auto at = std::ranges::find_if(choice_.keep, fails);
  return at != choice_.keep.end()
             ? std::optional(static_cast<std::size_t>(at - choice_.keep.begin()))
             : std::nullopt;
}

// How large what a criterion adds up is, by what a small share of each name in it changes.
double RowJudge::terms_of(const Rank& rank, double value) {
  constexpr double kShare = 0x1p-26;
  changed_ = scope_.slots();
  double terms = 0.0;
  for (const int slot : rank.value.slots()) {
    Quantity& name = changed_.values[static_cast<std::size_t>(slot)];
    const double before = std::exchange(name.value, name.value * (1.0 + kShare));
    const std::optional<Quantity> changed = rank.value.evaluate(changed_, scratch_);
    terms += changed ? std::abs(changed->value - value) / kShare : 0.0;
    name.value = before;
  }
  return terms;
}

std::optional<RankKeys> RowJudge::rank() {
  RankKeys keys = {};
  for (std::size_t i = 0; i < choice_.ranks.size(); ++i) {
    const Rank& rank = choice_.ranks[i];
    const std::optional<Quantity> value = rank.value.evaluate(scope_.slots(), scratch_);
    if (!value) {
      return std::nullopt;
    }
    const double terms = rank.has_terms ? terms_of(rank, value->value) : 0.0;
    keys[i] = rank_key(value->value, rank.order, terms);
  }
  return keys;
}

}  // namespace kinestat
