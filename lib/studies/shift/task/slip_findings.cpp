#include "studies/shift/task/slip_findings.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/index.hpp"

namespace kinestat {

namespace {

class SlipJudge {
 public:
  SlipJudge(const MechanismDescription& description,
            const Topology& topology,
            const ShiftPlan& plan,
            Diagnostics& found)
      : units_(description.units), topology_(topology), plan_(plan), found_(found) {}

  void judge(const ShiftSlip& slip, const SlipPlan& asked) const {
    const std::string element = name_of(slip.slips);
    const std::string holding = torque_text(std::abs(slip.holding_torque));
    if (slip.wrong_freewheel) {
      warn(asked,
           fmt::format("freewheel '{}' {}",
                       name_of(*slip.wrong_freewheel),
                       slip.wrong_freewheel == slip.opens
                           ? "locks where it should overrun, so that the change does not begin"
                           : "overruns where it should hold"),
           "check 'one_way' and the signs of the torques");
    } else if (slip.end == SlipEnd::never_synchronises) {
      warn(asked,
           fmt::format("'{}' with {} never synchronises: above {} its slip ends",
                       element,
                       torque_text(slip.capacity),
                       torque_text(slip.least_capacity)),
           fmt::format("raise the capacity above {}, or change the torques of input and output",
                       torque_text(slip.least_capacity)));
    } else if (!slip.holds()) {
      warn(asked,
           fmt::format("'{}' with {} slips on in the other sense: to hold the gear takes {}",
                       element,
                       torque_text(slip.capacity),
                       holding),
           fmt::format("raise the capacity to {} once the slip has ended", holding));
    }
  }

 private:
  std::string name_of(int element) const {
    return topology_.actuators[at(plan_.elements[at(element)].actuator)].name;
  }

  std::string torque_text(double si) const {
    return fmt::format(
        "{:.6g} {}", units_.from_si(QuantityKind::moment, si), units_.text(QuantityKind::moment));
  }

  void warn(const SlipPlan& asked, const std::string& message, std::string hint) const {
    found_.warning("W0713",
                   asked.where_capacity,
                   fmt::format("slip '{}': {}", asked.name.text, message),
                   std::move(hint));
  }

  const FileUnits& units_;
  const Topology& topology_;
  const ShiftPlan& plan_;
  Diagnostics& found_;
};

}  // namespace

void add_slips(const MechanismDescription& description,
               const Mechanism& mechanism,
               ShiftAnalysis& shift,
               Diagnostics& found) {
  if (shift.plan.slips.empty()) {
    return;
  }
  const Case loads = bind_slip_loads(description, mechanism);
  const SlipJudge judge(description, mechanism.topology, shift.plan, found);
  for (const SlipPlan& asked : shift.plan.slips) {
    auto answer = find_shift_slip(mechanism, shift.plan, shift.solution, asked, loads);
    if (auto* obstacle = std::get_if<SlipObstacle>(&answer)) {
      shift.slips_without_answer.push_back(std::move(*obstacle));
      continue;
    }
    shift.slips.push_back(std::get<ShiftSlip>(std::move(answer)));
    judge.judge(shift.slips.back(), asked);
  }
}

}  // namespace kinestat
