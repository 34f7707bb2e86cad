// The section `motion` bound to numbers: the drives and their ranges, and what is reported.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "mechanism/drive_schedule.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A drive and its range, measured from the drawn position [rad or m].
struct PlannedDrive {
  int actuator = 0;  ///< index into Topology::actuators
  int freedom = 0;   ///< index into Topology::freedoms
  double from = 0.0;
  double to = 0.0;
  bool until_limit = false;  ///< it runs until it reverses; the limit is looked for up to `to`
  SourceRange where;
};

/// A point whose path is reported.
struct TracedPoint {
  std::string name;  ///< by `name_of_trace`
  BodyId body;
  Vec3 at = Vec3::Zero();  ///< in the drawn position, from the origin of the geometry [m]
};

/// The columns of a motion by their names, "motor/action".
struct ChosenColumns {
  std::vector<std::string> usual;  ///< in the report without being named there
  std::vector<std::string> named;  ///< named by the report
};

/// The quantities that are reported in addition to the positions of the drives and traced points.
struct MotionReport {
  bool position = false;
  bool velocity = false;
  bool acceleration = false;
  bool action = false;
  bool reaction = false;  ///< resultant forces of couplings, their friction and what it loses
  bool power = false;
  bool efficiency = false;  ///< of the case, from its inputs to its outputs
  bool ratio = false;
  bool transmission_angle = false;
  bool mechanical_advantage = false;
  bool dynamics = false;       ///< energy, shaking force, wrench on the ground, equivalent inertia
  std::vector<int> positions;  ///< freedoms of which only the position is reported
  std::vector<int> freedoms;   ///< freedoms named one by one: position, velocity and acceleration
  std::vector<int> actions;    ///< actions named one by one
  std::vector<int> actuators;  ///< actuators of which everything is reported
  std::vector<Name> columns;   ///< names of columns, which are checked once the columns exist
  std::optional<ChosenColumns> chosen;  ///< the only columns that are reported; empty: all
  bool is_default = false;              ///< the file does not say what to report
  bool works = false;  ///< the default of a case with actions: those of actuators, and powers

  /// Of the actuators, at least.
  bool has_powers() const { return power || works; }

  /// That of the whole motion, where the case names both ends.
  bool tells_efficiency() const { return has_powers() || efficiency; }
};

/// Why a motion in time has no schedule.
enum class TimeProblem {
  none,
  no_speed,      ///< neither the case nor a law gives a drive a speed
  two_speeds,    ///< both the case and a law give a drive a speed
  two_courses,   ///< both the case and a profile or curve give a drive a course
  too_long,      ///< the profile of a drive takes longer than the motion
  beyond_curve,  ///< the curve of a drive does not cover the whole time
  no_duration,   ///< the curve of a drive repeats, and nothing gives a duration
  at_rest,       ///< a drive does not move, and nothing gives a duration
  never,         ///< a drive reverses before it reaches its end
  other_end,     ///< the given duration does not lead a drive to its end
  other_time,    ///< the drives reach their ends at different times
  to_limit       ///< the time at which a drive meets its limit is not known in advance
};

struct MotionPlan {
  std::vector<PlannedDrive> drives;
  std::optional<DriveSchedule> schedule;  ///< of a motion in time
  TimeProblem time_problem = TimeProblem::none;
  std::size_t problem_drive = 0;  ///< the drive with this problem
  int steps = 0;
  int which = -1;  ///< the case whose speeds and loads apply, index into Mechanism::cases; -1: none
  std::vector<TracedPoint> trace;
  MotionReport report;
  SourceRange where;
};

/// The member for which a word stands that reports many quantities at once; null for other words.
bool* find_report_word(std::string_view word, MotionReport& report);

/// The words that report many quantities at once.
std::span<const std::string> motion_report_words();

/// The name of a traced point: that of the file, otherwise BODY.N for the N-th point of the list.
std::string name_of_trace(const std::vector<TracePoint>& trace, std::size_t i);

/// Binds the section `motion` of a description that was bound to this mechanism without an error.
/// Empty if there is no such section. `which` is the case instead of that of the section, -1: none.
std::optional<MotionPlan> bind_motion(const MechanismDescription& description,
                                      const Mechanism& mechanism,
                                      std::optional<int> which = {});

/// Whether drives may run in time by the speeds and accelerations of a case.
bool runs_by_case(const MotionDescription& motion);

}  // namespace kinestat
