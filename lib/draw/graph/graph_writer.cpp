#include "draw/graph/graph_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "draw/symbols.hpp"

namespace kinestat {

namespace {

constexpr double kNodeText = 12.5;
constexpr double kLabelText = 11.5;
constexpr double kNodeHalfHeight = 13.0;
constexpr double kBetweenEdges = 30.0;  // parallel edges, in their middle [px]
constexpr double kMostBetweenEdges = 70.0;
constexpr double kBetweenLines = 5.0;  // the lines of one edge
constexpr double kWidest = 11.0;
constexpr double kHair = 1.2;
constexpr double kHatching = 9.0;  // below the ground [px]

bool holds(const PixelBox& box, PixelPoint p) {
  return p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom;
}

// An edge as points from node to node.
struct Curve {
  std::vector<PixelPoint> points;

  // The point and the direction there, by the share of the number of points.
  PixelPoint at(double share) const {
    return points[static_cast<std::size_t>(share * static_cast<double>(points.size() - 1))];
  }

  PixelPoint direction(double share) const {
    const auto last = static_cast<double>(points.size() - 1);
    const auto i = static_cast<std::size_t>(std::min(share * last, last - 1));
    return unit_of(points[i + 1] - points[i]);
  }
};

class GraphWriter {
 public:
  GraphWriter(Svg& svg, const GraphModel& model, const std::vector<PixelPoint>& places)
      : svg_(svg), model_(model), places_(places) {
    for (std::size_t v = 0; v < model.nodes.size(); ++v) {
      const PixelPoint half = node_half(model.nodes[v]);
      boxes_.push_back({.left = places[v].x - half.x,
                        .top = places[v].y - half.y,
                        .right = places[v].x + half.x,
                        .bottom = places[v].y + half.y});
      placer_.keep_free(boxes_.back());
      if (model.nodes[v].is_ground) {
        PixelBox hatching = boxes_.back();
        hatching.top = hatching.bottom;
        hatching.bottom += kHatching;
        placer_.keep_off(hatching);
      }
    }
    for (const ModelPower& power : model.power) {
      largest_ = std::max(largest_, power.size);
    }
    for (const ModelPort& port : model.ports) {
      largest_ = std::max(largest_, port.size);
    }
  }

  void write() {
    const std::vector<std::vector<Curve>> curves = find_curves();
    // What is highlighted, and what carries most power, lies on top.
    for (const std::size_t e : order_of_drawing()) {
      svg_.open_group(model_.edges[e].label);
      draw_edge(e, curves[e]);
      svg_.close_group();
    }
    for (std::size_t v = 0; v < model_.nodes.size(); ++v) {
      draw_node(v);
    }
    std::map<int, int> drawn;  // of each node
    for (const ModelPort& port : model_.ports) {
      draw_port(port, drawn[port.node]++);
    }
    constexpr std::size_t kMostLabels = 500;  // nobody reads more, and they take long
    for (std::size_t e = 0; model_.edges.size() <= kMostLabels && e < model_.edges.size(); ++e) {
      draw_label(e, curves[e][curves[e].size() / 2]);
    }
  }

  // Its labels name the edges.
  void write_highlights() {
    const std::vector<std::vector<Curve>> curves = find_curves();
    const auto each = [&](const auto& draw) {
      for (std::size_t e = 0; e < model_.edges.size(); ++e) {
        if (model_.edges[e].stroke == EdgeStroke::highlight) {
          std::ranges::for_each(curves[e], [&](const Curve& curve) { draw(e, curve); });
        }
      }
    };
    each([this](std::size_t e, const Curve& curve) { svg_.polyline(curve.points, paint_of(e)); });
    each([this](std::size_t e, const Curve& curve) { draw_head(e, curve); });
    for (std::size_t e = 0; e < model_.edges.size(); ++e) {
      draw_label(e, curves[e][curves[e].size() / 2]);
    }
  }

 private:
  // Of each edge, from which names keep off.
  std::vector<std::vector<Curve>> find_curves() {
    find_offsets();
    std::vector<std::vector<Curve>> curves;
    for (std::size_t e = 0; e < model_.edges.size(); ++e) {
      curves.push_back(curves_of(e));
      for (const Curve& curve : curves.back()) {
        keep_off(e, curve);
      }
    }
    return curves;
  }

