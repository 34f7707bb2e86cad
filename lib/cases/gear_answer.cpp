#include "cases/gear_answer.hpp"

namespace kinestat {

SolvedGear solved_gear(const Mechanism& mechanism,
                       const ShiftPlan& plan,
                       const ShiftState& state,
                       const CaseAnalysis& one) {
  const bool has_losses = one.efficiency && one.efficiency->state;
  return {.mechanism = mechanism,
          .plan = plan,
          .state = state,
          .which = one.which,
          .motion = one.motion ? &*one.motion : nullptr,
          .action = one.action ? &*one.action : nullptr,
          .lossy_actions = has_losses ? &one.efficiency->state->actions : nullptr};
}

}  // namespace kinestat
