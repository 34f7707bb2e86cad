// Which vertices are joined so far (union-find with path halving).
#pragma once

#include <numeric>
#include <vector>

namespace kinestat {

class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The smallest member of the set of v.
  int root(int v) {
    while (at(v) != v) {
      at(v) = at(at(v));
      v = at(v);
    }
    return v;
  }

  /// Joins the sets of a and b; false if they were one set already.
  bool join(int a, int b) {
    const int x = root(a);
    const int y = root(b);
    at(x < y ? y : x) = x < y ? x : y;
    return x != y;
  }

 private:
  int& at(int v) { return parent_[static_cast<std::size_t>(v)]; }

  std::vector<int> parent_;
};

}  // namespace kinestat
