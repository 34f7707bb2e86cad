// A mechanism left to what acts on it: forward dynamics in time.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/simulation/reduced_system.hpp"
#include "studies/simulation/simulation_plan.hpp"

namespace kinestat {

enum class SimulationEnd {
  complete,  ///< at the end of its time
  goal,      ///< where the file has it end
  parted,    ///< where a cable or a contact no longer holds what it holds
  stuck      ///< it cannot go on: SimulationSolution::obstacle
};

/// Lists are parallel to the freedoms, where not said otherwise [rad or m, and by s]; empty of what
/// has none, or would be rounding.
struct SimulationRow {
  double time = 0.0;  ///< [s]
  Configuration configuration;
  std::vector<std::optional<double>> positions = {};
  std::vector<std::optional<double>> rates = {};
  std::vector<std::optional<double>> rate_rates = {};
  std::vector<double> actions = {};               ///< that the case knows, in its order [N·m or N]
  std::vector<double> held = {};                  ///< of the plan's held freedoms: what that takes
  std::vector<std::optional<double>> borne = {};  ///< of all actions; none unless the plan asks
  std::vector<std::optional<Vec3>> reactions = {};  ///< resultant forces of `coupling_reactions`
                                                    ///< [N], likewise
  std::vector<std::optional<double>> load_powers = {};  ///< of the loads of the case, then of those
                                                        ///< that follow curves [W]
  std::vector<std::optional<double>> friction = {};  ///< of each friction of the mechanism, of tail
                                                     ///< on head about or along its freedom
  std::vector<SpringState> springs = {};  ///< of each spring; none in a singular position
  std::optional<double> kinetic = {};     ///< [J]; none in a singular position
  double potential = 0.0;                 ///< of weights and springs, as drawn zero [J]
  double supplied = 0.0;  ///< by actions, loads and what is held, since the begin [J]
  double lost = 0.0;      ///< in dampers, friction and impacts, likewise

  /// What of the energy nothing explains.
  std::optional<double> balance() const {
    return kinetic ? std::optional(*kinetic + potential - supplied + lost) : std::nullopt;
  }

  /// In a singular position, or so near to one that they would be rounding; then it has no actions
  /// either.
  bool lacks_accelerations = false;
};

struct SimulationEvent {
  enum class Kind {
    goal,           ///< a freedom comes to where the simulation ends
    impact,         ///< a freedom strikes its stop
    rest,           ///< it stays there
    release,        ///< it leaves it again
    stick,          ///< friction holds a freedom
    slip,           ///< and no longer does
    cable_slack,    ///< a cable would push: the simulation ends, as with all that follow
    contact_pulls,  ///< surfaces that touch would pull
    cable_slips,    ///< a cable would slip on a pulley that holds it by friction
    lift_off        ///< the arc of a cable on its pulley becomes zero
  };

  Kind kind = Kind::goal;
  double time = 0.0;
  std::string element;  ///< the freedom as the file names it; of what ends it by parting the
                        ///< segment, the contact of surfaces, or that of cable and pulley
  bool is_rotation = true;
  std::optional<double> position = {};     ///< [rad or m]; of freedoms
  std::optional<double> speed = {};        ///< before [rad/s or m/s]; likewise
  std::optional<double> speed_after = {};  ///< of an impact
};

/// Teeth that would pull on each other.
struct PullingTeeth {
  int action = 0;      ///< into Topology::actions
  double force = 0.0;  ///< the largest of a row [N], against its line of action
};

/// Where a column is least or greatest.
struct SimulationExtreme {
  double value = 0.0;  ///< [SI]
  double time = 0.0;   ///< [s]
};

/// Empty of a column without values.
struct SimulationExtremes {
  std::optional<SimulationExtreme> least = {};
  std::optional<SimulationExtreme> greatest = {};
};

/// What columns come to from either side of a moment at which the integration begins anew, as
/// where friction sticks or something is struck: actions and accelerations jump there.
struct SimulationSides {
  double time = 0.0;                               ///< [s]
  std::vector<std::optional<double>> before = {};  ///< one of each of `wanted_readings` [SI]
  std::vector<std::optional<double>> after = {};
};

struct SimulationSolution {
  SimulationEnd end = SimulationEnd::complete;
  SimulationObstacle obstacle;
  double time = 0.0;             ///< at which it ended [s]
  std::vector<int> coordinates;  ///< freedoms that it begins with
  std::vector<SimulationRow> rows;
  std::vector<SimulationEvent> events;
  std::vector<SimulationSides> sides;        ///< in the order of time
  std::vector<SimulationExtremes> extremes;  ///< of each of `wanted_readings`, also between rows
  bool looks_between_rows = true;     ///< false: it turned so often that some were left out there
  std::vector<CouplingId> unchecked;  ///< cables and contacts whose force nothing determines
  std::vector<IgnoredReaction> ignored;  ///< of couplings that rub or stick: the largest of a row
  std::vector<PullingTeeth> pulling;     ///< on a flank that is not known
  int evaluations = 0;                   ///< of the accelerations
  int integrated = 0;                    ///< steps of the integration
  int changes = 0;                       ///< of the coordinates, at dead points of those before
  double energy_drift = 0.0;             ///< largest of what nothing explains, since the begin [J]
  double energy_scale = 0.0;   ///< the largest kinetic energy, change of potential, work, also
                               ///< between rows [J]
  double closure_error = 0.0;  ///< the largest of a row, as share of the size
};

/// Whether some row has one for the freedom: its column is left out otherwise, as contacts have no
/// positions.
bool has_any(const SimulationSolution& solution,
             std::vector<std::optional<double>> SimulationRow::*list,
             int freedom);

/// From `start`, a closed configuration of the network, with these rates of its joints. Held
/// freedoms and stops must be joints of its tree, and so must freedoms that stick by themselves.
/// `which` is the only case of the mechanism.
SimulationSolution solve_simulation(const Mechanism& mechanism,
                                    const MotionNetwork& network,
                                    std::span<const DrawnCoupling> drawn,
                                    const SimulationPlan& plan,
                                    const Configuration& start,
                                    const std::vector<int>& coordinates,
                                    const VecX& rates);

}  // namespace kinestat
