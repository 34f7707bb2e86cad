#include "studies/sweep/report/sweep_column.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "cases/case_efficiency.hpp"
#include "cases/gear_answer.hpp"
#include "cases/input_inertia.hpp"
#include "cases/report/case_record.hpp"
#include "cases/report/ratio_in_units.hpp"
#include "core/contract.hpp"
#include "core/index.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "kinematics/bounded_motion.hpp"
#include "mechanism/check/report_name_check.hpp"
#include "mechanism/label_kind.hpp"
#include "mechanism/motion_figure.hpp"
#include "power/ratio.hpp"
#include "report/in_units.hpp"
#include "report/number_at_path.hpp"
#include "statics/coupling_wrenches.hpp"
#include "studies/shift/gear_limits.hpp"

namespace kinestat {

namespace {

using enum SweepColumnKind;

const RatioInUnits& ratio_in(const RatiosInUnits& ratios, SweepColumnKind kind) {
  return kind == ratio ? ratios.ratio : ratios.torque_ratio;
}

QuantityKind inertia_kind(const Mechanism& mechanism, int freedom) {
  return mechanism.topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation
             ? QuantityKind::inertia
             : QuantityKind::mass;
}

class ColumnSearch {
 public:
  ColumnSearch(const MechanismDescription& description,
               const Mechanism& mechanism,
               std::span<const Case> cases,
               const FindOfMotion& of_motion,
               Diagnostics& found)
      : description_(description),
        mechanism_(mechanism),
        topology_(mechanism.topology),
        cases_(cases),
        of_motion_(of_motion),
        found_(found),
        units_(description.units) {}

  std::vector<SweepColumn> run() {
    std::vector<SweepColumn> result;
    for (const Name& name : description_.sweep->report) {
      if (auto column = find(name)) {
        result.push_back(*std::move(column));
      }
    }
    return description_.sweep->report.empty() ? all() : result;
  }

 private:
  std::vector<SweepColumn> all() {
    std::vector<SweepColumn> result;
    for (const auto& [kind, name] :
         {std::pair(ratio, "ratio"), std::pair(torque_ratio, "torque_ratio")}) {
      if (const auto units = units_of_ratio(kind); units.size() == 1) {
        result.push_back({.kind = kind, .index = -1, .name = name, .unit = units.front()});
      }
    }
    for (int f = 0; f < topology_.freedom_count(); ++f) {
      result.push_back(rate_of(f));
    }
    for (int a = 0; a < topology_.action_count(); ++a) {
      result.push_back(action_of(a));
    }
    return result;
  }

  std::optional<SweepColumn> find(const Name& name) {
    if (name.text == "ratio" || name.text == "torque_ratio") {
      return ratio_of(name.text == "ratio" ? ratio : torque_ratio, name);
    }
    if (name.text == "step") {
      return step_of(name);
    }
    if (name.text == "limit_use") {
      return limit_use_of_gears(name);
    }
    if (name.text == kEquivalentInertiaWord) {
      return equivalent_inertia_of(name);
    }
    if (name.text == "efficiency" || name.text == "recirculation") {
      return SweepColumn{.kind = name.text == "efficiency" ? efficiency : recirculation,
                         .index = -1,
                         .name = name.text,
                         .unit = {}};
    }
    for (int a = 0; a < topology_.action_count(); ++a) {
      if (topology_.action_name(a) == name.text) {
        return action_of(a);
      }
    }
    for (int f = 0; f < topology_.freedom_count(); ++f) {
      if (topology_.freedom_name(f) == name.text) {
        return rate_of(f);
      }
    }
    for (const ActuatorTopology& actuator : topology_.actuators) {
      if (name.text == "lossy." + actuator.name) {
        SweepColumn result = action_of(actuator.action);
        result.kind = lossy_action;
        result.name = name.text;
        return result;
      }
    }
    if (is_report_path(name.text)) {
      return reported_at(name);
    }
    KINESTAT_EXPECTS(motion_figure_of(name.text));  // the check of the section lets no other pass
    return of_motion_(name);
  }

