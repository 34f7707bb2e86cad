#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "studies/motion/task/motion_findings.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

namespace {

std::string turn_place(const FrictionTurn& turn, const MotionTable& table) {
  const std::string from = row_place(table, table.rows[turn.before]);
  return turn.before == turn.after
             ? fmt::format("at {}", from)
             : fmt::format("between {} and {}", from, row_place(table, table.rows[turn.after]));
}

}  // namespace

void add_friction_turn_findings(const FoundMotion& motion,
                                const Mechanism& mechanism,
                                Diagnostics& found) {
  const std::vector<CouplingTopology>& couplings = mechanism.topology.couplings;
  for (const FrictionTurn& turn : motion.table.friction_turns) {
    const auto at = std::ranges::find(couplings, turn.coupling, &CouplingTopology::name);
    const std::string more = turn.count == 1   ? ""
                             : turn.count == 2 ? ", and once more"
                                               : fmt::format(", and {} more times", turn.count - 1);
    found.warning(
        "W0508",
        at->where,
        fmt::format(
            "friction of '{}' reverses {}{}", turn.coupling, turn_place(turn, motion.table), more),
        "friction changes sign there, so actions jump; at the reversal itself they are "
        "undetermined, and a row exactly there has none");
  }
}

}  // namespace kinestat
