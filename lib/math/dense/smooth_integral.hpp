// Integrals of a function that is known at some nodes.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace kinestat {

/// Between two nodes, by polynomials through those nearest to them, where these agree; with equal
/// weights where equal steps go on at the end as they began, as along whole turns.
class SmoothIntegral {
 public:
  /// In order; they differ. Those of last time cost nothing.
  void place(std::span<const double> nodes);

  /// Finds whether the function with these values returns, and where it is smooth: where the
  /// polynomial through six nodes, or through all where they are fewer, differs little from that
  /// through four.
  void look(std::span<const double> values);

  /// Over all intervals, of values of which each is what the same formula makes of one of the
  /// function: of the polynomials where that is smooth, else what `lines` says of the interval.
  double of(std::span<const double> values, std::span<const double> lines) const;

 private:
  static constexpr std::size_t kMost = 6;

  using Weights = std::array<double, kMost>;

  /// Of some nodes in such units that an interval between two of them is that from 0 to 1.
  struct Rule {
    std::array<double, kMost> nodes{};
    Weights weights{};  ///< of the integral over that interval
    Weights weights_of_four{};
  };

  struct Interval {
    std::size_t first = 0;  ///< of the nodes
    std::size_t rule = 0;
    double width = 0.0;
    double bend = 0.0;  ///< by how much a cubic differs from a straight line
    bool is_smooth = false;
  };

  bool returns(std::span<const double> values) const;

  std::vector<double> nodes_;
  std::size_t count_ = 0;  // of the nodes of a rule
  bool has_equal_steps_ = false;
  bool returns_ = false;
  std::vector<Rule> rules_;
  std::vector<Interval> intervals_;
};

}  // namespace kinestat
