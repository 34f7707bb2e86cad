// Findings about freewheels.
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "cases/findings/action_findings.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

void add_freewheel_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const FileUnits& units = file.description.units;
  for (const WrongFreewheel& wrong :
       find_wrong_freewheels(file.mechanism, one.motion, one.action)) {
    const CouplingTopology& coupling = file.mechanism.topology.coupling(wrong.coupling);
    const bool overruns = wrong.fault == FreewheelFault::overruns;
    const QuantityKind kind = overruns ? QuantityKind::moment : QuantityKind::angular_velocity;
    const std::string asked =
        fmt::format("'{}' would have to {}", coupling.name, overruns ? "hold" : "slip at");
    CaseFinding& added = found.warning(
        "W0611",
        coupling.where,
        fmt::format("case '{}': freewheel {} {:.6g} {}, and it {} {} {}",
                    one.which.label,
                    asked,
                    wrong.value / units.factor(kind),
                    units.text(kind),
                    overruns ? "holds" : "slips in the",
                    wrong.value > 0.0 ? "negative" : "positive",
                    overruns ? "torques only: it overruns" : "sense only: it locks"),
        overruns
            ? fmt::format("open it: action: {{{0}: 0}} instead of motion: {{{0}: 0}}; the sign "
                          "is that of the torque of the first of its bodies on the second",
                          coupling.name)
            : fmt::format("engage it: motion: {{{0}: 0}} instead of action: {{{0}: 0}}; the "
                          "sign is that of the second of its bodies relative to the first",
                          coupling.name));
    added.element = asked;  // other freewheels, and the other fault, are told beside it
    added.size = std::abs(wrong.value);
  }
}

}  // namespace kinestat
