#include "math/tapes/internal/lane_tape_maker.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/index.hpp"

namespace kinestat {

namespace {

constexpr int kNever = std::numeric_limits<int>::max();

}  // namespace

template <class Visit>
void LaneTapeMaker::visit_operands(const Node& node, const Visit& visit) const {
  for (const int operand : node.operands) {
    if (operand >= 0) {
      visit(operand);
    }
  }
  for (int i = node.first_product; i < node.end_product; ++i) {
    visit(recorder_.products_[at(i)].a.node);
    visit(recorder_.products_[at(i)].b.node);
  }
}

// Operands stand before their operations, so that one pass from the back suffices.
void LaneTapeMaker::find_needed(std::span<const TapeNumber> outputs) {
  const auto& nodes = recorder_.nodes_;
  is_needed_.assign(nodes.size(), false);
  last_use_.assign(nodes.size(), -1);
  for (const TapeNumber& output : outputs) {
    is_needed_[at(output.node)] = true;
    last_use_[at(output.node)] = kNever;
  }
  for (const int demand : recorder_.demands_) {
    is_needed_[at(demand)] = true;
  }
  for (std::size_t n = nodes.size(); n > 0; --n) {
    if (is_needed_[n - 1]) {
      visit_operands(nodes[n - 1], [&](int operand) {
        is_needed_[at(operand)] = true;
        last_use_[at(operand)] = std::max(last_use_[at(operand)], static_cast<int>(n) - 1);
      });
    }
  }
}

void LaneTapeMaker::place_constants() {
  const auto& nodes = recorder_.nodes_;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (is_needed_[n] && nodes[n].what == LaneRecorder::What::constant) {
      cells_[n] = static_cast<int>(tape_.constants_.size());
      tape_.constants_.push_back(nodes[n].value);
    }
  }
  tape_.reads_input_.resize(at(recorder_.input_count_));
  tape_.cell_count_ = tape_.constants_.size() + tape_.reads_input_.size();
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].what == LaneRecorder::What::input) {
      tape_.reads_input_[at(nodes[n].input)] = is_needed_[n];
      cells_[n] = static_cast<int>(tape_.constants_.size()) + nodes[n].input;
    }
  }
}

int LaneTapeMaker::take_cell() {
  if (free_.empty()) {
    return static_cast<int>(tape_.cell_count_++);
  }
  const int cell = free_.back();
  free_.pop_back();
  return cell;
}

// Once, where a node is an operand twice.
void LaneTapeMaker::release_operands(const Node& node, int after) {
  visit_operands(node, [&](int operand) {
    const bool is_result = recorder_.nodes_[at(operand)].what == LaneRecorder::What::operation;
    if (is_result && last_use_[at(operand)] == after) {
      free_.push_back(cells_[at(operand)]);
      last_use_[at(operand)] = kNever;
    }
  });
}

void LaneTapeMaker::place_operation(int n) {
  const Node& node = recorder_.nodes_[at(n)];
  const auto cell_of = [&](int operand) { return operand < 0 ? 0 : cells_[at(operand)]; };
  LaneOperation one{.kind = node.kind,
                    .target = 0,
                    .a = cell_of(node.operands[0]),
                    .b = cell_of(node.operands[1]),
                    .c = cell_of(node.operands[2])};
  if (node.kind == LaneOperationKind::substitute_sum) {
    one.a = static_cast<int>(tape_.products_.size());
    for (int i = node.first_product; i < node.end_product; ++i) {
      const LaneRecorder::Product& product = recorder_.products_[at(i)];
      tape_.products_.push_back({.a = cell_of(product.a.node), .b = cell_of(product.b.node)});
    }
    one.b = static_cast<int>(tape_.products_.size());
  }
  release_operands(node, n);
  const bool has_result = last_use_[at(n)] >= 0;
  if (has_result) {
    one.target = cells_[at(n)] = take_cell();
  }
  tape_.operations_.push_back(one);
}

LaneTape LaneTapeMaker::make(std::span<const TapeNumber> outputs) {
  find_needed(outputs);
  cells_.assign(recorder_.nodes_.size(), -1);
  place_constants();
  for (std::size_t n = 0; n < recorder_.nodes_.size(); ++n) {
    if (is_needed_[n] && recorder_.nodes_[n].what == LaneRecorder::What::operation) {
      place_operation(static_cast<int>(n));
    }
  }
  for (const TapeNumber& output : outputs) {
    tape_.outputs_.push_back(cells_[at(output.node)]);
  }
  return std::move(tape_);
}

}  // namespace kinestat