  // Arrows of power by both their sides and the head.
  void keep_off(std::size_t e, const Curve& curve) {
    const double half = has_power(e) ? power_width(power_of(e)->size, largest_) / 2 : 0.0;
    const std::size_t last = curve.points.size() - 1;
    for (std::size_t i = 1; i <= last; ++i) {
      const PixelPoint aside = half * left_of(unit_of(curve.points[i] - curve.points[i - 1]));
      placer_.keep_off(curve.points[i - 1] + aside, curve.points[i] + aside);
      if (half > 1.0) {
        placer_.keep_off(curve.points[i - 1] - aside, curve.points[i] - aside);
      }
    }
    if (has_power(e)) {
      const bool is_forward = power_of(e)->is_forward;
      const PixelPoint tip = curve.points[is_forward ? last : 0];
      const PixelPoint out = curve.direction(is_forward ? 1.0 : 0.0);
      const double head = head_length(2 * half);
      const PixelPoint back = tip - (is_forward ? head : -head) * out;
      placer_.keep_off(back + 0.4 * head * left_of(out), back - 0.4 * head * left_of(out));
    }
  }

  PixelPoint place(int node) const { return places_[static_cast<std::size_t>(node)]; }

  // By how much the middle of each edge lies off the straight line, to the left of the line from
  // the lower to the higher node: parallel edges, and all their lines, lie side by side.
  void find_offsets() {
    std::map<std::pair<int, int>, std::vector<std::size_t>> parallel;
    for (std::size_t e = 0; e < model_.edges.size(); ++e) {
      const ModelEdge& edge = model_.edges[e];
      parallel[std::minmax(edge.tail, edge.head)].push_back(e);
    }
    offsets_.assign(model_.edges.size(), 0.0);
    for (const auto& [pair, edges] : parallel) {
      const double between = room_between(pair.first, pair.second, edges);
      double width = -between;
      for (const std::size_t e : edges) {
        width += between + bundle_width(e);
      }
      double at = -width / 2;
      for (const std::size_t e : edges) {
        offsets_[e] = at + bundle_width(e) / 2;
        at += bundle_width(e) + between;
      }
    }
    for (std::size_t e = 0; e < model_.edges.size(); ++e) {
      lead_around_nodes(e);
    }
  }

  // Bends an edge that would run behind a node that it does not join, as little as need be.
  void lead_around_nodes(std::size_t e) {
    constexpr double kStep = 12.0;
    constexpr int kMostSteps = 10;
    const double first = offsets_[e];
    for (int i = 1; i <= 2 * kMostSteps && meets_node(e); ++i) {
      offsets_[e] = first + (i % 2 == 1 ? 1.0 : -1.0) * kStep * ((i + 1) / 2);
    }
    if (meets_node(e)) {
      offsets_[e] = first;
    }
  }

  bool meets_node(std::size_t e) const {
    constexpr double kAir = 4.0;
    const ModelEdge& edge = model_.edges[e];
    const Curve curve = curve_of(edge, offsets_[e]);
    for (std::size_t v = 0; v < boxes_.size(); ++v) {
      const PixelBox box = boxes_[v].grown(kAir + bundle_width(e) / 2);
      const bool is_end = static_cast<int>(v) == edge.tail || static_cast<int>(v) == edge.head;
      if (!is_end &&
          std::ranges::any_of(curve.points, [&box](PixelPoint p) { return holds(box, p); })) {
        return true;
      }
    }
    return false;
  }

  // So much that the label of each edge fits in, which takes more the steeper the edges are.
  double room_between(int tail, int head, const std::vector<std::size_t>& edges) const {
    constexpr double kAround = 8.0;
    const PixelPoint across = left_of(unit_of(place(head) - place(tail)));
    double room = kBetweenEdges;
    for (const std::size_t e : edges) {
      room = std::max(room, size_across(label_text(e), label_style(e), across) + kAround);
    }
    return std::min(room, kMostBetweenEdges);
  }

  // Of a text in that direction.
  static double size_across(const std::string& text, const TextStyle& style, PixelPoint across) {
    return std::abs(across.x) * text_width(text, style.size, style.weight) +
           std::abs(across.y) * style.size;
  }

  double bundle_width(std::size_t e) const {
    return kBetweenLines * std::max(0, model_.edges[e].lines - 1);
  }

  // One for each line; a dotted one if there is none to draw.
  std::vector<Curve> curves_of(std::size_t e) const {
    std::vector<Curve> curves;
    const int lines = std::max(1, model_.edges[e].lines);
    for (int i = 0; i < lines; ++i) {
      const double offset = offsets_[e] - bundle_width(e) / 2 + kBetweenLines * i;
      curves.push_back(curve_of(model_.edges[e], offset));
    }
    return curves;
  }

