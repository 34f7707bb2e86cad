#include "studies/shift/report/shift_text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "studies/shift/report/change_text.hpp"
#include "studies/shift/report/gear_report.hpp"
#include "studies/shift/report/non_gear_states.hpp"
#include "studies/shift/report/shift_sums.hpp"

namespace kinestat {

namespace {

constexpr const char* kEngaged = "●";
constexpr const char* kOpen = "·";

// A cell of the table; empty where there is no value.
std::string number_or_dash(const std::optional<double>& value) {
  return value ? format_short(*value) : "-";
}

struct ShownGear {
  const CaseAnalysis& one;
  GearValues values;
  std::vector<RatiosInUnits> ratios;
  std::optional<double> step;
};

class ShiftTables {
 public:
  explicit ShiftTables(const Analysis& analysis)
      : analysis_(analysis),
        topology_(analysis.mechanism.topology),
        plan_(analysis.shift->plan),
        solution_(analysis.shift->solution),
        in_(analysis.description.units) {
    for (std::size_t s = 0; s < solution_.table.steps.size(); ++s) {
      const CaseAnalysis& one = *find_gear_case(analysis, solution_.states[s]);
      GearValues values = gear_values(analysis, s);
      std::vector<RatiosInUnits> ratios = gear_ratios(analysis, s, values);
      gears_.push_back({.one = one,
                        .values = std::move(values),
                        .ratios = std::move(ratios),
                        .step = solution_.table.steps[s]});
    }
  }

  ShiftBlocks run(ShownOthers shown) const {
    TextBlocks gears(head_text());
    gears += gears_blocks();
    gears += remarks_text();
    gears += reactions_blocks();
    TextBlocks elements = elements_blocks();
    elements += change_blocks(analysis_);
    elements += slip_blocks(analysis_);
    return {.gears = std::move(gears),
            .others = others_blocks(shown),
            .other_count = solution_.states.size() - gears_.size(),
            .elements = std::move(elements)};
  }

 private:
  const std::string& actuator_name(int actuator) const {
    return topology_.actuators[static_cast<std::size_t>(actuator)].name;
  }

  const std::string& element_name(int element) const {
    return actuator_name(plan_.elements[static_cast<std::size_t>(element)].actuator);
  }

  std::string name_of(int state) const {
    return printable(solution_.states[static_cast<std::size_t>(state)].name);
  }

  std::string head_text() const {
    return fmt::format(
        "Shift table: a gear engages {}{} of {} elements (net degree of freedom {}, {}), "
        "{:.0f} possibilit{}{}, {}\n\n",
        solution_.needed,
        solution_.following == 0 ? ""
                                 : fmt::format(" to {}", solution_.needed + solution_.following),
        plan_.elements.size(),
        solution_.net_freedom,
        counted(plan_.inputs.size(), "input"),
        solution_.possibilities,
        solution_.possibilities == 1.0 ? "y" : "ies",
        plan_.combinations == ShiftCombinations::named
            ? fmt::format(", of which {} with a name", plan_.labels.size())
            : "",
        counted(gears_.size(), "gear"));
  }

  // A column for each element: engaged or open.
  void add_marks(const std::vector<std::size_t>& states, std::vector<TextColumn>& columns) const {
    for (int e = 0; e < static_cast<int>(plan_.elements.size()); ++e) {
      TextColumn column{.head = element_name(e), .cells = {}};
      for (const std::size_t s : states) {
        const bool is_engaged = std::ranges::binary_search(solution_.states[s].engaged, e);
        column.cells.push_back(is_engaged ? kEngaged : kOpen);
      }
      columns.push_back(std::move(column));
    }
  }

  TextColumn names(const char* head, std::size_t first, std::size_t count) const {
    TextColumn column{.head = head, .cells = {}};
    for (std::size_t s = first; s < first + count; ++s) {
      column.cells.push_back(name_of(static_cast<int>(s)));
    }
    return column;
  }

  template <class Cell>
  void add_column(std::string head, const Cell& cell, std::vector<TextColumn>& columns) const {
    TextColumn column{.head = std::move(head), .cells = {}};
    for (const ShownGear& gear : gears_) {
      column.cells.push_back(cell(gear));
    }
    columns.push_back(std::move(column));
  }

