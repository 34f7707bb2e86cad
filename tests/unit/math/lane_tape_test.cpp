#include "math/tapes/lane_tape.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "math/tapes/lane_recorder.hpp"

namespace kinestat {

namespace {

std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

// Every operation, on numbers that came before.
std::vector<TapeNumber> record_anything(std::mt19937& random,
                                        std::size_t inputs,
                                        LaneRecorder& recorder) {
  std::vector<TapeNumber> numbers = {recorder.constant(0.5), recorder.constant(-3.0)};
  for (std::size_t i = 0; i < inputs; ++i) {
    numbers.push_back(recorder.input(1.0, {.low = -2.0, .high = 2.0 + static_cast<double>(i)}));
  }
  const auto any = [&] { return numbers[random() % numbers.size()]; };
  for (int i = 0; i < 200; ++i) {
    const TapeNumber a = any();
    const TapeNumber b = any();
    const TapeNumber c = any();
    switch (random() % 9) {
      case 0:
        numbers.push_back(recorder.add(a, b));
        break;
      case 1:
        numbers.push_back(recorder.subtract(a, b));
        break;
      case 2:
        numbers.push_back(recorder.multiply(a, b));
        break;
      case 3:
        numbers.push_back(recorder.divide(a, b));
        break;
      case 4:
        numbers.push_back(recorder.negate_product(a, b));
        break;
      case 5:
        numbers.push_back(recorder.subtract_product(a, b, c));
        break;
      case 6:
        numbers.push_back(recorder.smaller(a, b));
        break;
      case 7:
        numbers.push_back(recorder.larger(a, b));
        break;
      default: {
        const std::vector<LaneRecorder::Product> products = {{a, b}, {b, c}, {c, any()}};
        numbers.push_back(recorder.substitute(products, any()));
        break;
      }
    }
    recorder.demand_at_most(numbers.back(), recorder.constant(1e6));
  }
  return numbers;
}

TEST(LaneTape, GivesTheSameBitsForAnyNumberOfLanes) {
  constexpr unsigned kSeed = 20261122;
  constexpr std::size_t kInputs = 6;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(round);
    LaneRecorder recorder;
    const std::vector<TapeNumber> outputs = record_anything(random, kInputs, recorder);
    const LaneTape tape = recorder.make_tape(outputs);
    LaneTape::Workspace lanes = tape.make_workspace(kLanes);
    LaneTape::Workspace alone = tape.make_workspace(1);
    std::vector<double> inputs;
    for (std::size_t i = 0; i < kInputs * kLanes; ++i) {
      inputs.push_back(random() % 10 == 0 ? 0.0 : number(random));
      tape.set_input(lanes, i / kLanes, i % kLanes, inputs.back());
    }
    tape.play(lanes);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      SCOPED_TRACE(lane);
      for (std::size_t i = 0; i < kInputs; ++i) {
        tape.set_input(alone, i, 0, inputs[i * kLanes + lane]);
      }
      tape.play(alone);
      EXPECT_EQ(tape.is_met(lanes, lane), tape.is_met(alone, 0));
      for (std::size_t o = 0; o < outputs.size(); ++o) {
        const double a = tape.output(lanes, o, lane);
        const double b = tape.output(alone, o, 0);
        // Which of two NaNs goes on is left open.
        EXPECT_TRUE(bits_of(a) == bits_of(b) || (std::isnan(a) && std::isnan(b))) << a << " " << b;
      }
    }
  }
}

TEST(LaneTape, HasNoQuotientOfZeros) {
  LaneRecorder recorder;
  const TapeNumber zero = recorder.constant(0.0);
  const TapeNumber any = recorder.input(1.0);
  const TapeNumber positive = recorder.input(1.0, {.low = 0.5, .high = 2.0});
  const TapeNumber outputs[] = {recorder.divide(zero, any), recorder.divide(zero, positive)};
  EXPECT_TRUE(recorder.is_zero(outputs[1]));
  const LaneTape tape = recorder.make_tape(outputs);
  LaneTape::Workspace workspace = tape.make_workspace(1);
  for (const double divisor : {3.0, 0.0}) {
    tape.set_input(workspace, 0, 0, divisor);
    tape.play(workspace);
    EXPECT_EQ(std::isnan(tape.output(workspace, 0, 0)), divisor == 0.0);
  }
}

