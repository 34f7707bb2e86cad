#include "studies/transmissions/structure.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

namespace kinestat {

namespace {

constexpr int kMarks = 3;  // housing, input, output

std::vector<Hyperedge> edges_of(const std::vector<SetShafts>& sets) {
  std::vector<Hyperedge> edges;
  for (const SetShafts& set : sets) {
    edges.emplace_back(set.begin(), set.end());
  }
  return edges;
}

// Words grow by a set: what a canonical word begins with is canonical, and sets ascend in it.
class StructureSearch {
 public:
  StructureSearch(int sets, int engaged, int free_shafts)
      : set_count_(static_cast<std::size_t>(sets)),
        shafts_(sets + engaged + 2),
        touched_(shafts_ - free_shafts) {
    extend(kMarks);
  }

  std::vector<TransmissionStructure> take() { return std::move(found_); }

 private:
  void extend(int named) {
    const int left = static_cast<int>(set_count_ - sets_.size());
    if (named > touched_ || named + 3 * left < touched_) {
      return;
    }
    if (left == 0) {
      add();
      return;
    }
    for (int a = 0; a <= named; ++a) {
      for (int b = a + 1; b <= std::max(a, named - 1) + 1; ++b) {
        for (int c = b + 1; c <= std::max(b, named - 1) + 1; ++c) {
          add_set({static_cast<Shaft>(a), static_cast<Shaft>(b), static_cast<Shaft>(c)}, named);
        }
      }
    }
  }

  void add_set(const SetShafts& set, int named) {
    if (!sets_.empty() && set <= sets_.back()) {
      return;
    }
    sets_.push_back(set);
    if (!has_block() && is_canonical()) {
      extend(std::max(named, set[2] + 1));
    }
    sets_.pop_back();
  }

  // Among the choices of sets that have the last.
  bool has_block() const {
    const std::size_t others = sets_.size() - 1;
    for (std::size_t choice = 0; choice < std::size_t{1} << others; ++choice) {
      std::uint32_t shafts = 0;
      for (std::size_t s = 0; s < sets_.size(); ++s) {
        if (s == others || (choice >> s & 1U) != 0) {
          shafts |= 1U << sets_[s][0] | 1U << sets_[s][1] | 1U << sets_[s][2];
        }
      }
      if (std::popcount(shafts) < std::popcount(choice) + 3) {
        return true;
      }
    }
    return false;
  }

  bool is_canonical() const {
    const std::vector<Hyperedge> edges = edges_of(sets_);
    return canonical_form(edges, kMarks).word == edges;
  }

  void add() {
    TransmissionStructure structure{.shafts = shafts_, .sets = sets_, .automorphisms = {}};
    structure.automorphisms = canonical_form(edges_of(sets_), kMarks).automorphisms;
    for (VertexMap& map : structure.automorphisms) {
      for (int free = touched_; free < shafts_; ++free) {
        map.push_back(static_cast<Shaft>(free));
      }
    }
    found_.push_back(std::move(structure));
  }

  std::size_t set_count_;
  int shafts_;
  int touched_;  // shafts with a set or a mark
  std::vector<SetShafts> sets_;
  std::vector<TransmissionStructure> found_;
};

}  // namespace

std::vector<TransmissionStructure> enumerate_structures(int sets, int engaged, int free_shafts) {
  return StructureSearch(sets, engaged, free_shafts).take();
}

}  // namespace kinestat
