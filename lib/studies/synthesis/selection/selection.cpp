#include "studies/synthesis/selection/selection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/contract.hpp"
#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// How near a linkage comes to the limit that speaks against it, or its margin: the more the better.
double reached_by(const LinkageCandidate& candidate) {
  switch (candidate.defect()) {
    case Defect::none:
    case Defect::digits:
    case Defect::circuit:
    case Defect::branch:
    case Defect::order:
    case Defect::grashof:
    case Defect::other_circuit:
    case Defect::full_turn:
    case Defect::transmission:
      return candidate.margin();
    case Defect::full_transmission:
      return candidate.best().full.margin();
    case Defect::centre_point:
    case Defect::circle_point:
      return -candidate.outside;
    case Defect::ratio:
      return -candidate.ratio;
    case Defect::size:
      return -candidate.longest;
  }
  return 0.0;
}

// What is kept of the many.
struct Sample {
  double margin = -1.0;  // below zero without a usable linkage
  Standing standing;  // its margin is what reached_by says; the rank is negative without a linkage
  Defects defects;
  Missing missing = Missing::dyads;  // without a linkage
};

Sample sample_of(const LinkageCandidate& candidate) {
  Sample sample{.standing = candidate.standing(), .defects = candidate.defects};
  sample.standing.margin = reached_by(candidate);
  if (candidate.is_usable()) {
    sample.margin = candidate.margin();
  }
  return sample;
}

Sample sample_of(const Shortfall& shortfall) {
  Sample sample;
  sample.missing = shortfall.missing;
  sample.standing.rank = static_cast<int>(shortfall.missing) - static_cast<int>(kMissingCount);
  sample.standing.margin = -shortfall.residual;
  return sample;
}

class Selector {
 public:
  Selector(std::span<const SelectionRange> ranges,
           const CandidateMaker& make,
           std::size_t keep,
           const ForEach& for_each,
           const ShortfallFinder& lacking,
           ChoiceHalves halves)
      : ranges_(ranges),
        make_(make),
        keep_(keep),
        for_each_(for_each),
        lacking_(lacking),
        exchange_(halves == ChoiceHalves::alike ? ranges.size() / 2 : 0) {}

  Selection run() {
    try_samples();
    count();
    std::vector<std::size_t> places = find_peaks();
    std::vector<SelectedLinkage> peaks(places.size());
    for_each_(peaks.size(), [&](std::size_t i) {
      peaks[i] = selected(places[i]);
      improve(peaks[i]);
    });
    sort(peaks);  // of those that are one linkage the best is kept
    for (SelectedLinkage& one : peaks) {
      if (selection_.best.size() < keep_) {
        keep_if_new(std::move(one));
      }
    }
    return std::move(selection_);
  }

 private:
  static constexpr std::size_t kBlock = 64;  // samples that one thread tries in one go
  static constexpr std::size_t kPeaks = 4;   // several may lead to the same linkage

  void try_samples() {
    std::size_t count = 1;
    for (const SelectionRange& range : ranges_) {
      count *= static_cast<std::size_t>(range.count);
    }
    samples_.resize(count);
    for_each_((count + kBlock - 1) / kBlock, [&](std::size_t block) {
      const std::size_t end = std::min(count, (block + 1) * kBlock);
      for (std::size_t i = block * kBlock; i < end; ++i) {
        samples_[i] = try_choice(choice_at(index_of(i)));
      }
    });
  }

  Sample try_choice(const std::vector<double>& choice) const {
    const auto found = make_(choice);
    return found ? sample_of(*found) : sample_of(lacking_ ? lacking_(choice) : Shortfall{});
  }