  std::optional<SweepColumn> reported_at(const Name& name) {
    if (auto unit = unit_at_path(case_record(), name.text, units_)) {
      return SweepColumn{
          .kind = reported, .index = -1, .name = name.text, .unit = *std::move(unit)};
    }
    const std::vector<std::string> paths = number_paths(case_record());
    found_.error(
        "E0313",
        name.where,
        fmt::format("the report of a case has no single number '{}'", printable(name.text)),
        guess_before(name.text, paths, "it has " + plain_list(paths, paths.size())));
    return std::nullopt;
  }

  // Between the gears of a shift table.
  std::optional<SweepColumn> step_of(const Name& name) {
    if (!description_.shift) {
      found_.error("E0305",
                   name.where,
                   "'step' is the ratio of the next lower gear over a gear's own, and the file has "
                   "no section 'shift'",
                   "remove 'step', or let 'shift:' name the input, the output and the elements");
      return std::nullopt;
    }
    if (const std::vector<std::string> others = gears_left_out(); !others.empty()) {
      found_.error(
          "E0305",
          name.where,
          fmt::format("'step' compares a gear with the next lower one of the file, and the "
                      "sweep leaves out {}",
                      quoted_list(others)),
          "name them too, or leave out 'cases:' of 'sweep'");
      return std::nullopt;
    }
    return SweepColumn{.kind = step, .index = -1, .name = name.text, .unit = {}};
  }

  // Of the gears that 'shift' names, those that the sweep does not analyse.
  std::vector<std::string> gears_left_out() const {
    std::vector<std::string> others;
    for (const GearLabel& gear : description_.shift->names) {
      if (std::ranges::find(cases_, gear.label.text, &Case::label) == cases_.end()) {
        others.push_back(gear.label.text);
      }
    }
    return others;
  }

  std::optional<SweepColumn> limit_use_of_gears(const Name& name) {
    if (!description_.shift || !description_.shift->limits) {
      found_.error(
          "E0305",
          name.where,
          "'limit_use' is the largest of a gear's torques and speeds over their limits, and "
          "the file has no 'limits' in a section 'shift'",
          "remove 'limit_use', or give limits, 'limits: {torque: 200 N*m}' in 'shift'");
      return std::nullopt;
    }
    return SweepColumn{.kind = limit_use, .index = -1, .name = name.text, .unit = {}};
  }

  // At the one input of a case, as its kind of freedom has it.
  std::optional<SweepColumn> equivalent_inertia_of(const Name& name) {
    const auto refuse = [&](std::string message, std::string hint) {
      found_.error("E0305", name.where, std::move(message), std::move(hint));
      return std::nullopt;
    };
    if (std::ranges::none_of(mechanism_.masses, &BodyMass::counts)) {
      return refuse("'equivalent_inertia' is of the inertia of bodies, and none has any",
                    "give 'bodies' mass, centre_of_mass and inertia, or remove "
                    "'equivalent_inertia'");
    }
    std::optional<QuantityKind> kind;
    for (const Case& one : cases_) {
      const std::optional<int> freedom = only_input_freedom(mechanism_, one);
      if (!freedom) {
        return refuse(fmt::format("'equivalent_inertia' is that at the input of a case, and case "
                                  "'{}' names {}",
                                  printable(one.label),
                                  one.inputs.empty() ? "none" : "several"),
                      fmt::format("add input: one of {}", plain_list(actuator_names())));
      }
      const QuantityKind its = inertia_kind(mechanism_, *freedom);
      if (kind && *kind != its) {
        return refuse(fmt::format("'equivalent_inertia' is in '{}' in one case and in '{}' in "
                                  "another",
                                  units_.text(*kind),
                                  units_.text(its)),
                      "name cases under 'cases:' of 'sweep' whose inputs are alike");
      }
      kind = its;
    }
    return SweepColumn{.kind = equivalent_inertia,
                       .index = -1,
                       .name = name.text,
                       .unit = kind ? units_.text(*kind) : ""};
  }

  std::vector<std::string> actuator_names() const {
    std::vector<std::string> names;
    for (const ActuatorTopology& one : topology_.actuators) {
      names.push_back(one.name);
    }
    return names;
  }

