#include "graph/planarity.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace kinestat {

namespace {

using Vertices = std::uint32_t;  // as bits
using Adjacency = std::array<Vertices, kMostPlanarVertices>;
using Path = std::vector<int>;

Vertices bit(int vertex) {
  return Vertices{1} << static_cast<unsigned>(vertex);
}

int last_of(Vertices some) {
  return static_cast<int>(std::bit_width(some)) - 1;
}

Vertices& at(Adjacency& graph, int vertex) {
  return graph[static_cast<std::size_t>(vertex)];
}

Vertices at(const Adjacency& graph, int vertex) {
  return graph[static_cast<std::size_t>(vertex)];
}

void join(Adjacency& graph, int a, int b) {
  at(graph, a) |= bit(b);
  at(graph, b) |= bit(a);
}

void cut(Adjacency& graph, int a, int b) {
  at(graph, a) &= ~bit(b);
  at(graph, b) &= ~bit(a);
}

// Takes away ends, and vertices between two others: neither changes whether a graph is planar.
void reduce(Adjacency& graph) {
  for (bool changes = true; changes;) {
    changes = false;
    for (int v = 0; v < kMostPlanarVertices; ++v) {
      const Vertices others = at(graph, v);
      const int degree = std::popcount(others);
      if (degree == 0 || degree > 2) {
        continue;
      }
      const int a = std::countr_zero(others);
      const int b = last_of(others);
      cut(graph, v, a);
      cut(graph, v, b);
      if (a != b) {
        join(graph, a, b);
      }
      changes = true;
    }
  }
}

// The blocks of a graph, each without the edges of the others.
class Blocks {
 public:
  explicit Blocks(const Adjacency& graph) : graph_(graph) {
    for (int v = 0; v < kMostPlanarVertices; ++v) {
      if (at(graph_, v) != 0 && order_[static_cast<std::size_t>(v)] == 0) {
        visit(v, -1);
      }
    }
  }

  const std::vector<Adjacency>& all() const { return found_; }

 private:
  int visit(int v, int parent) {
    const int mine = order_[static_cast<std::size_t>(v)] = ++count_;
    int low = mine;
    for (Vertices rest = at(graph_, v); rest != 0; rest &= rest - 1) {
      const int w = std::countr_zero(rest);
      const int its = order_[static_cast<std::size_t>(w)];
      if (its == 0) {
        const std::size_t first = edges_.size();
        edges_.push_back({v, w});
        const int below = visit(w, v);
        low = std::min(low, below);
        if (below >= mine) {
          Adjacency& block = found_.emplace_back();
          for (std::size_t i = first; i < edges_.size(); ++i) {
            join(block, edges_[i][0], edges_[i][1]);
          }
          edges_.resize(first);
        }
      } else if (w != parent && its < mine) {
        edges_.push_back({v, w});
        low = std::min(low, its);
      }
    }
    return low;
  }

  const Adjacency& graph_;
  std::array<int, kMostPlanarVertices> order_{};
  int count_ = 0;
  std::vector<std::array<int, 2>> edges_;
  std::vector<Adjacency> found_;
};

// Draws a block path by path into its faces.
class Drawing {
 public:
  explicit Drawing(const Adjacency& block) : left_(block) {}

  bool is_possible() {
    draw_circuit();
    while (true) {
      Fragment next;
      std::size_t fewest = faces_.size() + 1;
      bool has_fragment = false;
      for (const Fragment& fragment : fragments()) {
        std::size_t count = 0;
        std::size_t last = 0;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
          if ((fragment.contacts & ~mask_of(faces_[f])) == 0) {
            ++count;
            last = f;
          }
        }
        if (count < fewest) {
          fewest = count;
          next = fragment;
          next.face = last;
        }
        has_fragment = true;
      }
      if (!has_fragment || fewest == 0) {
        return !has_fragment;
      }
      draw_path(path_through(next), next.face);
    }
  }

 private:
  // What hangs together of the rest: an edge between drawn vertices, or vertices with the drawn
  // ones that they reach.
  struct Fragment {
    Vertices inner = 0;
    Vertices contacts = 0;
    std::size_t face = 0;
  };

  static Vertices mask_of(const Path& face) {
    Vertices mask = 0;
    for (const int v : face) {
      mask |= bit(v);
    }
    return mask;
  }

