#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/synthesis_tolerance.hpp"
#include "expression/parameters.hpp"
#include "report/number_format.hpp"
#include "studies/transmissions/task/find_transmissions.hpp"

namespace kinestat {

namespace {

class TaskReader {
 public:
  TaskReader(const MechanismDescription& description, Diagnostics& found)
      : description_(description),
        wanted_(*description.synthesis->transmission),
        found_(found),
        table_(evaluate_parameters<double>(parameters_of(description)).table) {}

  std::optional<TransmissionTask> run() {
    const int errors = found_.error_count();
    read();
    if (found_.error_count() == errors) {
      check_counts();
      check_ladder();
      apply_teeth();
    }
    return found_.error_count() == errors ? std::optional(task_) : std::nullopt;
  }

 private:
  double number(const Value& value) const {
    const auto result = evaluate_as<double>(
        QuantityKind::dimensionless, value.expression, description_.units, table_.lookup(), {});
    return std::get<double>(result);
  }

  int count(const std::optional<Value>& value, int usual) const {
    constexpr double kMost = 1e9;  // beyond all that there is
    return value ? static_cast<int>(std::lround(std::clamp(number(*value), -kMost, kMost))) : usual;
  }

  std::optional<double> limit(const std::optional<Value>& value) const {
    return value ? std::optional(number(*value)) : std::nullopt;
  }

  void refuse(SourceRange where, std::string message, std::string hint) {
    found_.error("E0803", where, std::move(message), std::move(hint));
  }

  ClosedRange range(const std::optional<ValueRange>& wanted,
                    std::string_view key,
                    std::string_view of = "ratios") {
    if (!wanted) {
      return {};
    }
    const ClosedRange result{.from = number(wanted->ends[0]), .to = number(wanted->ends[1])};
    if (result.from > result.to) {
      refuse(wanted->where,
             fmt::format("'{}' of '{}' is empty: it begins above its end", key, of),
             "write the least value first");
    }
    return result;
  }

  StationaryRatios stationary(const std::optional<StationaryRange>& wanted, std::string_view kind) {
    StationaryRatios result;
    if (!wanted) {
      result.range = {.from = kUsualLeastStationaryRatio, .to = kUsualLargestStationaryRatio};
      return result;
    }
    for (const Value& value : wanted->values) {
      result.values.push_back(number(value));
    }
    std::ranges::sort(result.values);
    result.values.erase(std::unique(result.values.begin(), result.values.end()),
                        result.values.end());
    if (!result.values.empty()) {
      result.range = {.from = result.values.front(), .to = result.values.back()};
      return result;
    }
    result.range = {.from = number(*wanted->from), .to = number(*wanted->to)};
    if (result.range.from > result.range.to) {
      refuse(wanted->where,
             fmt::format("'{}' of 'stationary_ratio' is empty: 'from' is above 'to'", kind),
             "write the least value behind 'from'");
    }
    return result;
  }

  void read() {
    task_.simple_sets = count(wanted_.sets.simple, 0);
    task_.double_planet_sets = count(wanted_.sets.double_planet, 0);
    if (wanted_.elements.all) {
      task_.elements = count(wanted_.elements.all, 0);
    } else {
      task_.brakes = count(wanted_.elements.brakes, 0);
      task_.elements = count(wanted_.elements.clutches, 0) + *task_.brakes;
    }
    task_.engaged = count(wanted_.engaged, 0);
    task_.free_shafts = count(wanted_.free_shafts, 0);
    LadderTask& ladder = task_.ladder;
    ladder.forward = count(wanted_.gears.forward, 0);
    ladder.reverse = count(wanted_.gears.reverse, 1);
    ladder.needs_direct = wanted_.gears.direct;
    ladder.one_change = wanted_.gears.one_change.value_or(true);
    ladder.reverse_change = wanted_.gears.reverse_change;
    ladder.first = range(wanted_.ratios.first, "first");
    ladder.last = range(wanted_.ratios.last, "last");
    ladder.spread = range(wanted_.ratios.spread, "spread");
    ladder.step = range(wanted_.ratios.step, "step");
    ladder.reverse_ratio = range(wanted_.ratios.reverse, "reverse");
    task_.stationary_ratios = {stationary(wanted_.stationary_ratio.simple, "simple"),
                               stationary(wanted_.stationary_ratio.double_planet, "double_planet")};
    task_.losses = {limit(wanted_.losses.simple).value_or(kUsualSimpleLoss),
                    limit(wanted_.losses.double_planet).value_or(kUsualDoublePlanetLoss)};
    task_.limits.element_torque = limit(wanted_.limits.element_torque);
    task_.limits.element_slip = limit(wanted_.limits.element_slip);
    task_.limits.shaft_speed = limit(wanted_.limits.shaft_speed);
    task_.limits.planet_speed = limit(wanted_.limits.planet_speed);
    task_.limits.efficiency = limit(wanted_.limits.efficiency);
    if (wanted_.limits.rotating_clutches) {
      task_.limits.rotating_clutches = count(wanted_.limits.rotating_clutches, 0);
    }
    if (wanted_.limits.hollow_shafts) {
      task_.limits.hollow_shafts =
          static_cast<std::uint64_t>(count(wanted_.limits.hollow_shafts, 0));
    }
    if (wanted_.teeth) {
      read_teeth(*wanted_.teeth);
    }
    task_.rank = static_cast<TransmissionRank>(wanted_.rank);
    task_.layout = static_cast<SectionLayout>(wanted_.layout);
    if (wanted_.structures) {
      task_.structures = {count(wanted_.structures->from, 0), count(wanted_.structures->to, 0)};
    }
  }

