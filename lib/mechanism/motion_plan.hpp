// The section `motion` bound to numbers: which drives run how far, and what is followed.
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
  bool until_limit = false;  ///< it runs until it turns back; `to` is how far that is looked for
  SourceRange where;
};

/// A point whose path is reported.
struct TracedPoint {
  std::string name;  ///< by `name_of_trace`
  BodyId body;
  Vec3 at = Vec3::Zero();  ///< in the drawn position, from the geometry's origin [m]
};

/// The columns of a motion by their names, "motor/action".
struct ChosenColumns {
  std::vector<std::string> usual;  ///< that the report has without a name of theirs
  std::vector<std::string> named;  ///< that the report names
};

/// Which quantities are reported beside the positions of the drives and the traced points.
struct MotionReport {
  bool position = false;
  bool velocity = false;
  bool acceleration = false;
  bool action = false;
  bool power = false;
  bool ratio = false;
  bool transmission_angle = false;
  bool mechanical_advantage = false;
  bool dynamics = false;       ///< energy, shaking and ground, equivalent inertia
  std::vector<int> positions;  ///< of these freedoms the position alone
  std::vector<int> freedoms;   ///< named one by one: their position, velocity and acceleration
  std::vector<int> actions;    ///< likewise
  std::vector<int> actuators;  ///< with all that is known of them
  std::vector<Name> columns;   ///< other names: of columns, which show once they are made
  std::optional<ChosenColumns> chosen;  ///< of all columns these alone; empty: all
  bool is_default = false;              ///< the file does not say what to report
};

/// Why a motion that is told in time has none.
enum class TimeProblem {
  none,
  no_speed,      ///< the case does not give a drive a speed, nor a law
  two_speeds,    ///< both do
  two_courses,   ///< the case, and a profile or a curve of the drive
  too_long,      ///< its profile takes longer than the motion
  beyond_curve,  ///< its curve does not reach over the whole time
  no_duration,   ///< a curve that repeats does not tell how long
  at_rest,       ///< a drive does not move, and nothing says how long
  never,         ///< a drive turns back before it comes to where it should end
  other_end,     ///< a drive ends elsewhere than the time says
  other_time,    ///< drives come to their ends at unlike times
  to_limit       ///< nobody knows before when a limit is met
};

struct MotionPlan {
  std::vector<PlannedDrive> drives;
  std::optional<DriveSchedule> schedule;  ///< of a motion in time
  TimeProblem time_problem = TimeProblem::none;
  std::size_t problem_drive = 0;  ///< whose
  int steps = 0;
  int which = -1;  ///< the case whose speeds and loads apply, index into Mechanism::cases; -1: none
  std::vector<TracedPoint> trace;
  MotionReport report;
  SourceRange where;
};

/// What a word stands for that reports many quantities at once; null for any other.
bool* find_report_word(std::string_view word, MotionReport& report);

/// These words.
std::span<const std::string> motion_report_words();

/// As the file says, or BODY.N, the N-th of all.
std::string name_of_trace(const std::vector<TracePoint>& trace, std::size_t i);

/// Of a description that has been bound to this mechanism without an error; empty if it has no
/// section `motion`.
std::optional<MotionPlan> bind_motion(const MechanismDescription& description,
                                      const Mechanism& mechanism);

}  // namespace kinestat
