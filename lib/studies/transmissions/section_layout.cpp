#include "studies/transmissions/section_layout.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "graph/planarity.hpp"

namespace kinestat {

namespace {

// Shafts by their numbers, as bits.
using ShaftMask = std::uint32_t;

ShaftMask bit(Shaft shaft) {
  return ShaftMask{1} << shaft;
}

// The graph of a section. From the axis, or from its sun, a set leads outwards to its ring. A shaft
// that several sets cross so is cut into a chain of pieces, one a set; its other edges are tried at
// each of them.
class SectionGraph {
 public:
  // Nothing passes between the axis and the suns of solid shafts.
  SectionGraph(const TransmissionStructure& structure,
               const RoleChoice& choice,
               SectionLayout layout,
               ShaftMask solid)
      : vertices_(structure.shafts) {
    for (int s = 0; s < structure.set_count(); ++s) {
      const SetShafts& shafts = structure.sets[static_cast<std::size_t>(s)];
      const SetRoles roles = set_roles(choice.roles_of(s));
      const Shaft sun = shafts[roles.sun];
      const End carrier = add_piece(shafts[roles.carrier]);
      const bool is_solid = (solid & bit(sun)) != 0;
      const End inner = is_solid ? add_piece(sun) : End{.shaft = sun};
      join(inner, carrier);
      join(carrier, {.shaft = shafts[roles.ring]});
      if (is_solid) {
        join({.shaft = kAxis}, inner);
      }
    }
    std::ranges::for_each(pieces_, [](auto& pieces) { std::ranges::sort(pieces); });
    layout == SectionLayout::coaxial ? add_coaxial_ends(solid != 0) : add_sideways_ends();
  }

  void add(Shaft a, Shaft b) { join({.shaft = a}, {.shaft = b}); }

  bool is_planar() {
    std::ranges::stable_sort(edges_, {}, [this](const auto& edge) {
      return ends_at(edge.from).size() * ends_at(edge.to).size();
    });
    return order_pieces(0);
  }

 private:
  static constexpr Shaft kAxis = 0xfe;
  static constexpr Shaft kBorder = 0xff;  // of the section where shafts leave it
  static constexpr int kAnyPiece = -1;

  using Edge = std::array<std::uint8_t, 2>;

  // A shaft, at one of its pieces.
  struct End {
    Shaft shaft = 0;
    int piece = kAnyPiece;
  };

  struct OpenEdge {
    End from;
    End to;
  };

  void join(const End& from, const End& to) { edges_.push_back({.from = from, .to = to}); }

  // Housing, input and output border the axis. What reaches it does so between input and output, on
  // the other side of which the housing is.
  void add_coaxial_ends(bool is_reached) {
    for (const Shaft shaft : {kHousing, kInput, kOutput}) {
      add(shaft, is_reached ? kBorder : kAxis);
    }
    if (is_reached) {
      add(kBorder, kAxis);
      for (const Shaft shaft : {kInput, kOutput}) {
        add(shaft, kAxis);
        add(shaft, kHousing);
      }
    }
  }

  void add_sideways_ends() {
    for (const Shaft shaft : {kInput, kOutput, kAxis}) {
      add(kHousing, shaft);
    }
  }

  End add_piece(Shaft shaft) {
    auto& pieces = pieces_[shaft];
    const int piece = pieces.empty() ? shaft : vertices_++;
    pieces.push_back(piece);
    return {.shaft = shaft, .piece = piece};
  }

  // Whether some order of the pieces of all shafts from this one on can be drawn.
  bool order_pieces(std::size_t shaft) {
    if (shaft == pieces_.size()) {
      std::vector<Edge> edges;
      for (const auto& pieces : pieces_) {
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
          edges.push_back(
              {static_cast<std::uint8_t>(pieces[i]), static_cast<std::uint8_t>(pieces[i + 1])});
        }
      }
      return place(0, edges);
    }
    auto& pieces = pieces_[shaft];
    bool is_possible = false;
    do {
      // A chain read backwards is the same.
      is_possible =
          (pieces.size() < 2 || pieces.front() < pieces.back()) && order_pieces(shaft + 1);
    } while (!is_possible && std::ranges::next_permutation(pieces).found);
    std::ranges::sort(pieces);
    return is_possible;
  }

  // Ends the edges from `at` on at all pieces in turn; they come with fewer ways first.
  bool place(std::size_t at, std::vector<Edge>& edges) const {
    const bool is_last = at == edges_.size();
    const std::vector<int> starts = is_last ? std::vector<int>() : ends_at(edges_[at].from);
    const std::vector<int> ends = is_last ? std::vector<int>() : ends_at(edges_[at].to);
    const bool has_ways = starts.size() * ends.size() != 1;
    if (has_ways && !kinestat::is_planar(vertices_ + 2, edges)) {
      return false;
    }
    for (const int a : starts) {
      for (const int b : ends) {
        edges.push_back({static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)});
        const bool is_possible = place(at + 1, edges);
        edges.pop_back();
        if (is_possible) {
          return true;
        }
      }
    }
    return is_last;
  }

  std::vector<int> ends_at(const End& end) const {
    if (end.shaft == kAxis || end.shaft == kBorder) {
      return {end.shaft == kAxis ? vertices_ : vertices_ + 1};
    }
    const auto& pieces = pieces_[end.shaft];
    return end.piece != kAnyPiece ? std::vector{end.piece}
           : pieces.empty()       ? std::vector<int>{end.shaft}
                                  : pieces;
  }

  int vertices_;
  std::array<std::vector<int>, kMostShafts> pieces_;  // of the shafts that sets cross
  std::vector<OpenEdge> edges_;
};

bool can_be_drawn(const TransmissionStructure& structure,
                  const RoleChoice& choice,
                  const ElementPlacement& elements,
                  SectionLayout layout,
                  ShaftMask solid) {
  SectionGraph graph(structure, choice, layout, solid);
  for (const ShaftPair& pair : elements) {
    graph.add(pair[0], pair[1]);
  }
  return graph.is_planar();
}

}  // namespace

bool can_be_arranged(const TransmissionStructure& structure,
                     const RoleChoice& choice,
                     const ElementPlacement& elements,
                     SectionLayout layout) {
  return layout == SectionLayout::any || can_be_drawn(structure, choice, elements, layout, 0);
}

std::optional<std::uint64_t> least_hollow_shafts(const TransmissionStructure& structure,
                                                 const RoleChoice& choice,
                                                 const ElementPlacement& elements,
                                                 SectionLayout layout) {
  if (layout == SectionLayout::any) {
    return std::nullopt;
  }
  ShaftMask suns = 0;
  for (int s = 0; s < structure.set_count(); ++s) {
    suns |= bit(structure.sets[static_cast<std::size_t>(s)][set_roles(choice.roles_of(s)).sun]);
  }
  suns &= ~bit(kHousing);
  int least = std::popcount(suns);
  // All subsets, as a count down under the mask.
  for (ShaftMask solid = suns; solid != 0; solid = (solid - 1) & suns) {
    const int hollow = std::popcount(suns ^ solid);
    if (hollow < least && can_be_drawn(structure, choice, elements, layout, solid)) {
      least = hollow;
    }
  }
  return static_cast<std::uint64_t>(least);
}

}  // namespace kinestat
