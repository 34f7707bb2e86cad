#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cases/gear_answer.hpp"
#include "cases/solve_cases.hpp"
#include "core/contract.hpp"
#include "core/synthesis_tolerance.hpp"
#include "files/load_file.hpp"
#include "format/mechanism_writer.hpp"
#include "report/number_format.hpp"
#include "studies/shift/gear_values.hpp"
#include "studies/transmissions/task/transmission_files.hpp"

namespace kinestat {

namespace {

// As it is read from its file.
std::optional<Loaded> read_back(const MechanismDescription& description, Diagnostics& found) {
  const SourceFile file{.path = "", .text = mechanism_text(description, {})};
  auto read = read_description(file, {}, found);
  return read ? bind_loaded(*std::move(read), found) : std::nullopt;
}

// Solves the mechanism of one transmission.
class TransmissionVerifier {
 public:
  TransmissionVerifier(const TransmissionAnalysis& analysis, const TransmissionVariant& variant)
      : analysis_(solve_transmission(analysis, variant)) {
    StationaryPoint teeth{};
    for (std::size_t s = 0; s < variant.teeth.size(); ++s) {
      teeth[s] = variant.teeth[s].stationary_ratio();
    }
    gears_ = list_gears(analysis.task, variant, teeth);
  }

  TransmissionCheck run() const {
    TransmissionCheck check{.agrees = true};
    for (const LadderGear& gear : gears_) {
      const bool is_known = compare(gear, check);
      check.agrees = check.agrees && is_known;
    }
    check.agrees = check.agrees && check.ratio <= kVerifiedRatio &&
                   check.torque <= kVerifiedTorque && check.efficiency <= kVerifiedTorque;
    return check;
  }

 private:
  // False where the mechanism has no such gear, or a magnitude is missing.
  bool compare(const LadderGear& gear, TransmissionCheck& check) const {
    const auto& states = analysis_.shift->solution.states;
    const auto state = std::ranges::find(states, gear.label, &NamedShiftState::name);
    const auto one = std::ranges::find(
        analysis_.cases, gear.label, [](const CaseAnalysis& each) { return each.which.label; });
    if (state == states.end() || one == analysis_.cases.end()) {
      return false;
    }
    const GearValues values = find_gear_values(
        solved_gear(analysis_.mechanism, analysis_.shift->plan, state->state, *one));
    const std::optional<double> efficiency =
        one->efficiency ? one->efficiency->carrier.value : std::optional(1.0);
    if (values.ratios.empty() || !values.ratios.front().ratio || !efficiency) {
      return false;
    }
    const double ratio = *values.ratios.front().ratio;
    check.ratio = std::max(check.ratio, std::abs(ratio / gear.figures.ratio - 1.0));
    check.efficiency = std::max(check.efficiency, std::abs(*efficiency - gear.efficiency));
    return compare_torques(values, gear, check);
  }

  bool compare_torques(const GearValues& values,
                       const LadderGear& gear,
                       TransmissionCheck& check) const {
    const std::optional<double> input = analysis_.shift->plan.inputs.front().action;
    KINESTAT_EXPECTS(input.has_value());
    double largest = 1.0;
    for (const double torque : gear.figures.torques) {
      largest = std::max(largest, std::abs(torque));
    }
    for (std::size_t j = 0; j < gear.figures.torques.size(); ++j) {
      const bool is_engaged = (gear.engaged >> j & 1U) != 0;
      if (is_engaged && !values.torques[j]) {
        return false;
      }
      const double torque = is_engaged ? *values.torques[j] / *input : 0.0;
      check.torque = std::max(check.torque, std::abs(torque - gear.figures.torques[j]) / largest);
    }
    return true;
  }

  Analysis analysis_;
  std::vector<LadderGear> gears_;
};

}  // namespace

Analysis solve_transmission(const TransmissionAnalysis& analysis,
                            const TransmissionVariant& variant) {
  Diagnostics ignored;
  std::optional<Loaded> loaded = read_back(describe_transmission(analysis, variant), ignored);
  KINESTAT_EXPECTS(loaded.has_value() && loaded->shift.has_value());
  return solve_cases(analysis.file, *std::move(loaded));
}

void check_transmissions(TransmissionAnalysis& analysis, Diagnostics& found) {
  for (std::size_t g = 0; g < analysis.groups.size(); ++g) {
    std::vector<TransmissionVariant>& variants = analysis.groups[g].variants;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const TransmissionCheck check = TransmissionVerifier(analysis, variants[i]).run();
      variants[i].check = check;
      if (!check.agrees) {
        found.warning("W0804",
                      analysis.description.synthesis->transmission->where,
                      fmt::format("the mechanism of transmission {}.{} differs from the search: "
                                  "ratios by {}, torques by {}, efficiencies by {}",
                                  g,
                                  i,
                                  format_short(check.ratio),
                                  format_short(check.torque),
                                  format_short(check.efficiency)),
                      "this program is wrong: please report it with the task");
      }
    }
  }
}

}  // namespace kinestat
