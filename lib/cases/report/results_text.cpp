#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cases/case_efficiency.hpp"
#include "cases/report/case_text.hpp"
#include "cases/report/ratio_in_units.hpp"
#include "core/tolerance.hpp"
#include "mechanism/gears/central_hinge.hpp"
#include "mechanism/gears/planet_load.hpp"
#include "mechanism/label_kind.hpp"
#include "report/number_format.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

std::string shown_ratio(const RatioInUnits& ratio) {
  return format_short(*ratio.value) + (ratio.unit.empty() ? "" : " " + ratio.unit);
}

// Of the input's action over the output's.
std::string_view action_word(const Case& which, const Mechanism& mechanism) {
  const auto is_couple = [&](int actuator) {
    const int action = mechanism.topology.actuators[static_cast<std::size_t>(actuator)].action;
    return mechanism.topology.actions[static_cast<std::size_t>(action)].is_couple;
  };
  const bool is_of_couple = is_couple(which.inputs.front());
  return is_of_couple != is_couple(which.outputs.front()) ? "action"
         : is_of_couple                                   ? "torque"
                                                          : "force";
}

std::string ratio_text(const CaseAnalysis& one,
                       const Mechanism& mechanism,
                       const FileUnits& units) {
  const auto [ratio, torque] = ratios_in_units(one, mechanism, units);
  std::string text =
      ratio.value ? fmt::format("  ratio {}{}", shown_ratio(ratio), fraction_behind(one.ratios))
                  : fmt::format("  no ratio: {}", one.ratios->reason);
  if (torque.value) {
    text += fmt::format(", {} ratio {}", action_word(one.which, mechanism), shown_ratio(torque));
  }
  return text + "\n";
}

std::string efficiency_text(const PowerFlow& flow) {
  if (flow.is_self_locking) {
    return "; self-locking: friction absorbs more power than the inputs supply";
  }
  if (flow.efficiency) {
    return fmt::format("; efficiency {}", format_short(*flow.efficiency));
  }
  return flow.no_efficiency.empty() ? "" : "; no efficiency: " + flow.no_efficiency;
}

std::string balance_text(const CaseAnalysis& one, const InUnits& in) {
  const PowerFlow& flow = *one.power;
  const std::string_view all =
      flow.loads.empty() ? "the powers of all couplings" : "the powers of all couplings and loads";
  return fmt::format(
      "  {}input power {} {}{}; {}\n",
      one.efficiency ? "without mesh losses: " : "",
      format_short(in.power(flow.input)),
      in.units().text(QuantityKind::power),
      efficiency_text(flow),
      flow.is_balanced
          ? fmt::format("{} sum to zero", all)
          : fmt::format("{} sum to {:.3g} of the largest", all, flow.balance_residual));
}

std::string share_text(const Efficiency& one) {
  if (one.is_self_locking) {
    return "self-locking";
  }
  return one.value ? format_short(*one.value) : "none (" + one.reason + ")";
}

// All three have none, for one reason.
bool has_one_reason(const TransmissionEfficiency& efficiency) {
  const Efficiency& first = efficiency.carrier;
  return !first.is_self_locking && !first.reason.empty() &&
         first.reason == efficiency.carrier_backward.reason &&
         first.reason == efficiency.absolute.reason;
}

bool nothing_rolls(const LossyState& state) {
  return std::ranges::none_of(state.meshes, &MeshLossPower::rolls);
}

// "  with mesh losses: input power 500 W, out -270.681 N*m": of the inputs and outputs those whose
// action the case does not give.
std::string lossy_ends_text(const Mechanism& mechanism,
                            const CaseAnalysis& one,
                            const InUnits& in) {
  const Case& which = one.which;
  std::vector<int> ends = which.inputs;
  ends.insert(ends.end(), which.outputs.begin(), which.outputs.end());
  const std::vector<std::optional<double>>& actions = one.efficiency->state->actions;
  std::vector<std::string> parts = {
      fmt::format("input power {} {}",
                  format_short(in.power(one.efficiency->state->input)),
                  in.units().text(QuantityKind::power))};
  for (const int end : ends) {
    const ActuatorTopology& actuator = mechanism.topology.actuators[static_cast<std::size_t>(end)];
    const auto a = static_cast<std::size_t>(actuator.action);
    const bool is_given =
        std::ranges::find(which.actions, actuator.action, &Primary::index) != which.actions.end();
    if (!is_given && actions[a]) {
      const bool is_couple = mechanism.topology.actions[a].is_couple;
      parts.push_back(fmt::format("{} {} {}",
                                  actuator.name,
                                  format_short(in.action(*actions[a], is_couple)),
                                  in.units().text(action_kind(is_couple))));
    }
  }
  return fmt::format("  with mesh losses: {}\n", fmt::join(parts, ", "));
}

