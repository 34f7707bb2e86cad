#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// Power through a mesh as the ground sees it, and as its carrier does.
TextBlocks meshes_blocks(const Topology& topology, const CaseAnalysis& one, const InUnits& in) {
  const std::vector<MeshPower>& meshes = one.power_graph->meshes;
  if (meshes.empty()) {
    return {};
  }
  const std::string unit = in.units().text(QuantityKind::power);
  Table table(
      {"Mesh", "carrier", fmt::format("power [{}]", unit), fmt::format("rolling [{}]", unit)});
  for (const MeshPower& mesh : meshes) {
    const auto e = static_cast<std::size_t>(mesh.coupling.value);
    table.add({topology.couplings[e].name,
               topology.body(mesh.carrier).name,
               format_short(in.power(*one.power->into_head[e])),
               format_short(in.power(mesh.rolling))});
  }
  return TextBlocks(std::move(table));
}

// "carrier -(f)-> planet5 -(i)-> planet6 -(g)-> carrier", or the members where there are several
// circles.
std::string circle_text(const Topology& topology,
                        const PowerGraph& graph,
                        const CirculatingPower& loop) {
  std::string text;
  for (std::size_t i = 0; i < loop.bodies.size(); ++i) {
    text += (i == 0 ? "" : ", ") + topology.body(loop.bodies[i]).name;
  }
  if (loop.arcs.size() != loop.bodies.size()) {
    return "among " + text;
  }
  text.clear();
  for (const std::size_t arc : loop.arcs) {
    text += fmt::format("{} -({})-> ",
                        topology.body(graph.net[arc].from).name,
                        topology.coupling(graph.net[arc].coupling).name);
  }
  return text + topology.body(loop.bodies.front()).name;
}

std::string loops_text(const Topology& topology, const PowerGraph& graph, const InUnits& in) {
  std::string text;
  for (const CirculatingPower& loop : graph.circulating) {
    const std::string_view teeth = graph.meshes.empty() ? ""
                                   : loop.rolls         ? "; its teeth roll"
                                                        : "; no teeth roll in it";
    text += fmt::format("  power circulates: {}, up to {} {}{}\n",
                        circle_text(topology, graph, loop),
                        format_short(in.power(loop.largest)),
                        in.units().text(QuantityKind::power),
                        teeth);
  }
  return text;
}

std::string efficiency_text(const PowerFlow& flow, bool has_lossy_meshes) {
  if (flow.is_self_locking) {
    return "; self-locking: friction takes more than the inputs give";
  }
  if (flow.efficiency) {
    return fmt::format("; efficiency {}{}",
                       format_short(*flow.efficiency),
                       has_lossy_meshes ? " without mesh losses" : "");
  }
  return flow.no_efficiency.empty() ? "" : "; no efficiency: " + flow.no_efficiency;
}

std::string balance_text(const CaseAnalysis& one, const InUnits& in) {
  const PowerFlow& flow = *one.power;
  const std::string_view all =
      flow.loads.empty() ? "the powers of all couplings" : "the powers of all couplings and loads";
  return fmt::format(
      "  input power {} {}{}; {}\n\n",
      format_short(in.power(flow.input)),
      in.units().text(QuantityKind::power),
      efficiency_text(flow, one.efficiency.has_value()),
      flow.is_balanced
          ? fmt::format("{} sum to zero", all)
          : fmt::format("{} sum to {:.3g} of the largest", all, flow.balance_residual));
}

}  // namespace

TextBlocks power_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  TextBlocks blocks = meshes_blocks(mechanism.topology, one, in);
  blocks += loops_text(mechanism.topology, *one.power_graph, in) + losses_text(mechanism, one) +
            balance_text(one, in);
  return blocks;
}

namespace {

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

}  // namespace

std::string losses_text(const Mechanism& mechanism, const CaseAnalysis& one) {
  if (!one.efficiency) {
    return {};
  }
  const TransmissionEfficiency& efficiency = *one.efficiency;
  if (has_one_reason(efficiency)) {
    return fmt::format("  no efficiency with mesh losses: {}\n", efficiency.carrier.reason);
  }
  const std::string carrier = fmt::format(
      "  efficiency with mesh losses, of what rolls in each carrier: {}; backwards {}\n",
      share_text(efficiency.carrier),
      share_text(efficiency.carrier_backward));
  const std::string absolute =
      fmt::format("  efficiency with mesh losses, of all power seen from the ground: {}\n",
                  share_text(efficiency.absolute));
  const std::string_view block =
      efficiency.state && nothing_rolls(*efficiency.state)
          ? "  no lossy mesh rolls, as in a train that turns as a block: its teeth lose nothing;\n"
            "  the figure seen from the ground takes a share of power that only rides along with "
            "them\n"
          : "";
  return (mechanism.loss_model == LossModel::carrier ? carrier + absolute : absolute + carrier) +
         std::string(block);
}

}  // namespace kinestat