  // By the carrier and by the absolute model, and with friction alone, as far as the file has any.
  void add_efficiencies(std::vector<TextColumn>& columns) const {
    TextColumn carrier{.head = "efficiency", .cells = {}};
    TextColumn absolute{.head = "absolute", .cells = {}};
    TextColumn friction{.head = "with friction", .cells = {}};
    bool is_lossy = false;
    bool has_losses = false;
    for (std::size_t s = 0; s < gears_.size(); ++s) {
      const CaseAnalysis& one = gears_[s].one;
      const auto& lossy = one.efficiency;
      carrier.cells.push_back(number_or_dash(lossy ? lossy->carrier.value : std::nullopt));
      absolute.cells.push_back(number_or_dash(lossy ? lossy->absolute.value : std::nullopt));
      friction.cells.push_back(number_or_dash(one.power ? one.power->efficiency : std::nullopt));
      is_lossy = is_lossy || lossy.has_value();
      has_losses = has_losses || (one.power && one.power->efficiency);
    }
    if (is_lossy) {
      columns.push_back(std::move(carrier));
      columns.push_back(std::move(absolute));
      friction.head = "friction alone";
    }
    if (has_losses) {
      columns.push_back(std::move(friction));
    }
  }

  // Beside the ratios, where numbers of teeth make them.
  void add_fractions(std::vector<TextColumn>& columns) const {
    TextColumn fractions{.head = "by teeth", .cells = {}};
    for (const ShownGear& gear : gears_) {
      const std::string behind = fraction_behind(gear.one.ratios);
      fractions.cells.push_back(behind.empty() ? behind : behind.substr(1));
    }
    const auto is_empty = [](const std::string& cell) { return cell.empty(); };
    if (!std::ranges::all_of(fractions.cells, is_empty)) {
      columns.push_back(std::move(fractions));
    }
  }

  TextBlocks gears_blocks() const {
    if (gears_.empty()) {
      return {};
    }
    std::vector<TextColumn> columns = {names("Gear", 0, gears_.size())};
    std::vector<std::size_t> states(gears_.size());
    std::iota(states.begin(), states.end(), std::size_t{0});
    add_marks(states, columns);
    const std::vector<RatiosInUnits> units = gear_ratio_units(analysis_);
    const auto with_unit = [](std::string head, const RatioInUnits& ratio) {
      return ratio.unit.empty() ? head : fmt::format("{} [{}]", head, ratio.unit);
    };
    for (std::size_t o = 0; o < plan_.outputs.size(); ++o) {
      const std::string to = plan_.outputs.size() == 1 ? "" : " " + actuator_name(plan_.outputs[o]);
      add_column(
          with_unit("ratio" + to, units[o].ratio),
          [o](const ShownGear& gear) { return number_or_dash(gear.ratios[o].ratio.value); },
          columns);
    }
    add_fractions(columns);
    add_column(
        "step",
        [](const ShownGear& gear) { return gear.step ? number_or_dash(gear.step) : ""; },
        columns);
    add_efficiencies(columns);
    if (plan_.outputs.size() == 1 && plan_.asks_actions) {
      add_column(
          with_unit("torque ratio", units.front().torque_ratio),
          [](const ShownGear& gear) {
            return number_or_dash(gear.ratios.front().torque_ratio.value);
          },
          columns);
      add_column(
          "recirculation",
          [](const ShownGear& gear) {
            return number_or_dash(gear.one.power_graph ? gear.one.power_graph->recirculation
                                                       : std::nullopt);
          },
          columns);
    }
    add_inertias(columns);
    return TextBlocks(std::move(columns));
  }

  // At the input, where bodies have any.
  void add_inertias(std::vector<TextColumn>& columns) const {
    const FileUnits& units = analysis_.description.units;
    TextColumn inertias{
        .head = fmt::format("inertia at input [{}]", units.text(QuantityKind::inertia)),
        .cells = {}};
    bool has_any = false;
    for (const ShownGear& gear : gears_) {
      const auto all = gear_inertias(analysis_, gear.one);
      has_any = has_any || all;
      inertias.cells.push_back(number_or_dash(
          all ? std::optional(units.from_si(QuantityKind::inertia,
                                            std::accumulate(all->begin(), all->end(), 0.0)))
              : std::nullopt));
    }
    if (has_any) {
      columns.push_back(std::move(inertias));
    }
  }

  // "out = 0.333333 engine + 0.666667 motor", in speeds.
  std::string speed_sum(std::size_t state, std::size_t output) const {
    return sum_text(analysis_,
                    plan_.outputs[output],
                    speed_shares(analysis_, solution_.states[state].state, output));
  }

