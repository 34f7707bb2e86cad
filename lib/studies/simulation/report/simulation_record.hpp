// What a report of a simulation says, whole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/mechanism_description.hpp"
#include "record/record.hpp"
#include "studies/simulation/simulation.hpp"

namespace kinestat {

class Diagnostics;

struct SimulationReportView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
  const Mechanism& mechanism;
  const SimulationPlan& plan;
  const SimulationSolution& solution;
  const Diagnostics* found;
};

/// What is told of each row. The name is "a.wz/position": element, then quantity.
struct SimulationColumn {
  std::string element;  ///< as of SimulationReading
  std::string quantity;
  QuantityKind kind = QuantityKind::dimensionless;
  std::vector<std::optional<double>> values = {};   ///< one a row [SI]
  std::size_t reading = 0;                          ///< which of `wanted_readings` it is
  bool is_coordinate = false;                       ///< of a freedom that the simulation began with
  std::optional<SimulationExtremes> extremes = {};  ///< of those for which they are sought

  std::string name() const { return element.empty() ? quantity : element + "/" + quantity; }
};

std::vector<SimulationColumn> simulation_columns(const SimulationReportView& view);

std::string_view word_of(SimulationEnd end);
std::string_view word_of(SimulationEvent::Kind kind);

const Record<SimulationReportView>& simulation_report_record();

}  // namespace kinestat