  SweepColumn rate_of(int freedom) const {
    const FreedomLabel& label = topology_.freedoms[static_cast<std::size_t>(freedom)];
    return {.kind = rate,
            .index = freedom,
            .name = topology_.freedom_name(freedom),
            .unit = units_.text(kind_of(label))};
  }

  SweepColumn action_of(int action) const {
    const ActionLabel& label = topology_.actions[static_cast<std::size_t>(action)];
    return {.kind = SweepColumnKind::action,
            .index = action,
            .name = topology_.action_name(action),
            .unit = units_.text(kind_of(label))};
  }

  // All that the cases have, each once.
  std::vector<std::string> units_of_ratio(SweepColumnKind kind) const {
    std::vector<std::string> units;
    for (const Case& one : cases_) {
      if (has_ratio_ends(one)) {
        const RatioEnds ends{.input = one.inputs.front(), .output = one.outputs.front()};
        units.push_back(ratio_in(ratios_in_units({}, ends, mechanism_, units_), kind).unit);
        if (std::ranges::count(units, units.back()) > 1) {
          units.pop_back();
        }
      }
    }
    return units;
  }

  // Refuses the column of a ratio that no row would have.
  void refuse_ratio(const Name& name) {
    const Case& first = cases_.front();
    MissingEnds missing = missing_ratio_ends(mechanism_, first);
    found_.error("E0303",
                 name.where,
                 fmt::format("'sweep' reports '{}', but case '{}' {}",
                             name.text,
                             printable(first.label),
                             missing.what),
                 std::move(missing.hint));
  }

