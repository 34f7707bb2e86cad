#include "studies/shift/report/shift_record.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "studies/shift/report/gear_part_records.hpp"
#include "studies/shift/report/gear_report.hpp"
#include "studies/shift/report/reaction_record.hpp"
#include "studies/shift/report/shift_parts.hpp"
#include "studies/shift/report/slip_record.hpp"

namespace kinestat {

namespace {

struct StateView {
  const Analysis& analysis;
  const NamedShiftState& state;
  std::optional<GearValues> gear = {};               // empty of what is no gear, as all below
  std::vector<RatiosInUnits> ratios = {};            // to each output
  const CaseAnalysis* one = nullptr;                 // its case
  std::optional<std::vector<double>> inertias = {};  // of the bodies at the input
  std::optional<double> step = {};
};

bool is_gear(const StateView& v) {
  return v.gear.has_value();
}

bool has_limits(const StateView& v) {
  return is_gear(v) && !v.gear->limits.empty();
}

// What it leaves free, and why it has no ratio.
std::string reason_of(const StateView& v) {
  std::string reason = v.state.reason;
  for (const Ratios& ratios : v.gear ? v.gear->ratios : std::vector<Ratios>()) {
    reason += (reason.empty() || ratios.reason.empty() ? "" : "; ") + ratios.reason;
  }
  return reason;
}

// What one output has, or a map of what several have by name.
template <class Write>
void write_outputs(const Analysis& analysis, Archive& to, const Write& write) {
  const std::vector<int>& outputs = analysis.shift->plan.outputs;
  if (outputs.size() == 1) {
    write(std::size_t{0});
    return;
  }
  to.begin_map();
  for (std::size_t o = 0; o < outputs.size(); ++o) {
    Property output;
    output.key = output.table_quantity = name_of_actuator(analysis, outputs[o]);
    if (to.begin(output)) {
      write(o);
      to.end(output);
    }
  }
  to.end_map();
}

auto write_ratio(RatioInUnits RatiosInUnits::*which) {
  return [which](const StateView& v, Archive& to) {
    if (v.ratios.empty()) {
      to.number(std::nullopt, {});
      return;
    }
    write_outputs(v.analysis, to, [&](std::size_t o) {
      to.number((v.ratios[o].*which).value, (v.ratios[o].*which).unit);
    });
  };
}

auto write_ratio_unit(RatioInUnits RatiosInUnits::*which) {
  return [which](const Analysis& v, Archive& to) {
    const std::vector<RatiosInUnits> units = gear_ratio_units(v);
    write_outputs(v, to, [&](std::size_t o) { to.text((units[o].*which).unit); });
  };
}

bool have_ratios_units(const Analysis& v) {
  return std::ranges::any_of(gear_ratio_units(v),
                             [](const RatiosInUnits& one) { return !one.ratio.unit.empty(); });
}

Shape by_output(Shape shape) {
  shape.may_be_by_name = true;
  return shape;
}

auto fill_loaded() {
  return [](Record<LoadedCoupling>& keys) {
    keys.text("coupling",
              "Name of the coupling, empty where none bears any force.",
              [](const LoadedCoupling& v) { return v.name; });
    keys.quantity("force",
                  QuantityKind::force,
                  "Magnitude of its force.",
                  [](const LoadedCoupling& v) { return std::optional(v.force); })
        .at_least(0);
  };
}

const Record<LoadedCoupling>& worst_bearing_record() {
  static const Record<LoadedCoupling> record(
      "The revolute or other guiding coupling with the largest force of the gear; null where no "
      "force is known.",
      fill_loaded());
  return record;
}

const Record<LoadedCoupling>& worst_mesh_record() {
  static const Record<LoadedCoupling> record(
      "The mesh with the largest force of the gear; null where no force is known.", fill_loaded());
  return record;
}

// Tables have the coupling as the element of its force.
void add_worst(Record<StateView>& keys,
               const std::string& key,
               const Record<LoadedCoupling>& record,
               std::optional<LoadedCoupling> GearValues::*member) {
  keys.part(key, record, [member](const StateView& v) { return *v.gear.*member; })
      .not_in_tables()
      .only_if(is_gear);
  keys.custom(key,
              map_shape(number_shape(QuantityKind::force, true)),
              "Its force by its name.",
              [member](const StateView& v, Archive& to) {
                const std::optional<LoadedCoupling>& worst = *v.gear.*member;
                to.begin_map();
                to.element(worst ? worst->name : "", {});
                to.quantity(worst ? std::optional(worst->force) : std::nullopt,
                            QuantityKind::force);
                to.end_map();
              })
      .in_tables_as(key + "/force")
      .only_in_tables()
      .only_if(is_gear);
}

void emit_limits(const StateView& v, const Each<LimitUse>& each) {
  for (const LimitUse& use : v.gear->limits) {
    each(name_of(use.part, v.analysis.shift->plan, v.analysis.mechanism.topology), use);
  }
}

void emit_elements(const StateView& v, const Each<ElementView>& each) {
  const auto count = static_cast<int>(v.analysis.shift->plan.elements.size());
  for (int e = 0; e < count; ++e) {
    each(name_of_element(v.analysis, e),
         {.torque = v.gear->torques[static_cast<std::size_t>(e)],
          .lossy_torque = v.gear->lossy_torques[static_cast<std::size_t>(e)],
          .has_lossy_meshes = !v.analysis.mechanism.lossy_meshes.empty(),
          .slip = v.gear->slips[static_cast<std::size_t>(e)]});
  }
}

void emit_inertia_shares(const StateView& v, const EachNumber& each) {
  const Mechanism& mechanism = v.analysis.mechanism;
  const double whole = std::accumulate(v.inertias->begin(), v.inertias->end(), 0.0);
  for (std::size_t b = 0; b < mechanism.masses.size(); ++b) {
    if (mechanism.masses[b].counts()) {
      each(mechanism.topology.bodies[b].name,
           whole > 0.0 ? std::optional((*v.inertias)[b] / whole) : std::nullopt,
           QuantityKind::dimensionless);
    }
  }
}

void write_speed_shares(const StateView& v, Archive& to) {
  const ShiftPlan& plan = v.analysis.shift->plan;
  to.begin_map();
  for (std::size_t o = 0; o < plan.outputs.size(); ++o) {
    const std::vector<RatioInUnits> shares = speed_shares(v.analysis, v.state.state, o);
    Property output;
    output.key = name_of_actuator(v.analysis, plan.outputs[o]);
    if (!to.begin(output)) {
      continue;
    }
    write_shares(v.analysis, shares, to);
    to.end(output);
  }
  to.end_map();
}

void write_torque_shares(const StateView& v, Archive& to) {
  const std::vector<int>& outputs = v.analysis.shift->plan.outputs;
  to.begin_map();
  for (std::size_t o = 0; o < outputs.size(); ++o) {
    Property output;
    output.key = name_of_actuator(v.analysis, outputs[o]);
    if (to.begin(output)) {
      write_shares(
          v.analysis, torque_shares_of(v.analysis, outputs[o], v.state.state.torque_shares[o]), to);
      to.end(output);
    }
  }
  to.end_map();
}

void emit_reactions(const StateView& v, const Each<ReactionView>& each) {
  for (const ShiftReaction& reaction : v.state.state.reactions) {
    each(name_of_actuator(v.analysis, actuator_of(v.analysis, reaction)),
         {.analysis = v.analysis, .reaction = reaction});
  }
}

void add_reactions(Record<StateView>& keys) {
  keys.map("reactions",
           reaction_record(),
           "Machines of 'reacts', whose speed and torque follow from those of the others; no key "
           "without any.",
           emit_reactions)
      .in_tables_as("reaction")
      .only_if([](const StateView& v) { return is_gear(v) && !v.state.state.reactions.empty(); });
  keys.custom("torque_shares",
              map_shape(map_shape(number_shape(ByContext::action_ratio, true))),
              "With 'reacts': the torque of each output is the sum of the torques of the inputs "
              "times these, without losses.",
              write_torque_shares)
      .not_in_tables()
      .only_if(
          [](const StateView& v) { return is_gear(v) && !v.state.state.torque_shares.empty(); });
}

void add_gear(Record<StateView>& keys) {
  keys.custom("speed_shares",
              map_shape(map_shape(number_shape(ByContext::rate_ratio, true))),
              "Where several inputs may have a speed of their own: that of each output is the sum "
              "of the speeds of these inputs times these shares. Without losses the torque of an "
              "input is minus its share times that of the output, if nothing else reacts.",
              write_speed_shares)
      .not_in_tables()
      .only_if([](const StateView& v) { return is_gear(v) && !v.state.state.shares.empty(); });
  add_reactions(keys);
  keys.number("step",
              Bare::number,
              "Ratio of the next lower forward gear over its own; null for the first gear and for "
              "reverse gears.",
              [](const StateView& v) { return v.step; })
      .only_if(is_gear);
  keys.text("ratio_fraction",
            "The ratio as a fraction of whole numbers, without rounding; no key where it is not "
            "made by the teeth of 'gears' alone, or of several outputs.",
            [](const StateView& v) { return v.one->ratios->fraction; })
      .not_in_tables()
      .not_compared()
      .only_if([](const StateView& v) {
        return is_gear(v) && v.one->ratios && !v.one->ratios->fraction.empty();
      });
  keys.custom("torque_ratio",
              by_output(number_shape(ByContext::action_ratio, true)),
              "Action of the input over that of the output without losses, of several outputs by "
              "name.",
              write_ratio(&RatiosInUnits::torque_ratio))
      .only_if(is_gear);
  keys.word("direction",
            {"forward", "reverse"},
            "By the sign of the ratio of the first output: forward is the sign given by 'forward' "
            "of 'shift', otherwise that of most gears.",
            [](const StateView& v) {
              const std::optional<double>& first = v.gear->ratios.front().ratio;
              using Word = std::optional<std::string_view>;
              return first
                         ? Word(*first * v.analysis.shift->solution.table.forward > 0.0 ? "forward"
                                                                                        : "reverse")
                         : Word();
            })
      .not_in_tables()
      .only_if(is_gear);
  keys.part("efficiency",
            gear_efficiency_record(),
            [](const StateView& v) -> const CaseAnalysis& { return *v.one; })
      .only_if(is_gear);
  keys.number("recirculation",
              Bare::number,
              "Largest power that a coupling transmits over the input power; above 1 power "
              "circulates.",
              [](const StateView& v) {
                return v.one->power_graph ? v.one->power_graph->recirculation : std::nullopt;
              })
      .only_if(is_gear);
  keys.quantity(
          "equivalent_inertia",
          QuantityKind::inertia,
          "Moment of inertia of the whole transmission at its input; no key if no body has mass or "
          "inertia, or with several inputs.",
          [](const StateView& v) {
            return std::accumulate(v.inertias->begin(), v.inertias->end(), 0.0);
          })
      .only_if([](const StateView& v) { return v.inertias.has_value(); });
  keys.numbers("inertia_shares",
               Bare::number,
               "Contribution of each body with mass or inertia.",
               emit_inertia_shares)
      .not_in_tables()
      .only_if([](const StateView& v) { return v.inertias.has_value(); });
  keys.map("elements", element_record(), "Every shift element of the gear by name.", emit_elements)
      .in_tables_as("")
      .only_if(is_gear);
  add_worst(keys, "worst_bearing", worst_bearing_record(), &GearValues::bearing);
  add_worst(keys, "worst_mesh", worst_mesh_record(), &GearValues::mesh);
  keys.number(
          "limit_use",
          Bare::ratio,
          "The largest of its torques and speeds over their limits, of a file that gives "
          "'limits': above 1 one of them is exceeded; speeds that the gear leaves open count for "
          "nothing; null where another one is not known.",
          [](const StateView& v) {
            const LimitUse* largest = find_largest_use(v.gear->limits);
            return largest != nullptr ? largest->use() : std::nullopt;
          })
      .only_if(has_limits);
  keys.map("limits",
           limit_record(),
           "Each limit by kind and name: torque.C1, slip.C1, speed.ring, planet_speed.planet.",
           emit_limits)
      .only_if(has_limits);
}

const Record<StateView>& state_record() {
  using View = StateView;
  static const Record<View> record("One combination of engaged elements.", [](Record<View>& keys) {
    keys.names("engaged",
               "The elements that are engaged; the others are open.",
               [](const View& v, const EachName& each) {
                 for (const int element : v.state.engaged) {
                   each(name_of_element(v.analysis, element));
                 }
               });
    keys.custom("engaged_elements",
                map_shape(whole_shape(false)),
                "1 of each that is engaged.",
                [](const View& v, Archive& to) {
                  to.begin_map();
                  for (const int element : v.state.engaged) {
                    to.element(name_of_element(v.analysis, element), {});
                    to.whole(1);
                  }
                  to.end_map();
                })
        .in_tables_as("engaged")
        .only_in_tables();
    keys.word("class",
              words_up_to(ShiftClass::tie_up),
              "gear; neutral: the input does not determine the output; locked: input or output "
              "cannot move; tie-up: more elements than needed, one of which follows from the "
              "others.",
              [](const View& v) { return word_of(v.state.state.kind); });
    keys.text(
        "reason",
        "Why it is not a gear, with the bodies locked and the freedoms that remain; of a gear "
        "what it leaves free, mostly empty.",
        reason_of);
    keys.count("freedom",
               "What the engaged elements leave of the net degree of freedom.",
               [](const View& v) { return v.state.state.freedom; });
    keys.custom("ratio",
                by_output(number_shape(ByContext::rate_ratio, true)),
                "Rate of the input over that of the output, of several outputs by name; null "
                "where it does not exist.",
                write_ratio(&RatiosInUnits::ratio));
    add_gear(keys);
  });
  return record;
}

void emit_states(const Analysis& v, const Each<StateView>& each) {
  const std::vector<NamedShiftState>& states = v.shift->solution.states;
  for (std::size_t s = 0; s < states.size(); ++s) {
    StateView view{.analysis = v, .state = states[s], .one = find_gear_case(v, states[s])};
    if (view.one != nullptr) {
      view.gear = gear_values(v, s);
      view.ratios = gear_ratios(v, s, *view.gear);
      view.step = v.shift->solution.table.steps[s];
      view.inertias = gear_inertias(v, *view.one);
    }
    each(states[s].name, view, word_of(states[s].state.kind));
  }
}

void write_equal_ratios(const Analysis& v, Archive& to) {
  to.begin_list();
  for (const std::vector<int>& group : v.shift->solution.table.equal_ratios) {
    to.begin_list();
    for (const int state : group) {
      to.text(v.shift->solution.states[static_cast<std::size_t>(state)].name);
    }
    to.end_list();
  }
  to.end_list();
}

void add_table(Record<Analysis>& keys) {
  keys.number("span",
              Bare::number,
              "Ratio of the first over that of the last forward gear; null with fewer than two.",
              [](const Analysis& v) { return v.shift->solution.table.span; });
  keys.custom("equal_ratios",
              list_shape(list_shape(word_shape({}, false))),
              "Gears of one ratio by different elements.",
              write_equal_ratios)
      .not_in_tables();
  keys.list("changes",
            change_record(),
            "Pairs of gears between which one element opens and one engages, or one does either, "
            "and forward gears that follow each other.",
            [](const Analysis& v, const Each<ChangeView>& each) {
              for (const GearChange& change : v.shift->solution.table.changes) {
                each({.analysis = v, .change = change});
              }
            })
      .not_in_tables();
  keys.map("changes_by_name",
           change_number_record(),
           "The same by the names of both gears.",
           [](const Analysis& v, const Each<ChangeView>& each) {
             for (const GearChange& change : v.shift->solution.table.changes) {
               const ChangeView view{.analysis = v, .change = change};
               each(view.name(), view);
             }
           })
      .in_tables_as("change")
      .only_in_tables();
}

}  // namespace

const Record<Analysis>& shift_record() {
  static const Record<Analysis> record(
      "Which combination of shift elements gives which gear. Every gear is also a case of its "
      "name.",
      [](Record<Analysis>& keys) {
        keys.count("possibilities",
                   "Number of combinations of as many elements as a gear engages.",
                   [](const Analysis& v) { return v.shift->solution.possibilities; });
        keys.count("net_freedom",
                   "Net degree of freedom with all elements open.",
                   [](const Analysis& v) { return v.shift->solution.net_freedom; });
        keys.count("engaged",
                   "Number of elements that a gear engages: the net degree of freedom minus the "
                   "number of inputs. With 'reacts' more, as inputs follow from each other.",
                   [](const Analysis& v) { return v.shift->solution.needed; });
        keys.custom("ratio_unit",
                    by_output(word_shape({}, false)),
                    "Unit of the ratios, of several outputs by name; no key if input and outputs "
                    "are of the same kind.",
                    write_ratio_unit(&RatiosInUnits::ratio))
            .not_in_tables()
            .not_compared()
            .only_if(have_ratios_units);
        keys.custom("torque_ratio_unit",
                    by_output(word_shape({}, false)),
                    "Likewise of the torque ratios.",
                    write_ratio_unit(&RatiosInUnits::torque_ratio))
            .not_in_tables()
            .not_compared()
            .only_if(have_ratios_units);
        keys.map("states",
                 state_record(),
                 "By label, or by elements joined with +; gears by decreasing ratio, then reverse "
                 "gears, then combinations that are not gears.",
                 emit_states)
            .in_tables_is(TableRole::cases);
        add_table(keys);
        keys.map("slip",
                 slip_record(),
                 "The changes of 'slip' by their names; no key without any.",
                 [](const Analysis& v, const Each<SlipView>& each) {
                   for (const ShiftSlip& slip : v.shift->slips) {
                     each(slip.name, {.analysis = v, .slip = slip}, word_of(slip.end));
                   }
                 })
            .only_if([](const Analysis& v) { return !v.shift->slips.empty(); });
        keys.map("slip_without_answer",
                 slip_obstacle_record(),
                 "The changes of 'slip' that have none, by their names; no key without any.",
                 [](const Analysis& v, const Each<SlipObstacle>& each) {
                   for (const SlipObstacle& one : v.shift->slips_without_answer) {
                     each(one.name, one);
                   }
                 })
            .only_if([](const Analysis& v) { return !v.shift->slips_without_answer.empty(); });
      });
  return record;
}

}  // namespace kinestat