  void draw_circuit() {
    // From any vertex on, never back at once, until one is met again: every vertex has two others.
    Path path = {static_cast<int>(
        std::ranges::find_if(left_, [](Vertices others) { return others != 0; }) - left_.begin())};
    Vertices seen = bit(path.front());
    for (int before = -1;;) {
      const Vertices others = at(left_, path.back()) & ~(before >= 0 ? bit(before) : 0);
      const int next = std::countr_zero(others);
      if ((seen & bit(next)) != 0) {
        path.erase(path.begin(), std::ranges::find(path, next));
        break;
      }
      before = path.back();
      path.push_back(next);
      seen |= bit(next);
    }
    drawn_ = mask_of(path);
    for (std::size_t i = 0; i < path.size(); ++i) {
      cut(left_, path[i], path[(i + 1) % path.size()]);
    }
    faces_ = {path, path};
  }

  std::vector<Fragment> fragments() const {
    std::vector<Fragment> result;
    Vertices known = drawn_;
    for (int v = 0; v < kMostPlanarVertices; ++v) {
      if ((drawn_ & bit(v)) != 0) {
        for (Vertices rest = at(left_, v) & drawn_ & ~(bit(v) - 1); rest != 0; rest &= rest - 1) {
          result.push_back({.contacts = bit(v) | (rest & -rest)});
        }
      } else if ((known & bit(v)) == 0 && at(left_, v) != 0) {
        Fragment fragment{.inner = bit(v)};
        for (Vertices reached = at(left_, v); reached != 0;) {
          const int w = std::countr_zero(reached);
          reached &= reached - 1;
          if ((drawn_ & bit(w)) != 0) {
            fragment.contacts |= bit(w);
          } else if ((fragment.inner & bit(w)) == 0) {
            fragment.inner |= bit(w);
            reached |= at(left_, w);
          }
        }
        known |= fragment.inner;
        result.push_back(fragment);
      }
    }
    return result;
  }

  // From one drawn vertex of a fragment through it to another.
  Path path_through(const Fragment& fragment) const {
    const int start = std::countr_zero(fragment.contacts);
    if (fragment.inner == 0) {
      return {start, last_of(fragment.contacts)};
    }
    std::array<int, kMostPlanarVertices> before{};
    Path queue;
    Vertices seen = 0;
    const auto reach = [&](int from, Vertices others) {
      for (Vertices rest = others & ~seen; rest != 0; rest &= rest - 1) {
        const int w = std::countr_zero(rest);
        before[static_cast<std::size_t>(w)] = from;
        queue.push_back(w);
      }
      seen |= others;
    };
    reach(start, at(left_, start) & fragment.inner);
    for (std::size_t i = 0;; ++i) {
      const int v = queue[i];
      const Vertices ends = at(left_, v) & fragment.contacts & ~bit(start);
      if (ends != 0) {
        Path path = {std::countr_zero(ends)};
        for (int w = v; w != start; w = before[static_cast<std::size_t>(w)]) {
          path.push_back(w);
        }
        path.push_back(start);
        return path;
      }
      reach(v, at(left_, v) & fragment.inner);
    }
  }

  void draw_path(const Path& path, std::size_t face) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      cut(left_, path[i], path[i + 1]);
    }
    drawn_ |= mask_of(path);
    Path around = faces_[face];
    std::rotate(around.begin(), std::ranges::find(around, path.front()), around.end());
    const auto end = std::ranges::find(around, path.back());
    // One face: along the border to the end of the path and back on it; the other: the rest.
    Path one(around.begin(), end);
    one.insert(one.end(), path.rbegin(), path.rend() - 1);
    Path other(path.begin(), path.end() - 1);
    other.insert(other.end(), end, around.end());
    faces_[face] = one;
    faces_.push_back(other);
  }

  Adjacency left_;  // edges that are not drawn
  Vertices drawn_ = 0;
  std::vector<Path> faces_;
};

}  // namespace

bool is_planar(int vertices, std::span<const std::array<std::uint8_t, 2>> edges) {
  Adjacency graph{};
  for (const auto& [a, b] : edges) {
    if (a != b && a < vertices && b < vertices) {
      join(graph, a, b);
    }
  }
  reduce(graph);
  const Blocks blocks(graph);
  return std::ranges::all_of(blocks.all(), [](const Adjacency& block) {
    int edge_ends = 0;
    int count = 0;
    for (const Vertices others : block) {
      edge_ends += std::popcount(others);
      count += others != 0 ? 1 : 0;
    }
    return count < 5 || (edge_ends <= 6 * count - 12 && Drawing(block).is_possible());
  });
}

}  // namespace kinestat
