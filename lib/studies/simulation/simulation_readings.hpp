// What can be told of each row of a simulation.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/simulation/simulation.hpp"

namespace kinestat {

/// A column, and how its value is read [SI]. The name is "a.wz/position": element, then quantity.
struct SimulationReading {
  std::string element;  ///< coupling.freedom, coupling.action, actuator, coupling, load or spring;
                        ///< empty of the whole
  std::string quantity;
  QuantityKind kind = QuantityKind::dimensionless;
  std::vector<std::string_view> words = {};  ///< of the report that ask for it
  std::string actuator = {};                 ///< what else its freedom is called; may be empty
  int freedom = -1;                          ///< whose it is, which may have none in any row
  bool has_peaks = true;                     ///< of time and what is rounding none are sought
  bool is_always = false;                    ///< whatever the report asks for
  bool is_usual = true;                      ///< where the report does not say it
  bool needs_actions = false;                ///< of couplings, which equilibrium says
  std::function<std::optional<double>(const SimulationRow& row, const SimulationRow& first)> value =
      {};
};

/// All of a mechanism; it and the plan must outlive them.
std::vector<SimulationReading> simulation_readings(const Mechanism& mechanism,
                                                   const SimulationPlan& plan);

/// Whether the report has it.
bool is_wanted(const SimulationReading& reading, const SimulationReport& report);

/// Those that the report of the plan has, in their order.
std::vector<SimulationReading> wanted_readings(const Mechanism& mechanism,
                                               const SimulationPlan& plan);

}  // namespace kinestat
