// From the positions of a motion to its table, in the units of the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

/// What of a motion is worked out, where not all of it is asked for.
struct MotionScope {
  std::optional<std::vector<std::string>> columns = {};  ///< these by their names; empty: all
  bool dead_points = true;
  bool overall_efficiency = false;                        ///< where the report tells it
  std::optional<std::vector<std::string>> extremes = {};  ///< of these they are looked for between
                                                          ///< the steps; empty: of all that can be
};

/// The table of what was found. What there is to say of its rows is added to `found`.
MotionTable make_motion_table(const MechanismDescription& description,
                              const Mechanism& mechanism,
                              const FoundMotion& motion,
                              const MotionScope& scope,
                              PositionFindings& found);

}  // namespace kinestat
