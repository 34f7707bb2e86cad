#include "synthesis/selection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contract.hpp"

namespace kinestat {

namespace {

// Usable ones first; then by how little is wrong, the later in the list of defects the less.
bool is_better(const LinkageCandidate& one, const LinkageCandidate& other) {
  const auto rank = [](Defect defect) {
    return defect == Defect::none ? static_cast<int>(Defect::size) + 1 : static_cast<int>(defect);
  };
  return rank(one.defect) != rank(other.defect) ? rank(one.defect) > rank(other.defect)
                                                : one.margin() > other.margin();
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
    std::vector<SelectedLinkage> peaks = find_peaks();
    for (SelectedLinkage& one : peaks) {
      improve(one);
      keep_if_new(std::move(one));
    }
    sort(selection_.best);
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

  // Notes the margin of the sample, below zero if it has no usable linkage.
  void try_sample(std::vector<double> choice) {
    ++selection_.samples;
    margins_.push_back(-1.0);
    std::optional<LinkageCandidate> found = best_of(choice);
    if (!found) {
      return;
    }
    ++selection_.with_linkage;
    if (found->defect == Defect::none) {
      ++selection_.usable;
      margins_.back() = found->margin();
      selection_.nearest.reset();
    } else if (selection_.usable == 0 &&
               (!selection_.nearest || is_better(*found, selection_.nearest->candidate))) {
      selection_.nearest =
          SelectedLinkage{.choice = std::move(choice), .candidate = *std::move(found)};
    }
  }

  // The samples with the largest margins among those that no neighbour along a range surpasses.
  std::vector<SelectedLinkage> find_peaks() const {
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i < margins_.size(); ++i) {
      if (margins_[i] >= 0.0 && is_peak(i)) {
        peaks.push_back(i);
      }
    }
    std::ranges::stable_sort(
        peaks, [&](std::size_t a, std::size_t b) { return margins_[a] > margins_[b]; });
    peaks.resize(std::min(peaks.size(), keep_));
    std::vector<SelectedLinkage> result;
    for (const std::size_t peak : peaks) {
      std::vector<double> choice = choice_at(index_of(peak));
      LinkageCandidate candidate = *best_of(choice);
      result.push_back({.choice = std::move(choice), .candidate = std::move(candidate)});
    }
    return result;
  }

  std::vector<int> index_of(std::size_t sample) const {
    std::vector<int> index(ranges_.size(), 0);
    for (std::size_t i = ranges_.size(); i > 0; --i) {
      const auto count = static_cast<std::size_t>(ranges_[i - 1].count);
      index[i - 1] = static_cast<int>(sample % count);
      sample /= count;
    }
    return index;
  }

  bool is_peak(std::size_t sample) const {
    const std::vector<int> index = index_of(sample);
    std::size_t stride = 1;
    for (std::size_t i = ranges_.size(); i > 0; --i) {
      const bool has_before = index[i - 1] > 0;
      const bool has_after = index[i - 1] + 1 < ranges_[i - 1].count;
      if ((has_before && margins_[sample - stride] > margins_[sample]) ||
          (has_after && margins_[sample + stride] > margins_[sample])) {
        return false;
      }
      stride *= static_cast<std::size_t>(ranges_[i - 1].count);
    }
    return true;
  }

  // Two peaks of the grid may lead to one and the same.
  void keep_if_new(SelectedLinkage one) {
    const bool is_known = std::ranges::any_of(
        selection_.best, [&](const SelectedLinkage& other) { return is_near(one, other); });
    if (!is_known) {
      selection_.best.push_back(std::move(one));
    }
  }

  bool is_near(const SelectedLinkage& one, const SelectedLinkage& other) const {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      if (std::abs(one.choice[i] - other.choice[i]) > std::abs(step(i))) {
        return false;
      }
    }
    return true;
  }

  static void sort(std::vector<SelectedLinkage>& found) {
    std::ranges::stable_sort(found, [](const SelectedLinkage& one, const SelectedLinkage& other) {
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
  std::vector<double> margins_;  // of all samples, the last range first
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
