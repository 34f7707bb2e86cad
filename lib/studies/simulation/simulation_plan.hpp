// What a simulation is asked for, in numbers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/source.hpp"

namespace kinestat {

/// A freedom as the file names it: an actuator, or coupling.freedom.
struct NamedFreedom {
  int freedom = 0;  ///< index into Topology::freedoms
  std::string name;
  SourceRange where;
};

/// Where a freedom begins [rad or m, from the drawn position] and how fast.
struct SimulationStart {
  NamedFreedom of;
  double position = 0.0;
  double speed = 0.0;  ///< [rad/s or m/s]
};

/// A freedom that something keeps at a steady speed, whatever that takes.
struct HeldFreedom {
  NamedFreedom of;
  double speed = 0.0;
};

/// The simulation ends when a freedom comes to that place, or to that speed.
struct SimulationGoal {
  NamedFreedom of;
  bool is_speed = false;
  double value = 0.0;
};

/// A freedom that goes no farther than that.
struct SimulationStop {
  NamedFreedom of;
  double place = 0.0;        ///< [rad or m, from the drawn position]
  double side = 1.0;         ///< 1: positions are below it, -1: above
  double restitution = 0.0;  ///< speed after by speed before an impact
};

/// What the rows tell. Names are those of columns or what they begin with, with points for slashes.
struct SimulationReport {
  bool is_default = true;  ///< the file does not say it: all that is usual
  bool position = false;
  bool velocity = false;
  bool acceleration = false;
  bool action = false;
  bool reaction = false;  ///< resultant forces of couplings, their friction and what it loses
  bool power = false;     ///< of actuators, loads and springs
  bool energy = false;
  std::vector<std::string> names = {};
};

inline constexpr std::string_view kPowerColumn = "power";

/// Words of a report that stand for a quantity of all, and which of the report they set; null for
/// any other.
bool* find_report_word(std::string_view word, SimulationReport& report);

/// Whether a report has the word.
bool asks(const SimulationReport& report, std::string_view word);

/// Whether a name of a report means the quantity of an element, `also` being what else that is
/// called, or empty.
bool names_column(const std::string& name,
                  const std::string& element,
                  const std::string& also,
                  std::string_view quantity);

struct SimulationPlan {
  std::vector<SimulationStart> starts;
  std::vector<HeldFreedom> held;
  std::vector<SimulationGoal> goals;
  std::vector<SimulationStop> stops;
  double duration = 0.0;   ///< [s]
  int steps = 0;           ///< of the rows, equal in time
  double tolerance = 0.0;  ///< of a step of the integration
  SimulationReport report = {};
  bool asks_actions = false;  ///< of couplings, for some column
  SourceRange where;
};

}  // namespace kinestat
