#include "studies/transmissions/section_layout.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "graph/planarity.hpp"

namespace kinestat {

namespace {

// The graph of a section. A carrier of several sets is cut into a chain of pieces, one a set; its
// other edges are tried at each of them.
class SectionGraph {
 public:
  SectionGraph(const TransmissionStructure& structure, const RoleChoice& choice)
      : vertices_(structure.shafts) {
    for (int s = 0; s < structure.set_count(); ++s) {
      const SetShafts& shafts = structure.sets[static_cast<std::size_t>(s)];
      const SetRoles roles = set_roles(choice.roles_of(s));
      const Shaft carrier = shafts[roles.carrier];
      const int piece = add_piece(carrier);
      pieces_of_sets_.push_back({piece, shafts[roles.sun]});
      pieces_of_sets_.push_back({piece, shafts[roles.ring]});
    }
    std::ranges::for_each(pieces_, [](auto& pieces) { std::ranges::sort(pieces); });
  }

  void add(Shaft a, Shaft b) { edges_.push_back({a, b}); }

  // A vertex that housing, input and output border.
  void add_axis() {
    for (const Shaft shaft : {kHousing, kInput, kOutput}) {
      edges_.push_back({shaft, kAxis});
    }
  }

  bool is_planar() {
    order_pieces(0);
    return found_;
  }

 private:
  static constexpr Shaft kAxis = 0xff;

  using Edge = std::array<std::uint8_t, 2>;

  // Half of an edge that is open: a piece, and a shaft of which the piece is to be chosen.
  struct FromPiece {
    int piece = 0;
    Shaft shaft = 0;
  };

  int add_piece(Shaft carrier) {
    auto& pieces = pieces_[carrier];
    const int piece = pieces.empty() ? carrier : vertices_++;
    pieces.push_back(piece);
    return piece;
  }

  void order_pieces(std::size_t carrier) {
    if (carrier == pieces_.size()) {
      std::vector<Edge> edges;
      for (const auto& pieces : pieces_) {
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
          edges.push_back(
              {static_cast<std::uint8_t>(pieces[i]), static_cast<std::uint8_t>(pieces[i + 1])});
        }
      }
      place(0, edges);
      return;
    }
    auto& pieces = pieces_[carrier];
    do {
      // A chain read backwards is the same.
      if (pieces.size() < 2 || pieces.front() < pieces.back()) {
        order_pieces(carrier + 1);
      }
    } while (!found_ && std::ranges::next_permutation(pieces).found);
    std::ranges::sort(pieces);
  }

  // Ends the edges from `at` on at all pieces in turn.
  void place(std::size_t at, std::vector<Edge>& edges) {
    const std::size_t of_sets = pieces_of_sets_.size();
    if (at == of_sets + edges_.size()) {
      found_ = kinestat::is_planar(vertices_ + 1, edges);
      return;
    }
    const bool is_of_set = at < of_sets;
    const Edge edge = is_of_set ? Edge{} : edges_[at - of_sets];
    const std::vector<int> starts =
        is_of_set ? std::vector{pieces_of_sets_[at].piece} : ends_at(edge[0]);
    const std::vector<int> ends = ends_at(is_of_set ? pieces_of_sets_[at].shaft : edge[1]);
    for (const int a : starts) {
      for (const int b : ends) {
        edges.push_back({static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)});
        place(at + 1, edges);
        edges.pop_back();
        if (found_) {
          return;
        }
      }
    }
  }

  std::vector<int> ends_at(Shaft shaft) const {
    if (shaft == kAxis) {
      return {vertices_};
    }
    const auto& pieces = pieces_[shaft];
    return pieces.empty() ? std::vector<int>{shaft} : pieces;
  }

  int vertices_;
  std::array<std::vector<int>, kMostShafts> pieces_;  // of the carriers
  std::vector<FromPiece> pieces_of_sets_;
  std::vector<Edge> edges_;
  bool found_ = false;
};

}  // namespace

bool can_be_arranged(const TransmissionStructure& structure,
                     const RoleChoice& choice,
                     const ElementPlacement& elements,
                     SectionLayout layout) {
  if (layout == SectionLayout::any) {
    return true;
  }
  SectionGraph graph(structure, choice);
  for (const ShaftPair& pair : elements) {
    graph.add(pair[0], pair[1]);
  }
  if (layout == SectionLayout::coaxial) {
    graph.add_axis();
  } else {
    graph.add(kHousing, kInput);
    graph.add(kHousing, kOutput);
  }
  return graph.is_planar();
}

}  // namespace kinestat
