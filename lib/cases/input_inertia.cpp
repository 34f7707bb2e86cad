#include "cases/input_inertia.hpp"

#include "core/index.hpp"
#include "dynamics/equivalent_inertia.hpp"

namespace kinestat {

std::optional<int> only_input_freedom(const Mechanism& mechanism, const Case& which) {
  return which.inputs.size() == 1
             ? std::optional(mechanism.topology.actuators[at(which.inputs.front())].freedom)
             : std::nullopt;
}

std::optional<std::vector<double>> input_inertias(const Mechanism& mechanism,
                                                  const CaseAnalysis& one) {
  const std::optional<int> freedom = only_input_freedom(mechanism, one.which);
  return freedom && one.motion ? equivalent_inertias(mechanism, *one.motion, *freedom)
                               : std::nullopt;
}

}  // namespace kinestat
