#include "cases/findings/limit_findings.hpp"

#include <fmt/format.h>

#include "cases/gear_answer.hpp"
#include "studies/shift/gear_limits.hpp"

namespace kinestat {

namespace {

std::string text_of(const LimitUse& one,
                    const std::string& owner,
                    const std::string& size,
                    const std::string& carrier) {
  switch (one.part.limit.kind) {
    case LimitKind::torque:
      return fmt::format(
          "element '{}' bears {}{}", owner, size, one.has_losses ? " with losses of meshes" : "");
    case LimitKind::slip:
      return fmt::format("open element '{}' slips at {}", owner, size);
    case LimitKind::speed:
      return fmt::format("body '{}' turns at {}", owner, size);
    case LimitKind::planet_speed:
      return fmt::format("planet '{}' turns at {} on its carrier '{}'", owner, size, carrier);
  }
  return "";
}

std::string_view remedy_for(LimitKind kind) {
  return kind == LimitKind::torque
             ? "lower 'input_action', change numbers of teeth, or raise the limit"
             : "lower 'input_motion', change numbers of teeth, or raise the limit";
}

}  // namespace

void add_limit_findings(const JudgedFile& file,
                        const CaseAnalysis& one,
                        const ShiftState& state,
                        CaseFindings& found) {
  const ShiftPlan& plan = file.shift->plan;
  const Topology& topology = file.mechanism.topology;
  const FileUnits& units = file.description.units;
  for (const LimitUse& each : find_limit_uses(solved_gear(file.mechanism, plan, state, one))) {
    if (!each.is_exceeded()) {
      continue;
    }
    const QuantityKind kind = quantity_of(each.part.limit.kind);
    const auto in_unit = [&](double si) {
      return fmt::format("{:.6g} {}", units.from_si(kind, si), units.text(kind));
    };
    const std::string& owner = owner_of(each.part, plan, topology);
    CaseFinding& added = found.warning(
        "W0712",
        each.part.limit.where,
        fmt::format(
            "gear '{}': {}, above its limit of {} by {:.3g} %",
            one.which.label,
            text_of(each, owner, in_unit(*each.size), topology.body(each.part.seen_from).name),
            in_unit(each.part.limit.most),
            100.0 * (*each.use() - 1.0)),
        std::string(remedy_for(each.part.limit.kind)));
    added.element = owner;
    added.size = *each.use();
  }
}

}  // namespace kinestat
