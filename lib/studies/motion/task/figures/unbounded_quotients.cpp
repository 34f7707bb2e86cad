#include "studies/motion/task/figures/unbounded_quotients.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion_tolerance.hpp"

namespace kinestat {

void UnboundedQuotients::look(const std::vector<MotionReading>& readings,
                              const MotionPosition& position,
                              double step,
                              bool stands) {
  seen_.resize(readings.size());
  for (std::size_t r = 0; r < readings.size(); ++r) {
    if (stands && readings[r].parts) {
      seen_[r].push_back({.step = step, .parts = {}, .stands = true});
      continue;
    }
    const std::optional<QuotientParts> parts =
        readings[r].parts ? readings[r].parts(position) : std::nullopt;
    if (parts && (parts->divisor != 0.0 || parts->dividend != 0.0)) {
      seen_[r].push_back({.step = step, .parts = *parts});
    }
  }
}

bool UnboundedQuotients::is_unbounded(std::span<const Seen> seen,
                                      std::span<const double> steps,
                                      std::vector<std::size_t>& poles) {
  double largest = 0.0;
  for (const Seen& one : seen) {
    largest = std::max(largest, std::abs(one.parts.divisor));
  }
  bool found = false;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const QuotientParts& here = seen[i].parts;
    found = found || (here.divisor == 0.0 && !seen[i].stands);
    if (i == 0 || seen[i].stands || seen[i - 1].stands) {
      continue;
    }
    const QuotientParts& before = seen[i - 1].parts;
    const bool turns_alone =
        here.divisor * before.divisor < 0.0 && here.dividend * before.dividend > 0.0;
    const bool jumps = seen[i].step - seen[i - 1].step < kSameApproach &&
                       std::abs(here.divisor - before.divisor) > kJump * largest;
    if (turns_alone && !jumps) {
      found = true;
      const auto row = std::ranges::lower_bound(steps, seen[i].step - kSameStep);
      const auto pole = static_cast<std::size_t>(row - steps.begin());
      if (poles.empty() || poles.back() != pole) {
        poles.push_back(pole);
      }
    }
  }
  return found;
}

void UnboundedQuotients::leave_out_unbounded(const std::vector<MotionReading>& readings,
                                             std::size_t first,
                                             std::span<const double> steps,
                                             MotionTable& table) const {
  for (std::size_t r = 0; r < seen_.size(); ++r) {
    std::vector<Seen> seen = seen_[r];
    std::ranges::stable_sort(seen, {}, &Seen::step);
    std::vector<std::size_t> poles;
    if (is_unbounded(seen, steps, poles)) {
      ColumnFigures& figures = table.figures[first + r];
      figures = {.least = readings[r].is_size ? figures.least : std::nullopt,
                 .greatest = std::nullopt,
                 .mean = std::nullopt,
                 .rms = std::nullopt,
                 .poles = poles};
    }
  }
}

}  // namespace kinestat
