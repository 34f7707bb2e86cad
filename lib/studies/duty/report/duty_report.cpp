#include "studies/duty/report/duty_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

class DutyText {
 public:
  explicit DutyText(const DutyReportView& view) : v_(view), units_(view.description.units) {}

  TextBlocks run() const {
    TextBlocks blocks;
    blocks += head();
    blocks += TextBlocks(energies());
    blocks += TextBlocks(no_efficiency());
    blocks += TextBlocks(losses());
    add(gears(), blocks);
    add(bearings(), blocks);
    blocks += TextBlocks(open_loads());
    add(elements(), blocks);
    return blocks;
  }

 private:
  static void add(Table table, TextBlocks& blocks) {
    if (!table.is_empty()) {
      blocks += TextBlocks(std::move(table));
    }
  }

  std::string in(QuantityKind kind) const { return fmt::format("[{}]", units_.text(kind)); }

  std::string number(QuantityKind kind, double si) const {
    return format_short(units_.from_si(kind, si));
  }

  std::string with_unit(QuantityKind kind, double si) const {
    return number(kind, si) + " " + units_.text(kind);
  }

  std::string optional_number(QuantityKind kind, const std::optional<double>& si) const {
    return si ? number(kind, *si) : "-";
  }

  std::string head() const {
    std::string text = "Duty: " + counted(v_.plan.points.size(), "point");
    if (v_.plan.repetitions != 1.0) {
      text += fmt::format(", {} times", format_short(v_.plan.repetitions));
    }
    text += fmt::format("; {}\n", with_unit(QuantityKind::time, v_.duty.whole.duration));
    if (v_.duty.at_rest > 0.0) {
      text += fmt::format("  at rest {}\n", with_unit(QuantityKind::time, v_.duty.at_rest));
    }
    if (v_.duty.both_ends > 0.0) {
      text += fmt::format("  for {} losses exceed the power of the inputs: the outputs drive too\n",
                          with_unit(QuantityKind::time, v_.duty.both_ends));
    }
    for (const UnansweredCase& one : v_.duty.unanswered) {
      text += fmt::format("  {} of {} ha{} no answer, the first of them {}\n",
                          counted(one.count, "point"),
                          v_.mechanism.cases[one.which].label,
                          one.count == 1 ? "s" : "ve",
                          place_of(v_.plan, one.first));
    }
    return text + "\n";
  }

  Table energies() const {
    Table table({"Case",
                 "duration " + in(QuantityKind::time),
                 "given " + in(QuantityKind::energy),
                 "taken " + in(QuantityKind::energy),
                 "lost " + in(QuantityKind::energy),
                 "efficiency"});
    const auto row = [&](const std::string& name, const DutyEnergy& one) {
      const std::optional<double> efficiency = one.efficiency();
      table.add({name,
                 number(QuantityKind::time, one.duration),
                 number(QuantityKind::energy, one.given),
                 number(QuantityKind::energy, one.taken),
                 number(QuantityKind::energy, one.lost),
                 efficiency ? format_short(*efficiency) : "-"});
    };
    for (const DutyCaseEnergy& one : v_.duty.cases) {
      row(v_.mechanism.cases[one.which].label, one.energy);
    }
    row("all", v_.duty.whole);
    return table;
  }

  std::string no_efficiency() const {
    const std::string& reason = v_.duty.whole.no_efficiency;
    return reason.empty() ? "" : fmt::format("  No efficiency: {}.\n\n", reason);
  }