  Curve curve_of(const ModelEdge& edge, double offset) const {
    constexpr int kPieces = 64;
    const PixelPoint from = place(edge.tail);
    const PixelPoint to = place(edge.head);
    const double sense = edge.tail < edge.head ? 1.0 : -1.0;
    // The middle of a quadratic curve lies half way to its control point.
    const PixelPoint control =
        0.5 * (from + to) + (2.0 * sense * offset) * left_of(unit_of(to - from));
    const PixelBox tail = boxes_[static_cast<std::size_t>(edge.tail)].grown(1.0);
    const PixelBox head = boxes_[static_cast<std::size_t>(edge.head)].grown(3.0);
    Curve curve;
    for (int i = 0; i <= kPieces; ++i) {
      const double t = static_cast<double>(i) / kPieces;
      const PixelPoint p = ((1 - t) * (1 - t)) * from + (2 * t * (1 - t)) * control + (t * t) * to;
      if (!holds(tail, p) && !holds(head, p)) {
        curve.points.push_back(p);
      }
    }
    if (curve.points.size() < 2) {
      curve.points = {from, to};
    }
    return curve;
  }

  const ModelPower* power_of(std::size_t e) const {
    return model_.power.empty() ? nullptr : &model_.power[e];
  }

  std::vector<std::size_t> order_of_drawing() const {
    std::vector<std::size_t> order(model_.edges.size());
    for (std::size_t e = 0; e < order.size(); ++e) {
      order[e] = e;
    }
    const auto weight = [this](std::size_t e) {
      const ModelPower* power = power_of(e);
      return std::pair(model_.edges[e].stroke == EdgeStroke::highlight,
                       power == nullptr ? 0.0 : power->size);
    };
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return weight(a) < weight(b); });
    return order;
  }

  Paint paint_of(std::size_t e) const {
    const ModelEdge& edge = model_.edges[e];
    const bool is_dashed = edge.lines == 0;
    switch (edge.stroke) {
      case EdgeStroke::branch:
        return {.stroke = Ink::ink, .width = edge.lines > 1 ? 1.7 : 2.6};
      case EdgeStroke::chord:
        return {.stroke = Ink::blue, .width = 1.6, .dash = is_dashed ? "1 4" : "7 4"};
      case EdgeStroke::background:
        return {.stroke = Ink::grid, .width = 1.4};
      case EdgeStroke::highlight:
        return {.stroke = Ink::vermilion, .width = 3.2};
    }
    return {};
  }

  // All its lines, then all heads: so they are short to write.
  void draw_edge(std::size_t e, const std::vector<Curve>& curves) {
    const ModelPower* power = power_of(e);
    for (const Curve& curve : curves) {
      if (power != nullptr) {
        draw_power(*power, curve);
      } else {
        svg_.polyline(curve.points, paint_of(e));
      }
    }
    for (std::size_t i = 0; power == nullptr && i < curves.size(); ++i) {
      draw_head(e, curves[i]);
    }
  }

  // From tail to head.
  void draw_head(std::size_t e, const Curve& curve) {
    const double share = 0.64;
    svg_.arrow_head(curve.at(share) + 5.0 * curve.direction(share),
                    curve.direction(share),
                    paint_of(e).stroke,
                    10.0);
  }

  // Of an arrow that wide, so that its head is twice as wide.
  static double head_length(double width) { return 9.0 + 2.0 * width; }

  void draw_power(const ModelPower& power, const Curve& curve) {
    if (power.size == 0.0) {
      svg_.polyline(curve.points, {.stroke = Ink::grid, .width = kHair});
      return;
    }
    std::vector<PixelPoint> points = curve.points;
    if (!power.is_forward) {
      std::reverse(points.begin(), points.end());
    }
    const double width = power_width(power.size, largest_);
    const double head = head_length(width);
    const PixelPoint tip = points.back();
    // The line ends within the head.
    while (points.size() > 2 && length_of(points.back() - tip) < 0.85 * head) {
      points.pop_back();
    }
    const Ink ink = power.recirculates ? Ink::vermilion : Ink::blue;
    svg_.polyline(points, {.stroke = ink, .width = width});
    if (power.recirculates) {
      svg_.polyline(points, {.stroke = Ink::paper, .width = std::max(1.0, 0.4 * width)});
    }
    svg_.arrow_head(tip, tip - points.back(), ink, head);
  }

