#include "studies/motion/task/find_motion.hpp"

#include <utility>

#include "studies/motion/motion.hpp"
#include "studies/motion/task/columns/motion_column_choice.hpp"
#include "studies/motion/task/cycle/find_motion_dynamics.hpp"
#include "studies/motion/task/motion_findings.hpp"
#include "studies/motion/task/motion_table_maker.hpp"

namespace kinestat {

namespace {

// That of the energies, which look as often as they need, where the file asks for these.
void take_overall_efficiency(MotionTable& table) {
  if (!table.dynamics || !table.dynamics->energy) {
    return;
  }
  const EnergyFigures& energy = *table.dynamics->energy;
  if (energy.efficiency || !energy.no_efficiency.empty()) {
    table.overall_efficiency = energy.efficiency;
    table.no_overall_efficiency = energy.no_efficiency;
  }
}

}  // namespace

std::optional<FoundMotion> find_motion(const MechanismDescription& description,
                                       const Mechanism& mechanism,
                                       Diagnostics& found) {
  MotionPlan plan = *bind_motion(description, mechanism);
  if (!choose_columns(description, mechanism, plan, found) ||
      !check_report(plan, mechanism, found)) {
    return std::nullopt;
  }
  std::optional<FoundMotion> motion = follow_motion(description, mechanism, std::move(plan), found);
  if (!motion) {
    return std::nullopt;
  }
  PositionFindings of_positions;
  motion->table = make_motion_table(
      description, mechanism, *motion, {.overall_efficiency = true}, of_positions);
  add_findings(*motion, description, mechanism, of_positions, found);
  motion->table.dynamics = find_motion_dynamics(description, mechanism, *motion, found);
  take_overall_efficiency(motion->table);
  return motion;
}

std::optional<FoundMotion> follow_motion(const MechanismDescription& description,
                                         const Mechanism& mechanism,
                                         MotionPlan plan,
                                         Diagnostics& found) {
  FoundMotion motion;
  motion.plan = std::move(plan);
  if (!check_time(motion.plan, mechanism, description.units, found)) {
    return std::nullopt;
  }
  MotionTask task{.drives = {}, .steps = motion.plan.steps};
  std::vector<int> driven;
  for (const PlannedDrive& drive : motion.plan.drives) {
    task.drives.push_back({.freedom = drive.freedom, .from = drive.from, .to = drive.to});
    task.until_limit = task.until_limit || drive.until_limit;
    driven.push_back(drive.freedom);
  }
  if (motion.plan.schedule) {
    const DriveSchedule& schedule = *motion.plan.schedule;
    for (int k = 0; k <= task.steps; ++k) {
      task.shares.push_back(schedule.share_at(static_cast<double>(k) / task.steps));
    }
    if (!schedule.is_straight()) {
      task.path = [schedule](std::size_t drive, double share) {
        return schedule.at(drive, share).position;
      };
      task.turns = schedule.turns();
    }
  }
  motion.drawn = bind_drawn_couplings(description, mechanism);
  motion.network = make_motion_network(mechanism, motion.drawn, driven);
  if (!check_movable(motion, mechanism, found) || !check_ranges(motion, mechanism, found)) {
    return std::nullopt;
  }
  motion.solution = solve_motion(motion.network, task);
  for (std::size_t d = 0; d < motion.plan.drives.size(); ++d) {
    motion.plan.drives[d].to = motion.solution.drives[d].to;
  }
  return motion;
}

void add_findings(const FoundMotion& motion,
                  const MechanismDescription& description,
                  const Mechanism& mechanism,
                  const PositionFindings& of_positions,
                  Diagnostics& found) {
  add_motion_findings(motion, description, mechanism, found);
  add_motion_passive_findings(motion, mechanism, found);
  of_positions.tell(motion.table, found);
  add_motion_transmission_findings(motion, mechanism, found);
  add_motion_speed_findings(motion, mechanism, found);
  add_friction_turn_findings(motion, mechanism, found);
}

}  // namespace kinestat
