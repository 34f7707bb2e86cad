// A graph of a mechanism as pictures and DOT text write it: names, directions, what is highlighted.
#pragma once

#include <string>
#include <vector>

#include "cases/analysis.hpp"

namespace kinestat {

/// How an edge is drawn.
enum class EdgeStroke {
  branch,      ///< of the spanning tree: full and thick
  chord,       ///< dashed
  background,  ///< thin and grey, where others are highlighted
  highlight    ///< of the circuit or cut-set that is shown
};

struct ModelNode {
  std::string name;
  bool is_ground = false;
  bool is_virtual = false;  ///< a virtual link of a cable
};

/// From tail to head, as the matrices of the method have it.
struct ModelEdge {
  int tail = 0;
  int head = 0;
  std::string label;  ///< "a"; of an expanded graph "a: Rx Ry C1"
  int lines = 1;      ///< how many edges it stands for, drawn beside each other
  EdgeStroke stroke = EdgeStroke::branch;
  bool is_mesh = false;  ///< teeth
};

/// Power along an edge.
struct ModelPower {
  double size = 0.0;          ///< [W], not negative; 0: none, or not known
  bool is_forward = true;     ///< from tail to head
  bool recirculates = false;  ///< it belongs to a circle of power
  std::string text;           ///< "150.8 W"
};

/// Power that enters or leaves at a coupling from outside the mechanism: an input, an output, a
/// load, a loss.
struct ModelPort {
  int node = 0;
  bool enters = true;
  double size = 0.0;  ///< [W]
  std::string text;   ///< "C1 100 W"
};

struct GraphModel {
  std::string name;              ///< "coupling_graph": fit for file names
  std::string title;             ///< "Coupling graph of Four-bar linkage", not escaped
  std::vector<ModelNode> nodes;  ///< the ground first
  std::vector<ModelEdge> edges;
  std::vector<ModelPower> power;  ///< of each edge, or empty
  std::vector<ModelPort> ports;
};

/// G_C: one edge a coupling.
GraphModel coupling_graph_model(const Analysis& analysis);

/// G_M: one line a freedom.
GraphModel motion_graph_model(const Analysis& analysis);

/// G_A: one line a passive constraint, and one an internalised action.
GraphModel action_graph_model(const Analysis& analysis);

/// One a fundamental circuit, in the order of the chords: its edges highlighted.
std::vector<GraphModel> circuit_models(const Analysis& analysis);

/// One a fundamental cut-set, in the order of the branches.
std::vector<GraphModel> cutset_models(const Analysis& analysis);

/// The coupling graph with the power of a case, whose index must be that of a case with a power
/// flow; edges whose power is not known have none.
GraphModel power_model(const Analysis& analysis, std::size_t which);

}  // namespace kinestat