  // Speed and torque of what reacts, and what the torques are by those of the inputs.
  TextBlocks reactions_blocks() const {
    if (plan_.reacting.empty() || gears_.empty()) {
      return {};
    }
    std::vector<TextColumn> columns = {names("Reacting", 0, gears_.size())};
    std::string sums;
    for (std::size_t r = 0; r < plan_.reacting.size(); ++r) {
      const int actuator = plan_.others[static_cast<std::size_t>(plan_.reacting[r])];
      const ActuatorTopology& one = topology_.actuators[static_cast<std::size_t>(actuator)];
      const bool turns = topology_.freedoms[static_cast<std::size_t>(one.freedom)].is_rotation;
      TextColumn speed{.head = fmt::format("{} [{}]", one.name, in_.units().text(rate_kind(turns))),
                       .cells = {}};
      TextColumn torque{
          .head = fmt::format("{} [{}]", one.name, in_.units().text(action_kind(turns))),
          .cells = {}};
      for (std::size_t s = 0; s < gears_.size(); ++s) {
        const ShiftReaction& reaction = solution_.states[s].state.reactions[r];
        const auto in_unit = [](const std::optional<double>& si, auto unit) {
          return number_or_dash(si ? std::optional(unit(*si)) : std::nullopt);
        };
        speed.cells.push_back(in_unit(reaction.rate, [&](double v) { return in_.rate(v, turns); }));
        torque.cells.push_back(
            in_unit(reaction.torque, [&](double v) { return in_.action(v, turns); }));
      }
      columns.push_back(std::move(speed));
      if (plan_.asks_actions) {
        columns.push_back(std::move(torque));
      }
    }
    TextBlocks blocks(std::move(columns));
    for (std::size_t s = 0; s < gears_.size(); ++s) {
      const std::string sum = torque_sums(analysis_, solution_.states[s].state);
      sums +=
          sum.empty() ? "" : fmt::format("  {}, torques: {}\n", name_of(static_cast<int>(s)), sum);
    }
    return blocks += sums.empty() ? "" : sums + "\n";
  }

  std::string remarks_text() const {
    std::string text;
    for (std::size_t s = 0; s < gears_.size(); ++s) {
      const std::string& reason = solution_.states[s].reason;
      text += reason.empty() ? "" : fmt::format("  {}: {}\n", name_of(static_cast<int>(s)), reason);
      const bool has_shares = !solution_.states[s].state.shares.empty();
      for (std::size_t o = 0; has_shares && o < plan_.outputs.size(); ++o) {
        text += fmt::format("  {}: {}\n", name_of(static_cast<int>(s)), speed_sum(s, o));
      }
      for (const Ratios& to_output : gears_[s].values.ratios) {
        const std::string& no_ratio = has_shares ? std::string() : to_output.reason;
        text += no_ratio.empty()
                    ? ""
                    : fmt::format("  {}: {}\n", name_of(static_cast<int>(s)), no_ratio);
      }
    }
    if (solution_.table.span) {
      text += fmt::format("  ratio spread of the forward gears {}\n",
                          format_short(*solution_.table.span));
    }
    for (const std::vector<int>& group : solution_.table.equal_ratios) {
      std::vector<std::string> names;
      for (const int state : group) {
        names.push_back(name_of(state));
      }
      text += fmt::format("  gears of equal ratio: {}\n", fmt::join(names, ", "));
    }
    return text.empty() ? "" : text + "\n";
  }

  // Each with its reason below the table.
  TextBlocks others_blocks(ShownOthers shown) const {
    const std::vector<std::size_t> states = shown_others(solution_, gears_.size(), shown);
    if (states.empty()) {
      return {};
    }
    TextColumn name{.head = "No gear", .cells = {}};
    TextColumn kinds{.head = "class", .cells = {}};
    std::string reasons;
    for (const std::size_t s : states) {
      const NamedShiftState& one = solution_.states[s];
      name.cells.push_back(name_of(static_cast<int>(s)));
      kinds.cells.emplace_back(word_of(one.state.kind));
      reasons += fmt::format("  {}: {}\n", name_of(static_cast<int>(s)), one.reason);
    }
    std::vector<TextColumn> columns = {std::move(name)};
    add_marks(states, columns);
    columns.push_back(std::move(kinds));
    return TextBlocks(std::move(columns)) +=
           reasons + rest_of_others_text(solution_, gears_.size(), states) + "\n";
  }

  // What each element bears where it is engaged, and how fast it slips where it is open.
  TextBlocks elements_blocks() const {
    if (gears_.empty()) {
      return {};
    }
    TextBlocks blocks;
    if (plan_.asks_actions) {
      blocks += values_blocks("Torque", QuantityKind::moment, &GearValues::torques, true);
      const auto has_losses = [](const ShownGear& gear) {
        return std::ranges::any_of(gear.values.lossy_torques,
                                   [](const auto& torque) { return torque.has_value(); });
      };
      if (std::ranges::any_of(gears_, has_losses)) {
        blocks +=
            values_blocks("With losses", QuantityKind::moment, &GearValues::lossy_torques, true);
      }
    }
    blocks += loads_blocks();
    blocks += limits_blocks();
    return blocks +=
           values_blocks("Slip", QuantityKind::angular_velocity, &GearValues::slips, false);
  }

