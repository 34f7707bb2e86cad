#include "sensitivity/internal/adjoint_side.hpp"

#include <utility>

namespace kinestat {

namespace {

std::vector<int> columns_of(const std::vector<Primary>& primaries, int first) {
  std::vector<int> columns;
  for (const Primary& primary : primaries) {
    columns.push_back(first + primary.index);
  }
  return columns;
}

}  // namespace

AdjointSide::AdjointSide(SparseMatrix system,
                         const std::vector<Primary>& primaries,
                         int first_column,
                         std::vector<double> units,
                         std::vector<Change> changes)
    : row_count_(static_cast<std::size_t>(system.rows)),
      column_count_(system.columns),
      elimination_(std::move(system), columns_of(primaries, first_column)),
      first_column_(first_column),
      units_(std::move(units)),
      changes_(std::move(changes)) {
  for (const Change& change : changes_) {
    is_possible_.push_back(change.is_nothing() ||
                           elimination_.is_consistent(change.known, right_hand_side(change)));
  }
}

void AdjointSide::add(const std::vector<double>& slopes,
                      std::vector<std::optional<Sum>>& result) const {
  VecX gradient = VecX::Zero(column_count_);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    gradient[first_column_ + static_cast<int>(i)] = slopes[i] * units_[i];
  }
  const AdjointSolution adjoint = elimination_.solve_adjoint(gradient);
  for (std::size_t p = 0; p < changes_.size(); ++p) {
    if (!is_possible_[p]) {
      result[p] = std::nullopt;
    } else if (result[p]) {
      kinestat::add(adjoint, changes_[p], *result[p]);
    }
  }
}

std::vector<double> AdjointSide::right_hand_side(const Change& change) const {
  std::vector<double> rhs(row_count_, 0.0);
  for (const auto& [row, value] : change.rows) {
    rhs[static_cast<std::size_t>(row)] += value;
  }
  return rhs;
}

}  // namespace kinestat
