#include "studies/motion/path_leg.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

PathLeg::PathLeg(const DrivePath& path, const std::vector<double>& units, double from, double to)
    : path_(path), units_(units), from_(from), to_(to) {
  for (std::size_t d = 0; d < units.size(); ++d) {
    low_.push_back(drive_at(d, from));
    high_.push_back(drive_at(d, to));
    if (std::abs(high_[d] - low_[d]) > std::abs(high_[fastest_] - low_[fastest_])) {
      fastest_ = d;
    }
  }
}

double PathLeg::drive_at(std::size_t drive, double share) const {
  return path_(drive, share) / units_[drive];
}

// Looked at in some places: between turns nothing but the laws of drives parts them from the line.
double PathLeg::bow() const {
  constexpr int kLooks = 4;
  const double way = high_[fastest_] - low_[fastest_];
  double bow = 0.0;
  for (int i = 1; i < kLooks && units_.size() > 1 && way != 0.0; ++i) {
    const double share = std::lerp(from_, to_, static_cast<double>(i) / kLooks);
    const double part = part_at(share);
    for (std::size_t d = 0; d < units_.size(); ++d) {
      bow = std::max(bow, std::abs(drive_at(d, share) - std::lerp(low_[d], high_[d], part)));
    }
  }
  return bow;
}

bool PathLeg::can_be_halved() const {
  const double middle = 0.5 * (from_ + to_);
  return to_ - from_ > kSameValue && from_ < middle && middle < to_;
}

double PathLeg::part_at(double share) const {
  if (share <= from_ || share >= to_) {
    return share <= from_ ? 0.0 : 1.0;
  }
  const double way = high_[fastest_] - low_[fastest_];
  return std::clamp((drive_at(fastest_, share) - low_[fastest_]) / way, 0.0, 1.0);
}

double PathLeg::share(double of_line) const {
  if (of_line <= 0.0 || of_line >= 1.0) {
    return of_line <= 0.0 ? from_ : to_;
  }
  const double place = std::lerp(low_[fastest_], high_[fastest_], of_line);
  const bool rises = high_[fastest_] > low_[fastest_];
  double low = from_;
  double high = to_;
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high)) {
    ((drive_at(fastest_, middle) < place) == rises ? low : high) = middle;
  }
  return high;
}

}  // namespace kinestat