TEST(LaneTape, StaysWithinTheRangesOfItsNumbers) {
  constexpr unsigned kSeed = 20261123;
  constexpr std::size_t kInputs = 4;
  std::mt19937 random(kSeed);
  int bounded = 0;
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    LaneRecorder recorder;
    std::vector<TapeNumber> outputs = record_anything(random, kInputs, recorder);
    outputs.resize(60);  // later ones are bounded by nothing
    const LaneTape tape = recorder.make_tape(outputs);
    LaneTape::Workspace workspace = tape.make_workspace(kLanes);
    for (std::size_t i = 0; i < kInputs * kLanes; ++i) {
      const double most = 2.0 + static_cast<double>(i / kLanes);
      std::uniform_real_distribution<double> number(-2.0, most);
      const double ends[] = {-2.0, most, 0.0, number(random), number(random)};
      tape.set_input(workspace, i / kLanes, i % kLanes, ends[random() % 5]);
    }
    tape.play(workspace);
    for (std::size_t o = 0; o < outputs.size(); ++o) {
      const TapeRange& range = recorder.range(outputs[o]);
      bounded += std::isfinite(range.most()) ? 1 : 0;
      for (std::size_t lane = 0; lane < kLanes && std::isfinite(range.most()); ++lane) {
        const double value = tape.output(workspace, o, lane);
        EXPECT_TRUE(range.low <= value && value <= range.high)
            << value << " " << range.low << " " << range.high;
      }
    }
  }
  EXPECT_GT(bounded, 2000);
}

TEST(LaneTape, NotesNoDemandThatTheRangesAnswer) {
  LaneRecorder recorder;
  const TapeNumber x = recorder.input(3.0, {.low = 2.0, .high = 4.0});
  const TapeNumber y = recorder.input(7.0, {.low = 5.0, .high = 9.0});
  const TapeNumber difference = recorder.subtract(x, y);
  recorder.demand_at_least(difference, recorder.constant(1.0));
  recorder.demand_at_most(difference, recorder.constant(7.0));
  recorder.demand_no_underflow(recorder.multiply(x, y), x, y);
  EXPECT_EQ(recorder.make_tape({}).operation_count(), 0U);

  recorder.demand_at_least(difference, recorder.constant(1.5));
  EXPECT_EQ(recorder.make_tape({}).operation_count(), 2U);
}

// A pin on a gear that rides on another: (x + y) - x is y, whatever x is.
TEST(LaneTape, NotesNoDemandThatIsAnsweredOnceTermsCancel) {
  LaneRecorder recorder;
  const TapeNumber x = recorder.input(3.0, {.low = 1.0, .high = 100.0});
  const TapeNumber y = recorder.input(7.0, {.low = 5.0, .high = 9.0});
  const TapeNumber share = recorder.constant(0.3);
  const TapeNumber both = recorder.multiply(recorder.add(x, y), share);
  const TapeNumber rest = recorder.subtract_product(
      both, recorder.constant(2.0), recorder.multiply(x, recorder.constant(0.15)));
  recorder.demand_at_least(rest, recorder.constant(1.49));
  recorder.demand_at_most(recorder.subtract(both, recorder.multiply(x, share)),
                          recorder.constant(2.71));
  EXPECT_EQ(recorder.make_tape({}).operation_count(), 0U);

  recorder.demand_at_least(rest, recorder.constant(1.51));
  EXPECT_GT(recorder.make_tape({}).operation_count(), 0U);
}

