#include "cases/report/case_record.hpp"

#include "cases/free_parameters.hpp"
#include "cases/report/ratio_in_units.hpp"
#include "dynamics/dynamics_record.hpp"
#include "dynamics/spring_record.hpp"
#include "kinematics/kinematic_record.hpp"
#include "mechanism/label_kind.hpp"
#include "power/power_record.hpp"
#include "statics/static_record.hpp"

namespace kinestat {

namespace {

const Record<CaseView>& primary_record() {
  static const Record<CaseView> record(
      "The magnitudes known in the case.", [](Record<CaseView>& keys) {
        keys.names("motion",
                   "Names of the known motions, coupling.freedom.",
                   [](const CaseView& v, const EachName& each) {
                     for (const Primary& primary : v.one.which.motions) {
                       if (!primary.is_assumed) {
                         each(v.mechanism.topology.freedom_name(primary.index));
                       }
                     }
                   });
        keys.names("action",
                   "Names of the known actions, coupling.action or an actuator.",
                   [](const CaseView& v, const EachName& each) {
                     for (const Primary& primary : v.one.which.actions) {
                       each(v.mechanism.topology.action_name(primary.index));
                     }
                   });
      });
  return record;
}

const Record<Ratios>& ratio_evidence_record() {
  static const Record<Ratios> record("Error bound of the ratios.", [](Record<Ratios>& keys) {
    keys.number("ratio_error_bound",
                Bare::number,
                "Bound of the relative error of the ratio; 1 where no digit is certain, null where "
                "the rates have no bound.",
                [](const Ratios& v) { return v.ratio_bound; })
        .at_least(0);
    keys.number("torque_ratio_error_bound",
                Bare::number,
                "Bound of the relative error of the torque ratio; 1 where no digit is certain, "
                "null where the actions have no bound.",
                [](const Ratios& v) { return v.torque_ratio_bound; })
        .at_least(0);
  });
  return record;
}

auto read_ratio(RatioInUnits RatiosInUnits::*which) {
  return [which](const CaseView& v) {
    const RatiosInUnits ratios = ratios_in_units(v.one, v.mechanism, v.units);
    return std::pair((ratios.*which).value, (ratios.*which).unit);
  };
}

auto read_ratio_unit(RatioInUnits RatiosInUnits::*which) {
  return [which](const CaseView& v) { return read_ratio(which)(v).second; };
}

bool has_ratios(const CaseView& v) {
  return v.one.ratios.has_value();
}

void add_ratios(Record<CaseView>& keys) {
  const auto has_unit = [](const CaseView& v) {
    return v.one.ratios && !read_ratio_unit(&RatiosInUnits::ratio)(v).empty();
  };
  keys.converted("ratio",
                 ByContext::rate_ratio,
                 "Rate of the input over rate of the output; null where it does not exist, see "
                 "reason. Without unit if both are of the same kind.",
                 read_ratio(&RatiosInUnits::ratio))
      .not_in_tables()
      .only_if(has_ratios);
  keys.text("ratio_fraction",
            "The ratio as a fraction of whole numbers, without rounding; no key where it is not "
            "made by the teeth of 'gears' alone.",
            [](const CaseView& v) { return v.one.ratios->fraction; })
      .not_in_tables()
      .not_compared()
      .only_if([](const CaseView& v) { return v.one.ratios && !v.one.ratios->fraction.empty(); });
  keys.converted("torque_ratio",
                 ByContext::action_ratio,
                 "Action of the input over action of the output; null where it does not exist. "
                 "Without unit if both are of the same kind.",
                 read_ratio(&RatiosInUnits::torque_ratio))
      .not_in_tables()
      .only_if(has_ratios);
  keys.text("ratio_unit",
            "Unit of the ratio; no key if input and output are of the same kind.",
            read_ratio_unit(&RatiosInUnits::ratio))
      .not_compared()
      .only_if(has_unit);
  keys.text("torque_ratio_unit",
            "Unit of the torque ratio; no key if input and output are of the same kind.",
            read_ratio_unit(&RatiosInUnits::torque_ratio))
      .not_compared()
      .only_if(has_unit);
  keys.text("reason",
            "Why there is no ratio.",
            [](const CaseView& v) { return v.one.ratios->reason; })
      .not_compared()
      .only_if([](const CaseView& v) { return v.one.ratios && !v.one.ratios->reason.empty(); });
  keys.part("evidence",
            ratio_evidence_record(),
            [](const CaseView& v) -> const Ratios& { return *v.one.ratios; })
      .not_compared()
      .only_if(has_ratios);
}

// The function of the free parameters that a magnitude is, in the unit of the magnitude.
void write_affine(std::string_view name,
                  QuantityKind kind,
                  const std::optional<AffineValue>& value,
                  const std::vector<FreeParameterLabel>& parameters,
                  Archive& to) {
  to.element(name, {});
  if (!value) {
    to.null();
    return;
  }
  to.begin_map();
  to.element("1", {});
  to.quantity(value->constant, kind);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (value->coefficients[i] != 0.0) {  // without influence
      to.element(parameters[i].name, {});
      to.quantity(value->coefficients[i], kind);
    }
  }
  to.end_map();
}

void write_all_affine(const CaseView& v, Archive& to) {
  const Topology& topology = v.mechanism.topology;
  const std::vector<FreeParameterLabel>& parameters = affine_dependence(*v.analysis).parameters;
  const AffineCase& affine = affine_case(*v.analysis, v.one);
  to.begin_map();
  for (const AffineMagnitude& rate : affine.rates) {
    const QuantityKind kind = kind_of(topology.freedoms[static_cast<std::size_t>(rate.index)]);
    write_affine(topology.freedom_name(rate.index), kind, rate.value, parameters, to);
  }
  for (const AffineMagnitude& action : affine.actions) {
    const QuantityKind kind = kind_of(topology.actions[static_cast<std::size_t>(action.index)]);
    write_affine(topology.action_name(action.index), kind, action.value, parameters, to);
  }
  to.end_map();
}

Shape affine_shape() {
  Shape of_magnitude = map_shape(number_shape(ByContext::coefficient, false));
  of_magnitude.is_nullable = true;
  return map_shape(std::move(of_magnitude));
}

KinematicView motion_of(const CaseView& v) {
  return {.mechanism = v.mechanism, .motion = *v.one.motion};
}

StaticView actions_of(const CaseView& v) {
  return {.mechanism = v.mechanism,
          .which = v.one.which,
          .action = *v.one.action,
          .contacts = v.one.contacts,
          .converters = v.one.converters,
          .units = v.units};
}

// Tables have each ratio in the pass of its magnitudes.
const Record<CaseView>& case_kinematic_record() {
  static const Record<CaseView> record(kinematic_record().meaning, [](Record<CaseView>& keys) {
    keys.include(kinematic_record(), motion_of);
    keys.converted(
            "ratio", ByContext::rate_ratio, "That of the case.", read_ratio(&RatiosInUnits::ratio))
        .only_in_tables()
        .only_if(has_ratios);
  });
  return record;
}

const Record<CaseView>& case_static_record() {
  static const Record<CaseView> record(static_record().meaning, [](Record<CaseView>& keys) {
    keys.include(static_record(), actions_of);
    keys.converted("torque_ratio",
                   ByContext::action_ratio,
                   "That of the case.",
                   read_ratio(&RatiosInUnits::torque_ratio))
        .only_in_tables()
        .only_if(has_ratios);
  });
  return record;
}

void add_passes(Record<CaseView>& keys) {
  keys.part("kinematics", case_kinematic_record(), [](const CaseView& v) { return v; })
      .only_if([](const CaseView& v) { return v.one.motion.has_value(); })
      .in_tables_is(TableRole::table);
  keys.part("statics", case_static_record(), [](const CaseView& v) { return v; })
      .only_if([](const CaseView& v) { return v.one.action.has_value(); })
      .in_tables_is(TableRole::table);
  keys.part("power",
            power_record(),
            [](const CaseView& v) {
              return PowerView{.mechanism = v.mechanism,
                               .which = v.one.which,
                               .action = *v.one.action,
                               .flow = *v.one.power,
                               .graph = *v.one.power_graph,
                               .efficiency = v.one.efficiency ? &*v.one.efficiency : nullptr};
            })
      .only_if([](const CaseView& v) { return v.one.power.has_value(); })
      .in_tables_is(TableRole::table);
  keys.map("springs",
           spring_record(),
           "Springs by name; no key without any.",
           [](const CaseView& v, const Each<SpringView>& each) {
             for (std::size_t i = 0; i < v.one.springs.size(); ++i) {
               each(v.mechanism.springs[i].name,
                    {.mechanism = v.mechanism, .index = i, .state = v.one.springs[i]});
             }
           })
      .only_if([](const CaseView& v) { return !v.one.springs.empty(); })
      .not_in_tables();
  keys.part("dynamics",
            dynamics_record(),
            [](const CaseView& v) {
              return DynamicsView{.mechanism = v.mechanism, .dynamics = *v.one.dynamics};
            })
      .only_if([](const CaseView& v) { return v.one.dynamics.has_value(); })
      .in_tables_is(TableRole::table);
}

}  // namespace

const Record<CaseView>& case_record() {
  static const Record<CaseView> record("One case of the file.", [](Record<CaseView>& keys) {
    keys.part("primary", primary_record(), [](const CaseView& v) { return v; });
    add_ratios(keys);
    add_passes(keys);
    keys.custom(
            "affine",
            affine_shape(),
            "Magnitudes that depend on the free parameters; only in files that have any. Each "
            "as an affine function: the constant under \"1\", the coefficient of each parameter "
            "under its name, in the units of the file; null for a magnitude that is not affine "
            "in them.",
            write_all_affine)
        .not_in_tables()
        .only_if([](const CaseView& v) {
          return v.analysis != nullptr && has_free_parameters(v.analysis->description);
        });
  });
  return record;
}

}  // namespace kinestat