  void read_teeth(const WantedTeeth& wanted) {
    const ClosedRange sun = range(wanted.sun, "sun", "teeth");
    const ClosedRange ring = range(wanted.ring, "ring", "teeth");
    TeethLimits& limits = task_.teeth.emplace();
    limits.least_sun = static_cast<int>(std::lround(sun.from));
    limits.largest_sun = static_cast<int>(std::lround(sun.to));
    limits.least_ring = static_cast<int>(std::lround(ring.from));
    limits.largest_ring = static_cast<int>(std::lround(ring.to));
    limits.least_planet = count(wanted.planet, kUsualLeastPlanet);
    limits.planets.assign(kUsualPlanetCounts.begin(), kUsualPlanetCounts.end());
    if (!wanted.planets.empty()) {
      limits.planets.clear();
      for (const Value& value : wanted.planets) {
        limits.planets.push_back(count(value, 0));
      }
    }
  }

  // Stationary ratios become those that the teeth make: of a range those within it, of a list all
  // must be among them.
  void apply_teeth() {
    if (!task_.teeth) {
      return;
    }
    for (const SetKind kind : {SetKind::simple, SetKind::double_planet}) {
      const bool is_simple = kind == SetKind::simple;
      if ((is_simple ? task_.simple_sets : task_.double_planet_sets) > 0) {
        apply_teeth(
            kind,
            is_simple ? "simple" : "double_planet",
            is_simple ? wanted_.stationary_ratio.simple : wanted_.stationary_ratio.double_planet);
      }
    }
  }

  void apply_teeth(SetKind kind,
                   std::string_view name,
                   const std::optional<StationaryRange>& wanted) {
    StationaryRatios& ratios = task_.stationary_ratios[static_cast<std::size_t>(kind)];
    const std::vector<double> made = ratios_of_teeth(kind, *task_.teeth);
    for (double& value : ratios.values) {
      const auto nearest =
          std::ranges::min_element(made, {}, [&](double one) { return std::abs(one - value); });
      if (nearest == made.end() || std::abs(*nearest - value) > kRangeSlack * value) {
        refuse(
            wanted->where,
            fmt::format(
                "no {} set within 'teeth' has the stationary ratio {}", name, format_short(value)),
            made.empty() ? "widen 'teeth'"
                         : fmt::format("the nearest is {}", format_short(*nearest)));
        return;
      }
      value = *nearest;
    }
    if (!ratios.values.empty()) {
      return;
    }
    for (const double one : made) {
      if (one >= ratios.range.from && one <= ratios.range.to) {
        ratios.values.push_back(one);
      }
    }
    if (ratios.values.empty()) {
      refuse(wanted_.teeth->where,
             fmt::format("no {} set within 'teeth' has a stationary ratio from {} to {}",
                         name,
                         format_short(ratios.range.from),
                         format_short(ratios.range.to)),
             "planets must be equally spaced and not touch: widen 'sun' and 'ring', or allow fewer "
             "'planets'");
      return;
    }
    ratios.range = {.from = ratios.values.front(), .to = ratios.values.back()};
    ratios.tries_all = false;
  }

