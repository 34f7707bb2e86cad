#include "studies/benchmark/interleaved_times.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// Time passes only while something runs.
class FakeMachine {
 public:
  std::function<void()> job(double seconds) {
    return [this, seconds] { now_ += seconds; };
  }

  Clock clock() {
    return [this] { return now_; };
  }

 private:
  double now_ = 0.0;
};

TEST(InterleavedTimes, AreRatiosToTheUnit) {
  FakeMachine machine;

  const InterleavedTimes times = time_interleaved(
      machine.job(2.0), {machine.job(6.0), machine.job(0.5)}, {.rounds = 4}, machine.clock());

  EXPECT_EQ(times.ratios,
            (std::vector<std::vector<double>>{{3.0, 3.0, 3.0, 3.0}, {0.25, 0.25, 0.25, 0.25}}));
  EXPECT_EQ(times.unit, std::vector<double>(8, 2.0));
}

TEST(InterleavedTimes, BeginNoRoundAfterTheLimit) {
  FakeMachine machine;

  // The probes take 4 s, a round 6 s: the third would begin after 16 s.
  const InterleavedTimes times = time_interleaved(
      machine.job(2.0), {machine.job(2.0)}, {.rounds = 100, .seconds = 15.0}, machine.clock());

  EXPECT_EQ(times.ratios.front().size(), 2U);
}

TEST(InterleavedTimes, HaveOneRoundAtLeast) {
  FakeMachine machine;

  const InterleavedTimes times = time_interleaved(
      machine.job(2.0), {machine.job(9.0)}, {.rounds = 5, .seconds = 0.0}, machine.clock());

  EXPECT_EQ(times.ratios.front(), std::vector<double>{4.5});
}

TEST(Median, IsTheValueInTheMiddle) {
  EXPECT_EQ(median_of({9.0, 1.0, 4.0}), 4.0);
}

TEST(Median, OfAnEvenNumberIsTheMeanOfTwo) {
  EXPECT_EQ(median_of({9.0, 1.0, 4.0, 6.0}), 5.0);
}

}  // namespace
}  // namespace kinestat
