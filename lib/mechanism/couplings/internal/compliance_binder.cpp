#include "mechanism/couplings/internal/compliance_binder.hpp"

#include <algorithm>
#include <map>
#include <string>

#include <fmt/format.h>

namespace kinestat {

template <class Scalar>
std::vector<Scalar> bind_compliances(const MechanismDescription& description,
                                     const Topology& topology,
                                     EvaluatorOf<Scalar>& evaluator) {
  std::map<std::string, std::size_t> actions;
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    actions.emplace(topology.action_name(static_cast<int>(a)), a);
  }
  std::vector<Scalar> compliances(topology.actions.size(), Scalar(0.0));
  for (const CouplingDescription& coupling : description.couplings) {
    for (const StiffnessDescription& one : coupling.stiffness) {
      const std::size_t a = actions.at(coupling.name.text + "." + one.action.text);
      const bool is_couple = topology.actions[a].is_couple;
      const auto stiffness = evaluator.number(
          one.value, is_couple ? QuantityKind::angular_stiffness : QuantityKind::stiffness);
      if (stiffness) {
        compliances[a] = Scalar(1.0) / *stiffness;
      }
    }
  }
  return compliances;
}

template std::vector<double> bind_compliances(const MechanismDescription&,
                                              const Topology&,
                                              EvaluatorOf<double>&);
template std::vector<Dual> bind_compliances(const MechanismDescription&,
                                            const Topology&,
                                            EvaluatorOf<Dual>&);

void warn_of_idle_stiffness(const MechanismDescription& description, Diagnostics& found) {
  const auto first = std::ranges::find_if(
      description.couplings,
      [](const CouplingDescription& coupling) { return !coupling.stiffness.empty(); });
  const bool has_stiffness = first != description.couplings.end();
  const bool is_asked_for = description.indeterminate == IndeterminateChoice::stiffness;
  if (has_stiffness && !is_asked_for) {
    found.warning("W0301",
                  first->stiffness.front().action.where,
                  fmt::format("the stiffness of coupling '{}' is never used", first->name.text),
                  "add 'statics: {indeterminate: stiffness}', or remove it");
  }
  if (is_asked_for && !has_stiffness) {
    found.warning("W0301",
                  description.statics_where,
                  "statics are to use the stiffness of couplings, but none has any",
                  "add for example 'stiffness: {Rx: 2e6 N/m}' to couplings");
  }
}

}  // namespace kinestat
