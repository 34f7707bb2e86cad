// Findings about the flanks of teeth.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/action_findings.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

// Forces of teeth that press the flank against which their sign speaks: as the teeth have no other
// one that is known, or none on which they would stay.
std::vector<int> find_wrong_flanks(const JudgedFile& file, const CaseAnalysis& one) {
  std::vector<int> wrong;
  if (one.action->magnitudes.empty()) {
    return wrong;
  }
  const auto force_of = [&](int action) {
    const bool is_known = one.action->magnitudes[static_cast<std::size_t>(action)].has_value();
    return is_known ? bounded_action(*one.action, action).zeroed() : 0.0;
  };
  for (const int action : file.mechanism.one_flanked) {
    if (force_of(action) < 0.0) {
      wrong.push_back(action);
    }
  }
  const auto& flanks = file.mechanism.geometry.other_flanks;
  for (std::size_t i = 0; i < flanks.size(); ++i) {
    const bool is_coast =
        std::ranges::find(one.coast_flanks, static_cast<int>(i)) != one.coast_flanks.end();
    const double force = force_of(flanks[i].action);
    if (is_coast ? force > 0.0 : force < 0.0) {
      wrong.push_back(flanks[i].action);
    }
  }
  return wrong;
}

std::string ways_out(const JudgedFile& file, CouplingId coupling) {
  const std::string way =
      file.description.couplings[static_cast<std::size_t>(coupling.value)].contact
          ? "leave out 'contact: true' for teeth that roll on each other"
          : "let both bodies turn about hinges, or give a gear its tangent and pressure_angle";
  return way + "; or write 'flank: fixed' if the line of action holds for both loads";
}

}  // namespace

void add_tooth_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const Topology& topology = file.mechanism.topology;
  const FileUnits& units = file.description.units;
  for (const int a : find_wrong_flanks(file, one)) {
    const auto action = static_cast<std::size_t>(a);
    const CouplingTopology& coupling = topology.coupling(topology.actions[action].coupling);
    const double force = one.action->magnitudes[action].value_or(0.0);
    CaseFinding& added = found.warning(
        "W0610",
        coupling.where,
        fmt::format("case '{}': the load presses the teeth of '{}' on their other flank, which is "
                    "not known; with {:.6g} {} on the line of action they pull on each other",
                    one.which.label,
                    coupling.name,
                    force / units.factor(QuantityKind::force),
                    units.text(QuantityKind::force)),
        ways_out(file, topology.actions[action].coupling));
    added.element = coupling.name;
    added.size = std::abs(force);
  }
}

}  // namespace kinestat
