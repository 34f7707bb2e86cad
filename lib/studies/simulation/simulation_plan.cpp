#include "studies/simulation/simulation_plan.hpp"

#include <algorithm>
#include <array>

#include "description/simulation_report_words.hpp"
#include "mechanism/column_path.hpp"

namespace kinestat {

namespace {

// In the order of the words.
constexpr std::array<bool SimulationReport::*, kSimulationReportWords.size()> kMembers = {
    &SimulationReport::position,
    &SimulationReport::velocity,
    &SimulationReport::acceleration,
    &SimulationReport::action,
    &SimulationReport::reaction,
    &SimulationReport::power,
    &SimulationReport::energy};

}  // namespace

bool* find_report_word(std::string_view word, SimulationReport& report) {
  const auto at = std::ranges::find(kSimulationReportWords, word);
  return at == kSimulationReportWords.end()
             ? nullptr
             : &(report.*kMembers[static_cast<std::size_t>(at - kSimulationReportWords.begin())]);
}

bool names_column(const std::string& name,
                  const std::string& element,
                  const std::string& also,
                  std::string_view quantity) {
  const std::string asked = dotted(name);
  const std::string end = dotted(std::string(quantity));
  return (element.empty() ? begins_with_parts(end, asked)
                          : begins_with_parts(element + "." + end, asked)) ||
         (!also.empty() && begins_with_parts(also + "." + end, asked));
}

bool asks(const SimulationReport& report, std::string_view word) {
  const auto at = std::ranges::find(kSimulationReportWords, word);
  return at != kSimulationReportWords.end() &&
         report.*kMembers[static_cast<std::size_t>(at - kSimulationReportWords.begin())];
}

}  // namespace kinestat
