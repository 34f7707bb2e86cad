// The efficiency of a whole motion, by the mean powers of its case.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// Takes the means of all powers from columns of its own, the last of the table before the closure
/// error: of a motion without time they count for as long as the drive stays at a position.
class OverallEfficiency {
 public:
  OverallEfficiency(const Mechanism& mechanism, const MotionPlan& plan);

  /// None where the report does not tell it, or the case lacks ends, motions or actions. `first` is
  /// the case with all of its loads, as solved in some position.
  void add_readings(const CaseAnalysis& first, std::vector<MotionReading>& readings);

  /// Whether it is a column of its own.
  static bool is_own(const MotionColumn& column);

  /// Tells the efficiency, or why there is none, by the figures of the table, and erases its own
  /// columns.
  void finish(MotionTable& table) const;

 private:
  void balance(double left, std::vector<double>& actuators, std::vector<double>& loads) const;
  void tell(std::size_t first, MotionTable& table) const;
  std::optional<double> stay(const MotionPosition& at) const;

  const Mechanism& mechanism_;
  const MotionPlan& plan_;
  bool has_question_ = false;
  std::optional<Case> which_;         // with its loads as solved
  std::optional<std::size_t> drive_;  // the one that runs, of a motion without time
};

}  // namespace kinestat
