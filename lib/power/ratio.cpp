#include "power/ratio.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "core/utf8.hpp"
#include "power/internal/bounded_magnitude.hpp"
#include "power/rate_ratio.hpp"

namespace kinestat {

namespace {

// Loads that follow curves come behind the others.
const std::string& name_of_load(const Case& which, std::size_t index) {
  return index < which.loads.size() ? which.loads[index].name
                                    : which.moving_loads[index - which.loads.size()].name;
}

std::vector<double> input_rates(const Mechanism& mechanism,
                                const Case& which,
                                const KinematicSolution& motion) {
  std::vector<double> rates;
  for (const int i : which.inputs) {
    const int freedom = mechanism.topology.actuators[static_cast<std::size_t>(i)].freedom;
    rates.push_back(motion.rates[static_cast<std::size_t>(freedom)]);
  }
  return rates;
}

// The sum of the inputs' actions; empty if one of them is open, or a convention. Where several are
// summed, what they were rounded to as typed may be all that is left.
std::optional<BoundedNumber> total_action(const Mechanism& mechanism,
                                          const Case& which,
                                          const StaticSolution& action) {
  std::optional<BoundedNumber> sum;
  for (const int i : which.inputs) {
    const int index = mechanism.topology.actuators[static_cast<std::size_t>(i)].action;
    if (!action.magnitudes[static_cast<std::size_t>(index)] || is_by_convention(action, index)) {
      return std::nullopt;
    }
    const BoundedNumber one = bounded_action(action, index);
    sum = sum ? *sum + rounded_as_typed(one)
              : (which.inputs.size() == 1 ? one : rounded_as_typed(one));
  }
  return sum;
}

// Of ratios that have a value.
std::optional<double> bound_of_ratio(const Mechanism& mechanism,
                                     const Case& which,
                                     const KinematicSolution& motion) {
  if (!has_bounds(motion.answer)) {
    return std::nullopt;
  }
  const auto freedom = [&](int actuator) {
    return mechanism.topology.actuators[static_cast<std::size_t>(actuator)].freedom;
  };
  return (bounded_rate(motion, freedom(which.inputs.front())) /
          bounded_rate(motion, freedom(which.outputs.front())))
      .relative_bound();
}

}  // namespace

std::optional<double> common_rate(std::span<const double> rates) {
  const double first = rates.front();
  const bool is_common = std::ranges::all_of(rates, [&](double rate) {
    return std::abs(rate - first) <= kCancellation * std::abs(first);
  });
  return is_common ? std::optional(first) : std::nullopt;
}

std::optional<double> share_of(std::optional<double> above, std::optional<double> below) {
  return above && below && *below != 0.0 ? std::optional(*above / *below) : std::nullopt;
}

bool has_ratio_ends(const Case& which) {
  return !which.inputs.empty() && which.outputs.size() == 1;
}

MissingEnds missing_ratio_ends(const Mechanism& mechanism, const Case& which) {
  KINESTAT_EXPECTS(!has_ratio_ends(which));
  const bool has_input = !which.inputs.empty();
  if (which.outputs.size() > 1) {
    std::vector<std::string> names;
    for (const int i : which.outputs) {
      names.push_back(mechanism.topology.actuators[static_cast<std::size_t>(i)].name);
    }
    return {.what = fmt::format("has several outputs, {}", plain_list(names)),
            .hint = fmt::format("name one of them, output: {}", names.front())};
  }
  for (const bool is_input : {true, false}) {
    const std::vector<std::size_t>& loads = is_input ? which.input_loads : which.output_loads;
    if (!loads.empty() && (is_input ? which.inputs : which.outputs).empty()) {
      const std::string& name = name_of_load(which, loads.front());
      const std::string_view end = is_input ? "input" : "output";
      return {
          .what = fmt::format(
              "has the load '{}' for its {}, which has no speed of its own", printable(name), end),
          .hint = fmt::format(
              "declare an actuator on the coupling that '{0}' moves, and let "
              "the case give its action, 0 beside the load, and name it: "
              "action: {{ACTUATOR: 0}}, {1}: [ACTUATOR, {0}]; that has a ratio, and the "
              "mechanical advantage is the action of the output over the load",
              printable(name),
              end)};
    }
  }
  const bool has_output = !which.outputs.empty();
  return {.what = has_input    ? "lacks 'output'"
                  : has_output ? "lacks 'input'"
                               : "lacks 'input' and 'output'",
          .hint = has_input    ? "add output: NAME, an actuator of the case"
                  : has_output ? "add input: NAME, an actuator of the case"
                               : "add input: NAME and output: NAME, actuators of the case"};
}

Ratios find_ratios(const Mechanism& mechanism,
                   const Case& which,
                   const KinematicSolution& motion,
                   const StaticSolution* action) {
  KINESTAT_EXPECTS(has_ratio_ends(which));
  KINESTAT_EXPECTS(motion.status == SolveStatus::solved);
  const auto& actuators = mechanism.topology.actuators;
  const ActuatorTopology& output = actuators[static_cast<std::size_t>(which.outputs.front())];
  const std::optional<double> fast = common_rate(input_rates(mechanism, which, motion));
  const double slow = motion.rates[static_cast<std::size_t>(output.freedom)];
  Ratios ratios;
  if (!fast) {
    ratios.reason = "the inputs have different rates";
    return ratios;
  }
  ratios.ratio = share_of(fast, slow);
  if (!ratios.ratio) {
    ratios.reason = "output '" + output.name + "' is at rest";
  } else {
    ratios.ratio_bound = bound_of_ratio(mechanism, which, motion);
  }
  const bool has_loads = !which.input_loads.empty() || !which.output_loads.empty();
  if (action != nullptr && !has_loads) {
    add_torque_ratio(mechanism, which, *action, ratios);
  }
  return ratios;
}

void add_torque_ratio(const Mechanism& mechanism,
                      const Case& which,
                      const StaticSolution& action,
                      Ratios& ratios) {
  const ActuatorTopology& output =
      mechanism.topology.actuators[static_cast<std::size_t>(which.outputs.front())];
  const std::optional<BoundedNumber> in = total_action(mechanism, which, action);
  const bool has_output = action.magnitudes[static_cast<std::size_t>(output.action)] &&
                          !is_by_convention(action, output.action);
  if (!in || !has_output) {
    return;
  }
  const BoundedNumber out = bounded_action(action, output.action);
  ratios.torque_ratio = share_of(in->zeroed(), out.zeroed());
  const std::optional<double> advantage = share_of(out.zeroed(), in->zeroed());
  ratios.advantage = advantage ? std::optional(std::abs(*advantage)) : std::nullopt;
  if (ratios.torque_ratio && has_bounds(action.answer)) {
    ratios.torque_ratio_bound = (*in / out).relative_bound();
  }
}

}  // namespace kinestat
