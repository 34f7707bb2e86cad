#include "studies/shift/report/gear_report.hpp"

#include <algorithm>

#include "cases/gear_answer.hpp"
#include "cases/input_inertia.hpp"
#include "core/contract.hpp"

namespace kinestat {

const CaseAnalysis* find_gear_case(const Analysis& analysis, const NamedShiftState& state) {
  if (state.state.kind != ShiftClass::gear) {
    return nullptr;
  }
  const auto at = std::ranges::find(
      analysis.cases, state.name, [](const CaseAnalysis& one) { return one.which.label; });
  KINESTAT_EXPECTS(at != analysis.cases.end());
  return &*at;
}

namespace {

// One to each output.
std::vector<RatiosInUnits> in_file_units(const Analysis& analysis,
                                         int input,
                                         const std::vector<Ratios>& to_outputs) {
  const std::vector<int>& outputs = analysis.shift->plan.outputs;
  std::vector<RatiosInUnits> ratios;
  for (std::size_t o = 0; o < outputs.size(); ++o) {
    ratios.push_back(ratios_in_units(to_outputs[o],
                                     {.input = input, .output = outputs[o]},
                                     analysis.mechanism,
                                     analysis.description.units));
  }
  return ratios;
}

}  // namespace

GearValues gear_values(const Analysis& analysis, std::size_t state) {
  const NamedShiftState& gear = analysis.shift->solution.states[state];
  const CaseAnalysis& one = *find_gear_case(analysis, gear);
  return find_gear_values(solved_gear(analysis.mechanism, analysis.shift->plan, gear.state, one));
}

std::optional<std::vector<double>> gear_inertias(const Analysis& analysis,
                                                 const CaseAnalysis& gear) {
  const std::optional<int> freedom = only_input_freedom(analysis.mechanism, gear.which);
  const bool turns =
      freedom &&
      analysis.mechanism.topology.freedoms[static_cast<std::size_t>(*freedom)].is_rotation;
  return turns ? input_inertias(analysis.mechanism, gear) : std::nullopt;
}

std::vector<RatiosInUnits> gear_ratios(const Analysis& analysis,
                                       std::size_t state,
                                       const GearValues& gear) {
  const CaseAnalysis& one = *find_gear_case(analysis, analysis.shift->solution.states[state]);
  return in_file_units(analysis, one.which.inputs.front(), gear.ratios);
}

std::vector<RatioInUnits> speed_shares(const Analysis& analysis,
                                       const ShiftState& state,
                                       std::size_t output) {
  std::vector<RatioInUnits> shares;
  const ShiftPlan& plan = analysis.shift->plan;
  for (std::size_t i = 0; i < plan.inputs.size() && !state.shares.empty(); ++i) {
    Ratios share;
    share.ratio = state.shares[output][i];
    shares.push_back(
        ratios_in_units(share,
                        {.input = plan.outputs[output], .output = plan.inputs[i].actuator},
                        analysis.mechanism,
                        analysis.description.units)
            .ratio);
  }
  return shares;
}

std::vector<RatiosInUnits> gear_ratio_units(const Analysis& analysis) {
  const ShiftPlan& plan = analysis.shift->plan;
  return in_file_units(
      analysis, plan.inputs.front().actuator, std::vector<Ratios>(plan.outputs.size(), Ratios{}));
}

}  // namespace kinestat
