// A case worked out for rows of parameters that come from another program.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "studies/sweep/task/state_solver.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

/// What is asked of it.
struct RowRequest {
  std::vector<std::string> inputs;   ///< parameters
  std::vector<std::string> outputs;  ///< as `report` of a sweep has them; empty: as it chooses them
  std::optional<std::string> label;  ///< of the case; empty: there is but one
};

/// A sweep whose states are rows. What is recorded of the case is found with the first rows.
class RowPlayer {
 public:
  /// The description has been bound without an error. Empty iff an error was added.
  static std::optional<RowPlayer> make(MechanismDescription description,
                                       const RowRequest& request,
                                       Diagnostics& found);

  std::span<const SweepAxis> inputs() const { return task_->plan.axes(); }

  std::span<const SweepColumn> outputs() const { return task_->columns; }

  /// The outputs of each row behind those of the row before. A NaN is an output without a value.
  /// The numbers of the rows are finite; `status` is as long as there are rows, or empty.
  void play(std::span<const double> rows,
            std::span<double> outputs,
            std::span<const char*> statuses);

  /// Whether rows are played and not each analysed as a whole; known once some were.
  bool is_played() const { return task_->tapes.has_value(); }

 private:
  explicit RowPlayer(std::unique_ptr<SweepTask> task) : task_(std::move(task)) {}

  void run(std::span<double> outputs, std::span<const char*> statuses);
  const char* kept(std::string_view status);

  std::unique_ptr<SweepTask> task_;  // to which its tapes and the solver refer
  std::unique_ptr<StateSolver> solver_;
  std::set<std::string, std::less<>> statuses_;  // that rows have had
};

}  // namespace kinestat
