#include "synthesis/selection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contract.hpp"

namespace kinestat {

namespace {

bool is_better(const LinkageCandidate& one, const LinkageCandidate& other) {
  const bool is_usable = one.defect == Defect::none;
  const bool was_usable = other.defect == Defect::none;
  return is_usable != was_usable ? is_usable : one.margin() > other.margin();
}

class Selector {
 public:
  Selector(std::span<const SelectionRange> ranges,
           const TaskMaker& make_task,
           const LinkageLimits& limits,
           std::size_t keep)
      : ranges_(ranges), make_task_(make_task), limits_(limits), keep_(keep) {}

  Selection run() {
    std::vector<int> index(ranges_.size(), 0);
    do {
      try_sample(choice_at(index));
    } while (advance(index));
    for (SelectedLinkage& one : selection_.best) {
      improve(one);
    }
    sort();
    return std::move(selection_);
  }

 private:
  std::vector<double> choice_at(const std::vector<int>& index) const {
    std::vector<double> choice;
    for (std::size_t i = 0; i < index.size(); ++i) {
      choice.push_back(ranges_[i].from + step(i) * index[i]);
    }
    return choice;
  }

  double step(std::size_t i) const {
    const SelectionRange& range = ranges_[i];
    return range.count > 1 ? (range.to - range.from) / (range.count - 1) : 0.0;
  }

  // The next combination, the last number first.
  bool advance(std::vector<int>& index) const {
    for (std::size_t i = index.size(); i > 0; --i) {
      if (++index[i - 1] < ranges_[i - 1].count) {
        return true;
      }
      index[i - 1] = 0;
    }
    return false;
  }

  std::optional<LinkageCandidate> best_of(const std::vector<double>& choice) const {
    const auto positions = make_task_(choice);
    if (!positions) {
      return std::nullopt;
    }
    const BurmesterSolution solution = solve_burmester(*positions);
    std::vector<LinkageCandidate> found = rank_linkages(solution.dyads, *positions, limits_);
    return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
  }

  void try_sample(std::vector<double> choice) {
    ++selection_.samples;
    std::optional<LinkageCandidate> found = best_of(choice);
    if (!found) {
      return;
    }
    ++selection_.with_linkage;
    if (found->defect != Defect::none) {
      return;
    }
    ++selection_.usable;
    std::vector<SelectedLinkage>& best = selection_.best;
    if (best.size() == keep_ && !is_better(*found, best.back().candidate)) {
      return;
    }
    best.push_back({.choice = std::move(choice), .candidate = *std::move(found)});
    sort();
    if (best.size() > keep_) {
      best.pop_back();
    }
  }

  void sort() {
    std::ranges::stable_sort(selection_.best,
                             [](const SelectedLinkage& one, const SelectedLinkage& other) {
                               return is_better(one.candidate, other.candidate);
                             });
  }

  // Steps of half the grid's, halved whenever none of them helps; never beyond the ranges.
  void improve(SelectedLinkage& one) const {
    constexpr int kHalvings = 24;
    double share = 0.5;
    for (int i = 0; i < kHalvings; ++i) {
      if (!improve_by(one, share)) {
        share *= 0.5;
      }
    }
  }

  bool improve_by(SelectedLinkage& one, double share) const {
    bool helps = false;
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      for (const double sign : {1.0, -1.0}) {
        std::vector<double> choice = one.choice;
        const auto [low, high] = std::minmax(ranges_[i].from, ranges_[i].to);
        choice[i] = std::clamp(choice[i] + sign * share * step(i), low, high);
        std::optional<LinkageCandidate> found = best_of(choice);
        if (found && is_better(*found, one.candidate)) {
          one = {.choice = std::move(choice), .candidate = *std::move(found)};
          helps = true;
        }
      }
    }
    return helps;
  }

  std::span<const SelectionRange> ranges_;
  const TaskMaker& make_task_;
  const LinkageLimits& limits_;
  std::size_t keep_;
  Selection selection_;
};

}  // namespace

Selection select_linkages(std::span<const SelectionRange> ranges,
                          const TaskMaker& make_task,
                          const LinkageLimits& limits,
                          int keep) {
  KINESTAT_EXPECTS(keep > 0);
  return Selector(ranges, make_task, limits, static_cast<std::size_t>(keep)).run();
}

}  // namespace kinestat
