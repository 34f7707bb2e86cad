// Which rows of a sweep are written, and which of them are best.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "expression/slots.hpp"
#include "studies/sweep/ranked_row.hpp"
#include "studies/sweep/task/row_scope.hpp"

namespace kinestat {

/// A criterion by which rows are ranked.
struct Rank {
  SlotExpression value;
  RankOrder order = RankOrder::largest;
  bool has_terms = false;  ///< it adds or subtracts
};

struct RowChoice {
  std::vector<SlotCondition> keep;  ///< what a row must fulfil
  std::vector<Rank> ranks;          ///< by which the best are chosen; none: all are written
  bool asks_parameters = false;     ///< whether any of these names parameters
};

/// Of the section `sweep`, and of --top or --pareto. A condition or a formula names parameters and
/// quantities of the rows; errors are those of conditions (E0311 for another name), and E0101 for
/// criteria. Empty iff an error was added.
std::optional<RowChoice> find_row_choice(const MechanismDescription& description,
                                         const SweepPlan& plan,
                                         std::span<const SweepColumn> columns,
                                         const std::optional<BestChoice>& best,
                                         Diagnostics& found);

/// Judges rows; each worker has its own.
class RowJudge {
 public:
  /// All of these must outlive it.
  RowJudge(const SweepPlan& plan, std::span<const SweepColumn> columns, const RowChoice& choice)
      : choice_(choice), scope_(plan, columns) {}

  /// Takes the places of a state on the axes.
  void enter(std::span<const std::uint64_t> places);

  /// Takes a row of that state; the first condition that does not hold or cannot be told.
  std::optional<std::size_t> failing_condition(const SweepRow& row);

  /// What ranks that row, if all of it has a value.
  std::optional<RankKeys> rank();

 private:
  double terms_of(const Rank& rank, double value);

  const RowChoice& choice_;
  RowScope scope_;
  Slots changed_;
  std::vector<Quantity> scratch_;
};

}  // namespace kinestat