  // The most loaded bearing and mesh of each gear, where any force is known.
  TextBlocks loads_blocks() const {
    const std::string unit = in_.units().text(QuantityKind::force);
    std::vector<TextColumn> columns = {names("Most loaded", 0, gears_.size())};
    const auto add = [&](const char* kind, std::optional<LoadedCoupling> GearValues::*member) {
      TextColumn name{.head = kind, .cells = {}};
      TextColumn force{.head = fmt::format("force [{}]", unit), .cells = {}};
      bool has_any = false;
      for (const ShownGear& gear : gears_) {
        const std::optional<LoadedCoupling>& one = gear.values.*member;
        name.cells.push_back(!one ? "open" : one->name.empty() ? "none" : one->name);
        force.cells.push_back(one ? format_short(in_.force(one->force)) : "-");
        has_any = has_any || (one && !one->name.empty());
      }
      if (has_any) {
        columns.push_back(std::move(name));
        columns.push_back(std::move(force));
      }
    };
    add("bearing", &GearValues::bearing);
    add("mesh", &GearValues::mesh);
    return columns.size() > 1 ? TextBlocks(std::move(columns)) : TextBlocks();
  }

  // What each gear takes most of.
  TextBlocks limits_blocks() const {
    if (plan_.limits.empty()) {
      return {};
    }
    std::vector<TextColumn> columns = {names("Limits", 0, gears_.size())};
    TextColumn use{.head = "largest use", .cells = {}};
    TextColumn of{.head = "of", .cells = {}};
    TextColumn size{.head = "value", .cells = {}};
    TextColumn most{.head = "limit", .cells = {}};
    for (const ShownGear& gear : gears_) {
      const LimitUse* largest = find_largest_use(gear.values.limits);
      use.cells.push_back(number_or_dash(largest != nullptr ? largest->use() : std::nullopt));
      of.cells.push_back(largest != nullptr ? kinestat::name_of(largest->part, plan_, topology_)
                                            : "-");
      size.cells.push_back(largest != nullptr ? with_unit(*largest, *largest->size) : "-");
      most.cells.push_back(largest != nullptr ? with_unit(*largest, largest->part.limit.most)
                                              : "-");
    }
    for (TextColumn* column : {&use, &of, &size, &most}) {
      columns.push_back(std::move(*column));
    }
    return TextBlocks(std::move(columns));
  }

  std::string with_unit(const LimitUse& one, double si) const {
    const QuantityKind kind = quantity_of(one.part.limit.kind);
    return fmt::format("{} {}", format_short(in_.of(kind, si)), in_.units().text(kind));
  }

  TextBlocks values_blocks(const char* what,
                           QuantityKind kind,
                           std::vector<std::optional<double>> GearValues::*values,
                           bool of_engaged) const {
    const std::string head = fmt::format("{} [{}]", what, in_.units().text(kind));
    std::vector<TextColumn> columns = {names(head.c_str(), 0, gears_.size())};
    TextColumn largest{.head = "largest magnitude", .cells = {}};
    std::vector<std::optional<double>> sizes(gears_.size(), 0.0);
    for (std::size_t e = 0; e < plan_.elements.size(); ++e) {
      TextColumn column{.head = element_name(static_cast<int>(e)), .cells = {}};
      for (std::size_t s = 0; s < gears_.size(); ++s) {
        const bool is_engaged =
            std::ranges::binary_search(solution_.states[s].holding(), static_cast<int>(e));
        const std::optional<double>& si = (gears_[s].values.*values)[e];
        const auto value = si ? std::optional(in_.of(kind, *si)) : std::nullopt;
        column.cells.push_back(is_engaged == of_engaged ? number_or_dash(value) : kOpen);
        if (is_engaged == of_engaged) {
          sizes[s] = value && sizes[s] ? std::optional(std::max(*sizes[s], std::abs(*value)))
                                       : std::nullopt;
        }
      }
      columns.push_back(std::move(column));
    }
    for (const std::optional<double>& size : sizes) {
      largest.cells.push_back(number_or_dash(size));
    }
    columns.push_back(std::move(largest));
    return TextBlocks(std::move(columns));
  }

  const Analysis& analysis_;
  const Topology& topology_;
  const ShiftPlan& plan_;
  const ShiftSolution& solution_;
  InUnits in_;
  std::vector<ShownGear> gears_;
};

}  // namespace

ShiftBlocks shift_parts(const Analysis& analysis, ShownOthers shown) {
  KINESTAT_EXPECTS(analysis.shift.has_value());
  return ShiftTables(analysis).run(shown);
}

TextBlocks shift_blocks(const Analysis& analysis) {
  ShiftBlocks parts = shift_parts(analysis, ShownOthers::first);
  parts.gears += std::move(parts.others);
  parts.gears += std::move(parts.elements);
  return std::move(parts.gears);
}

}  // namespace kinestat
