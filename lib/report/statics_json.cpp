#include "report/statics_json.hpp"

#include "report/solution_json.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

// A wrench that equilibrium does not determine is null, part by part.
Json wrench_json(const Mechanism& mechanism,
                 std::size_t e,
                 const std::optional<BoundedWrench>& wrench,
                 const InUnits& in) {
  const Vec3& at = mechanism.geometry.points[e];
  const Vec3& origin = mechanism.geometry.origin;
  Json result = object_of(8);
  result["wrench"] = wrench ? sixfold_of(about_world(*wrench, origin).zeroed(), in) : Json();
  result["moment"] = wrench ? vector(in.moment(moment_at(*wrench, at - origin).zeroed())) : Json();
  result["force"] = wrench ? vector(in.force(wrench->force.zeroed())) : Json();
  result["at"] = vector(in.length(at));
  result["screw"] =
      wrench ? screw_json(find_axis(*wrench, mechanism.geometry.length), origin, in) : Json();
  return result;
}

// The point of a couple alone is null; its moment is the same anywhere.
Json load_json(const Mechanism& mechanism, const Load& load, const InUnits& in) {
  const Vec3& origin = mechanism.geometry.origin;
  const Wrench& wrench = load.acts.wrench;
  Json result = object_of(8);
  result["body"] = mechanism.topology.body(load.acts.body).name;
  result["wrench"] = sixfold_of(about_world(written(wrench), origin).zeroed(), in);
  result["moment"] = vector(in.moment(couple_of(load, origin)));
  result["force"] = vector(in.force(wrench.force));
  result["at"] = load.point ? vector(in.length(*load.point)) : Json(nullptr);
  return result;
}

// Its size as a couple or as a drag, a force; the moment is about the point of the coupling.
Json friction_json(const Mechanism& mechanism, const FrictionAction& friction, const InUnits& in) {
  const auto e = static_cast<std::size_t>(friction.coupling.value);
  const Vec3 at = mechanism.geometry.points[e] - mechanism.geometry.origin;
  Json result = object_of(8);
  result[friction.is_couple ? "couple" : "drag"] =
      number(in.action(friction.magnitude, friction.is_couple));
  result["moment"] = vector(in.moment(moment_at(written(friction.wrench), at).zeroed()));
  result["force"] = vector(in.force(friction.wrench.force));
  return result;
}

// Coefficients in the units of the file, for 1 unit of the first action.
Json self_stress_json(const Topology& topology, const SelfStress& stress, const InUnits& in) {
  const FileUnits& units = in.units();
  const auto factor = [&](int action) {
    const bool turns = topology.actions[static_cast<std::size_t>(action)].is_couple;
    return units.factor(turns ? QuantityKind::moment : QuantityKind::force);
  };
  Json couplings = Json::array();
  Json actions = object_of(stress.terms.size());
  for (const DependenceTerm& term : stress.terms) {
    const ActionLabel& label = topology.actions[static_cast<std::size_t>(term.index)];
    const std::string& coupling = topology.coupling(label.coupling).name;
    if (couplings.empty() || couplings.back() != coupling) {
      couplings.push_back(coupling);
    }
    actions[topology.action_name(term.index)] =
        number(term.coefficient * factor(stress.terms.front().index) / factor(term.index));
  }
  Json result = object_of(8);
  result["couplings"] = std::move(couplings);
  result["actions"] = std::move(actions);
  return result;
}

Json completion_json(const Topology& topology, const Completion& completion, const InUnits& in) {
  Json result = object_of(8);
  result["method"] = word_of(completion.by);
  if (completion.by == IndeterminateChoice::minimum_norm) {
    result["length"] = number(in.length(completion.length));
  }
  result["actions"] = Json::array();
  for (const int a : completion.actions) {
    result["actions"].push_back(topology.action_name(a));
  }
  return result;
}

