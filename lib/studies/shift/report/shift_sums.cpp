#include "studies/shift/report/shift_sums.hpp"

#include <cmath>

#include <fmt/format.h>

#include "report/number_format.hpp"
#include "studies/shift/report/reaction_record.hpp"
#include "studies/shift/report/shift_parts.hpp"

namespace kinestat {

std::string sum_text(const Analysis& analysis,
                     int actuator,
                     const std::vector<RatioInUnits>& shares) {
  std::string sum;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double share = shares[i].value.value_or(0.0);
    if (share == 0.0) {
      continue;
    }
    const std::string size = format_short(std::abs(share));
    const char* sign = share < 0.0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
    sum += fmt::format("{}{}{}{}",
                       sign,
                       size == "1" ? "" : size + " ",
                       name_of_actuator(analysis, analysis.shift->plan.inputs[i].actuator),
                       shares[i].unit.empty() ? "" : fmt::format(" ({})", shares[i].unit));
  }
  return fmt::format("{} = {}", name_of_actuator(analysis, actuator), sum.empty() ? "0" : sum);
}

std::string torque_sums(const Analysis& analysis, const ShiftState& state) {
  std::vector<std::string> sums;
  const std::vector<int>& outputs = analysis.shift->plan.outputs;
  for (std::size_t o = 0; o < state.torque_shares.size(); ++o) {
    sums.push_back(sum_text(
        analysis, outputs[o], torque_shares_of(analysis, outputs[o], state.torque_shares[o])));
  }
  for (const ShiftReaction& reaction : state.reactions) {
    const int actuator = actuator_of(analysis, reaction);
    if (!reaction.torque_shares.empty()) {
      sums.push_back(sum_text(
          analysis, actuator, torque_shares_of(analysis, actuator, reaction.torque_shares)));
    }
  }
  return fmt::format("{}", fmt::join(sums, ", "));
}

}  // namespace kinestat
