// What numbers of a file may be, from state to state of a sweep.
#pragma once

#include <span>
#include <vector>

#include "description/mechanism_description.hpp"
#include "expression/slots.hpp"
#include "mechanism/check/section_context.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace kinestat {

/// The numbers that the check of the file looks at and that are different in the states: a state in
/// which one is not allowed has no answer, whoever needs it. Those that depend on one axis alone
/// are looked at once for all its places, and kept only if one of these is refused, or if it runs
/// through rows, of which more may follow.
class StateRules {
 public:
  /// The description must be that of the plan.
  StateRules(const SweepPlan& plan, const MechanismDescription& description);

  bool are_empty() const { return rules_.empty(); }

  /// `scratch` is kept by the caller.
  bool hold(const Slots& slots, std::vector<Quantity>& scratch) const;

 private:
  struct Rule {
    SlotExpression value;
    NumberRule rule;
  };

  bool holds(const Rule& rule, const Slots& slots, std::vector<Quantity>& scratch) const;
  bool holds_on(const SweepPlan& plan, std::size_t axis, const Rule& rule) const;

  FileUnits units_;
  std::vector<Rule> rules_;
};

}  // namespace kinestat
