// Where speeds of closed forms bend sharply.
#include "studies/motion/task/figures/sharp_bends.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

std::vector<FreedomRates> rows_of(int steps, double (*speed)(double)) {
  std::vector<FreedomRates> rows;
  for (int i = 0; i <= steps; ++i) {
    rows.push_back({speed(i)});
  }
  return rows;
}

// A step of an arctangent, a hundredth of a step wide.
double jump(double step) {
  return std::atan(100.0 * (step - 4.3));
}

TEST(SharpBends, AreHalvedUntilNoneIsLeft) {
  const std::vector<FreedomRates> rows = rows_of(8, jump);
  ASSERT_TRUE(has_sharp_bends(rows));
  std::vector<double> looks = {4.0, 5.0};
  look_into_sharp_bends(rows, [&](double step) {
    EXPECT_GT(step, 4.0);
    EXPECT_LT(step, 5.0);
    looks.push_back(step);
    return FreedomRates{jump(step)};
  });
  std::ranges::sort(looks);
  double fastest = 0.0;
  for (const FreedomRates& row : rows) {
    fastest = std::max(fastest, std::abs(*row[0]));
  }
  for (std::size_t i = 1; i < looks.size(); ++i) {
    EXPECT_LE(std::abs(jump(looks[i]) - jump(looks[i - 1])), 0.5 * fastest) << looks[i];
  }
  EXPECT_LT(looks.size(), 20U);
}

TEST(SharpBends, AreNoneOfWhatRunsEvenlyOrHardlyMoves) {
  EXPECT_FALSE(has_sharp_bends(rows_of(24, [](double step) { return std::sin(0.2618 * step); })));
  EXPECT_FALSE(has_sharp_bends({}));
  std::vector<FreedomRates> rows = rows_of(8, [](double) { return 1.0; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].push_back(i % 2 == 0 ? 1e-15 : -1e-15);  // rounding beside what moves
    rows[i].emplace_back();
  }
  EXPECT_FALSE(has_sharp_bends(rows));
}

TEST(SharpBends, EndWhereNothingIsKnown) {
  int looks = 0;
  look_into_sharp_bends(rows_of(8, jump), [&](double) {
    ++looks;
    return FreedomRates();
  });
  EXPECT_EQ(looks, 1);
}

}  // namespace
}  // namespace kinestat
