#include "graph/strong_components.hpp"

#include <algorithm>

namespace kinestat {

namespace {

constexpr int kUnseen = -1;

// Tarjan's search, with a stack of its own instead of recursion: graphs may be long.
class StrongSearch {
 public:
  explicit StrongSearch(const Digraph& graph)
      : heads_(static_cast<std::size_t>(graph.vertex_count)),
        order_(heads_.size(), kUnseen),
        low_(heads_.size(), 0),
        is_open_(heads_.size(), false) {
    for (const Edge& edge : graph.edges) {
      heads_[static_cast<std::size_t>(edge.tail)].push_back(edge.head);
    }
  }

  std::vector<std::vector<int>> run() {
    for (std::size_t v = 0; v < heads_.size(); ++v) {
      if (order_[v] == kUnseen) {
        search_from(static_cast<int>(v));
      }
    }
    std::ranges::sort(parts_);
    return std::move(parts_);
  }

 private:
  struct Step {
    int vertex = 0;
    std::size_t next = 0;  ///< edge to follow
  };

  void search_from(int root) {
    enter(root);
    while (!path_.empty()) {
      Step& step = path_.back();
      const auto v = static_cast<std::size_t>(step.vertex);
      if (step.next < heads_[v].size()) {
        follow(v, heads_[v][step.next++]);
      } else {
        leave(v);
      }
    }
  }

  void enter(int vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    order_[v] = low_[v] = count_++;
    is_open_[v] = true;
    open_.push_back(vertex);
    path_.push_back({.vertex = vertex, .next = 0});
  }

  void follow(std::size_t v, int head) {
    const auto h = static_cast<std::size_t>(head);
    if (order_[h] == kUnseen) {
      enter(head);
    } else if (is_open_[h]) {
      low_[v] = std::min(low_[v], order_[h]);
    }
  }

  void leave(std::size_t v) {
    path_.pop_back();
    if (!path_.empty()) {
      const auto before = static_cast<std::size_t>(path_.back().vertex);
      low_[before] = std::min(low_[before], low_[v]);
    }
    if (low_[v] == order_[v]) {
      take_part(static_cast<int>(v));
    }
  }

  // All that is open from the vertex on.
  void take_part(int first) {
    const auto begin = std::ranges::find(open_, first);
    std::vector<int> part(begin, open_.end());
    open_.erase(begin, open_.end());
    for (const int vertex : part) {
      is_open_[static_cast<std::size_t>(vertex)] = false;
    }
    if (part.size() > 1) {
      std::ranges::sort(part);
      parts_.push_back(std::move(part));
    }
  }

  std::vector<std::vector<int>> heads_;  // of the edges of each vertex
  std::vector<int> order_;               // in which vertices were met
  std::vector<int> low_;                 // the earliest open vertex that is reached
  std::vector<bool> is_open_;
  std::vector<int> open_;
  std::vector<Step> path_;
  std::vector<std::vector<int>> parts_;
  int count_ = 0;
};

}  // namespace

std::vector<std::vector<int>> find_strong_components(const Digraph& graph) {
  return StrongSearch(graph).run();
}

}  // namespace kinestat
