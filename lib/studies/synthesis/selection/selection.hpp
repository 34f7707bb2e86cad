// The best linkage over what a task leaves free.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "math/numbers/for_each_number.hpp"
#include "studies/synthesis/selection/selection_choice.hpp"
#include "studies/synthesis/selection/selection_counts.hpp"

namespace kinestat {

/// One free number, tried in equal steps, both ends included.
struct SelectionRange {
  double from = 0.0;
  double to = 0.0;
  int count = 2;
};

/// How often each of that many numbers is tried, 2 at least, so that there are about `samples`
/// combinations: not fewer.
int samples_along(int samples, double numbers);

/// How many of the best a report and its picture have.
inline constexpr int kBestLinkages = 10;

struct SelectedLinkage {
  std::vector<double> choice;  ///< one number a range
  LinkageCandidate candidate;
};

struct Selection {
  std::vector<SelectedLinkage>
      best;  ///< usable, the best first: each better than what is around it
  std::optional<SelectedLinkage> nearest;  ///< without a usable one: what comes nearest
  std::optional<std::vector<double>>
      nearest_choice;  ///< without any linkage: that which comes nearest to one
  SelectionCounts counts;
};

/// Whether the second half of the numbers stands for the same as the first.
enum class ChoiceHalves { differ, alike };

/// Every combination of the ranges; of those that no neighbour surpasses the `keep` best are
/// improved between their neighbours, step by step along each number, as long as the margin of the
/// transmission angle grows. Where none is usable, the nearest passes the positions if any does and
/// misses the fewest limits, of these the mildest, and that least; it is improved likewise, and
/// may then be usable, and the best. The
/// same result in every run, whatever `for_each` does at once. Without `lacking` a choice without a
/// linkage misses dyads. The best are different ones: of those between which the straight way
/// hardly leads down only the better is kept. Where `halves` are alike, one for each dyad, their
/// exchange makes no other linkage, and the best have it once.
Selection select_linkages(std::span<const SelectionRange> ranges,
                          const CandidateMaker& make,
                          int keep,
                          const ForEach& for_each = one_after_another,
                          const ShortfallFinder& lacking = {},
                          ChoiceHalves halves = ChoiceHalves::differ);

}  // namespace kinestat
