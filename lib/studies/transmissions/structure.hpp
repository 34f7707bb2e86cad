// Structures of planetary transmissions: which terminals of the sets are on one shaft.
//
// Shafts are points of an affine space, a set is three of them in a line (the lever), the motions
// of the train are the affine functions. A gear merges shafts, which projects the levers along what
// joins them, until one lever is left: its diagram.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "graph/hypergraph_form.hpp"

namespace kinestat {

using Shaft = std::uint8_t;

inline constexpr Shaft kHousing = 0;
inline constexpr Shaft kInput = 1;
inline constexpr Shaft kOutput = 2;

/// What the search is made for: its tables grow with the powers of these.
inline constexpr int kMostGearSets = 4;
inline constexpr int kMostElements = 7;
inline constexpr int kMostEngaged = 4;

/// The three shafts of a planetary set, ascending, whichever is sun, carrier and ring.
using SetShafts = std::array<Shaft, 3>;

/// A structure up to the order of its sets and of their terminals, as its canonical word. Housing,
/// input and output are shafts 0, 1 and 2; those that only elements touch are the last.
struct TransmissionStructure {
  int shafts = 0;
  std::vector<SetShafts> sets;
  std::vector<VertexMap> automorphisms;  ///< of the shafts; they keep housing, input and output

  int set_count() const { return static_cast<int>(sets.size()); }
};

/// All structures in the order of their words, which numbers them. The transmission has one freedom
/// in a gear: sets + engaged + 2 shafts. Left out are blocks: q sets on fewer than q + 2 shafts
/// turn as one, or one of their equations says nothing (Lorea 1975).
std::vector<TransmissionStructure> enumerate_structures(int sets, int engaged, int free_shafts);

}  // namespace kinestat
