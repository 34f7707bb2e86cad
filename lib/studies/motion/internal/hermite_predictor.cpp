#include "studies/motion/internal/hermite_predictor.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion_tolerance.hpp"

namespace kinestat {

void HermitePredictor::leave(std::span<const double> rates,
                             std::span<const double> arrival,
                             double share_step) {
  const bool is_same = std::abs(share_step - step_) <= kSameStep * step_;
  count_ = is_same ? std::min(count_ + 1, kLength) : 1;
  step_ = share_step;
  newest_ = (newest_ + 1) % kLength;
  Mark& mark = marks_[static_cast<std::size_t>(newest_)];
  mark.rates.assign(rates.begin(), rates.end());
  mark.arrival.assign(arrival.begin(), arrival.end());
}

bool HermitePredictor::leads_by(double share_step) const {
  return count_ == kLength && std::abs(share_step - step_) <= kSameStep * step_;
}

// Of degree seven through four points and their rates: Hermite's weights at 1 for the nodes 0, -1,
// -2 and -3, which are -36, 64 and 47/3 for the positions of the last three. The arrivals lead to
// these from the newest.
void HermitePredictor::predict(std::span<double> step) const {
  const Mark& a = mark(0);
  const Mark& b = mark(1);
  const Mark& c = mark(2);
  const Mark& d = mark(3);
  for (std::size_t i = 0; i < step.size(); ++i) {
    const double places =
        -131.0 / 3.0 * a.arrival[i] - 239.0 / 3.0 * b.arrival[i] - 47.0 / 3.0 * c.arrival[i];
    const double slopes =
        16.0 * a.rates[i] + 72.0 * b.rates[i] + 48.0 * c.rates[i] + 4.0 * d.rates[i];
    step[i] = places + step_ * slopes;
  }
}

}  // namespace kinestat
