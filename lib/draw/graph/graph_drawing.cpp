#include "draw/graph/graph_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "draw/graph/graph_layout.hpp"
#include "draw/graph/graph_writer.hpp"
#include "draw/symbols.hpp"
#include "draw/text_styles.hpp"

namespace kinestat {

namespace {

// Nodes keep that far apart: their names, and labels between them.
double distance_of(const GraphModel& model) {
  double widest = 0.0;
  for (const ModelNode& node : model.nodes) {
    widest = std::max(widest, 2 * node_half(node).x);
  }
  double label = 0.0;
  for (const ModelEdge& edge : model.edges) {
    label = std::max(label, text_width(edge.label, 11.5));
  }
  const double for_power = model.power.empty() ? 0.0 : 60.0;
  return std::clamp(widest + 44.0 + 0.5 * label + for_power, 100.0, 210.0);
}

Digraph digraph_of(const GraphModel& model) {
  Digraph graph{.vertex_count = static_cast<int>(model.nodes.size()), .edges = {}};
  for (const ModelEdge& edge : model.edges) {
    graph.edges.push_back({.tail = edge.tail, .head = edge.head});
  }
  return graph;
}

// A line of the legend and what it means.
struct LegendLine {
  Paint paint;
  std::string_view words;
};

std::vector<LegendLine> legend_of(const GraphModel& model) {
  if (!model.power.empty()) {
    std::vector<LegendLine> lines = {
        {{.stroke = Ink::blue, .width = 5.0}, "power, as wide as it is large"}};
    if (std::ranges::any_of(model.power, &ModelPower::recirculates)) {
      lines.push_back({{.stroke = Ink::vermilion, .width = 5.0}, "power that circulates"});
    }
    lines.push_back({{.stroke = Ink::grid, .width = 1.2}, "no power"});
    return lines;
  }
  return {{{.stroke = Ink::ink, .width = 2.6}, "branch of the tree"},
          {{.stroke = Ink::blue, .width = 1.6, .dash = "7 4"}, "chord; arrows from tail to head"}};
}

void draw_legend(Svg& svg, const GraphModel& model) {
  double x = svg.bounds().left;
  double y = svg.bounds().bottom + 24.0;
  const double right = std::max(svg.bounds().right, x + 260.0);
  for (const LegendLine& line : legend_of(model)) {
    const double width = 34.0 + text_width(line.words, kSmall.size);
    if (x > svg.bounds().left && x + width > right) {
      x = svg.bounds().left;
      y += 18.0;
    }
    svg.line({.x = x, .y = y}, {.x = x + 28, .y = y}, line.paint);
    if (line.paint.stroke == Ink::vermilion) {
      svg.line({.x = x, .y = y}, {.x = x + 28, .y = y}, {.stroke = Ink::paper, .width = 2.0});
    }
    svg.text({.x = x + 34, .y = y + 4}, line.words, kSmall);
    x += width + 20.0;
  }
}

std::string describe(const GraphModel& model) {
  return fmt::format(
      "{}. {} nodes, {} edges.", model.title, model.nodes.size(), model.edges.size());
}

std::vector<PixelPoint> moved(std::vector<PixelPoint> places, PixelPoint by) {
  for (PixelPoint& p : places) {
    p = p + by;
  }
  return places;
}

PixelBox moved(const PixelBox& box, PixelPoint by) {
  return {.left = box.left + by.x,
          .top = box.top + by.y,
          .right = box.right + by.x,
          .bottom = box.bottom + by.y};
}

}  // namespace

Picture draw_graph(const GraphModel& model) {
  const std::vector<PixelPoint> places = lay_out(digraph_of(model), distance_of(model));
  Svg svg;
  write_graph(svg, model, places);
  draw_legend(svg, model);
  return make_picture(model.name, model.title, describe(model), svg);
}

std::optional<Picture> draw_graphs(const std::vector<GraphModel>& models, std::string title) {
  if (models.empty()) {
    return std::nullopt;
  }
  const GraphModel& first = models.front();
  const std::vector<PixelPoint> places = lay_out(digraph_of(first), 0.8 * distance_of(first));
  // Drawn once, and used again by the others.
  GraphModel plain = first;
  for (ModelEdge& edge : plain.edges) {
    edge.stroke = EdgeStroke::background;
  }
  Svg alone;
  write_graph(alone, plain, places);
  PixelBox cell = alone.bounds().grown(10.0);
  for (const GraphModel& model : models) {
    Svg one;
    write_highlights(one, model, places);
    cell.add(one.bounds().grown(10.0));
  }
  const TextStyle style = {.ink = Ink::ink, .size = 12.0, .weight = Weight::bold};
  double width = cell.width();
  for (const GraphModel& model : models) {
    width = std::max(width, text_width(model.title, style.size, style.weight));
  }
  constexpr double kPage = 1000.0;
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor(kPage / (width + 20.0))));
  const std::string id = Svg::id("graph");
  const std::vector<Attribute> marks = {{"id", id}};
  PixelPoint first_place = {.x = 0.0, .y = 0.0};
  Svg svg;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const PixelPoint corner = {.x = static_cast<double>(i % columns) * (width + 20.0),
                               .y = static_cast<double>(i / columns) * (cell.height() + 40.0)};
    svg.open_group(models[i].title);
    svg.text(corner, models[i].title, style);
    const PixelPoint by = {.x = corner.x - cell.left, .y = corner.y + 14.0 - cell.top};
    if (i == 0) {
      first_place = by;
      svg.open_group({}, marks);
      write_graph(svg, plain, moved(places, by));
      svg.close_group();
    } else {
      svg.use(id, by - first_place, moved(alone.bounds(), by));
    }
    write_highlights(svg, models[i], moved(places, by));
    svg.close_group();
  }
  std::string words = fmt::format("{}: {} pictures of one graph.", title, models.size());
  return make_picture(first.name, std::move(title), std::move(words), svg);
}

}  // namespace kinestat
