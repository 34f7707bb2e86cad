// The last points of a way in equal steps, from which the next one follows.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace kinestat {

class HermitePredictor {
 public:
  /// Forgets all points.
  void clear() { count_ = 0; }

  /// Adds a point with its rates by the share, and the step of all joints by which it was reached.
  /// One that was reached by another step of the share than those before begins anew.
  void leave(std::span<const double> rates, std::span<const double> arrival, double share_step);

  /// Whether there are points enough for a step of this size.
  bool leads_by(double share_step) const;

  /// The next step of all joints.
  void predict(std::span<double> step) const;

 private:
  static constexpr int kLength = 4;

  struct Mark {
    std::vector<double> rates;
    std::vector<double> arrival;
  };

  const Mark& mark(int age) const {
    return marks_[static_cast<std::size_t>((newest_ + kLength - age) % kLength)];
  }

  std::array<Mark, kLength> marks_;
  int newest_ = 0;
  int count_ = 0;
  double step_ = 0.0;
};

}  // namespace kinestat
