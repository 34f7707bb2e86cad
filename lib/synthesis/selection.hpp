// The best linkage over what a task leaves free.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/synthesis.hpp"

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

/// The best linkage for a choice of the free numbers, one a range; empty where there is none. It is
/// asked from several threads at once.
using CandidateMaker = std::function<std::optional<LinkageCandidate>(std::span<const double>)>;

/// The positions for a choice of the free numbers; empty where there is no such motion.
using TaskMaker =
    std::function<std::optional<std::vector<PositionJets>>(std::span<const double> choice)>;

/// Five positions a task: the best pair of their dyads.
CandidateMaker candidates_of(const TaskMaker& make_task, const LinkageLimits& limits);

/// Does the job of every number below `count`, in any order or at the same time.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

void one_after_another(std::size_t count, const std::function<void(std::size_t)>& job);

struct SelectedLinkage {
  std::vector<double> choice;  ///< one number a range
  LinkageCandidate candidate;
};

struct Selection {
  std::vector<SelectedLinkage>
      best;  ///< usable, the best first: each better than what is around it
  std::optional<SelectedLinkage> nearest;  ///< without a usable one: what comes nearest
  int samples = 0;
  int with_linkage = 0;  ///< samples that have a linkage at all
  int usable = 0;        ///< samples that have one without defect and within the limits
};

/// Every combination of the ranges; of those that no neighbour surpasses the `keep` best are
/// improved between their neighbours, step by step along each number, as long as the margin of the
/// transmission angle grows. The same result in every run, whatever `for_each` does at once.
Selection select_linkages(std::span<const SelectionRange> ranges,
                          const CandidateMaker& make,
                          int keep,
                          const ForEach& for_each = one_after_another);

}  // namespace kinestat
