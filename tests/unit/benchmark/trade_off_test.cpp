#include "studies/benchmark/trade_off.hpp"

#include <gtest/gtest.h>

#include "library_mechanism.hpp"

namespace kinestat {
namespace {

// Each look at the clock takes a second: all methods are equally fast.
Clock ticking() {
  return [now = 0.0]() mutable { return now += 1.0; };
}

TradeOff trade_off_of(const std::string& name, ProblemSide side) {
  const Mechanism mechanism = library_mechanism(name);
  return find_trade_off(
      mechanism, mechanism.cases.front(), side, {.rounds = 1, .seconds = 0.0}, ticking());
}

const MethodResult& method(const TradeOff& result, SolveMethod which) {
  return result.methods[static_cast<std::size_t>(which)];
}

class Trade : public testing::TestWithParam<std::string> {};

TEST_P(Trade, BoundsCoverTheErrorAtEveryExtreme) {
  for (const ProblemSide side : {ProblemSide::motion, ProblemSide::action}) {
    const TradeOff result = trade_off_of(GetParam(), side);

    for (const SolveMethod which : {SolveMethod::bounded, SolveMethod::high}) {
      for (const ExtremeResult& one : method(result, which).extremes) {
        EXPECT_GE(one.bound.value(), one.error.value()) << key_of(which);
      }
    }
  }
}

TEST_P(Trade, HighHasTwiceTheDigitsOfDoubles) {
  for (const ProblemSide side : {ProblemSide::motion, ProblemSide::action}) {
    const TradeOff result = trade_off_of(GetParam(), side);

    EXPECT_LT(method(result, SolveMethod::fast).worst_error.value(), 1e-11);
    EXPECT_LT(method(result, SolveMethod::high).worst_error.value(), 1e-26);
    EXPECT_EQ(method(result, SolveMethod::exact).worst_error.value(), 0.0);
  }
}

// Of methods that are equally fast only the most accurate is on the front.
TEST_P(Trade, TheFrontIsOfTheMostAccurate) {
  const TradeOff result = trade_off_of(GetParam(), ProblemSide::motion);

  for (const MethodResult& one : result.methods) {
    EXPECT_EQ(one.is_on_front, one.method == SolveMethod::exact) << key_of(one.method);
  }
}

// 2^-24 of a distance of 10^9 sizes is many sizes.
TEST_P(Trade, FloatsLoseEverythingFarFromTheOrigin) {
  const TradeOff result = trade_off_of(GetParam(), ProblemSide::action);
  const ExtremeResult& far = method(result, SolveMethod::float_lu).extremes.back();

  EXPECT_TRUE(far.status == MethodStatus::not_finite || far.error.value() > 0.1);
}

INSTANTIATE_TEST_SUITE_P(Library,
                         Trade,
                         testing::Values("planar/four_bar.yaml", "transmissions/ravigneaux.yaml"),
                         [](const auto& one) { return one.index == 0 ? "FourBar" : "Ravigneaux"; });

TEST(TradeOff, SaysWhyThereIsNone) {
  const Mechanism mechanism = library_mechanism("planar/four_bar.yaml");

  const TradeOff result =
      find_trade_off(mechanism, Case(), ProblemSide::motion, {.rounds = 1}, ticking());

  EXPECT_EQ(result.reason, NoProblem::not_asked);
  EXPECT_TRUE(result.methods.empty());
}

}  // namespace
}  // namespace kinestat