  // The counts; and if nothing is usable, what comes nearest: of equal ones the first.
  void count() {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& sample = samples_[i];
      const Sample& best = samples_[nearest];
      if (sample.standing.rank >= 0) {
        selection_.counts.add(sample.defects);
      } else {
        selection_.counts.add(sample.missing);
      }
      nearest = sample.standing.is_better_than(best.standing) ? i : nearest;
    }
    if (selection_.counts.usable == 0 && selection_.counts.with_linkage > 0) {
      SelectedLinkage found = selected(nearest);
      improve(found);
      (found.candidate.is_usable() ? selection_.best.emplace_back()
                                   : selection_.nearest.emplace()) = std::move(found);
    }
    if (selection_.counts.with_linkage == 0 && !samples_.empty() &&
        samples_[nearest].missing != Missing::motion) {
      selection_.nearest_choice = choice_at(index_of(nearest));
    }
  }

  SelectedLinkage selected(std::size_t sample) const {
    SelectedLinkage result{.choice = choice_at(index_of(sample)), .candidate = {}};
    result.candidate = *make_(result.choice);
    return result;
  }

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

  // The samples with the largest margins among those that no neighbour along a range surpasses.
  std::vector<std::size_t> find_peaks() const {
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (samples_[i].margin >= 0.0 && is_peak(i)) {
        peaks.push_back(i);
      }
    }
    std::ranges::stable_sort(peaks, [&](std::size_t a, std::size_t b) {
      return samples_[a].margin > samples_[b].margin;
    });
    const std::size_t orders = exchange_ > 0 ? 2 : 1;  // of the dyads
    peaks.resize(std::min(peaks.size(), orders * kPeaks * keep_));
    return peaks;
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
      if ((has_before && samples_[sample - stride].margin > samples_[sample].margin) ||
          (has_after && samples_[sample + stride].margin > samples_[sample].margin)) {
        return false;
      }
      stride *= static_cast<std::size_t>(ranges_[i - 1].count);
    }
    return true;
  }

  // Two peaks of the grid may lead to one and the same, and where the free numbers are more than
  // what they are free for, very different ones too.
  void keep_if_new(SelectedLinkage one) {
    const bool is_known = std::ranges::any_of(selection_.best, [&](const SelectedLinkage& other) {
      return is_same(one.candidate, other.candidate) || is_below(one, other, 0) ||
             (exchange_ > 0 && is_below(one, other, exchange_));
    });
    if (!is_known) {
      selection_.best.push_back(std::move(one));
    }
  }

  // On the slope of a better one, with its numbers so many places further on: beside it, or the
  // straight way there hardly leads down.
  bool is_below(const SelectedLinkage& one,
                const SelectedLinkage& better,
                std::size_t places) const {
    constexpr double kDip = 0.05;  // as a share of the margin: the search follows no sharp ridge
    constexpr std::array<double, 7> kOnTheWay = {0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};
    if (is_near(one, better, places)) {
      return true;
    }
    return std::ranges::all_of(kOnTheWay, [&](double share) {
      std::vector<double> choice;
      for (std::size_t i = 0; i < ranges_.size(); ++i) {
        const double to = better.choice[(i + places) % ranges_.size()];
        choice.push_back(one.choice[i] + share * (to - one.choice[i]));
      }
      const std::optional<LinkageCandidate> found = make_(choice);
      return found && found->is_usable() &&
             found->margin() >= (1.0 - kDip) * one.candidate.margin();
    });
  }

  static bool is_same(const LinkageCandidate& one, const LinkageCandidate& other) {
    return one.linkage.type() == other.linkage.type() &&
           std::abs(one.ratio - other.ratio) < kSameLinkage * one.ratio &&
           std::abs(one.longest - other.longest) < kSameLinkage * one.longest;
  }

  // With the numbers of the other so many places further on.
  bool is_near(const SelectedLinkage& one, const SelectedLinkage& other, std::size_t places) const {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const double number = other.choice[(i + places) % ranges_.size()];
      if (std::abs(one.choice[i] - number) > std::abs(step(i))) {
        return false;
      }
    }
    return true;
  }

  static void sort(std::vector<SelectedLinkage>& found) {
    std::ranges::stable_sort(found, [](const SelectedLinkage& one, const SelectedLinkage& other) {
      return one.candidate.standing().is_better_than(other.candidate.standing());
    });
  }

  // Steps of half the grid's along every number, or if none of them helps across every two, so that
  // a limit that runs obliquely is followed; halved if neither helps; never beyond the ranges.
  void improve(SelectedLinkage& one) const {
    constexpr int kRounds = 60;
    constexpr int kHalvings = 24;
    double share = 0.5;
    int halvings = 0;
    for (int i = 0; i < kRounds && halvings < kHalvings; ++i) {
      if (!improve_by(one, share)) {
        share *= 0.5;
        ++halvings;
      }
    }
  }

  bool improve_by(SelectedLinkage& one, double share) const {
    bool helps = false;
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      for (const double sign : {1.0, -1.0}) {
        const bool helps_so = improve_along(one, i, sign * share, i, 0.0);
        helps = helps || helps_so;
      }
    }
    return helps || improve_across(one, share);
  }

  bool improve_across(SelectedLinkage& one, double share) const {
    bool helps = false;
    for (std::size_t pair = 0; pair < ranges_.size() * ranges_.size(); ++pair) {
      const std::size_t i = pair / ranges_.size();
      const std::size_t j = pair % ranges_.size();
      for (const double sign : {1.0, -1.0}) {
        // Of i and j in both orders: with the same sign, and with the other.
        const double other = i < j ? sign * share : -sign * share;
        const bool helps_so = i != j && improve_along(one, i, sign * share, j, other);
        helps = helps || helps_so;
      }
    }
    return helps;
  }

  bool improve_along(
      SelectedLinkage& one, std::size_t i, double share, std::size_t j, double other) const {
    std::vector<double> choice = one.choice;
    choice[i] = within(i, choice[i] + share * step(i));
    choice[j] = within(j, choice[j] + other * step(j));
    std::optional<LinkageCandidate> found = make_(choice);
    if (!found || !sample_of(*found).standing.is_better_than(sample_of(one.candidate).standing)) {
      return false;
    }
    one = {.choice = std::move(choice), .candidate = *std::move(found)};
    return true;
  }

  double within(std::size_t i, double value) const {
    const auto [low, high] = std::minmax(ranges_[i].from, ranges_[i].to);
    return std::clamp(value, low, high);
  }

  std::span<const SelectionRange> ranges_;
  const CandidateMaker& make_;
  std::size_t keep_;
  const ForEach& for_each_;
  const ShortfallFinder& lacking_;
  std::size_t exchange_ = 0;     // numbers of one dyad, where those of the other are alike
  std::vector<Sample> samples_;  // the last range runs fastest
  Selection selection_;
};

}  // namespace

int samples_along(int samples, double numbers) {
  const double each = std::pow(static_cast<double>(samples), 1.0 / numbers);
  return std::max(2, static_cast<int>(std::ceil(each * (1.0 - kSameValue))));
}

Selection select_linkages(std::span<const SelectionRange> ranges,
                          const CandidateMaker& make,
                          int keep,
                          const ForEach& for_each,
                          const ShortfallFinder& lacking,
                          ChoiceHalves halves) {
  KINESTAT_EXPECTS(keep > 0);
  return Selector(ranges, make, static_cast<std::size_t>(keep), for_each, lacking, halves).run();
}

}  // namespace kinestat
