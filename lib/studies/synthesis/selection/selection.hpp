// The best linkage over what a task leaves free.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "math/numbers/for_each_number.hpp"
#include "studies/synthesis/selection/selection_choice.hpp"

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

inline constexpr std::size_t kDefectCount = static_cast<std::size_t>(Defect::size) + 1;

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
  int samples = 0;
  int with_linkage = 0;  ///< samples that have a linkage at all
  int usable = 0;        ///< samples that have one without defect and within the limits
  std::array<int, kDefectCount> defects{};   ///< samples with a linkage by its Defect
  std::array<int, kMissingCount> missing{};  ///< the others by their Missing
};

/// Whether the second half of the numbers stands for the same as the first.
enum class ChoiceHalves { differ, alike };

/// Every combination of the ranges; of those that no neighbour surpasses the `keep` best are
/// improved between their neighbours, step by step along each number, as long as the margin of the
/// transmission angle grows. Where none is usable, the nearest has the mildest defect, and of those
/// that miss a limit it misses it least. The same result in every run, whatever `for_each` does at
/// once. Without `lacking` a choice without a linkage misses dyads. The best are different ones: of
/// those between which the straight way hardly leads down only the better is kept. Where `halves`
/// are alike, one for each dyad, their exchange makes no other linkage, and the best have it once.
Selection select_linkages(std::span<const SelectionRange> ranges,
                          const CandidateMaker& make,
                          int keep,
                          const ForEach& for_each = one_after_another,
                          const ShortfallFinder& lacking = {},
                          ChoiceHalves halves = ChoiceHalves::differ);

}  // namespace kinestat
