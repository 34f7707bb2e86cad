// All transmissions that can do what is asked.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "math/numbers/for_each_number.hpp"
#include "studies/transmissions/ladder_figures.hpp"
#include "studies/transmissions/ladder_walk.hpp"
#include "studies/transmissions/transmission_task.hpp"

namespace kinestat {

/// A layout with roles of its sets, at the best of the stationary ratios and with the best of the
/// ladders that do what is asked.
struct FoundTransmission {
  std::uint32_t structure = 0;  ///< its number
  std::uint32_t layout = 0;     ///< its number among the layouts of the structure
  RoleChoice roles;
  StationaryPoint stationary_ratios{};
  ElementPlacement elements;         ///< as many as the layout has classes
  std::vector<std::uint8_t> ladder;  ///< elements of each gear as bits, the reverse gear last
  std::vector<double> ratios;        ///< of these gears
  double rank = 0.0;
  LadderFigures figures;
  std::uint64_t points = 0;      ///< stationary ratios of the grid that would do
  std::uint32_t placements = 0;  ///< of the elements, that can be built as asked
};

/// What is left at each stage of a search.
struct SearchStages {
  std::uint64_t structures = 0;
  std::uint64_t layouts = 0;           ///< up to roles and kinds of the sets
  std::uint64_t labelled_layouts = 0;  ///< with them
  std::uint64_t not_refuted = 0;       ///< by the ranges of ratios over all stationary ratios
  std::uint64_t undecided = 0;         ///< neither refuted nor solved, however small the ranges
  std::uint64_t with_ladder = 0;       ///< labelled ones that have one
  std::uint64_t not_buildable = 0;     ///< of those, as none of their placements can be built
  std::uint64_t over_limits = 0;       ///< of the rest
  std::uint64_t points = 0;            ///< stationary ratios of all of them
  std::uint64_t found = 0;             ///< labelled ones that do all that is asked
  std::uint64_t layouts_found = 0;     ///< the same up to roles and kinds

  SearchStages& operator+=(const SearchStages& other);
};

struct TransmissionSearch {
  std::uint64_t structure_count = 0;  ///< all that there are, also outside of a slice
  SearchStages stages;
  std::vector<FoundTransmission> found;  ///< the best first
};

/// Of every `count` structures the one with this place, from 0.
struct SearchShare {
  std::size_t place = 0;
  std::size_t count = 1;
};

/// What is known of structures, by their number, so that a search can be interrupted and shared;
/// both are called from several threads.
struct SearchStore {
  std::function<std::optional<TransmissionSearch>(std::size_t structure)> find;
  std::function<void(std::size_t structure, const TransmissionSearch& found)> keep;
};

/// The task is right by itself. What is found hangs neither on the order of jobs nor on threads.
TransmissionSearch search_transmissions(const TransmissionTask& task,
                                        const ForEach& for_each,
                                        const SearchShare& share = {},
                                        const SearchStore* store = nullptr);

}  // namespace kinestat
