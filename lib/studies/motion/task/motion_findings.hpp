// What became of a finite motion, as diagnostics.
#pragma once

#include <string_view>

#include "core/diagnostic.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// Where a case may be named: in 'motion', or in 'sweep' too.
enum class CasePlace { motion, sweep };

/// Whether what the plan asks for can be answered: quantities that need a case, or its input and
/// output. False iff an error was added.
bool check_report(const MotionPlan& plan,
                  const Mechanism& mechanism,
                  Diagnostics& found,
                  CasePlace place = CasePlace::motion);

/// How the drives run in time: E0509, W0512. False iff an error was added.
bool check_time(const MotionPlan& plan,
                const Mechanism& mechanism,
                const FileUnits& units,
                Diagnostics& found);

/// Couplings that cannot be moved: E0507. False iff there are any.
bool check_movable(const FoundMotion& motion, const Mechanism& mechanism, Diagnostics& found);

/// Ranges of drives that would take hours: E0305. False iff there are any.
bool check_ranges(const FoundMotion& motion, const Mechanism& mechanism, Diagnostics& found);

/// A limit on the way, which is an answer.
inline constexpr std::string_view kEndsAtLimit = "W0518";

/// What a limit on the way to the end is.
enum class EndOfMotion {
  may_be_a_limit,  ///< an answer, W0518
  must_be_reached  ///< none, E0505: only the end is asked for
};

/// What stopped the motion, and what it passed.
void add_motion_findings(const FoundMotion& motion,
                         const MechanismDescription& description,
                         const Mechanism& mechanism,
                         Diagnostics& found,
                         EndOfMotion end = EndOfMotion::may_be_a_limit);

/// Why rows have no velocities or accelerations, beside what is found of the case in each position;
/// nothing where all rows have what was asked for.
void add_motion_speed_findings(const FoundMotion& motion,
                               const Mechanism& mechanism,
                               Diagnostics& found);

/// W0506, once, that drives leave positions open: bodies that turn or shift without any other
/// feeling it, where the report has positions that show it, or velocities that neither the drives
/// nor the case determine.
void add_motion_passive_findings(const FoundMotion& motion,
                                 const Mechanism& mechanism,
                                 Diagnostics& found);

/// W0505, why there is no transmission angle: where one is asked for and no position has it. At
/// dead points alone it explains itself.
void add_motion_transmission_findings(const FoundMotion& motion,
                                      const Mechanism& mechanism,
                                      Diagnostics& found);

/// W0508, once a coupling, that friction turns round: at a dead point its friction has no
/// direction, and just before and behind it two.
void add_friction_turn_findings(const FoundMotion& motion,
                                const Mechanism& mechanism,
                                Diagnostics& found);

}  // namespace kinestat