  void draw_node(std::size_t v) {
    const ModelNode& node = model_.nodes[v];
    const PixelBox& box = boxes_[v];
    Paint paint = {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.5};
    if (node.is_ground) {
      paint.fill = Ink::tint;
      paint.width = 2.4;
      draw_fixed_line(svg_,
                      {.x = box.left + 3, .y = box.bottom + 2},
                      {.x = box.right - 3, .y = box.bottom + 2});
    }
    if (node.is_virtual) {
      paint.dash = "3 2";
    }
    svg_.rectangle(box, paint, kNodeHalfHeight);
    svg_.text({.x = places_[v].x, .y = places_[v].y + 0.36 * kNodeText},
              node.name,
              {.ink = Ink::ink,
               .size = kNodeText,
               .weight = node.is_ground ? Weight::bold : Weight::normal,
               .anchor = Anchor::middle});
  }

  // An arrow from outside, or to it, away from the middle of the picture; `number` counts those of
  // its node.
  void draw_port(const ModelPort& port, int number) {
    PixelPoint middle = {.x = 0.0, .y = 0.0};
    for (const PixelPoint& p : places_) {
      middle = middle + (1.0 / static_cast<double>(places_.size())) * p;
    }
    PixelPoint out = unit_of(place(port.node) - middle);
    const double turn = 0.5 * number;
    out = std::cos(turn) * out + std::sin(turn) * left_of(out);
    const PixelPoint half = node_half(model_.nodes[static_cast<std::size_t>(port.node)]);
    const double edge = 6.0 + std::min(half.x / std::abs(out.x), half.y / std::abs(out.y));
    const PixelPoint near = place(port.node) + edge * out;
    const PixelPoint far = near + 42.0 * out;
    const double width = power_width(port.size, largest_);
    svg_.arrow(port.enters ? far : near,
               port.enters ? near : far,
               {.stroke = Ink::green, .width = width},
               head_length(width));
    for (const double side : {-0.5, 0.0, 0.5}) {
      const PixelPoint beside = (side * head_length(width)) * left_of(out);
      placer_.keep_off(near + beside, far + beside);
    }
    const TextStyle style = {.ink = Ink::green, .size = kLabelText, .has_halo = true};
    const PlacedName label = placer_.place(far, port.text, style, 5.0);
    write_label(svg_, label, port.text, style);
  }

  bool has_power(std::size_t e) const {
    const ModelPower* power = power_of(e);
    return power != nullptr && power->size > 0.0;
  }

  std::string label_text(std::size_t e) const {
    const std::string& label = model_.edges[e].label;
    return has_power(e) ? label + ": " + power_of(e)->text : label;
  }

  TextStyle label_style(std::size_t e) const {
    return {.ink = has_power(e) || power_of(e) == nullptr ? Ink::ink : Ink::soft,
            .size = kLabelText,
            .weight = has_power(e) ? Weight::bold : Weight::normal,
            .anchor = Anchor::middle,
            .has_halo = true};
  }

  void draw_label(std::size_t e, const Curve& curve) {
    if (model_.edges[e].stroke == EdgeStroke::background) {
      return;
    }
    const std::string text = label_text(e);
    const TextStyle style = label_style(e);
    const double beside = has_power(e) ? power_width(power_of(e)->size, largest_) / 2 : 1.0;
    std::vector<PixelPoint> middles;
    for (const double farther : {0.0, 5.0, 10.0}) {
      for (const double share : {0.5, 0.42, 0.58, 0.34, 0.72, 0.26, 0.8, 0.18, 0.88, 0.12}) {
        const PixelPoint across = left_of(curve.direction(share));
        const double away =
            beside + 3.0 + farther + size_across(text, style, across) / 2 + bundle_width(e) / 2;
        middles.push_back(curve.at(share) + away * across);
        middles.push_back(curve.at(share) - away * across);
      }
    }
    const std::array anchors = {curve.at(0.5)};
    const PlacedName label = placer_.place_at(middles, anchors, text, style);
    write_label(svg_, label, text, style);
  }

  Svg& svg_;
  const GraphModel& model_;
  const std::vector<PixelPoint>& places_;
  std::vector<PixelBox> boxes_;
  std::vector<double> offsets_;
  NamePlacer placer_;
  double largest_ = 0.0;
};

}  // namespace

double power_width(double size, double largest) {
  return largest > 0.0 ? std::max(kHair, kWidest * size / largest) : kHair;
}

PixelPoint node_half(const ModelNode& node) {
  return {.x = std::max(kNodeHalfHeight, text_width(node.name, kNodeText, Weight::bold) / 2 + 8.0),
          .y = kNodeHalfHeight};
}

void write_graph(Svg& svg, const GraphModel& model, const std::vector<PixelPoint>& places) {
  GraphWriter(svg, model, places).write();
}

void write_highlights(Svg& svg, const GraphModel& model, const std::vector<PixelPoint>& places) {
  GraphWriter(svg, model, places).write_highlights();
}

}  // namespace kinestat
