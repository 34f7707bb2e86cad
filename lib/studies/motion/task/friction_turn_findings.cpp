#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "studies/motion/task/motion_findings.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

namespace {

// That of the first turn; a longer rest has none.
const MotionEvent* first_event(const FrictionTurn& turn, const MotionTable& table) {
  const auto event = std::ranges::find_if(table.events, [&](const MotionEvent& one) {
    return one.kind == kFrictionReversalEvent && one.element == turn.coupling &&
           one.row >= turn.turns.front().before && one.row <= turn.turns.front().after;
  });
  return event == table.events.end() ? nullptr : &*event;
}

// The first place.
std::string turn_place(const FrictionTurn& turn, const MotionTable& table) {
  if (const MotionEvent* event = first_event(turn, table)) {
    return "at " + event_place(table, *event);
  }
  const auto [before, after] = turn.turns.front();
  const auto place_of = [&](double row) {
    return row_place(table, table.rows[static_cast<std::size_t>(row)]);
  };
  return before == after
             ? fmt::format("at {}", place_of(before))
             : fmt::format(
                   "between {} and {}", place_of(std::floor(before)), place_of(std::ceil(after)));
}

}  // namespace

void add_friction_turn_findings(const FoundMotion& motion,
                                const Mechanism& mechanism,
                                Diagnostics& found) {
  const std::vector<CouplingTopology>& couplings = mechanism.topology.couplings;
  for (const FrictionTurn& turn : motion.table.friction_turns) {
    const auto at = std::ranges::find(couplings, turn.coupling, &CouplingTopology::name);
    const std::size_t count = turn.turns.size();
    const std::string more = count == 1   ? ""
                             : count == 2 ? ", and once more"
                                          : ", and " + counted(count - 1, "more time");
    found.warning(
        "W0508",
        at->where,
        fmt::format(
            "friction of '{}' reverses {}{}", turn.coupling, turn_place(turn, motion.table), more),
        fmt::format("friction changes sign there, so actions jump; at the reversal itself they are "
                    "undetermined, and a row exactly there has none{}",
                    first_event(turn, motion.table) == nullptr
                        ? ""
                        : "; 'events' in JSON and CSV have their values on either side"));
  }
}

}  // namespace kinestat
