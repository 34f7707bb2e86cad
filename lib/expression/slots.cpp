#include "expression/slots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/contract.hpp"
#include "expression/evaluate/arithmetic.hpp"
#include "expression/evaluate/condition_value.hpp"
#include "expression/evaluate/sum_rounding.hpp"

namespace kinestat {

namespace {

// The usual case of an operation, as `operate` has it: results that are finite and no zeros, which
// might be underflow, of bare numbers or a sum. Empty for whatever needs a closer look.
std::optional<Quantity> usual_result(const Node& node, const Quantity& a, const Quantity& b) {
  double value = 0.0;
  switch (node.kind) {
    case NodeKind::add:
      value = a.value + b.value;
      break;
    case NodeKind::subtract:
      value = a.value - b.value;
      break;
    case NodeKind::multiply:
      value = a.value * b.value;
      break;
    case NodeKind::divide:
      value = a.value / b.value;
      break;
    default:
      return std::nullopt;
  }
  const bool has_dimension =
      is_sum(node.kind) ? a.dimension == b.dimension : is_bare(a.dimension) && is_bare(b.dimension);
  const bool is_usual = has_dimension && std::isfinite(value) && value != 0.0;
  return is_usual ? std::optional(Quantity{value, a.dimension}) : std::nullopt;
}

}  // namespace

SlotExpression::SlotExpression(Expression expression, const SlotOf& slot_of)
    : expression_(std::move(expression)) {
  for (const std::string& name : expression_.names()) {
    slots_.push_back(slot_of(name));
    KINESTAT_EXPECTS(slots_.back() >= 0);
  }
}

std::optional<Quantity> SlotExpression::evaluate(const Slots& slots,
                                                 std::vector<Quantity>& scratch) const {
  const std::span<const Node> nodes = expression_.nodes();
  scratch.clear();
  for (const Node& node : nodes) {
    if (node.kind == NodeKind::name) {
      const auto slot = static_cast<std::size_t>(slots_[static_cast<std::size_t>(node.name)]);
      if (!slots.has_value[slot]) {
        return std::nullopt;
      }
      scratch.push_back(slots.values[slot]);
      continue;
    }
    if (node.left < 0) {
      scratch.push_back(leaf(node));
      continue;
    }
    const int right = node.right < 0 ? node.left : node.right;
    const Unit* unit = node.right < 0 ? nullptr : nodes[static_cast<std::size_t>(right)].unit;
    const Quantity& a = scratch[static_cast<std::size_t>(node.left)];
    const Quantity& b = scratch[static_cast<std::size_t>(right)];
    std::optional<Quantity> usual = unit == nullptr ? usual_result(node, a, b) : std::nullopt;
    if (usual) {
      if (is_sum(node.kind)) {
        const auto value_at = [&](int index) {
          return scratch[static_cast<std::size_t>(index)].value;
        };
        usual->value = settled_sum(nodes, value_at, node, usual->value);
      }
      scratch.push_back(*usual);
      continue;
    }
    const Outcome outcome = operate(node, a, b, unit);
    const auto* value = std::get_if<Quantity>(&outcome);
    if (value == nullptr) {
      return std::nullopt;
    }
    scratch.push_back(*value);
  }
  return scratch.back();
}

SlotCondition::SlotCondition(Condition condition, const SlotOf& slot_of, const AnswerOf& answer_of)
    : condition_(std::move(condition)) {
  for (const ConditionValue& value : condition_.values()) {
    values_.emplace_back(value.expression, slot_of);
  }
  for (const std::string& name : condition_.names()) {
    slots_.push_back(slot_of(name));
  }
  for (const ConditionQuestion& question : condition_.questions()) {
    answers_.push_back(answer_of(question));
    const std::vector<int>& slots = answers_.back().slots;
    slots_.insert(slots_.end(), slots.begin(), slots.end());
  }
}

std::optional<bool> SlotCondition::holds(const Slots& slots, std::vector<Quantity>& scratch) const {
  const int count = static_cast<int>(condition_.parts().size());
  return count == 0 ? std::optional(true) : part_holds(count - 1, slots, scratch);
}

// As ConditionCheck, which also has words for what is wrong.
std::optional<bool> SlotCondition::part_holds(int index,
                                              const Slots& slots,
                                              std::vector<Quantity>& scratch) const {
  const ConditionPart& part = condition_.parts()[static_cast<std::size_t>(index)];
  if (part.kind == ConditionKind::comparison) {
    const auto left = values_[static_cast<std::size_t>(part.left)].evaluate(slots, scratch);
    const auto right = values_[static_cast<std::size_t>(part.right)].evaluate(slots, scratch);
    if (!left || !right || left->dimension != right->dimension) {
      return std::nullopt;
    }
    return kinestat::holds(part.comparison, order_of(left->value, right->value));
  }
  if (part.kind == ConditionKind::question) {
    return answers_[static_cast<std::size_t>(part.left)].holds(slots, scratch);
  }
  const std::optional<bool> left = part_holds(part.left, slots, scratch);
  if (!left || part.kind == ConditionKind::negation) {
    return left ? std::optional(!*left) : std::nullopt;
  }
  const bool is_decided = *left == (part.kind == ConditionKind::either);
  return is_decided ? left : part_holds(part.right, slots, scratch);
}

}  // namespace kinestat
