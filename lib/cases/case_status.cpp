#include "cases/case_status.hpp"

#include <algorithm>

#include "cases/case_efficiency.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

std::string_view impossible_status(const Mechanism& mechanism, const CaseAnalysis& one) {
  const std::vector<WrongFreewheel> wrong =
      find_wrong_freewheels(mechanism, one.motion, one.action);
  if (!wrong.empty()) {
    return wrong.front().fault == FreewheelFault::overruns ? kFreewheelOverruns : kFreewheelLocks;
  }
  if (!one.action) {
    return {};
  }
  if (!find_pushed_segments(mechanism, *one.action).empty()) {
    return kCableSlack;
  }
  if (!find_pulling_contacts(mechanism, *one.action).empty()) {
    return kContactPulls;
  }
  return std::ranges::find(one.contacts, BeltState::beyond_limit, &CableContactState::belt_state) ==
                 one.contacts.end()
             ? std::string_view()
             : kCableSlips;
}

std::string_view case_status(const Mechanism& mechanism,
                             const CaseAnalysis& one,
                             bool asks_power,
                             bool asks_efficiency) {
  if (one.motion && one.motion->status != SolveStatus::solved) {
    return word_of(one.motion->status);
  }
  if (one.has_unknown_loads()) {
    return kUnknownLoad;
  }
  const SolveStatus status = one.action ? one.action->status : SolveStatus::solved;
  if (status != SolveStatus::solved && status != SolveStatus::underdetermined) {
    return one.action && !one.action->other_actions.empty() ? kAmbiguous : word_of(status);
  }
  if (const std::string_view word = impossible_status(mechanism, one); !word.empty()) {
    return word;
  }
  if (status != SolveStatus::solved) {
    return word_of(status);
  }
  const bool judges_power = asks_power || asks_efficiency;
  if (judges_power && one.power && !one.power->is_balanced) {
    return kUnbalanced;
  }
  const bool is_self_locking = one.efficiency ? one.efficiency->carrier.is_self_locking
                                              : one.power && one.power->is_self_locking;
  if (judges_power && is_self_locking) {
    return kSelfLocking;
  }
  return asks_efficiency && lacks_efficiency(one, mechanism) ? kNoEfficiency
                                                             : word_of(SolveStatus::solved);
}

}  // namespace kinestat
