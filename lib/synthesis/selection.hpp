// The best linkage over what a task leaves free.
#pragma once

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

/// The positions for a choice of the free numbers; empty where there is no such motion.
using TaskMaker =
    std::function<std::optional<std::vector<PositionJets>>(std::span<const double> choice)>;

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

/// Every combination of the ranges; those that no neighbour surpasses are improved between their
/// neighbours, step by step along each number, as long as the margin of the transmission angle
/// grows, and the best are kept. The same result in every run. Five positions a task.
Selection select_linkages(std::span<const SelectionRange> ranges,
                          const TaskMaker& make_task,
                          const LinkageLimits& limits,
                          int keep);

}  // namespace kinestat
