#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "description/simulation_report_words.hpp"
#include "mechanism/cases/load.hpp"
#include "mechanism/check/section_checks.hpp"

namespace kinestat {

namespace {

// An actuator, or coupling.freedom or coupling.action.
void check_target(const Name& target, const SectionContext& context) {
  const DeclaredNames& names = context.names;
  const std::size_t dot = target.text.find('.');
  if (dot == std::string::npos) {
    names.check_actuator(target, "'simulation' names", context.found);
    return;
  }
  const Name owner{.text = target.text.substr(0, dot), .where = target.where};
  names.couplings.check(owner, "'simulation' names something of", context.found);
}

void check_number(const std::optional<Value>& value, const SectionContext& context) {
  if (value) {
    context.evaluator.quantity(*value);
  }
}

// A word, or the name of what a column is of.
void check_report(const Name& name, const SectionContext& context) {
  if (std::ranges::count(kSimulationReportWords, name.text) > 0) {
    return;
  }
  const Name owner{.text = name.text.substr(0, name.text.find_first_of("./")), .where = name.where};
  const bool is_spring =
      name.text.starts_with(kSpringPrefix) && !context.description.springs.empty();
  const std::vector<LoadDescription>& loads = context.description.loads;
  const bool is_load = name.text.starts_with(kWeightPrefix) ||
                       std::ranges::any_of(loads, [&](const LoadDescription& one) {
                         return one.name.text == owner.text;
                       });
  if (owner.text == kEnergyWord || is_spring || is_load ||
      context.names.couplings.contains(owner.text) ||
      context.names.actuators.contains(owner.text)) {
    return;
  }
  const std::vector<std::string> words(kSimulationReportWords.begin(),
                                       kSimulationReportWords.end());
  const std::span<const std::string> actuators = context.names.actuators.names();
  std::vector<std::string> guesses(actuators.begin(), actuators.end());
  const std::span<const std::string> couplings = context.names.couplings.names();
  guesses.insert(guesses.end(), couplings.begin(), couplings.end());
  guesses.insert(guesses.end(), words.begin(), words.end());
  context.found.error("E0313",
                      name.where,
                      fmt::format("'report' of 'simulation' cannot hold '{}'", name.text),
                      guess_before(owner.text,
                                   guesses,
                                   fmt::format("write one of {}, or {}; declared actuators are {}",
                                               plain_list(words),
                                               kSimulationReportNames,
                                               plain_list(actuators))));
}

}  // namespace

void check_simulation(const SectionContext& context) {
  if (!context.description.simulation) {
    return;
  }
  const SimulationDescription& simulation = *context.description.simulation;
  constexpr NumberRule kTolerance = {.kind = QuantityKind::dimensionless,
                                     .range = kIntegrationTolerance,
                                     .allowed = "a number from 1e-13 to 1e-3"};
  constexpr NumberRule kRestitution = {.kind = QuantityKind::dimensionless,
                                       .range = kLostShare,
                                       .allowed = "a number from 0, below 1"};
  context.number(simulation.time, kDuration, "'time' of 'simulation'");
  context.number(simulation.steps, kStepCount, "'steps' of 'simulation'");
  context.number(simulation.tolerance, kTolerance, "'tolerance' of 'simulation'");
  for (const std::vector<FreedomState>* list : {&simulation.start, &simulation.until}) {
    for (const FreedomState& one : *list) {
      check_target(one.target, context);
      check_number(one.position, context);
      check_number(one.speed, context);
    }
  }
  for (const Name& one : simulation.report) {
    check_report(one, context);
  }
  for (const StopDescription& one : simulation.stops) {
    check_target(one.target, context);
    check_number(one.from, context);
    check_number(one.to, context);
    context.number(one.restitution, kRestitution, "'restitution' of a stop");
  }
}

}  // namespace kinestat