// Why a case has no power, or "".
std::string_view lack_of_power(const CaseAnalysis& one) {
  return !one.which.asks_motions   ? "no velocities are given"
         : !one.which.asks_actions ? "no actions or loads are given"
                                   : "";
}

std::string_view lack_of_ratio(const CaseAnalysis& one) {
  return !one.which.asks_motions        ? "no velocities are given"
         : !one.which.names_both_ends() ? "the case does not name input and output"
                                        : "";
}

std::string_view lack_of_efficiency(const CaseAnalysis& one) {
  const std::string_view lack = lack_of_power(one);
  return lack.empty() ? lack_of_ratio(one) : lack;
}

// "  no ratio, no efficiency: no velocities are given": why the case has dashes in the overview
// where others have numbers. Empty where they have none either, or lines of their own tell.
std::string lacks_text(const Analysis& analysis, const CaseAnalysis& one) {
  const auto any_has = [&](auto has) { return std::ranges::any_of(analysis.cases, has); };
  std::vector<std::pair<std::string_view, std::vector<std::string_view>>> lacks;
  const auto add = [&](std::string_view what, std::string_view reason) {
    if (!reason.empty()) {
      const auto same =
          std::ranges::find(lacks, reason, [](const auto& lack) { return lack.first; });
      (same != lacks.end() ? same->second
                           : lacks.emplace_back(reason, std::vector<std::string_view>()).second)
          .push_back(what);
    }
  };
  if (!one.ratios && any_has([](const CaseAnalysis& other) {
        return other.ratios && other.ratios->ratio.has_value();
      })) {
    add("no ratio", lack_of_ratio(one));
  }
  if (!one.efficiency && any_has([&](const CaseAnalysis& other) {
        return case_efficiency(other, analysis.mechanism).value.has_value();
      })) {
    add("no efficiency", lack_of_efficiency(one));
  }
  if (!one.power && any_has([](const CaseAnalysis& other) { return other.power.has_value(); })) {
    add("no power", lack_of_power(one));
  }
  if (!one.action && !one.which.asks_actions &&
      any_has([](const CaseAnalysis& other) { return other.action.has_value(); })) {
    add("no forces", "no actions or loads are given");
  }
  std::string text;
  for (const auto& [reason, what] : lacks) {
    text += fmt::format("  {}: {}\n", fmt::join(what, ", "), reason);
  }
  return text;
}

bool bears_force(const Topology& topology, const CouplingTopology& coupling) {
  const auto first = topology.actions.begin() + coupling.first_action;
  return std::any_of(
      first, first + coupling.action_count, [](const ActionLabel& one) { return !one.is_couple; });
}

void count(double size, const std::string& coupling, LargestAction& largest) {
  largest.is_borne = true;
  const double same = kSameValue * std::max(size, largest.size);
  if (size > largest.size + same) {
    largest.size = size;
    largest.couplings.clear();
  }
  if (size > 0.0 && size >= largest.size - same) {
    largest.couplings.push_back(coupling);
  }
}

// "largest force 538.516 N in a, b, c"
std::string largest_text(const char* what, const LargestAction& largest, const InUnits& in) {
  constexpr std::size_t kMost = 3;
  const auto shown = static_cast<std::ptrdiff_t>(std::min(largest.couplings.size(), kMost));
  const auto first = largest.couplings.begin();
  const bool is_couple = largest.is_couple;
  std::string text = fmt::format("largest {}{} {} {} in {}",
                                 largest.is_open ? "determined " : "",
                                 what,
                                 format_short(in.action(largest.size, is_couple)),
                                 in.units().text(action_kind(is_couple)),
                                 fmt::join(first, first + shown, ", "));
  return largest.couplings.size() > kMost
             ? text + fmt::format(" and {} more", largest.couplings.size() - kMost)
             : text;
}

std::string largest_text(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  const LargestActions largest = largest_actions(mechanism, one);
  std::vector<std::string> parts;
  if (largest.force.size > 0.0) {
    parts.push_back(largest_text("force", largest.force, in));
  }
  if (largest.moment.size > 0.0) {
    parts.push_back(largest_text("moment", largest.moment, in));
  }
  if (parts.empty()) {
    return "";
  }
  std::vector<std::string_view> remarks;
  if (largest.is_per_planet) {
    remarks.push_back("values are those of the most heavily loaded planet");
  }
  if (largest.has_central_hinges) {
    remarks.push_back("radial planet forces cancel on the central bearings");
  }
  return fmt::format("  {}{}{}{}\n",
                     one.efficiency ? "without mesh losses: " : "",
                     fmt::join(parts, "; "),
                     remarks.empty() ? "" : "\n  ",
                     fmt::join(remarks, "; "));
}

