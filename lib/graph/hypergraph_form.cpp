#include "graph/hypergraph_form.hpp"

#include <algorithm>
#include <cstddef>

namespace kinestat {

namespace {

constexpr std::uint8_t kUnnamed = 0xff;

class FormSearch {
 public:
  FormSearch(const std::vector<Hyperedge>& edges, int kept) : edges_(edges), used_(edges.size()) {
    int count = kept;
    for (const Hyperedge& edge : edges) {
      count = std::max(count, edge.back() + 1);
    }
    names_.assign(static_cast<std::size_t>(count), kUnnamed);
    for (int i = 0; i < kept; ++i) {
      names_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i);
    }
    next_ = static_cast<std::uint8_t>(kept);
    place(0);
  }

  HypergraphForm result() const {
    HypergraphForm form{.word = word_, .automorphisms = {}};
    std::vector<std::uint8_t> vertex_of(next_of_word_);
    for (std::size_t v = 0; v < names_.size(); ++v) {
      if (namings_.front()[v] != kUnnamed) {
        vertex_of[namings_.front()[v]] = static_cast<std::uint8_t>(v);
      }
    }
    for (const VertexMap& naming : namings_) {
      VertexMap& map = form.automorphisms.emplace_back();
      for (const std::uint8_t vertex : vertex_of) {
        map.push_back(naming[vertex]);
      }
    }
    std::ranges::sort(form.automorphisms);
    return form;
  }

 private:
  // How an edge reads by the names so far, if its other vertices are named next.
  Hyperedge reading(const Hyperedge& edge) const {
    Hyperedge read;
    std::uint8_t next = next_;
    for (const std::uint8_t vertex : edge) {
      read.push_back(names_[vertex] != kUnnamed ? names_[vertex] : next++);
    }
    std::ranges::sort(read);
    return read;
  }

  // Continues the word at a place with the edges that read least there.
  void place(std::size_t at) {
    if (at == edges_.size()) {
      namings_.push_back(names_);
      next_of_word_ = next_;
      return;
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (used_[i]) {
        continue;
      }
      Hyperedge read = reading(edges_[i]);
      const bool is_new = at == word_.size();
      const auto order = is_new ? std::strong_ordering::less : read <=> word_[at];
      if (order > 0) {
        continue;
      }
      if (order < 0) {
        word_.resize(at);
        word_.push_back(std::move(read));
        namings_.clear();
      }
      used_[i] = true;
      name_next(edges_[i], at);
      used_[i] = false;
    }
  }

  // Every order in which the vertices without a name may get one.
  void name_next(const Hyperedge& edge, std::size_t at) {
    bool has_unnamed = false;
    for (const std::uint8_t vertex : edge) {
      if (names_[vertex] == kUnnamed) {
        has_unnamed = true;
        names_[vertex] = next_++;
        name_next(edge, at);
        --next_;
        names_[vertex] = kUnnamed;
      }
    }
    if (!has_unnamed) {
      place(at + 1);
    }
  }

  const std::vector<Hyperedge>& edges_;
  std::vector<bool> used_;
  VertexMap names_;
  std::uint8_t next_ = 0;
  std::vector<Hyperedge> word_;
  std::vector<VertexMap> namings_;  // that give the word
  std::uint8_t next_of_word_ = 0;
};

}  // namespace

HypergraphForm canonical_form(const std::vector<Hyperedge>& edges, int kept) {
  return FormSearch(edges, kept).result();
}

}  // namespace kinestat
