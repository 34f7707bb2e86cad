#include "studies/sweep/task/row_choice.hpp"

#include <algorithm>
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
    const auto holds = evaluate_condition(one.condition, lookup(), names_.names());
    const auto* error = std::get_if<ExpressionError>(&holds);
    if (error != nullptr && error->code != kNoFiniteValue) {
      const bool is_name = error->code == "E0311";
      found_.error(
          error->code,
          place_in(one.where, one.text_column, one.condition.text(), error->offset, error->length),
          error->message,
          is_name ? fmt::format("{}{}'report' of 'sweep' names what rows hold",
                                error->hint,
                                error->hint.empty() ? "" : " ")
                  : error->hint);
      return;
    }
    choice.keep.emplace_back(one.condition, slot_of());
  }

  void add_rank(const TopChoice& top, RowChoice& choice) {
    const bool is_quantity = std::ranges::find(quantities_, top.by) != quantities_.end();
    auto parsed = is_quantity ? std::variant<Expression, ExpressionError>(expression_named(top.by))
                              : parse_expression(top.by);
    if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
      refuse_rank(top, error->message, error->hint);
      return;
    }
    const auto& formula = std::get<Expression>(parsed);
    for (const std::string& name : formula.names()) {
      if (names_.slot_of(name) < 0) {
        refuse_rank(top,
                    name == top.by ? "the rows have no such quantity"
                                   : fmt::format("the rows have no quantity '{}'", printable(name)),
                    guess_before(name, names_.names(), "they have " + plain_list(quantities_)));
        return;
      }
    }
    const auto value = evaluate(formula, lookup(), names_.names());
    const auto* error = std::get_if<ExpressionError>(&value);
    if (error != nullptr && error->code != kNoFiniteValue) {
      refuse_rank(top, error->message, error->hint);
      return;
    }
    choice.rank.emplace(formula, slot_of());
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

  void refuse_rank(const TopChoice& top, const std::string& message, std::string hint) {
    found_.error(
        "E0101", {}, fmt::format("--by '{}': {}", printable(top.by), message), std::move(hint));
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
                                         const std::optional<TopChoice>& top,
                                         Diagnostics& found) {
  const int errors_before = found.error_count();
  RowChoice choice;
  ChoiceSearch search(description, plan, columns, found);
  for (const Requirement& one : description.sweep->keep) {
    search.add_condition(one, choice);
  }
  if (top) {
    search.add_rank(*top, choice);
  }
  const auto asks_parameters = [&](const auto& one) {
    const auto parameters = static_cast<int>(description.parameters.size());
    return std::ranges::any_of(one.slots(), [&](int slot) { return slot < parameters; });
  };
  choice.asks_parameters = std::ranges::any_of(choice.keep, asks_parameters) ||
                           (choice.rank && asks_parameters(*choice.rank));
  return found.error_count() == errors_before ? std::optional(std::move(choice)) : std::nullopt;
}

void RowJudge::enter(std::span<const std::uint64_t> places) {
  if (choice_.asks_parameters) {
    scope_.enter(places);
  }
}

std::optional<std::size_t> RowJudge::failing_condition(const SweepRow& row) {
  if (!choice_.keep.empty() || choice_.rank) {
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

std::optional<double> RowJudge::rank() {
  const std::optional<Quantity> value = choice_.rank->evaluate(scope_.slots(), scratch_);
  return value ? std::optional(value->value) : std::nullopt;
}

}  // namespace kinestat
