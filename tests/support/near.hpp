// Comparison of matrices in tests, with the worst entry in the message.
#pragma once

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/types.hpp"

namespace kinestat {

/// For values that a handful of operations give: some hundred roundings of numbers about 1.
inline constexpr double kTight = 1e-13;

/// Whether every entry differs by at most `tolerance` (absolute: multiply it by the size of the
/// entries). The message names the worst entry. A NaN is never near.
inline ::testing::AssertionResult is_near(const Eigen::Ref<const MatX>& actual,
                                          const Eigen::Ref<const MatX>& expected,
                                          double tolerance) {
  if (actual.rows() != expected.rows() || actual.cols() != expected.cols()) {
    return ::testing::AssertionFailure() << fmt::format("actual is {} x {}, expected is {} x {}",
                                                        actual.rows(),
                                                        actual.cols(),
                                                        expected.rows(),
                                                        expected.cols());
  }
  Eigen::Index row = 0;
  Eigen::Index column = 0;
  double worst = -1.0;
  for (Eigen::Index c = 0; c < actual.cols(); ++c) {
    for (Eigen::Index r = 0; r < actual.rows(); ++r) {
      const double difference = std::abs(actual(r, c) - expected(r, c));
      if (!(difference <= worst)) {
        worst = difference;
        row = r;
        column = c;
      }
    }
  }
  if (actual.size() == 0 || worst <= tolerance) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << fmt::format(
             "worst entry is ({}, {}): actual {:.17g}, expected {:.17g}, they differ by "
             "{:.3g}, more than {:.3g}",
             row,
             column,
             actual(row, column),
             expected(row, column),
             worst,
             tolerance);
}

}  // namespace kinestat
