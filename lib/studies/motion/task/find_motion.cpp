#include "studies/motion/task/find_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/accuracy.hpp"
#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/bind/near_description.hpp"
#include "studies/motion/motion.hpp"
#include "studies/motion/task/motion_choice.hpp"
#include "studies/motion/task/motion_findings.hpp"
#include "studies/motion/task/motion_passive_findings.hpp"
#include "studies/motion/task/motion_speed_findings.hpp"
#include "studies/motion/task/motion_table_maker.hpp"
#include "studies/motion/task/motion_transmission_findings.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

namespace {

// Far from the origin of the world, doubles would lose the digits of what lies between the points.
std::optional<MechanismDescription> beside_mechanism(const MechanismDescription& description,
                                                     const Mechanism& mechanism) {
  const Vec3& origin = mechanism.geometry.origin;
  return origin.isZero(0.0) ? std::nullopt : described_from(description, origin);
}

// How many digits of the size are left of the coordinates.
void warn_of_far_origin(const FoundMotion& motion, const Mechanism& mechanism, Diagnostics& found) {
  const double distance = mechanism.geometry.origin.norm();
  const double left = std::floor(-std::log10(kEpsilon * distance / mechanism.geometry.length));
  if (distance > 0.0 && left < kUsualDigits) {
    found.warning(
        "W0502",
        motion.plan.where,
        fmt::format("the mechanism is so far from the origin that its points are rounded: "
                    "about {:.0f} digits of the motion are right",
                    std::max(left, 0.0)),
        "draw it near the origin");
  }
}

}  // namespace

std::optional<FoundMotion> find_motion(const MechanismDescription& drawn,
                                       const Mechanism& in_world,
                                       Diagnostics& found) {
  FoundMotion motion;
  const std::optional<MechanismDescription> beside = beside_mechanism(drawn, in_world);
  const MechanismDescription& description = beside ? *beside : drawn;
  if (beside) {
    Diagnostics ignored;  // It complains of nothing that the first binding did not.
    motion.near = bind_unassembled(*beside, ignored);
    motion.origin = in_world.geometry.origin;
    KINESTAT_EXPECTS(motion.near.has_value());
  }
  const Mechanism& mechanism = motion.near ? *motion.near : in_world;
  motion.plan = *bind_motion(description, mechanism);
  if (!check_report(motion.plan, mechanism, found)) {
    return std::nullopt;
  }
  MotionTask task{.drives = {}, .steps = motion.plan.steps};
  std::vector<int> driven;
  for (const PlannedDrive& drive : motion.plan.drives) {
    task.drives.push_back({.freedom = drive.freedom, .from = drive.from, .to = drive.to});
    driven.push_back(drive.freedom);
  }
  motion.drawn = bind_drawn_couplings(description, mechanism);
  motion.network = make_motion_network(mechanism, motion.drawn, driven);
  if (!check_movable(motion, mechanism, found) || !check_ranges(motion, mechanism, found)) {
    return std::nullopt;
  }
  warn_of_far_origin(motion, mechanism, found);
  motion.solution = solve_motion(motion.network, task);
  PositionFindings of_positions;
  motion.table = make_motion_table(description, mechanism, motion, of_positions);
  add_motion_findings(motion, description, mechanism, found);
  add_motion_passive_findings(motion, mechanism, found);
  of_positions.tell(motion.table, found);
  add_motion_transmission_findings(motion, mechanism, found);
  add_motion_speed_findings(motion, mechanism, found);
  return motion;
}

}  // namespace kinestat
