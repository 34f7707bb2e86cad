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

}  // namespace

TextBlocks power_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  TextBlocks blocks = meshes_blocks(mechanism.topology, one, in);
  blocks += loops_text(mechanism.topology, *one.power_graph, in);
  return blocks;
}

}  // namespace kinestat
