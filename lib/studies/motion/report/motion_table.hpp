// A finite motion as a table: what is reported of every position, and what happens between them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"
#include "mechanism/motion_column_names.hpp"
#include "studies/motion/report/motion_dynamics.hpp"
#include "studies/motion/report/motion_event.hpp"

namespace kinestat {

/// How a motion ended.
enum class MotionEnd {
  complete,       ///< at the positions that the file asks for
  limited,        ///< a drive came to its limit before
  drives_locked,  ///< the drives cannot move at all, or not together
  lost,           ///< the branch could not be followed
  not_assembled   ///< the drawn position does not close
};

/// The word in reports.
std::string_view word_of(MotionEnd end);

/// One value of every position. The name is "a.wz/position": element, then quantity.
struct MotionColumn {
  std::string element;     ///< coupling.freedom, coupling.action, actuator, body or traced point;
                           ///< empty of a value of the whole
  std::string quantity;    ///< "position", "velocity", "linear/x"
  std::string unit;        ///< that of the file; empty for a bare number
  bool is_named = false;   ///< the report asks for it by its own name
  bool is_output = false;  ///< of a freedom that the case names as output

  std::string name() const { return element.empty() ? quantity : element + "/" + quantity; }
};

/// One position. `values` is parallel to the columns, in their units; empty where there is none.
struct MotionRow {
  int step = 0;
  std::vector<std::optional<double>> values;
  std::string status;                               ///< "solved", "singular", …
  std::vector<std::optional<double>> at_rest = {};  ///< for means: without friction, whose
                                                    ///< direction is open; else empty
  bool lacks_velocities = false;                    ///< they were asked for, and there are none
  bool lacks_accelerations = false;                 ///< likewise, where there are velocities
  bool drops_velocities = false;                    ///< some are left out: they would be rounding
  bool drops_accelerations = false;                 ///< likewise
};

/// The range of one drive, from the drawn position.
struct DriveTravel {
  std::string name;     ///< of the actuator
  std::string freedom;  ///< coupling.freedom
  std::string unit;
  double from = 0.0;
  double to = 0.0;
  std::optional<double> reached;  ///< the last position, or where it was lost; empty without any
};

/// How far a body was moved to close the drawn position.
struct BodyCorrection {
  std::string body;
  Vec3 shift = Vec3::Zero();  ///< of its reference point, in the file's unit of length
  double angle = 0.0;         ///< in the file's unit of angle
};

/// How far the ends of a coupling are apart.
struct CouplingGap {
  std::string coupling;
  double distance = 0.0;  ///< in the file's unit of length
  double angle = 0.0;     ///< in the file's unit of angle
};

/// A position between the rows, at which or beside which values turn sharply or jump.
struct MotionPlace {
  double row = 0.0;                           ///< where between the rows, as of an event
  std::vector<std::optional<double>> values;  ///< parallel to the columns
};

/// Where a column is least or greatest.
struct ColumnExtreme {
  double value = 0.0;  ///< in the unit of the column
  double drive = 0.0;  ///< position of the first drive, in its unit
  double row = 0.0;    ///< where between the rows, as of an event
};

/// What one column comes to.
struct ColumnFigures {
  std::optional<ColumnExtreme> least;  ///< empty where no position has a value
  std::optional<ColumnExtreme> greatest;
  std::optional<double> mean;  ///< over the way of the drives, or in time; empty where some step
                               ///< has no value, or the motion does not reach its end
  std::optional<double> rms;   ///< root of the mean square in time; likewise, and of a motion in
                               ///< time alone
  std::vector<std::size_t> poles = {};  ///< rows: on the way there the value goes through infinity
  std::optional<double> mean_by_half = {};  ///< of columns that are checked so: that of every
                                            ///< second step
};

struct MotionTable {
  MotionEnd end = MotionEnd::complete;
  std::string label;         ///< of the case that gives speeds and loads; may be empty
  int steps = 0;             ///< that the file asks for
  bool until_limit = false;  ///< the file asks for the way to the limit, wherever that is
  std::vector<DriveTravel> drives;
  std::vector<MotionColumn> columns;  ///< first the position of each drive
  std::vector<MotionRow> rows;
  std::vector<std::string> between;  ///< statuses that positions between the rows have, of which
                                     ///< figures are, each once and in order; but "solved"
  std::vector<MotionEvent> events;
  std::vector<ColumnFigures> figures;  ///< parallel to the columns
  bool looks_between_steps = false;    ///< extremes are more than those of steps and dead points
  std::vector<double> corners;         ///< steps at which values turn sharply or jump
  std::vector<MotionPlace> places;     ///< there, in order
  bool may_lack_dead_points = false;   ///< more would have had to be looked at than is feasible
  std::vector<FrictionTurn> friction_turns;  ///< where actions are reported
  double worst_closure =
      0.0;             ///< largest closure error of any row, relative to the mechanism's size
  int worst_step = 0;  ///< where it is
  std::vector<CouplingGap> drawn_gaps;       ///< of the drawn position, if it does not close
  std::vector<BodyCorrection> corrections;   ///< that closed it
  std::vector<CouplingGap> nearest_gaps;     ///< where nothing closes it: of the nearest position
  std::optional<double> overall_efficiency;  ///< find_efficiency by the means of powers
  std::string no_overall_efficiency;         ///< why there is none, of a case that names both ends
  std::optional<double> duration;            ///< of a motion in time, in the unit of time
  std::string time_unit;
  std::optional<MotionDynamics> dynamics;  ///< where the file asks for it
  std::string length_unit;
  std::string angle_unit;

  /// Whether the motion goes as far as the file asks for.
  bool is_whole() const {
    return end == MotionEnd::complete || (end == MotionEnd::limited && until_limit);
  }
};

}  // namespace kinestat
