#include "cases/case_efficiency.hpp"

namespace kinestat {

Efficiency case_efficiency(const CaseAnalysis& one, const Mechanism& mechanism) {
  if (one.efficiency) {
    return mechanism.loss_model == LossModel::carrier ? one.efficiency->carrier
                                                      : one.efficiency->absolute;
  }
  return one.power ? Efficiency{.value = one.power->efficiency,
                                .reason = one.power->no_efficiency,
                                .is_self_locking = one.power->is_self_locking}
                   : Efficiency{};
}

bool loses_power(const CaseAnalysis& one) {
  return one.efficiency || (one.action && !one.action->friction.empty());
}

bool lacks_efficiency(const CaseAnalysis& one, const Mechanism& mechanism) {
  return one.power && one.which.names_both_ends() && loses_power(one) &&
         !case_efficiency(one, mechanism).value;
}

}  // namespace kinestat
