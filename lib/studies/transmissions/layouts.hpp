// Layouts: where the shift elements of a structure are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "studies/transmissions/generic_train.hpp"

namespace kinestat {

/// A gear of a layout.
struct LayoutGear {
  std::uint32_t state = 0;    ///< of the generic train
  std::uint8_t elements = 0;  ///< engaged, as bits by their place in the layout
};

/// A structure with the classes of its elements.
struct TransmissionLayout {
  ClassMask classes = 0;
  std::vector<LayoutGear> gears;           ///< all of them, whatever a ladder needs
  int distinct_gears = 0;                  ///< of different ratio
  std::vector<std::size_t> automorphisms;  ///< of those of the structure, which keep it
};

/// All layouts of that many classes, up to the automorphisms of the structure, with so many gears
/// of different ratio at least. Left out are those of which something is idle: a class in no gear
/// or in all, a set whose stationary ratio changes all ratios by one factor, a free shaft that
/// fewer than three elements touch.
std::vector<TransmissionLayout> find_layouts(const GenericTrain& train,
                                             int elements,
                                             int least_gears,
                                             int free_shafts);

/// Whether of these gears together every element is engaged in some and open in some, and every set
/// rolls: its stationary ratio does not change all ratios by one factor.
bool all_have_use(const GenericTrain& train, int elements, std::span<const LayoutGear> gears);

/// One pair of shafts for each class of a layout, in their order.
using ElementPlacement = std::vector<ShaftPair>;

/// The placements of a layout, up to the automorphisms that keep it.
std::vector<ElementPlacement> placements_of(const GenericTrain& train,
                                            const TransmissionLayout& layout);

}  // namespace kinestat
