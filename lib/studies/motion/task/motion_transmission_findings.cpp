#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "power/transmission_angle.hpp"
#include "studies/motion/task/motion_findings.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

namespace {

std::string reason_of(TransmissionObstacle why, std::string_view output) {
  switch (why) {
    case TransmissionObstacle::same_actuator:
      return "it is the input too";
    case TransmissionObstacle::no_one_coupling:
      return fmt::format("the body of '{}' is not driven through exactly one other coupling",
                         output);
    case TransmissionObstacle::open_force:
      return fmt::format("equilibrium does not determine the force that drives '{}'", output);
    case TransmissionObstacle::couple:
      return fmt::format("a couple drives '{}', and it has no line", output);
    case TransmissionObstacle::rest:
      return fmt::format("'{}' does not move where the force acts", output);
  }
  return {};
}

std::string hint_of(TransmissionObstacle why) {
  return why == TransmissionObstacle::open_force
             ? "write 'space: planar' if all moves in one plane, or list with 'passive:' what the "
               "couplings carry; 'mechanical_advantage' needs no force"
             : "take 'transmission_angle' out of 'report'; 'mechanical_advantage' says how well "
               "the output is driven";
}

}  // namespace

void add_motion_transmission_findings(const FoundMotion& motion,
                                      const Mechanism& mechanism,
                                      Diagnostics& found) {
  const MotionTable& table = motion.table;
  const auto column =
      std::ranges::find(table.columns, "transmission_angle", &MotionColumn::quantity);
  if (column == table.columns.end()) {
    return;
  }
  const auto c = static_cast<std::size_t>(column - table.columns.begin());
  const MotionRow* first = nullptr;
  for (const MotionRow& row : table.rows) {
    if (row.values[c]) {
      return;
    }
    first = first == nullptr && row.status != kSingularEvent ? &row : first;
  }
  if (first == nullptr) {
    return;
  }
  MotionPositions positions(
      mechanism,
      motion.plan,
      motion.network,
      motion.drawn,
      {.transmission_angle = true, .closure_error = worst_closure_error(motion.solution)});
  positions.at(motion.solution.configuration_at(first->step),
               motion.solution.shares[static_cast<std::size_t>(first->step)]);
  const Case& which = mechanism.cases[static_cast<std::size_t>(motion.plan.which)];
  const int output = which.outputs.front();
  if (const auto why =
          find_transmission_obstacle(positions.moved(), which.inputs.front(), output)) {
    const std::string& name = mechanism.topology.actuators[static_cast<std::size_t>(output)].name;
    found.warning("W0505",
                  motion.plan.where,
                  fmt::format("'{}' has no transmission angle: {}", name, reason_of(*why, name)),
                  hint_of(*why));
  }
}

}  // namespace kinestat
