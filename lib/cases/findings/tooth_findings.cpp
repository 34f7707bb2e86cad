// Findings about the flanks of teeth.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cases/findings/action_findings.hpp"
#include "mechanism/gears/coast_flanks.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

double tooth_force(const CaseAnalysis& one, int action) {
  const bool is_known = one.action->magnitudes[static_cast<std::size_t>(action)].has_value();
  return is_known ? bounded_action(*one.action, action).zeroed() : 0.0;
}

}  // namespace

ToothWords words_of_pulling_teeth(const MechanismDescription& description,
                                  CouplingId id,
                                  double force) {
  const CouplingDescription& coupling = description.couplings[static_cast<std::size_t>(id.value)];
  const FileUnits& units = description.units;
  return {.what = fmt::format("the load presses the teeth of '{}' on their other flank, which is "
                              "not known; with {:.6g} {} on the line of action they pull on each "
                              "other",
                              coupling.name.text,
                              force / units.factor(QuantityKind::force),
                              units.text(QuantityKind::force)),
          .hint = fmt::format("{}; or write 'flank: fixed' if the line of action holds for both "
                              "loads",
                              coupling.contact
                                  ? "leave out 'contact: true' for teeth that roll on each other"
                                  : "let both bodies turn about hinges, or give a gear its tangent "
                                    "and pressure_angle")};
}

void add_tooth_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  if (one.action->magnitudes.empty()) {
    return;
  }
  const Topology& topology = file.mechanism.topology;
  for (const int action : pulling_teeth(
           file.mechanism, one.coast_flanks, [&](int a) { return tooth_force(one, a); })) {
    const auto a = static_cast<std::size_t>(action);
    const CouplingTopology& coupling = topology.coupling(topology.actions[a].coupling);
    const double force = one.action->magnitudes[a].value_or(0.0);
    ToothWords words =
        words_of_pulling_teeth(file.description, topology.actions[a].coupling, force);
    CaseFinding& added = found.warning("W0610",
                                       coupling.where,
                                       fmt::format("case '{}': {}", one.which.label, words.what),
                                       std::move(words.hint));
    added.element = coupling.name;
    added.size = std::abs(force);
  }
}

}  // namespace kinestat