// Sums of multiples of the inputs, of which most terms cancel.
TEST(LaneTape, StaysWithinTheRangesOfSumsThatCancel) {
  constexpr unsigned kSeed = 20261124;
  constexpr std::size_t kInputs = 3;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  int narrow = 0;
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    LaneRecorder recorder;
    std::vector<TapeNumber> sums;
    for (std::size_t i = 0; i < kInputs; ++i) {
      sums.push_back(recorder.input(1.0, {.low = -2.0, .high = 2.0}));
    }
    for (int i = 0; i < 40; ++i) {
      const TapeNumber a = sums[random() % sums.size()];
      const TapeNumber b = sums[random() % sums.size()];
      const TapeNumber factor = recorder.constant(random() % 4 == 0 ? 1.0 : number(random));
      sums.push_back(random() % 2 == 0 ? recorder.subtract(recorder.multiply(a, factor), b)
                                       : recorder.subtract_product(a, factor, b));
    }
    const LaneTape tape = recorder.make_tape(sums);
    LaneTape::Workspace workspace = tape.make_workspace(kLanes);
    for (std::size_t i = 0; i < kInputs * kLanes; ++i) {
      const double ends[] = {-2.0, 2.0, std::clamp(number(random), -2.0, 2.0)};
      tape.set_input(workspace, i / kLanes, i % kLanes, ends[random() % 3]);
    }
    tape.play(workspace);
    for (std::size_t o = 0; o < sums.size(); ++o) {
      const TapeRange& range = recorder.range(sums[o]);
      narrow += range.most() < 1e-12 ? 1 : 0;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const double value = tape.output(workspace, o, lane);
        EXPECT_TRUE(range.low <= value && value <= range.high)
            << value << " " << range.low << " " << range.high;
      }
    }
  }
  EXPECT_GT(narrow, 100);
}

TEST(LaneTape, DoesWhatIsRecorded) {
  LaneRecorder recorder;
  const TapeNumber x = recorder.input(2.0);
  const TapeNumber y = recorder.input(3.0);
  const std::vector<LaneRecorder::Product> products = {{x, y}, {y, recorder.constant(5.0)}};
  const std::vector<TapeNumber> outputs = {
      recorder.add(x, y),
      recorder.subtract(x, y),
      recorder.multiply(x, y),
      recorder.divide(x, y),
      recorder.negate_product(x, y),
      recorder.subtract_product(x, y, recorder.constant(7.0)),
      recorder.substitute(products, x),
      recorder.smaller(x, y),
      recorder.larger(x, y),
  };
  // For 4 and 3: sums and products that can be worked out by hand.
  const std::vector<double> expected = {
      7.0, 1.0, 12.0, 4.0 / 3.0, -12.0, -17.0, -27.0 / 4.0, 3.0, 4.0};

  const LaneTape tape = recorder.make_tape(outputs);
  LaneTape::Workspace workspace = tape.make_workspace(1);
  tape.set_input(workspace, 0, 0, 4.0);
  tape.set_input(workspace, 1, 0, 3.0);
  tape.play(workspace);

  for (std::size_t o = 0; o < expected.size(); ++o) {
    EXPECT_EQ(tape.output(workspace, o, 0), expected[o]) << o;
  }
}

TEST(LaneTape, MakesZerosOfRounding) {
  LaneRecorder recorder;
  const TapeNumber x = recorder.input(1.0);
  const TapeNumber tenth = recorder.constant(0.1);
  const std::vector<LaneRecorder::Product> products = {
      {x, recorder.constant(0.3)}, {x, recorder.constant(-0.1)}, {x, recorder.constant(-0.2)}};
  const std::vector<TapeNumber> outputs = {
      recorder.subtract_product(
          recorder.multiply(x, recorder.constant(0.3)), x, recorder.constant(0.1 + 0.2)),
      recorder.substitute(products, tenth)};
  ASSERT_NE(0.1 + 0.2, 0.3);

  const LaneTape tape = recorder.make_tape(outputs);
  LaneTape::Workspace workspace = tape.make_workspace(1);
  tape.set_input(workspace, 0, 0, 7.0);
  tape.play(workspace);

  EXPECT_EQ(tape.output(workspace, 0, 0), 0.0);
  EXPECT_EQ(tape.output(workspace, 1, 0), 0.0);
}

TEST(LaneTape, SaysInWhichLanesADemandIsNotMet) {
  LaneRecorder recorder;
  const TapeNumber x = recorder.input(1.0);
  const TapeNumber product = recorder.multiply(x, x);
  recorder.demand_at_most(x, recorder.constant(10.0));
  recorder.demand_at_least(x, recorder.constant(0.5));
  recorder.demand_no_underflow(product, x, x);
  const LaneTape tape = recorder.make_tape(std::vector<TapeNumber>{product});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inputs[kLanes] = {1.0, -10.0, 10.5, 0.25, nan, -0.5, -11.0, 0.0};
  const bool expected[kLanes] = {true, true, false, false, false, true, false, false};

  LaneTape::Workspace workspace = tape.make_workspace(kLanes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    tape.set_input(workspace, 0, lane, inputs[lane]);
  }
  tape.play(workspace);

  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    EXPECT_EQ(tape.is_met(workspace, lane), expected[lane]) << lane;
  }
}

