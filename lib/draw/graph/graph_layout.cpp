#include "draw/graph/graph_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "draw/symbols.hpp"

namespace kinestat {

namespace {

// Beyond this, the order on the circle stays that of the tree: nobody reads such a picture closely.
constexpr int kLargestOrdered = 40;

// Beyond this, nodes stand on a circle: what else could be done takes too long.
constexpr int kLargestLaidOut = 300;

using Pair = std::pair<int, int>;

double cross(PixelPoint a, PixelPoint b) {
  return a.x * b.y - a.y * b.x;
}

bool do_cross(PixelPoint a, PixelPoint b, PixelPoint c, PixelPoint d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  return c_side * d_side < 0.0 && a_side * b_side < 0.0;
}

double distance_to_segment(PixelPoint p, PixelPoint a, PixelPoint b) {
  const PixelPoint ab = b - a;
  const PixelPoint ap = p - a;
  const double square = ab.x * ab.x + ab.y * ab.y;
  const double share = square > 0.0 ? (ap.x * ab.x + ap.y * ab.y) / square : 0.0;
  return length_of(p - (a + std::clamp(share, 0.0, 1.0) * ab));
}

// Neighbours once each, whatever the direction and the number of edges.
std::vector<Pair> pairs_of(const Digraph& graph) {
  std::set<Pair> pairs;
  for (const Edge& edge : graph.edges) {
    if (edge.tail != edge.head) {
      pairs.insert({std::min(edge.tail, edge.head), std::max(edge.tail, edge.head)});
    }
  }
  return {pairs.begin(), pairs.end()};
}

class LayoutFinder {
 public:
  LayoutFinder(const Digraph& graph, double distance)
      : graph_(graph), distance_(distance), pairs_(pairs_of(graph)) {}

  std::vector<PixelPoint> find() {
    const int n = graph_.vertex_count;
    if (n < 3 || n > kLargestLaidOut) {
      return on_circle(all_vertices(), std::nullopt);
    }
    consider(best_circle(all_vertices(), std::nullopt));
    if (n > 4) {
      std::vector<int> others = all_vertices();
      others.erase(others.begin());
      consider(best_circle(others, 0));
    }
    const std::vector<PixelPoint> start = best_;
    consider(relaxed(start));
    return best_;
  }

 private:
  std::vector<int> all_vertices() const {
    // By depth-first search, so that neighbours come beside each other.
    std::vector<int> order;
    std::vector<bool> is_seen(static_cast<std::size_t>(graph_.vertex_count), false);
    std::vector<int> waiting;
    for (int v = graph_.vertex_count - 1; v >= 0; --v) {
      waiting.push_back(v);
    }
    while (!waiting.empty()) {
      const int v = waiting.back();
      waiting.pop_back();
      if (is_seen[static_cast<std::size_t>(v)]) {
        continue;
      }
      is_seen[static_cast<std::size_t>(v)] = true;
      order.push_back(v);
      for (auto pair = pairs_.rbegin(); pair != pairs_.rend(); ++pair) {
        if (pair->first == v || pair->second == v) {
          waiting.push_back(pair->first == v ? pair->second : pair->first);
        }
      }
    }
    return order;
  }

  // The first of the order at the bottom, which is where the ground is looked for.
  std::vector<PixelPoint> on_circle(const std::vector<int>& order,
                                    std::optional<int> middle) const {
    constexpr double kWider = 1.2;
    const auto count = static_cast<double>(order.size());
    const double least = middle ? 1.25 : 0.6;
    const double radius =
        distance_ * std::max(least, 0.5 / std::sin(std::numbers::pi / std::max(2.0, count)));
    std::vector<PixelPoint> places(static_cast<std::size_t>(graph_.vertex_count));
    for (std::size_t i = 0; i < order.size(); ++i) {
      const double angle =
          std::numbers::pi / 2 + 2 * std::numbers::pi * static_cast<double>(i) / count;
      places[static_cast<std::size_t>(order[i])] = {.x = kWider * radius * std::cos(angle),
                                                    .y = radius * std::sin(angle)};
    }
    return places;
  }