// A line for each model, the action with losses, and a word on what tells the models apart where
// the teeth do not roll. Empty without lossy meshes.
std::string losses_text(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  if (!one.efficiency) {
    return {};
  }
  const TransmissionEfficiency& efficiency = *one.efficiency;
  if (has_one_reason(efficiency)) {
    return fmt::format("  no efficiency with mesh losses: {}\n", efficiency.carrier.reason);
  }
  const std::string carrier =
      fmt::format(
          "  efficiency with mesh losses (from rolling power): {}; if the output drives: {}\n",
          share_text(efficiency.carrier),
          share_text(efficiency.carrier_backward)) +
      (efficiency.state ? lossy_ends_text(mechanism, one, in) : "");
  const std::string absolute =
      fmt::format("  absolute efficiency (power seen from the ground){}: {}\n",
                  mechanism.loss_model == LossModel::carrier ? ", for comparison" : "",
                  share_text(efficiency.absolute));
  const std::string_view block =
      efficiency.state && nothing_rolls(*efficiency.state)
          ? "  no mesh with losses rolls, as where the train turns as a block: its teeth lose "
            "nothing;\n"
            "  the absolute efficiency also counts losses on power that is only carried around\n"
          : "";
  return (mechanism.loss_model == LossModel::carrier ? carrier + absolute : absolute + carrier) +
         std::string(block);
}

}  // namespace

LargestActions largest_actions(const Mechanism& mechanism, const CaseAnalysis& one) {
  LargestActions largest;
  largest.moment.is_couple = true;
  const bool has_wrenches = one.action && !one.action->wrenches.empty();
  const std::vector<std::optional<CentralHinge>> central = find_central_hinges(mechanism);
  for (std::size_t e = 0; has_wrenches && e < mechanism.topology.couplings.size(); ++e) {
    const CouplingTopology& coupling = mechanism.topology.couplings[e];
    const auto wrench = bounded_wrench(*one.action, CouplingId{static_cast<int>(e)});
    bool is_open = !wrench;
    BoundedWrench with_planets = wrench.value_or(BoundedWrench{});
    for (std::size_t i = 0; central[e] && i < central[e]->planets.size(); ++i) {
      const CountedCoupling& planet = central[e]->planets[i];
      if (const auto other = bounded_wrench(*one.action, planet.coupling)) {
        const BoundedNumber sign{.value = planet.sign, .bound = 0.0};
        with_planets = with_planets +
                       BoundedWrench{.moment = sign * other->moment, .force = sign * other->force};
      } else {
        is_open = true;
      }
    }
    if (is_open) {
      largest.force.is_open = largest.force.is_open || bears_force(mechanism.topology, coupling);
      largest.moment.is_open = largest.moment.is_open || !mechanism.is_unplaced[e];
      continue;
    }
    const Vec3& point = mechanism.geometry.points[e];
    const double force =
        borne(central[e], wrench->force.zeroed(), with_planets.force.zeroed()).norm();
    const double moment =
        borne(
            central[e], moment_at(*wrench, point).zeroed(), moment_at(with_planets, point).zeroed())
            .norm();
    const double share = most_loaded_share(mechanism, coupling);
    count(share * force, coupling.name, largest.force);
    if (!mechanism.is_unplaced[e]) {
      count(share * moment, coupling.name, largest.moment);
    }
    largest.is_per_planet = largest.is_per_planet || share < 1.0;
    largest.has_central_hinges = largest.has_central_hinges ||
                                 (central[e] && central[e]->across != CentralHinge::Across::shared);
  }
  return largest;
}

std::string ratio_cell(const CaseAnalysis& one, const Mechanism& mechanism, const InUnits& in) {
  const std::optional<RatioInUnits> ratio =
      one.ratios ? std::optional(ratios_in_units(one, mechanism, in.units()).ratio) : std::nullopt;
  return ratio && ratio->value ? shown_ratio(*ratio) : "-";
}

std::string efficiency_cell(const CaseAnalysis& one, const Mechanism& mechanism) {
  const Efficiency efficiency = case_efficiency(one, mechanism);
  return efficiency.is_self_locking ? "self-locking"
         : efficiency.value         ? format_short(*efficiency.value)
                                    : "-";
}

// With the losses that the efficiency has.
std::string input_power_cell(const CaseAnalysis& one,
                             const Mechanism& mechanism,
                             const InUnits& in) {
  if (!one.power) {
    return "-";
  }
  const bool has_losses =
      one.efficiency && one.efficiency->state && mechanism.loss_model == LossModel::carrier;
  return format_short(in.power(has_losses ? one.efficiency->state->input : one.power->input));
}

std::string results_text(const Analysis& analysis, const CaseAnalysis& one) {
  const Mechanism& mechanism = analysis.mechanism;
  const InUnits in(analysis.description.units);
  std::string text;
  if (one.ratios) {
    text += ratio_text(one, mechanism, in.units());
  }
  if (one.power) {
    text += losses_text(mechanism, one, in) + balance_text(one, in);
  }
  return text + lacks_text(analysis, one) + largest_text(mechanism, one, in);
}

}  // namespace kinestat
