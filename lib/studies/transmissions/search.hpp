// All transmissions that can do what is asked.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
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

/// How far a search is.
struct SearchProgress {
  std::size_t structures = 0;  ///< done
  std::size_t known = 0;       ///< of those, from the store
  std::size_t total = 0;
  std::uint64_t found = 0;
  double share = 0.0;  ///< done of all layouts, which differ widely from structure to structure
  double known_share = 0.0;  ///< of those, from the store
};

/// The task is right by itself. What is found hangs neither on the order of jobs nor on threads.
/// `tell`, if any, hears of every structure that is done, by one thread at a time.
TransmissionSearch search_transmissions(
    const TransmissionTask& task,
    const ForEach& for_each,
    const SearchShare& share = {},
    const SearchStore* store = nullptr,
    const std::function<void(const SearchProgress&)>& tell = {});

/// How many transmissions there are for a task, or of a part of all that there would be to try.
struct TransmissionCount {
  std::uint64_t found = 0;
  bool is_of_a_part = false;
  std::uint64_t work = 0;  ///< that it took
};

/// Counts for tasks that differ in nothing but what they ask of ratios, changes, limits and layout,
/// with about `most_work` tests of a layout in all. Over ranges what is hard to find is not
/// counted. `layouts` is how many all structures have (SearchStages).
std::vector<TransmissionCount> count_transmissions(std::span<const TransmissionTask> tasks,
                                                   std::uint64_t layouts,
                                                   std::uint64_t most_work,
                                                   const ForEach& for_each);

}  // namespace kinestat
