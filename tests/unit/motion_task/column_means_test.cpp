// Means of closed forms over samples.
#include "studies/motion/task/figures/column_means.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

std::vector<MeanSample> samples_of(int steps, const std::function<double(double)>& value) {
  std::vector<MeanSample> samples;
  for (int i = 0; i <= steps; ++i) {
    samples.push_back({.step = static_cast<double>(i), .value = value(i)});
  }
  return samples;
}

std::optional<double> none(double, double, double) {
  return std::nullopt;
}

ColumnMeans mean_of(
    std::span<const MeanSample> samples,
    const MeanCourse& course,
    const std::function<std::optional<double>(double from, double end, double left)>& before) {
  SmoothIntegral integral;
  return means_of(samples, course, before, integral);
}

TEST(ColumnMeans, AreThoseOfCubicsWhateverTheSteps) {
  for (const int steps : {6, 7, 40}) {
    const auto share = [steps](double step) { return step / steps; };
    const ColumnMeans found =
        mean_of(samples_of(steps, [&](double at) { return std::pow(share(at), 3); }), {}, none);
    ASSERT_TRUE(found.mean && found.mean_square);
    EXPECT_NEAR(*found.mean, 1.0 / 4.0, 1e-14);
  }
}

// |x - 1/3| has a corner at the fourth of twelve steps: both sides are lines.
TEST(ColumnMeans, EndAtCorners) {
  const std::vector<double> corners = {4.0};
  const auto samples = samples_of(12, [](double at) { return std::abs(at / 12.0 - 1.0 / 3.0); });
  const ColumnMeans found = mean_of(samples, {.pieces = {}, .corners = corners}, none);
  EXPECT_NEAR(*found.mean, 0.5 * (1.0 / 9.0 + 4.0 / 9.0), 1e-15);
  EXPECT_NEAR(*found.mean_square, (1.0 / 27.0 + 8.0 / 27.0) / 3.0, 1e-15);
}

// The root of what is left has 2/3, with the last value or without it.
TEST(ColumnMeans, ToALimitAreThoseOfItsRoot) {
  const auto root = [](double at) { return std::sqrt(1.0 - at / 24.0); };
  std::vector<MeanSample> samples = samples_of(24, root);
  const MeanCourse course{.pieces = {}, .corners = {}, .ends_at_limit = true};
  EXPECT_NEAR(*mean_of(samples, course, none).mean, 2.0 / 3.0, 1e-12);
  samples.back().value.reset();
  const auto before = [&](double from, double end, double left) {
    return std::optional(root(std::lerp(end, from, left)));
  };
  EXPECT_NEAR(*mean_of(samples, course, before).mean, 2.0 / 3.0, 1e-12);
}

// A piece is integrated by its points alone, whatever lies beside them.
TEST(ColumnMeans, TakePiecesByTheirPoints) {
  const double aside = 1.0 / std::sqrt(3.0);
  const TimePiece piece{
      .begin = 1.0,
      .end = 3.0,
      .points = {{.step = 2.0 - aside, .weight = 1.0}, {.step = 2.0 + aside, .weight = 1.0}}};
  const auto cube = [](double at) { return at > 1.0 && at < 3.0 ? std::pow(at - 1.0, 3) : 0.0; };
  std::vector<MeanSample> samples = {{.step = 0.0, .value = 0.0},
                                     {.step = 1.0, .value = 0.0},
                                     {.step = piece.points[0].step, .value = {}, .weight = 1.0},
                                     {.step = 2.0, .value = 77.0},
                                     {.step = piece.points[1].step, .value = {}, .weight = 1.0},
                                     {.step = 3.0, .value = 0.0},
                                     {.step = 4.0, .value = 0.0}};
  samples[2].value = cube(samples[2].step);
  samples[4].value = cube(samples[4].step);
  const std::vector<double> corners = {1.0, 3.0};
  const std::vector<TimePiece> pieces = {piece};
  const ColumnMeans found = mean_of(samples, {.pieces = pieces, .corners = corners}, none);
  EXPECT_NEAR(*found.mean, 4.0 / 4.0, 1e-14);
}

// What rests is left out; what lacks a value for another reason takes the mean away.
TEST(ColumnMeans, LeaveOutRestsAlone) {
  std::vector<MeanSample> samples = samples_of(6, [](double) { return 3.0; });
  for (const std::size_t open : {4UL, 5UL, 6UL}) {
    samples[open] = {.step = samples[open].step, .value = {}, .rests = true};
  }
  const auto same = [](double, double, double) { return std::optional(3.0); };
  EXPECT_EQ(mean_of(samples, {}, same).mean, 3.0);
  for (const std::size_t open : {4UL, 5UL, 6UL}) {
    samples[open].rests = false;
  }
  EXPECT_FALSE(mean_of(samples, {}, same).mean);
  EXPECT_FALSE(mean_of(std::span(samples).first(1), {}, same).mean);
}

}  // namespace
}  // namespace kinestat