  void check_counts() {
    const int sets = task_.sets();
    if (sets < 1 || sets > kMostGearSets) {
      refuse(wanted_.sets.where,
             fmt::format("the task has {} sets; a search takes 1 to {}", sets, kMostGearSets),
             "change 'sets'");
      return;
    }
    if (task_.elements > kMostElements) {
      refuse(
          wanted_.elements.where,
          fmt::format(
              "the task has {} elements; a search takes up to {}", task_.elements, kMostElements),
          "change 'elements'");
    }
    if (task_.engaged >= task_.elements) {
      refuse(wanted_.engaged->where,
             fmt::format("{} of {} elements are engaged in every gear: there is nothing to shift",
                         task_.engaged,
                         task_.elements),
             "take more elements, or engage fewer");
      return;
    }
    const int shafts = sets + task_.engaged + 2 - task_.free_shafts;
    if (shafts > 3 * sets + 3) {
      refuse(wanted_.engaged->where,
             fmt::format("{} {} terminals for {} shafts, and {} engaged elements need {}",
                         sets,
                         sets == 1 ? "set has" : "sets have",
                         3 * sets + 3,
                         task_.engaged,
                         shafts),
             "engage fewer elements, or take more sets");
    }
    double combinations = 1.0;
    for (int i = 1; i <= task_.engaged; ++i) {
      combinations *= static_cast<double>(task_.elements - task_.engaged + i) / i;
    }
    const int gears = task_.ladder.forward + task_.ladder.reverse;
    if (gears > std::lround(combinations)) {
      refuse(wanted_.gears.forward->where,
             fmt::format("{} gears are wanted, and {} of {} elements make {} at most",
                         gears,
                         task_.engaged,
                         task_.elements,
                         std::lround(combinations)),
             "take more elements, or want fewer gears");
    }
    if (task_.limits.hollow_shafts && task_.layout == SectionLayout::any) {
      refuse(wanted_.where,
             "'hollow_shafts' of 'limits' counts around an axis, and 'layout: any' has none",
             "write layout: coaxial, or sideways, or leave 'hollow_shafts' out");
    }
    if (task_.structures && (*task_.structures)[0] > (*task_.structures)[1]) {
      refuse(wanted_.structures->where,
             "'structures' is empty: 'from' is above 'to'",
             "write the lesser number behind 'from'");
    }
  }

  void check_ladder() {
    const LadderTask& ladder = task_.ladder;
    if (!(ladder.step.from > 1.0)) {
      refuse(wanted_.ratios.step->where,
             "'step' of 'ratios' begins at 1 or below: gears of one ratio would follow each other",
             "begin above 1, for example [1.1, 2]");
      return;
    }
    const int steps = ladder.forward - 1;
    const double least = std::pow(ladder.step.from, steps);
    const double largest = std::pow(ladder.step.to, steps);
    if (ladder.spread.from > largest || ladder.spread.to < least) {
      refuse(wanted_.ratios.spread->where,
             fmt::format("{} steps of {} to {} give a spread of {} to {}, not that of 'spread'",
                         steps,
                         format_short(ladder.step.from),
                         format_short(ladder.step.to),
                         format_short(least),
                         format_short(largest)),
             "widen 'step' or 'spread'");
    }
    if (ladder.first.from > ladder.last.to * largest ||
        ladder.first.to < ladder.last.from * least) {
      refuse(wanted_.ratios.first ? wanted_.ratios.first->where : wanted_.ratios.last->where,
             fmt::format("{} steps of {} to {} do not lead from 'first' to 'last'",
                         steps,
                         format_short(ladder.step.from),
                         format_short(ladder.step.to)),
             "widen 'step', 'first' or 'last'");
    }
    if (ladder.needs_direct && (ladder.first.to < 1.0 || ladder.last.from > 1.0)) {
      refuse(wanted_.gears.forward->where,
             "'direct' requires a gear of ratio 1, but 'first' and 'last' exclude it",
             "let 'last' begin at 1 or below and 'first' end at 1 or above, or leave 'direct' out");
    }
  }

  const MechanismDescription& description_;
  const TransmissionDescription& wanted_;
  Diagnostics& found_;
  BasicParameterTable<double> table_;
  TransmissionTask task_;
};

}  // namespace

std::optional<TransmissionTask> read_transmission_task(const MechanismDescription& description,
                                                       Diagnostics& found) {
  return TaskReader(description, found).run();
}

}  // namespace kinestat