// What each of several equal planets has of the actions that they share.
Json planets_json(const Mechanism& mechanism, const StaticSolution& action, const InUnits& in) {
  const Topology& topology = mechanism.topology;
  Json result = object_of(topology.actions.size());
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    const int count = mechanism.planet_counts[a];
    if (count > 1) {
      const std::optional<double>& all = action.magnitudes[a];
      Json one = object_of(2);
      one["count"] = count;
      one["each"] =
          all ? number(in.action(*all / count, topology.actions[a].is_couple)) : Json(nullptr);
      result[topology.action_name(static_cast<int>(a))] = std::move(one);
    }
  }
  return result;
}

Json contact_json(const CableContact& contact, const ContactState& state, const InUnits& in) {
  const auto in_unit = [](const std::optional<double>& value, const auto& converted) {
    return value ? number(converted(*value)) : Json(nullptr);
  };
  const auto force = [&](double v) { return in.force(v); };
  Json result = object_of(8);
  result["wrap"] = in_unit(contact.wrap, [&](double v) { return in.angle(v); });
  result["before"] = in_unit(state.before, force);
  result["after"] = in_unit(state.after, force);
  result["ratio"] = number(state.ratio);
  result["limit"] = number(state.limit);
  result["slip_speed"] = in_unit(state.slip_speed, [&](double v) { return in.linear(v); });
  result["slip_power"] = in_unit(state.slip_power, [&](double v) { return in.power(v); });
  result["grip"] = word_of(state.grip);
  return result;
}

}  // namespace

Json statics_json(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  const Topology& topology = mechanism.topology;
  const StaticSolution& action = *one.action;
  Json result = object_of(8);
  result["status"] = word_of(action.status);
  result["order"] = action.counts.order;
  result["net_constraint"] = action.counts.net_constraint;
  Json& actions = result["actions"] = object_of(topology.actions.size());
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    const std::optional<double> magnitude =
        action.magnitudes.empty() ? std::nullopt : action.magnitudes[a];
    appended(actions, topology.action_name(static_cast<int>(a))) =
        magnitude ? number(in.action(*magnitude, topology.actions[a].is_couple)) : Json(nullptr);
  }
  result["undetermined"] = Json::array();
  for (const int a : action.check.undetermined) {
    result["undetermined"].push_back(topology.action_name(a));
  }
  if (!action.self_stresses.empty()) {
    result["self_stresses"] = Json::array();
    for (const SelfStress& stress : action.self_stresses) {
      result["self_stresses"].push_back(self_stress_json(topology, stress, in));
    }
  }
  if (action.completion.by != IndeterminateChoice::report) {
    result["completion"] = completion_json(topology, action.completion, in);
  }
  Json& couplings = result["couplings"] = object_of(topology.couplings.size());
  for (std::size_t e = 0; e < action.wrenches.size(); ++e) {
    appended(couplings, topology.couplings[e].name) =
        wrench_json(mechanism, e, bounded_wrench(action, CouplingId{static_cast<int>(e)}), in);
  }
  if (!one.which.loads.empty()) {
    result["loads"] = object_of(one.which.loads.size());
    for (const Load& load : one.which.loads) {
      result["loads"][load.name] = load_json(mechanism, load, in);
    }
  }
  if (!action.friction.empty()) {
    result["friction"] = object_of(action.friction.size());
    for (const FrictionAction& friction : action.friction) {
      result["friction"][topology.coupling(friction.coupling).name] =
          friction_json(mechanism, friction, in);
    }
  }
  if (has_planets(mechanism) && !action.magnitudes.empty()) {
    result["planets"] = planets_json(mechanism, action, in);
  }
  if (!one.contacts.empty()) {
    result["contacts"] = object_of(one.contacts.size());
    for (std::size_t i = 0; i < one.contacts.size(); ++i) {
      result["contacts"][mechanism.contacts[i].name] =
          contact_json(mechanism.contacts[i], one.contacts[i], in);
    }
  }
  result["evidence"] =
      evidence_json(action.evidence,
                    action.wrenches.empty() ? std::nullopt : std::optional(action.residual),
                    action.answer);
  return result;
}

}  // namespace kinestat
