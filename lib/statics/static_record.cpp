#include "statics/static_record.hpp"

#include "mechanism/label_kind.hpp"
#include "network/evidence_record.hpp"
#include "screw/screw_record.hpp"
#include "statics/internal/self_stress_record.hpp"
#include "statics/internal/wrench_records.hpp"

namespace kinestat {

namespace {

// Actions that complete equilibrium have their method as their status.
std::string_view status_of(const StaticView& v, bool is_completed) {
  return is_completed ? word_of(v.action.completion.by) : std::string_view();
}

void emit_actions(const StaticView& v, const EachNumber& each) {
  const Topology& topology = v.mechanism.topology;
  for (int a = 0; a < topology.action_count(); ++a) {
    const auto i = static_cast<std::size_t>(a);
    each(topology.action_name(a),
         v.action.magnitudes.empty() ? std::nullopt : v.action.magnitudes[i],
         kind_of(topology.actions[i]),
         status_of(v, is_completed(v.action, a)));
  }
}

void emit_undetermined(const StaticView& v, const EachName& each) {
  for (const int a : v.action.check.undetermined) {
    each(v.mechanism.topology.action_name(a));
  }
}

void emit_self_stresses(const StaticView& v, const Each<SelfStressView>& each) {
  for (const SelfStress& stress : v.action.self_stresses) {
    each({.topology = v.mechanism.topology, .stress = stress, .units = v.units});
  }
}

void emit_wrenches(const StaticView& v, const Each<CouplingWrenchView>& each) {
  const Topology& topology = v.mechanism.topology;
  for (std::size_t e = 0; e < v.action.wrenches.size(); ++e) {
    each(topology.couplings[e].name,
         {.geometry = v.mechanism.geometry,
          .wrench = bounded_wrench(v.action, CouplingId{static_cast<int>(e)}),
          .at = v.mechanism.geometry.points[e]},
         status_of(v, is_completed(v.action, topology.couplings[e])));
  }
}

void emit_loads(const StaticView& v, const Each<LoadView>& each) {
  for (const Load& load : v.which.loads) {
    each(load.name, {.mechanism = v.mechanism, .load = load});
  }
}

void emit_friction(const StaticView& v, const Each<FrictionView>& each) {
  for (const FrictionAction& friction : v.action.friction) {
    each(v.mechanism.topology.coupling(friction.coupling).name,
         {.geometry = v.mechanism.geometry, .friction = friction});
  }
}

// What each of several equal planets has of the actions that they share.
void emit_planets(const StaticView& v, const Each<PlanetShare>& each) {
  const Topology& topology = v.mechanism.topology;
  for (int a = 0; a < topology.action_count(); ++a) {
    const auto i = static_cast<std::size_t>(a);
    if (v.mechanism.planet_counts[i] > 1) {
      each(topology.action_name(a),
           {.count = v.mechanism.planet_counts[i],
            .sharing = v.mechanism.load_sharing[i],
            .all = v.action.magnitudes[i],
            .kind = kind_of(topology.actions[i])},
           status_of(v, is_completed(v.action, a)));
    }
  }
}

// What a contact does is its status.
void emit_contacts(const StaticView& v, const Each<ContactView>& each) {
  for (std::size_t i = 0; i < v.contacts.size(); ++i) {
    const CableContact& contact = v.mechanism.contacts[i];
    each(contact.name,
         {.contact = contact, .state = v.contacts[i]},
         word_of(v.contacts[i].belt_state));
  }
}

void emit_converters(const StaticView& v, const Each<ConverterState>& each) {
  for (const ConverterState& state : v.converters) {
    each(v.mechanism.topology.coupling(state.coupling).name, state);
  }
}

void add_answer(Record<StaticView>& keys) {
  keys.word("status",
            words_up_to(SolveStatus::at_rest),
            "Whether the actions are determined.",
            [](const StaticView& v) { return word_of(v.action.status); })
      .in_tables_is(TableRole::status);
  keys.count("order",
             "Order of the screw system in which the actions were solved.",
             [](const StaticView& v) { return v.action.counts.order; })
      .not_in_tables();
  keys.count("net_constraint",
             "Number of actions that must be known.",
             [](const StaticView& v) { return v.action.counts.net_constraint; })
      .not_in_tables();
  keys.numbers("actions",
               ByContext::action,
               "Magnitude of every action (of tail on head) by coupling.action or actuator, in the "
               "unit of moment or force; null where it is not determined. See completion for those "
               "that equilibrium alone leaves open.",
               emit_actions)
      .in_tables_as("action");
  keys.names("undetermined",
             "Names of the actions that equilibrium does not determine.",
             emit_undetermined);
  keys.list("self_stresses",
            self_stress_record(),
            "Self-stresses: actions in equilibrium with each other alone, which equilibrium leaves "
            "undetermined; no key if there are none, or too many to list.",
            emit_self_stresses)
      .in_tables_as("self_stress")
      .only_if([](const StaticView& v) { return !v.action.self_stresses.empty(); });
  keys.part("completion",
            completion_record(),
            [](const StaticView& v) {
              return CompletionView{.topology = v.mechanism.topology,
                                    .completion = v.action.completion};
            })
      .not_in_tables()
      .only_if([](const StaticView& v) {
        return v.action.completion.by != IndeterminateChoice::report;
      });
}

void add_wrenches(Record<StaticView>& keys) {
  keys.map("couplings",
           coupling_wrench_record(),
           "Sum of the actions of every coupling, of tail on head.",
           emit_wrenches)
      .in_tables_as("");
  keys.map("loads",
           load_record(),
           "Loads that act in the case, weights among them as gravity.BODY; no key without loads.",
           emit_loads)
      .in_tables_as("load")
      .only_if([](const StaticView& v) { return !v.which.loads.empty(); });
  keys.map("friction",
           friction_record(),
           "Friction of couplings, of tail on head and against the motion; part of their wrenches. "
           "No key without friction.",
           emit_friction)
      .only_if([](const StaticView& v) { return !v.action.friction.empty(); });
  keys.map("planets",
           planet_record(),
           "Actions that several equal planets share; no key without any.",
           emit_planets)
      .in_tables_as("planet")
      .only_if([](const StaticView& v) {
        return has_planets(v.mechanism) && !v.action.magnitudes.empty();
      });
  keys.map("contacts",
           contact_record(),
           "Contacts of cables, belts and chains with pulleys; no key without any.",
           emit_contacts)
      .in_tables_as("contact")
      .only_if([](const StaticView& v) { return !v.contacts.empty(); });
  keys.map("converters",
           converter_record(),
           "Torque converters and fluid couplings of a case with motion; no key without any.",
           emit_converters)
      .in_tables_as("converter")
      .only_if([](const StaticView& v) { return !v.converters.empty(); });
}

}  // namespace

const Record<StaticView>& static_record() {
  static const Record<StaticView> record(
      "Actions from the known actions and the loads.", [](Record<StaticView>& keys) {
        add_answer(keys);
        add_wrenches(keys);
        keys.part("evidence",
                  evidence_record(),
                  [](const StaticView& v) {
                    return EvidenceView{.rank = v.action.evidence,
                                        .answer = v.action.answer,
                                        .residual = v.action.residual,
                                        .is_answered = !v.action.wrenches.empty()};
                  })
            .not_in_tables()
            .not_compared();
      });
  return record;
}

}  // namespace kinestat