  // Where energy is lost, the most first.
  Table losses() const {
    std::vector<std::pair<std::string, double>> rows;
    for (const CouplingLoss& one : v_.duty.meshes) {
      rows.emplace_back("teeth " + name_of(one.coupling), one.energy);
    }
    for (const CouplingLoss& one : v_.duty.frictions) {
      rows.emplace_back("friction " + name_of(one.coupling), one.energy);
    }
    for (const DamperLoss& one : v_.duty.dampers) {
      rows.emplace_back("damping " + v_.mechanism.springs[one.spring].name, one.energy);
    }
    for (const ElementDuty& one : v_.duty.elements) {
      rows.emplace_back("slip " + name_of(one), one.lost);
    }
    std::erase_if(rows, [](const auto& row) { return row.second == 0.0; });
    std::ranges::stable_sort(rows, std::greater(), [](const auto& row) { return row.second; });
    Table table({"Lost in", "energy " + in(QuantityKind::energy), "share"});
    for (const auto& [name, energy] : rows) {
      table.add(
          {name, number(QuantityKind::energy, energy), format_short(energy / v_.duty.whole.lost)});
    }
    if (rows.empty()) {
      table.add({"nothing", "0", "-"});
    }
    return table;
  }

  Table gears() const {
    Table table(wear_head({"Gear", "in mesh"}, QuantityKind::moment, v_.plan.gear_exponent));
    for (const GearDuty& one : v_.duty.gears) {
      table.add(wear_row({v_.mechanism.topology.body(one.gear).name, name_of(one.mesh)},
                         one.planets,
                         one.wear,
                         QuantityKind::moment));
    }
    return table;
  }

  Table bearings() const {
    Table table(wear_head({"Bearing"}, QuantityKind::force, v_.plan.bearing_exponent));
    for (const BearingDuty& one : v_.duty.bearings) {
      table.add(wear_row({name_of(one.bearing)}, one.planets, one.wear, QuantityKind::force));
    }
    return table;
  }

  // The finding of the points names what is open.
  std::string open_loads() const {
    const auto is_open = [](const auto& one) { return !one.wear.largest; };
    return std::ranges::any_of(v_.duty.gears, is_open) ||
                   std::ranges::any_of(v_.duty.bearings, is_open)
               ? "  Equilibrium leaves loads without a value open (W0601).\n\n"
               : "";
  }

  // Equivalent loads need an exponent.
  std::vector<std::string> wear_head(std::vector<std::string> names,
                                     QuantityKind load,
                                     const std::optional<double>& exponent) const {
    names.insert(names.end(), {"planets", "revolutions", "largest " + in(load)});
    if (exponent) {
      names.push_back("equivalent " + in(load));
    }
    return names;
  }

  std::vector<std::string> wear_row(std::vector<std::string> names,
                                    int planets,
                                    const DutyWear& wear,
                                    QuantityKind load) const {
    names.insert(names.end(),
                 {std::to_string(planets),
                  wear.revolutions ? format_short(*wear.revolutions) : "-",
                  optional_number(load, wear.largest)});
    const bool has_exponent = load == QuantityKind::moment ? v_.plan.gear_exponent.has_value()
                                                           : v_.plan.bearing_exponent.has_value();
    if (has_exponent) {
      names.push_back(optional_number(load, wear.equivalent));
    }
    return names;
  }

  Table elements() const {
    Table table(
        {"Element", "engaged " + in(QuantityKind::time), "largest " + in(QuantityKind::moment)});
    for (const ElementDuty& one : v_.duty.elements) {
      table.add({name_of(one),
                 number(QuantityKind::time, one.engaged),
                 number(QuantityKind::moment, one.largest)});
    }
    return table;
  }

  const std::string& name_of(CouplingId coupling) const {
    return v_.mechanism.topology.coupling(coupling).name;
  }

  const std::string& name_of(const ElementDuty& one) const {
    return v_.mechanism.topology.actuators[static_cast<std::size_t>(one.actuator)].name;
  }

  const DutyReportView& v_;
  const FileUnits& units_;
};

}  // namespace

TextBlocks duty_blocks(const DutyReportView& view) {
  return DutyText(view).run();
}

FileReport make_duty_report(const DutyReportView& view, const ReportForms& forms) {
  FileReport report;
  add_forms(duty_report_record, view, forms, report);
  if (forms.text) {
    report.text += title_text(view.file, view.description) + "\n";
    report.text += duty_blocks(view);
  }
  return report;
}

}  // namespace kinestat
