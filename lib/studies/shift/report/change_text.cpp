#include "studies/shift/report/change_text.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "studies/shift/report/shift_parts.hpp"

namespace kinestat {

namespace {

// What the slip of a change does not claim.
constexpr const char* kInertiaPhase =
    "  Inertia phase alone, with rigid shafts, steady torques and no losses: torque phase, overlap "
    "of\n  elements, hydraulics and temperatures are not in it.\n";

// A cell of the table; a dash where there is no value.
std::string cell_of(const std::optional<double>& value) {
  return value ? format_short(*value) : "-";
}

class ChangeText {
 public:
  explicit ChangeText(const Analysis& analysis)
      : analysis_(analysis), plan_(analysis.shift->plan), in_(analysis.description.units) {}

  // What a change asks of the elements, there and back.
  TextBlocks changes() const {
    const std::vector<GearChange>& changes = analysis_.shift->solution.table.changes;
    if (changes.empty()) {
      return {};
    }
    std::vector<TextColumn> columns = {head("Change"),
                                       head("opens"),
                                       head("engages"),
                                       head("elements"),
                                       head("step"),
                                       head("slip to synchronise", QuantityKind::angular_velocity),
                                       head("in the reverse change")};
    for (const GearChange& one : changes) {
      add_row({change_text(one.from, one.to),
               elements_text(one.opens),
               elements_text(one.engages),
               fmt::format("{}", one.elements()),
               one.step ? format_short(*one.step) : "",
               cell_in(QuantityKind::angular_velocity, one.slip),
               cell_in(QuantityKind::angular_velocity, one.slip_back)},
              columns);
    }
    return TextBlocks(std::move(columns));
  }

  TextBlocks slips() const {
    using enum QuantityKind;
    const std::vector<ShiftSlip>& slips = analysis_.shift->slips;
    if (slips.empty()) {
      return TextBlocks(refusals());
    }
    std::vector<TextColumn> columns = {head("Slip"),
                                       head("change"),
                                       head("opens"),
                                       head("slips"),
                                       head("capacity", moment),
                                       head("least", moment),
                                       head("to hold", moment),
                                       head("slip", angular_velocity),
                                       head("time", time),
                                       head("energy lost", energy),
                                       head("peak power", power)};
    std::string lines;
    for (const ShiftSlip& one : slips) {
      add_row({printable(one.name),
               one.from ? change_text(*one.from, one.to) : "open - " + state_name(one.to),
               one.opens ? name_of_element(analysis_, *one.opens) : "-",
               name_of_element(analysis_, one.slips),
               cell_in(moment, one.capacity),
               cell_in(moment, one.least_capacity),
               cell_in(moment, one.holding_torque),
               cell_in(angular_velocity, one.slip),
               one.time ? cell_in(time, one.time) : std::string("never"),
               cell_in(energy, one.energy),
               cell_in(power, one.peak_power)},
              columns);
      lines += fmt::format("  {}: {}, {}{}{}\n",
                           printable(one.name),
                           shaft_text(plan_.inputs.front().actuator, one.input),
                           shaft_text(plan_.outputs.front(), one.output),
                           held_text(one),
                           balance_text(one));
    }
    return TextBlocks(std::move(columns)) += lines + refusals() + kInertiaPhase + "\n";
  }

 private:
  std::string refusals() const {
    std::string lines;
    for (const SlipObstacle& one : analysis_.shift->slips_without_answer) {
      lines += fmt::format("  {}: no answer: {}\n", printable(one.name), one.reason);
    }
    return lines;
  }

  static TextColumn head(std::string text) { return {.head = std::move(text), .cells = {}}; }

  TextColumn head(std::string_view text, QuantityKind kind) const {
    return head(fmt::format("{} [{}]", text, in_.units().text(kind)));
  }

  static void add_row(std::vector<std::string> cells, std::vector<TextColumn>& columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i].cells.push_back(std::move(cells[i]));
    }
  }

  std::string cell_in(QuantityKind kind, const std::optional<double>& si) const {
    return cell_of(si ? std::optional(in_.of(kind, *si)) : std::nullopt);
  }

  std::string value_in(QuantityKind kind, double si) const {
    return fmt::format("{} {}", format_short(in_.of(kind, si)), in_.units().text(kind));
  }

  std::string state_name(int state) const {
    return printable(analysis_.shift->solution.states[static_cast<std::size_t>(state)].name);
  }

  std::string change_text(int from, int to) const {
    return fmt::format("{} - {}", state_name(from), state_name(to));
  }

  std::string elements_text(const std::vector<int>& elements) const {
    std::vector<std::string> names;
    for (const int element : elements) {
      names.push_back(name_of_element(analysis_, element));
    }
    return names.empty() ? "-" : fmt::format("{}", fmt::join(names, ", "));
  }

  // "in 400 to 243.249 rad/s at -167.234 rad/s^2"
  std::string shaft_text(int actuator, const SlipShaft& shaft) const {
    using enum QuantityKind;
    const std::string to =
        shaft.end ? " to " + format_short(in_.of(angular_velocity, *shaft.end)) : "";
    return fmt::format("{} {}{} {} at {}",
                       name_of_actuator(analysis_, actuator),
                       format_short(in_.of(angular_velocity, shaft.start)),
                       to,
                       in_.units().text(angular_velocity),
                       value_in(angular_acceleration, shaft.acceleration));
  }

  std::string held_text(const ShiftSlip& slip) const {
    std::string text;
    for (const HeldElement& one : slip.held) {
      text += fmt::format(", {} bears {}",
                          name_of_element(analysis_, one.element),
                          value_in(QuantityKind::moment, one.torque));
    }
    return text;
  }

  // "; kinetic energy -12 J = work 8 J - lost 20 J"
  std::string balance_text(const ShiftSlip& slip) const {
    using enum QuantityKind;
    return slip.time ? fmt::format("; change of kinetic energy {} = work {} - {} lost",
                                   value_in(energy, *slip.kinetic_energy_change),
                                   value_in(energy, *slip.work),
                                   value_in(energy, *slip.energy))
                     : "";
  }

  const Analysis& analysis_;
  const ShiftPlan& plan_;
  InUnits in_;
};

}  // namespace

TextBlocks change_blocks(const Analysis& analysis) {
  return ChangeText(analysis).changes();
}

TextBlocks slip_blocks(const Analysis& analysis) {
  return ChangeText(analysis).slips();
}

}  // namespace kinestat
