#include "statics/internal/self_stress_record.hpp"

#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

QuantityKind kind_of(const SelfStressView& v, const DependenceTerm& term) {
  return kinestat::kind_of(v.topology.actions[static_cast<std::size_t>(term.index)]);
}

void emit_couplings(const SelfStressView& v, const EachName& each) {
  CouplingId last;
  for (const DependenceTerm& term : v.stress.terms) {
    const CouplingId coupling = v.topology.actions[static_cast<std::size_t>(term.index)].coupling;
    if (&term == &v.stress.terms.front() || coupling != last) {
      each(v.topology.coupling(coupling).name);
    }
    last = coupling;
  }
}

QuantityKind first_kind(const SelfStressView& v) {
  return kind_of(v, v.stress.terms.front());
}

void emit_actions(const SelfStressView& v, const EachNumber& each) {
  const double unit = v.units.factor(first_kind(v));
  for (const DependenceTerm& term : v.stress.terms) {
    each(v.topology.action_name(term.index), term.coefficient * unit, kind_of(v, term));
  }
}

}  // namespace

const Record<SelfStressView>& self_stress_record() {
  static const Record<SelfStressView> record(
      "One of them; its first action is in no other.", [](Record<SelfStressView>& keys) {
        keys.names("couplings", "Couplings that take part.", emit_couplings);
        keys.text("per",
                  "The unit of the first action: the magnitudes are for 1 of it.",
                  [](const SelfStressView& v) { return v.units.text(first_kind(v)); })
            .reference_unit()
            .not_compared();
        keys.numbers("actions",
                     ByContext::action,
                     "Magnitudes for 1 unit of the first action.",
                     emit_actions)
            .in_tables_as("");
      });
  return record;
}

const Record<CompletionView>& completion_record() {
  static const Record<CompletionView> record(
      "Where values of actions come from that equilibrium leaves open; no key where nobody asked "
      "for them.",
      [](Record<CompletionView>& keys) {
        keys.word("method",
                  {std::string(word_of(IndeterminateChoice::minimum_norm)),
                   std::string(word_of(IndeterminateChoice::stiffness))},
                  "Minimum norm of all actions, which is a convention, or minimum energy of "
                  "elastic couplings.",
                  [](const CompletionView& v) { return word_of(v.completion.by); });
        keys.quantity("length",
                      QuantityKind::length,
                      "The length by which the minimum norm divides couples.",
                      [](const CompletionView& v) { return v.completion.length; })
            .only_if([](const CompletionView& v) {
              return v.completion.by == IndeterminateChoice::minimum_norm;
            });
        keys.names("actions",
                   "Names of the actions with such a value.",
                   [](const CompletionView& v, const EachName& each) {
                     for (const int a : v.completion.actions) {
                       each(v.topology.action_name(a));
                     }
                   });
      });
  return record;
}

}  // namespace kinestat
