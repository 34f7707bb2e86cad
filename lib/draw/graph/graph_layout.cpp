#include "draw/graph/graph_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "draw/line_grid.hpp"
#include "draw/symbols.hpp"

namespace kinestat {

namespace {

// Beyond this, the order on the circle stays that of the tree: nobody reads such a picture closely.
constexpr int kLargestOrdered = 40;

// Beyond this, nodes stand on a circle: what else could be done takes too long.
constexpr int kLargestLaidOut = 300;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

using Pair = std::pair<int, int>;

// Whether a point is nearer to the line from a to b than the radius.
bool is_covered(PixelPoint p, PixelPoint a, PixelPoint b, double radius) {
  const PixelPoint ab = b - a;
  const PixelPoint ap = p - a;
  const double square = ab.x * ab.x + ab.y * ab.y;
  const double aside = ab.x * ap.y - ab.y * ap.x;
  if (aside * aside >= radius * radius * square && square > 0.0) {
    return false;
  }
  const double share = square > 0.0 ? (ap.x * ab.x + ap.y * ab.y) / square : 0.0;
  return length_of(p - (a + std::clamp(share, 0.0, 1.0) * ab)) < radius;
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

// Crossings count most, edges across nodes more, long edges a little.
constexpr double kPriceOfCrossing = 3.0;
constexpr double kCovered = 10.0;

double price_of(const LayoutFaults& faults) {
  return kPriceOfCrossing * faults.crossings + kCovered * faults.covered_nodes;
}

// Not all of them once their price exceeds the limit.
LayoutFaults faults_of(const std::vector<Pair>& pairs,
                       const std::vector<PixelPoint>& places,
                       double node_radius,
                       double limit) {
  LayoutFaults faults;
  const auto at = [&places](int v) { return places[static_cast<std::size_t>(v)]; };
  for (std::size_t i = 0; i < pairs.size() && price_of(faults) <= limit; ++i) {
    const auto& [a, b] = pairs[i];
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [c, d] = pairs[j];
      const bool is_joined = a == c || a == d || b == c || b == d;
      if (!is_joined && do_cross(at(a), at(b), at(c), at(d))) {
        ++faults.crossings;
      }
    }
    for (int v = 0; v < static_cast<int>(places.size()); ++v) {
      if (v != a && v != b && is_covered(at(v), at(a), at(b), node_radius)) {
        ++faults.covered_nodes;
      }
    }
  }
  return faults;
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
    double least = cost(on_circle(order, middle), kNoLimit);
    bool is_better = static_cast<int>(order.size()) <= kLargestOrdered;
    while (is_better) {
      is_better = false;
      for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size(); ++j) {
          std::swap(order[i], order[j]);
          const double now = cost(on_circle(order, middle), least);
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

  // More than the limit where it would be, and then not all of it.
  double cost(const std::vector<PixelPoint>& places, double limit) const {
    const double price = price_of(faults_of(pairs_, places, 0.3 * distance_, limit));
    if (price > limit) {
      return price;
    }
    double length = 0.0;
    for (const Pair& pair : pairs_) {
      length += length_of(place(places, pair.first) - place(places, pair.second));
    }
    return price + length / distance_ / std::max<double>(1.0, static_cast<double>(pairs_.size()));
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
    const double now = cost(places, kNoLimit);
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
  return faults_of(pairs_of(graph), places, node_radius, kNoLimit);
}

}  // namespace kinestat