  // One column holds the ratios of all cases, so they must measure the same.
  SweepColumn ratio_of(SweepColumnKind kind, const Name& name) {
    const std::vector<std::string> units = units_of_ratio(kind);
    if (units.empty() && !cases_.empty()) {
      refuse_ratio(name);
    }
    if (units.size() > 1) {
      found_.error(
          "E0305",
          name.where,
          fmt::format(
              "'{}' is in '{}' in one case and in '{}' in another", name.text, units[0], units[1]),
          "name cases under 'cases:' of 'sweep' whose inputs and outputs are alike");
    }
    return {
        .kind = kind, .index = -1, .name = name.text, .unit = units.empty() ? "" : units.front()};
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  std::span<const Case> cases_;
  const FindOfMotion& of_motion_;
  Diagnostics& found_;
  const FileUnits& units_;
};

// The action, with mesh losses if asked for: callers do so only if some mesh has losses.
std::optional<double> action_value(const CaseAnalysis& one, std::size_t action, bool is_lossy) {
  if (is_lossy) {
    return one.efficiency && one.efficiency->state ? one.efficiency->state->actions[action]
                                                   : std::nullopt;
  }
  const bool has_value = one.action && action < one.action->magnitudes.size() &&
                         one.action->magnitudes[action].has_value();
  return has_value ? std::optional(bounded_action(*one.action, static_cast<int>(action)).zeroed())
                   : std::nullopt;
}

std::optional<double> equivalent_inertia_value(const CaseAnalysis& one,
                                               const Mechanism& mechanism,
                                               const FileUnits& units) {
  const auto shares = input_inertias(mechanism, one);
  return shares ? std::optional(units.from_si(
                      inertia_kind(mechanism, *only_input_freedom(mechanism, one.which)),
                      std::accumulate(shares->begin(), shares->end(), 0.0)))
                : std::nullopt;
}

bool is_same_freedom(const FreedomLabel& a, const FreedomLabel& b) {
  return a.coupling == b.coupling && a.name == b.name && a.is_rotation == b.is_rotation;
}

bool is_same_action(const ActionLabel& a, const ActionLabel& b) {
  return a.coupling == b.coupling && a.name == b.name && a.is_couple == b.is_couple &&
         a.actuator == b.actuator;
}

// -1 if it is not there.
template <class Label, class IsSame>
int place_of(const std::vector<Label>& labels, const Label& label, const IsSame& is_same) {
  const auto at =
      std::ranges::find_if(labels, [&](const Label& one) { return is_same(one, label); });
  return at == labels.end() ? -1 : static_cast<int>(at - labels.begin());
}

}  // namespace

bool needs_statics(SweepColumnKind kind) {
  return kind != ratio && kind != rate && kind != step && kind != motion &&
         kind != equivalent_inertia;
}

bool needs_power(SweepColumnKind kind) {
  return kind == efficiency || kind == recirculation || kind == limit_use || kind == lossy_action ||
         kind == reported;
}

bool asks(std::span<const SweepColumn> columns, SweepColumnKind kind) {
  return std::ranges::find(columns, kind, &SweepColumn::kind) != columns.end();
}

bool asks_power(std::span<const SweepColumn> columns) {
  return std::ranges::any_of(columns, needs_power, &SweepColumn::kind);
}

std::optional<std::vector<SweepColumn>> find_sweep_columns(const MechanismDescription& description,
                                                           const Mechanism& mechanism,
                                                           std::span<const Case> cases,
                                                           const FindOfMotion& of_motion,
                                                           Diagnostics& found) {
  KINESTAT_EXPECTS(description.sweep.has_value());
  const int errors_before = found.error_count();
  std::vector<SweepColumn> result =
      ColumnSearch(description, mechanism, cases, of_motion, found).run();
  return found.error_count() == errors_before ? std::optional(std::move(result)) : std::nullopt;
}

bool has_same_magnitudes(const Topology& a, const Topology& b) {
  return std::ranges::equal(a.freedoms, b.freedoms, is_same_freedom) &&
         std::ranges::equal(a.actions, b.actions, is_same_action);
}

std::vector<SweepColumn> columns_in(const std::vector<SweepColumn>& columns,
                                    const Topology& file,
                                    const Topology& state) {
  std::vector<SweepColumn> result = columns;
  for (SweepColumn& column : result) {
    if (column.kind == rate) {
      column.index = place_of(state.freedoms, file.freedoms[at(column.index)], is_same_freedom);
    } else if (column.kind == SweepColumnKind::action || column.kind == lossy_action) {
      column.index = place_of(state.actions, file.actions[at(column.index)], is_same_action);
    }
  }
  return result;
}

std::optional<double> value_of(const SweepColumn& column,
                               const CaseAnalysis& one,
                               const Mechanism& mechanism,
                               const FileUnits& units) {
  const InUnits in(units);
  const auto i = static_cast<std::size_t>(column.index);
  switch (column.kind) {
    case ratio:
    case torque_ratio:
      return one.ratios ? ratio_in(ratios_in_units(one, mechanism, units), column.kind).value
                        : std::nullopt;
    case step:
    case limit_use:
    case motion:
      return std::nullopt;
    case efficiency:
      return case_efficiency(one, mechanism).value;
    case recirculation:
      return one.power_graph ? one.power_graph->recirculation : std::nullopt;
    case equivalent_inertia:
      return equivalent_inertia_value(one, mechanism, units);
    case reported:
      return number_at_path(case_record(),
                            CaseView{.mechanism = mechanism, .units = units, .one = one},
                            column.name,
                            units);
    case rate:
      return one.motion && i < one.motion->rates.size() && one.motion->knows_rate(column.index)
                 ? std::optional(in.rate(bounded_rate(*one.motion, column.index).zeroed(),
                                         mechanism.topology.freedoms[i].is_rotation))
                 : std::nullopt;
    case SweepColumnKind::action:
    case lossy_action: {
      if (column.index < 0) {
        return std::nullopt;
      }
      const bool is_lossy = column.kind == lossy_action && !mechanism.lossy_meshes.empty();
      const std::optional<double> value = action_value(one, i, is_lossy);
      return value ? std::optional(in.action(*value, mechanism.topology.actions[i].is_couple))
                   : std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<double> limit_use_of(const Mechanism& mechanism,
                                   const ShiftPlan& plan,
                                   const ShiftState& state,
                                   const CaseAnalysis& one) {
  const std::vector<LimitUse> uses = find_limit_uses(solved_gear(mechanism, plan, state, one));
  const LimitUse* largest = find_largest_use(uses);
  return largest != nullptr ? largest->use() : std::nullopt;
}

}  // namespace kinestat
