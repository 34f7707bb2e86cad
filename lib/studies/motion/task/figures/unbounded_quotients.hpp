// Quotients of a motion that become infinite on the way.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

/// Sees by the signs of what is divided between which steps quotients go through infinity: a ratio
/// where the output turns back and the input does not, a mechanical advantage where the input needs
/// nothing. Where both come to zero together, as at rest, the quotient stays what it is; and where
/// the divisor jumps to its other sign, as where friction turns round.
class UnboundedQuotients {
 public:
  /// Looks at positions of a motion, in any order, always with the same readings; where a drive
  /// `stands` nothing says how a quotient comes from before to behind.
  void look(const std::vector<MotionReading>& readings,
            const MotionPosition& position,
            double step,
            bool stands);

  /// What has no bound has no extreme and no mean, and poles instead. The columns of the readings
  /// begin at `first`, and the rows stand at those steps.
  void leave_out_unbounded(const std::vector<MotionReading>& readings,
                           std::size_t first,
                           std::span<const double> steps,
                           MotionTable& table) const;

 private:
  struct Seen {
    double step = 0.0;
    QuotientParts parts;
    bool stands = false;
  };

  static bool is_unbounded(std::span<const Seen> seen,
                           std::span<const double> steps,
                           std::vector<std::size_t>& poles);

  std::vector<std::vector<Seen>> seen_;  // of each reading
};

}  // namespace kinestat
