// The motion of one state of a sweep, and its figures in the rows.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "studies/motion/task/found_motion.hpp"
#include "studies/sweep/motion/swept_motion.hpp"
#include "studies/sweep/report/sweep_rows.hpp"

namespace kinestat {

/// Each worker has its own.
class StateMotion {
 public:
  /// Both must outlive it; `columns` are those of the rows.
  StateMotion(const SweptMotion& asked, std::span<const SweepColumn> columns);

  /// Moves the mechanism of a state and fills what rows have of its motion: the values that
  /// `kinestat motion` reports, where they are right. Rows that are solved so far get the status of
  /// the motion.
  void fill(const MechanismDescription& description,
            const Mechanism& mechanism,
            std::span<SweepRow> rows);

 private:
  std::string move(const MechanismDescription& description,
                   const Mechanism& mechanism,
                   std::size_t row,
                   std::optional<FoundMotion>& motion);
  std::string find_figures(const MechanismDescription& description,
                           const Mechanism& mechanism,
                           FoundMotion& motion);
  void show(std::string_view status, SweepRow& row);

  const SweptMotion& asked_;
  std::span<const SweepColumn> columns_;
  std::vector<double> values_;                   ///< of the figures, of the last row
  std::set<std::string, std::less<>> statuses_;  ///< rows point into them
};

}  // namespace kinestat
