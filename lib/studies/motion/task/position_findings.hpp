// What there is to say of the positions of a motion, each thing once.
#pragma once

#include <string_view>
#include <vector>

#include "cases/case_findings.hpp"
#include "core/diagnostic.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// Gathers the findings of the rows of a motion, in their order.
class PositionFindings {
 public:
  /// Those of the row of that number, counted from 0.
  void add(std::size_t row, const CaseFindings& found);

  /// Tells each with the brackets of the first drive in which it holds. Of one that `found` says of
  /// the drawn position already and that holds everywhere, nothing more is said.
  void tell(const MotionTable& table, Diagnostics& found) const;

 private:
  // One finding, as it is where it is worst.
  struct Held {
    CaseFinding worst;
    std::size_t worst_row = 0;
    bool varies = false;  ///< it is not the same everywhere
    std::vector<std::size_t> rows;
  };

  std::vector<Held> held_;
};

}  // namespace kinestat
