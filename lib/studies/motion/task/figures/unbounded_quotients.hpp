// Quotients of a motion that become infinite on the way.
#pragma once

#include <cstddef>
#include <vector>

#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

/// Sees by the signs of what is divided between which steps quotients go through infinity: a ratio
/// where the output turns back and the input does not, a mechanical advantage where the input needs
/// nothing. Where both come to zero together, as at rest, the quotient stays what it is.
class UnboundedQuotients {
 public:
  /// Looks at the positions of a motion one after the other, always with the same readings.
  void look(const std::vector<MotionReading>& readings, const MotionPosition& position);

  /// What has no bound has no extreme and no mean, and poles instead. The columns of the readings
  /// begin at `first`.
  void leave_out_unbounded(const std::vector<MotionReading>& readings,
                           std::size_t first,
                           MotionTable& table) const;

 private:
  std::vector<QuotientParts> last_;              // of each reading; 0: none yet
  std::vector<bool> is_unbounded_;               // likewise
  std::vector<std::vector<std::size_t>> poles_;  // likewise
  std::size_t row_ = 0;
};

}  // namespace kinestat
