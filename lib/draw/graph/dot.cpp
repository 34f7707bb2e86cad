#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "draw/graph/graph_drawing.hpp"

namespace kinestat {

namespace {

// In double quotes a backslash and a quote have a meaning, and so has a line end: a control
// character becomes a space.
std::string in_dot_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char character : text) {
    if (character == '"' || character == '\\') {
      result += '\\';
    }
    result += is_ascii_control(character) ? ' ' : character;
  }
  return result + "\"";
}

std::string_view style_of(EdgeStroke stroke) {
  switch (stroke) {
    case EdgeStroke::branch:
      return "style=solid, penwidth=2";
    case EdgeStroke::chord:
      return "style=dashed";
    case EdgeStroke::background:
      return "style=dotted";
    case EdgeStroke::highlight:
      return "style=bold, penwidth=3";
  }
  return "";
}

double largest_power(const GraphModel& model) {
  double size = 0.0;
  for (const ModelPower& power : model.power) {
    size = std::max(size, power.size);
  }
  return size;
}

// Of a power, from 1 to 6.
double pen_width(double size, double largest) {
  return largest > 0.0 ? 1.0 + 5.0 * size / largest : 1.0;
}

std::string edge_text(const ModelEdge& edge) {
  const std::string times = edge.lines > 1 ? fmt::format(" ({})", edge.lines) : "";
  return fmt::format("  b{} -> b{} [label={}, {}];\n",
                     edge.tail,
                     edge.head,
                     in_dot_quotes(edge.label + times),
                     style_of(edge.stroke));
}

std::string power_text(const ModelEdge& edge, const ModelPower& power, double largest) {
  const bool flows = power.size > 0.0;
  const int from = power.is_forward ? edge.tail : edge.head;
  const int to = power.is_forward ? edge.head : edge.tail;
  return fmt::format("  b{} -> b{} [label={}, penwidth={:.2f}{}{}];\n",
                     from,
                     to,
                     in_dot_quotes(power.text.empty() ? edge.label : edge.label + " " + power.text),
                     pen_width(power.size, largest),
                     flows ? "" : ", style=dotted, dir=none",
                     power.recirculates ? ", color=\"black:black\"" : "");
}

std::string port_text(const ModelPort& port, std::size_t index, double largest) {
  const std::string name = fmt::format("p{}", index);
  const std::string body = fmt::format("b{}", port.node);
  return fmt::format("  {} [label={}, shape=plaintext];\n  {} -> {} [penwidth={:.2f}];\n",
                     name,
                     in_dot_quotes(port.text),
                     port.enters ? name : body,
                     port.enters ? body : name,
                     pen_width(port.size, largest));
}

}  // namespace

std::string dot_text(const GraphModel& model) {
  std::string text =
      fmt::format("digraph {{\n  label={};\n  node [shape=circle];\n", in_dot_quotes(model.title));
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    const ModelNode& node = model.nodes[n];
    text += fmt::format("  b{} [label={}{}{}];\n",
                        n,
                        in_dot_quotes(node.name),
                        node.is_ground ? ", shape=box" : "",
                        node.is_virtual ? ", style=dashed" : "");
  }
  double largest = largest_power(model);
  for (const ModelPort& port : model.ports) {
    largest = std::max(largest, port.size);
  }
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    text += model.power.empty() ? edge_text(model.edges[e])
                                : power_text(model.edges[e], model.power[e], largest);
  }
  for (std::size_t p = 0; p < model.ports.size(); ++p) {
    text += port_text(model.ports[p], p, largest);
  }
  return text + "}\n";
}

}  // namespace kinestat
