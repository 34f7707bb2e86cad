#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "graph/components.hpp"
#include "mechanism/bind/structure_binder.hpp"

namespace kinestat {

namespace {

std::vector<std::string> body_names(const Topology& topology, const std::vector<int>& bodies) {
  std::vector<std::string> names;
  for (const int b : bodies) {
    names.push_back(topology.bodies[static_cast<std::size_t>(b)].name);
  }
  return names;
}

bool check_connected(const Topology& topology, const Digraph& graph, Diagnostics& found) {
  const std::vector<std::vector<int>> parts = find_components(graph);
  if (parts.size() <= 1) {
    return true;
  }
  std::string list;
  constexpr std::size_t kMostParts = 8;  // that are listed
  for (std::size_t i = 1; i < std::min(parts.size(), kMostParts + 1); ++i) {
    list += fmt::format("{}{{{}}}", i == 1 ? "" : ", ", plain_list(body_names(topology, parts[i])));
  }
  if (parts.size() > kMostParts + 1) {
    list += fmt::format(" and {} more", parts.size() - 1 - kMostParts);
  }
  found.error("E0401",
              topology.bodies[static_cast<std::size_t>(parts[1].front())].where,
              fmt::format("bodies are not connected: nothing joins {} to the ground's part {{{}}}",
                          list,
                          plain_list(body_names(topology, parts[0]))),
              "add the couplings that are missing, or remove these bodies");
  return false;
}

// The given tree as edge numbers; complains about names that are no coupling.
std::optional<std::vector<int>> find_branches(const MechanismDescription& description,
                                              const Topology& topology,
                                              Diagnostics& found) {
  std::vector<int> branches;
  std::vector<std::string> names;
  for (const CouplingTopology& coupling : topology.couplings) {
    names.push_back(coupling.name);
  }
  bool is_good = true;
  for (const Name& name : *description.tree) {
    const auto at = std::ranges::find(names, name.text);
    const int branch = static_cast<int>(at - names.begin());
    if (at != names.end() && std::ranges::find(branches, branch) != branches.end()) {
      is_good = false;
      found.error("E0307",
                  name.where,
                  fmt::format("the tree names coupling '{}' twice", name.text),
                  "remove one of the two");
    }
    branches.push_back(branch);
    if (at == names.end()) {
      is_good = false;
      found.error("E0313",
                  name.where,
                  fmt::format("the tree names coupling '{}', which is not declared", name.text),
                  fmt::format("declared couplings are {}", plain_list(names)));
    }
  }
  return is_good ? std::optional(std::move(branches)) : std::nullopt;
}

std::optional<SpanningTree> bind_tree(const MechanismDescription& description,
                                      const Topology& topology,
                                      const Digraph& graph,
                                      Diagnostics& found) {
  if (!description.tree) {
    return find_spanning_tree(graph);
  }
  const auto branches = find_branches(description, topology, found);
  if (!branches) {
    return std::nullopt;
  }
  std::optional<SpanningTree> tree = find_spanning_tree(graph, *branches);
  if (!tree) {
    const std::size_t needed = topology.bodies.size() - 1;
    found.error(
        "E0402",
        description.tree_where,
        branches->size() == needed
            ? "the couplings of the tree close a circuit"
            : fmt::format("the tree has {} couplings; it needs {}, one for each moving body",
                          branches->size(),
                          needed),
        "remove 'tree' to take the first couplings that close no circuit");
  }
  return tree;
}

}  // namespace

std::optional<CouplingGraph> bind_coupling_graph(const MechanismDescription& description,
                                                 const Topology& topology,
                                                 Diagnostics& found) {
  Digraph graph = topology.coupling_graph();
  if (!check_connected(topology, graph, found)) {
    return std::nullopt;
  }
  std::optional<SpanningTree> tree = bind_tree(description, topology, graph, found);
  if (!tree) {
    return std::nullopt;
  }
  return make_coupling_graph(std::move(graph), *std::move(tree));
}

}  // namespace kinestat