  std::vector<PixelPoint> best_circle(std::vector<int> order, std::optional<int> middle) const {
    double least = cost(on_circle(order, middle));
    bool is_better = static_cast<int>(order.size()) <= kLargestOrdered;
    while (is_better) {
      is_better = false;
      for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size(); ++j) {
          std::swap(order[i], order[j]);
          const double now = cost(on_circle(order, middle));
          if (now < least * 0.999) {
            least = now;
            is_better = true;
          } else {
            std::swap(order[i], order[j]);
          }
        }
      }
    }
    return on_circle(order, middle);
  }

  // Crossings count most, edges across nodes more, long edges a little.
  double cost(const std::vector<PixelPoint>& places) const {
    constexpr double kPriceOfCrossing = 3.0;
    constexpr double kCovered = 10.0;
    const LayoutFaults faults = find_faults(graph_, places, 0.3 * distance_);
    double length = 0.0;
    for (const Pair& pair : pairs_) {
      length += length_of(place(places, pair.first) - place(places, pair.second));
    }
    return kPriceOfCrossing * faults.crossings + kCovered * faults.covered_nodes +
           length / distance_ / std::max<double>(1.0, static_cast<double>(pairs_.size()));
  }

  static PixelPoint place(const std::vector<PixelPoint>& places, int vertex) {
    return places[static_cast<std::size_t>(vertex)];
  }

  // Nodes push each other off, edges pull, for a fixed number of steps that become smaller
  // (Fruchterman and Reingold 1991).
  std::vector<PixelPoint> relaxed(std::vector<PixelPoint> places) const {
    constexpr int kSteps = 300;
    const double ideal = 1.1 * distance_;
    for (int step = 0; step < kSteps; ++step) {
      std::vector<PixelPoint> push(places.size());
      for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const PixelPoint between = places[i] - places[j];
          const double length = std::max(1.0, length_of(between));
          const PixelPoint force = (ideal * ideal / length / length) * between;
          push[i] = push[i] + force;
          push[j] = push[j] - force;
        }
      }
      for (const auto& [a, b] : pairs_) {
        const PixelPoint between = place(places, a) - place(places, b);
        const PixelPoint force = (length_of(between) / ideal) * between;
        push[static_cast<std::size_t>(a)] = push[static_cast<std::size_t>(a)] - force;
        push[static_cast<std::size_t>(b)] = push[static_cast<std::size_t>(b)] + force;
      }
      const double longest = 0.2 * ideal * (1.0 - static_cast<double>(step) / kSteps);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double length = length_of(push[i]);
        places[i] = places[i] + (std::min(length, longest) / std::max(1.0, length)) * push[i];
      }
    }
    return spread(std::move(places));
  }

  // So large that the two nodes that are closest keep the distance.
  std::vector<PixelPoint> spread(std::vector<PixelPoint> places) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        least = std::min(least, length_of(places[i] - places[j]));
      }
    }
    for (PixelPoint& p : places) {
      p = (distance_ / std::max(1.0, least)) * p;
    }
    return places;
  }

  void consider(std::vector<PixelPoint> places) {
    const double now = cost(places);
    if (best_.empty() || now < least_) {
      best_ = std::move(places);
      least_ = now;
    }
  }

  const Digraph& graph_;
  double distance_;
  std::vector<Pair> pairs_;
  std::vector<PixelPoint> best_;
  double least_ = 0.0;
};

}  // namespace

std::vector<PixelPoint> lay_out(const Digraph& graph, double distance) {
  return LayoutFinder(graph, distance).find();
}

LayoutFaults find_faults(const Digraph& graph,
                         const std::vector<PixelPoint>& places,
                         double node_radius) {
  LayoutFaults faults;
  const std::vector<Pair> pairs = pairs_of(graph);
  const auto at = [&places](int v) { return places[static_cast<std::size_t>(v)]; };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [a, b] = pairs[i];
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [c, d] = pairs[j];
      const bool is_joined = a == c || a == d || b == c || b == d;
      if (!is_joined && do_cross(at(a), at(b), at(c), at(d))) {
        ++faults.crossings;
      }
    }
    for (int v = 0; v < graph.vertex_count; ++v) {
      if (v != a && v != b && distance_to_segment(at(v), at(a), at(b)) < node_radius) {
        ++faults.covered_nodes;
      }
    }
  }
  return faults;
}

}  // namespace kinestat
