// Findings about clutches and brakes.
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cases/findings/action_findings.hpp"
#include "kinematics/bounded_motion.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

ClutchWords words_of_driving_clutch(const std::string& clutch,
                                    double torque,
                                    double slip,
                                    const FileUnits& units) {
  const double in_file = torque / units.factor(QuantityKind::moment);
  const std::string& unit = units.text(QuantityKind::moment);
  return {.would = fmt::format("'{}' would have to drive", clutch),
          .how = fmt::format("its torque of {:.6g} {} acts along its slip of {:.6g} {}",
                             in_file,
                             unit,
                             slip / units.factor(QuantityKind::angular_velocity),
                             units.text(QuantityKind::angular_velocity)),
          .hint = fmt::format("a clutch or brake that slips can only take power: write {}: {:.6g} "
                              "{}, where its torque is given",
                              clutch,
                              -in_file,
                              unit)};
}

void add_clutch_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  if (!one.power || !one.motion || !one.action) {
    return;
  }
  const Topology& topology = file.mechanism.topology;
  const FileUnits& units = file.description.units;
  for (std::size_t i = 0; i < topology.actuators.size(); ++i) {
    const ActuatorTopology& actuator = topology.actuators[i];
    const auto freedom = static_cast<std::size_t>(actuator.freedom);
    const CouplingTopology& coupling = topology.coupling(topology.freedoms[freedom].coupling);
    const bool is_clutch =
        coupling.type == CouplingType::clutch || coupling.type == CouplingType::brake;
    if (!is_clutch) {
      continue;
    }
    const double torque = bounded_action(*one.action, actuator.action).zeroed();
    const double slip = bounded_rate(*one.motion, actuator.freedom).zeroed();
    if (torque * slip <= 0.0) {
      continue;
    }
    ClutchWords words = words_of_driving_clutch(coupling.name, torque, slip, units);
    CaseFinding& added =
        found.warning("W0612",
                      coupling.where,
                      fmt::format("case '{}': {}: {}", one.which.label, words.would, words.how),
                      std::move(words.hint));
    added.element = words.would;
    added.size = torque * slip;
  }
}

}  // namespace kinestat
