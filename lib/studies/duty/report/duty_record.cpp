#include "studies/duty/report/duty_record.hpp"

#include <array>

#include "cases/case_status.hpp"
#include "core/diagnostic.hpp"
#include "report/report_keys.hpp"

namespace kinestat {

namespace {

constexpr std::array<std::string_view, 4> kStatusWords = {
    "solved", "at_rest", "both_ends", "unanswered"};

// One of several alike, with what names it.
template <class Item>
struct ItemView {
  const DutyReportView& of;
  const Item& item;
};

const Record<DutyEnergy>& energy_record() {
  using View = DutyEnergy;
  static const Record<View> record(
      "Energies over a duration: energy supplied = energy delivered + energy lost.",
      [](Record<View>& keys) {
        keys.quantity(
            "duration", QuantityKind::time, "Duration.", [](const View& v) { return v.duration; });
        keys.quantity("given",
                      QuantityKind::energy,
                      "By actuators and loads while they drive.",
                      [](const View& v) { return v.given; });
        keys.quantity("taken",
                      QuantityKind::energy,
                      "By actuators and loads while they are driven.",
                      [](const View& v) { return v.taken; });
        keys.quantity("lost",
                      QuantityKind::energy,
                      "In teeth, bearings, dampers, and elements that slip or drag.",
                      [](const View& v) { return v.lost; });
        keys.number("efficiency",
                    Bare::efficiency,
                    "Energy delivered over energy supplied; null where none is supplied, or where "
                    "bodies or springs store or release energy.",
                    [](const View& v) { return v.efficiency(); });
        keys.text("reason",
                  "What leaves no efficiency.",
                  [](const View& v) { return v.no_efficiency; })
            .not_compared()
            .only_if([](const View& v) { return !v.no_efficiency.empty(); });
      });
  return record;
}

const Record<CouplingLoss>& loss_record() {
  using View = CouplingLoss;
  static const Record<View> record("The loss of a coupling.", [](Record<View>& keys) {
    keys.quantity(
        "lost", QuantityKind::energy, "Energy lost there.", [](const View& v) { return v.energy; });
  });
  return record;
}

const Record<DamperLoss>& damper_record() {
  using View = DamperLoss;
  static const Record<View> record("The loss of a spring's damping.", [](Record<View>& keys) {
    keys.quantity(
        "lost", QuantityKind::energy, "Energy lost there.", [](const View& v) { return v.energy; });
  });
  return record;
}

template <class View, class WearOf>
void add_wear(Record<View>& keys, QuantityKind load, const WearOf& wear_of) {
  keys.number("revolutions",
              Bare::number,
              "Revolutions, of all repetitions; null where a gear leaves its speed open.",
              [wear_of](const View& v) { return wear_of(v).revolutions; });
  keys.quantity("largest",
                load,
                "The largest of all points; null where equilibrium leaves that of a point open.",
                [wear_of](const View& v) { return wear_of(v).largest; });
  keys.quantity("equivalent",
                load,
                "Equivalent load: the constant load that causes the same damage in the same number "
                "of revolutions (Miner); null without an exponent, where nothing turns, or where a "
                "speed or load is open.",
                [wear_of](const View& v) { return wear_of(v).equivalent; });
}

const Record<GearDuty>& gear_record() {
  using View = GearDuty;
  static const Record<View> record(
      "The teeth of a gear in one mesh, seen from its carrier.", [](Record<View>& keys) {
        keys.count("planets",
                   "Equal planets that share the mesh; the torque is that of one.",
                   [](const View& v) { return v.planets; });
        add_wear(keys, QuantityKind::moment, [](const View& v) { return v.wear; });
      });
  return record;
}

const Record<BearingDuty>& bearing_record() {
  using View = BearingDuty;
  static const Record<View> record(
      "A bearing about which bodies turn: the magnitude of the force that it carries, with losses.",
      [](Record<View>& keys) {
        keys.count("planets",
                   "Equal planets that have one each; the force is that of one.",
                   [](const View& v) { return v.planets; });
        add_wear(keys, QuantityKind::force, [](const View& v) { return v.wear; });
      });
  return record;
}

const Record<ElementDuty>& element_record() {
  using View = ElementDuty;
  static const Record<View> record("A clutch or brake.", [](Record<View>& keys) {
    keys.quantity(
        "engaged", QuantityKind::time, "The time for which it holds a torque.", [](const View& v) {
          return v.engaged;
        });
    keys.quantity("largest", QuantityKind::moment, "Its largest torque.", [](const View& v) {
      return v.largest;
    });
    keys.quantity("lost",
                  QuantityKind::energy,
                  "Energy that it loses where it slips under a known torque; its drag is under "
                  "'friction'.",
                  [](const View& v) { return v.lost; });
  });
  return record;
}

std::vector<std::string> point_statuses() {
  std::vector<std::string> words(kStatusWords.begin(), kStatusWords.end());
  words.insert(words.end(), kImpossibleStatuses.begin(), kImpossibleStatuses.end());
  return words;
}

const Record<ItemView<DutyPointState>>& point_record() {
  using View = ItemView<DutyPointState>;
  static const Record<View> record("One point of the duty.", [](Record<View>& keys) {
    keys.text("case", "Its case or gear.", [](const View& v) {
      const auto index = static_cast<std::size_t>(&v.item - v.of.duty.points.data());
      return v.of.mechanism.cases[v.of.plan.points[index].which].label;
    });
    keys.word(
        "status",
        point_statuses(),
        "at_rest: nothing moves; both_ends: losses take more than the inputs supply, and the "
        "outputs drive too; unanswered: the analysis of the case has no result either; the "
        "others: solved, but a cable would have to push, or slip, surfaces to pull, or a freewheel "
        "to hold or slip in the other sense.",
        [](const View& v) {
          return v.item.impossible.empty() ? word_of(v.item.status) : v.item.impossible;
        });
    keys.include(energy_record(), [](const View& v) -> const DutyEnergy& { return v.item.energy; });
    keys.number("balance_residual",
                Bare::ratio,
                "|supplied - delivered - lost| over the largest power.",
                [](const View& v) { return v.item.balance_residual; });
  });
  return record;
}

const std::string& name_of(const DutyReportView& v, CouplingId coupling) {
  return v.mechanism.topology.coupling(coupling).name;
}

void emit_losses(const DutyReportView& v,
                 const std::vector<CouplingLoss>& losses,
                 const Each<CouplingLoss>& each) {
  for (const CouplingLoss& one : losses) {
    each(name_of(v, one.coupling), one);
  }
}

const Record<DutyReportView>& duty_record() {
  using View = DutyReportView;
  static const Record<View> record(
      "The section 'duty': energies, and what gears and bearings bear, of all repetitions.",
      [](Record<View>& keys) {
        keys.include(energy_record(),
                     [](const View& v) -> const DutyEnergy& { return v.duty.whole; });
        keys.quantity(
            "at_rest", QuantityKind::time, "The time for which nothing moves.", [](const View& v) {
              return v.duty.at_rest;
            });
        keys.quantity("both_ends",
                      QuantityKind::time,
                      "The time for which losses take more than the inputs supply.",
                      [](const View& v) { return v.duty.both_ends; });
        keys.count("unanswered",
                   "Points without a result, which are not included in the sums.",
                   [](const View& v) {
                     int count = 0;
                     for (const UnansweredCase& one : v.duty.unanswered) {
                       count += one.count;
                     }
                     return count;
                   });
        keys.number("balance_residual",
                    Bare::ratio,
                    "The largest |supplied - delivered - lost| of all points over the largest "
                    "power.",
                    [](const View& v) { return v.duty.balance_residual; });
        keys.map("cases",
                 energy_record(),
                 "Energies by case or gear.",
                 [](const View& v, const Each<DutyEnergy>& each) {
                   for (const DutyCaseEnergy& one : v.duty.cases) {
                     each(v.mechanism.cases[one.which].label, one.energy);
                   }
                 })
            .in_tables_is(TableRole::cases);
        keys.map("meshes",
                 loss_record(),
                 "Gear mesh losses, by mesh.",
                 [](const View& v, const Each<CouplingLoss>& each) {
                   emit_losses(v, v.duty.meshes, each);
                 })
            .in_tables_is(TableRole::element);
        keys.map("friction",
                 loss_record(),
                 "Losses of couplings with friction, and of elements with drag.",
                 [](const View& v, const Each<CouplingLoss>& each) {
                   emit_losses(v, v.duty.frictions, each);
                 })
            .in_tables_is(TableRole::element);
        keys.map("dampers",
                 damper_record(),
                 "Losses of springs with damping.",
                 [](const View& v, const Each<DamperLoss>& each) {
                   for (const DamperLoss& one : v.duty.dampers) {
                     each(v.mechanism.springs[one.spring].name, one);
                   }
                 })
            .in_tables_is(TableRole::element)
            .only_if([](const View& v) { return !v.duty.dampers.empty(); });
        keys.map(
                "elements",
                element_record(),
                "Clutches and brakes by name.",
                [](const View& v, const Each<ElementDuty>& each) {
                  for (const ElementDuty& one : v.duty.elements) {
                    each(
                        v.mechanism.topology.actuators[static_cast<std::size_t>(one.actuator)].name,
                        one);
                  }
                })
            .in_tables_is(TableRole::element);
        keys.map("gears",
                 gear_record(),
                 "Gears in their meshes, as MESH.BODY.",
                 [](const View& v, const Each<GearDuty>& each) {
                   for (const GearDuty& one : v.duty.gears) {
                     each(name_of(v, one.mesh) + "." + v.mechanism.topology.body(one.gear).name,
                          one);
                   }
                 })
            .in_tables_is(TableRole::element);
        keys.map("bearings",
                 bearing_record(),
                 "Bearings by name.",
                 [](const View& v, const Each<BearingDuty>& each) {
                   for (const BearingDuty& one : v.duty.bearings) {
                     each(name_of(v, one.bearing), one);
                   }
                 })
            .in_tables_is(TableRole::element);
        keys.list("points",
                  point_record(),
                  "Every point, of one repetition.",
                  [](const View& v, const Each<ItemView<DutyPointState>>& each) {
                    for (const DutyPointState& one : v.duty.points) {
                      each({.of = v, .item = one});
                    }
                  })
            .not_in_tables();
      });
  return record;
}

}  // namespace

std::string_view word_of(DutyStatus status) {
  return kStatusWords[static_cast<std::size_t>(status)];
}

const Record<DutyReportView>& duty_report_record() {
  using View = DutyReportView;
  static const Record<View> record(
      "What 'kinestat duty --format json' writes: energies and losses of a duty cycle, and loads "
      "on gears and bearings.",
      [](Record<View>& keys) {
        add_head(keys);
        keys.part("duty", duty_record(), [](const View& v) -> const View& { return v; })
            .in_tables_is(TableRole::table);
        add_diagnostics(keys);
      });
  return record;
}

}  // namespace kinestat
