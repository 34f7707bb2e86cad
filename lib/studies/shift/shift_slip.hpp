// A change of gear in which one element slips at a steady torque: its inertia phase.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "mechanism/shift_plan.hpp"
#include "studies/shift/shift_solution.hpp"

namespace kinestat {

/// Input or output while the element slips; its speed is a line over time.
struct SlipShaft {
  double start = 0.0;         ///< [rad/s]
  double acceleration = 0.0;  ///< [rad/s²]
  std::optional<double> end;  ///< [rad/s]; empty where the slip does not end
};

/// What an element that stays engaged bears [N·m], tail on head.
struct HeldElement {
  int element = 0;  ///< of ShiftPlan::elements
  double torque = 0.0;
};

enum class SlipEnd { synchronises, never_synchronises };

/// The word in reports.
constexpr std::string_view word_of(SlipEnd end) {
  return end == SlipEnd::synchronises ? "synchronises" : "never synchronises";
}

/// Two freedoms, those of input and slip, of steady inertia under steady torques:
/// M (ω', s') = Q. Slip is head minus tail, as rates of elements are.
struct ShiftSlip {
  std::string name;
  std::optional<int> from;   ///< index into ShiftSolution::states; empty where the train was open
  int to = 0;                ///< likewise
  std::optional<int> opens;  ///< of ShiftPlan::elements
  int slips = 0;             ///< likewise: the one that engages
  SlipEnd end = SlipEnd::synchronises;
  double slip = 0.0;             ///< at the start [rad/s]
  double slip_rate = 0.0;        ///< [rad/s²]
  double capacity = 0.0;         ///< [N·m], a size
  double holding_torque = 0.0;   ///< at which the slip stays as it is, and which the element bears
                                 ///< once it is engaged [N·m], tail on head
  double least_capacity = 0.0;   ///< above which the slip ends [N·m]
  double peak_power = 0.0;       ///< lost at the start [W]
  std::optional<double> time;    ///< until the slip has ended [s]
  std::optional<double> energy;  ///< lost until then [J]
  std::optional<double> work;    ///< of input, output and loads until then [J]
  std::optional<double> kinetic_energy_change;  ///< until then [J]
  std::optional<double> residual;  ///< of change = work - energy, as share of the largest of these
  SlipShaft input;
  SlipShaft output;
  double input_inertia = 0.0;            ///< [kg·m²] of the input while the output rests
  std::optional<double> output_inertia;  ///< likewise; both empty where the output follows
  std::optional<double> shared_inertia;  ///< the entry of the matrix between them
  std::vector<HeldElement> held;
  std::optional<int> wrong_freewheel;  ///< one that would have to hold, or slip, the other way

  /// Whether the element bears the gear once it is engaged.
  bool holds() const;
};

/// Why there is none, and what to do about it.
struct SlipObstacle {
  std::string name;  ///< of the slip
  SourceRange where;
  std::string reason;
  std::string remedy;
};

/// `loads` are what bind_slip_loads says.
std::variant<ShiftSlip, SlipObstacle> find_shift_slip(const Mechanism& mechanism,
                                                      const ShiftPlan& plan,
                                                      const ShiftSolution& solution,
                                                      const SlipPlan& slip,
                                                      const Case& loads);

}  // namespace kinestat