TEST(LaneTape, TellsUnderflowFromZero) {
  LaneRecorder recorder;
  const TapeNumber x = recorder.input(1.0);
  const TapeNumber small = recorder.constant(1e-200);
  const TapeNumber product = recorder.multiply(x, small);
  recorder.demand_no_underflow(product, x, small);
  const LaneTape tape = recorder.make_tape(std::vector<TapeNumber>{product});

  LaneTape::Workspace workspace = tape.make_workspace(1);
  for (const auto& [value, expected] :
       std::vector<std::pair<double, bool>>{{1.0, true}, {0.0, true}, {1e-200, false}}) {
    SCOPED_TRACE(value);
    tape.set_input(workspace, 0, 0, value);
    tape.play(workspace);
    EXPECT_EQ(tape.is_met(workspace, 0), expected);
  }
}

TEST(LaneTape, LeavesOutWhatNothingNeeds) {
  LaneRecorder recorder;
  const TapeNumber x = recorder.input(2.0);
  const TapeNumber y = recorder.input(3.0);
  const TapeNumber wanted = recorder.add(x, x);
  recorder.multiply(wanted, y);

  const LaneTape tape = recorder.make_tape(std::vector<TapeNumber>{wanted});

  EXPECT_EQ(tape.operation_count(), 1U);
  EXPECT_TRUE(tape.reads_input(0));
  EXPECT_FALSE(tape.reads_input(1));
}

TEST(LaneRecorder, WorksOutConstantsAndNotesEachOperationOnce) {
  LaneRecorder recorder;
  const TapeNumber x = recorder.input(2.0);
  const TapeNumber half = recorder.constant(0.5);

  EXPECT_EQ(recorder.value(recorder.add(half, half)), 1.0);
  EXPECT_TRUE(recorder.is_constant(recorder.add(half, half)));
  EXPECT_EQ(recorder.multiply(x, recorder.constant(1.0)), x);
  EXPECT_EQ(recorder.add(x, recorder.constant(0.0)), x);
  EXPECT_TRUE(recorder.is_zero(recorder.multiply(x, recorder.constant(0.0))));
  EXPECT_EQ(recorder.multiply(x, half), recorder.multiply(half, x));
  EXPECT_EQ(recorder.divide(x, recorder.constant(4.0)),
            recorder.multiply(recorder.multiply(x, half), half));
}

// Not above the bound a number is an exact zero; where its range leaves no doubt it stays what it
// is.
TEST(LaneRecorder, TakesForZeroWhatABoundDoesNotTellFromIt) {
  LaneRecorder recorder;
  const TapeNumber value = recorder.input(2.0, {.low = -2.0, .high = 2.0});
  const TapeNumber bound = recorder.input(0.5, {.low = 0.0, .high = 1.0});
  const TapeNumber kept = recorder.zero_within(value, bound);
  EXPECT_EQ(recorder.value(kept), 2.0);
  EXPECT_EQ(recorder.value(recorder.zero_within(recorder.constant(0.5), recorder.constant(0.5))),
            0.0);
  EXPECT_EQ(recorder.value(recorder.zero_within(recorder.constant(-0.75), recorder.constant(0.5))),
            -0.75);
  EXPECT_EQ(recorder.zero_within(value, recorder.constant(0.0)), value);
  const LaneTape tape = recorder.make_tape(std::vector<TapeNumber>{kept});
  LaneTape::Workspace workspace = tape.make_workspace(1);
  const auto played = [&](double number, double within) {
    tape.set_input(workspace, 0, 0, number);
    tape.set_input(workspace, 1, 0, within);
    tape.play(workspace);
    return tape.output(workspace, 0, 0);
  };
  EXPECT_EQ(played(-0.25, 0.5), 0.0);
  EXPECT_EQ(played(-0.5, 0.5), 0.0);
  EXPECT_EQ(played(-0.75, 0.5), -0.75);
  EXPECT_EQ(played(1e-300, 0.0), 1e-300);
}

}  // namespace

}  // namespace kinestat
