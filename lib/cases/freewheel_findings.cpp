// Findings about freewheels.
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cases/action_findings.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

void add_freewheel_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const FileUnits& units = file.description.units;
  for (const WrongFreewheel& wrong :
       find_wrong_freewheels(file.mechanism, one.motion, one.action)) {
    const CouplingTopology& coupling = file.mechanism.topology.coupling(wrong.coupling);
    const bool overruns = wrong.fault == FreewheelFault::overruns;
    const QuantityKind kind = overruns ? QuantityKind::moment : QuantityKind::angular_velocity;
    const std::string value =
        fmt::format("{:.6g} {}", wrong.value / units.factor(kind), units.text(kind));
    const std::string_view holds = wrong.value > 0.0 ? "negative" : "positive";
    CaseFinding& added = found.warning(
        "W0611",
        coupling.where,
        overruns
            ? fmt::format("case '{}': freewheel '{}' would have to hold {}, and it holds {} "
                          "torques only: it overruns",
                          one.which.label,
                          coupling.name,
                          value,
                          holds)
            : fmt::format("case '{}': freewheel '{}' would have to slip at {}, and it slips in "
                          "the {} sense only: it locks",
                          one.which.label,
                          coupling.name,
                          value,
                          holds),
        overruns
            ? fmt::format("open it: action: {{{0}: 0}} instead of motion: {{{0}: 0}}; the sign "
                          "is that of the torque of the first of its bodies on the second",
                          coupling.name)
            : fmt::format("engage it: motion: {{{0}: 0}} instead of action: {{{0}: 0}}; the "
                          "sign is that of the second of its bodies relative to the first",
                          coupling.name));
    added.element = fmt::format("{} {}", coupling.name, overruns ? "overruns" : "locks");
    added.size = std::abs(wrong.value);
  }
}

}  // namespace kinestat
