#include "studies/synthesis/selection/selection.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "studies/synthesis/positions/special_frame.hpp"
#include "studies/synthesis/positions/specification.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

const Point kFreePoint{0.75, 2.0};

// do Valle 1983: E in the origin, its pole and its centre, in tables 3 (PPP-P-P) and 5 (PPPP-P).
PositionSpecification first_position(double degrees, bool is_stationary) {
  return {.at = {0.0, 0.0},
          .angle = degrees * kDegree,
          .pole = Point(3.75, 3.25),
          .curvature = CurvatureSpecification{{3.0, 2.6}, kFreePoint, 0.58},
          .is_stationary = is_stationary};
}

std::optional<std::vector<PositionJets>> table_3(std::span<const double> choice) {
  const auto first = find_jets(first_position(30.0, false), {.s = choice[0]});
  return std::vector{*first.jets,
                     finite_position({2.25, 1.2}, 52.0 * kDegree),
                     finite_position({4.0, 1.0}, 65.0 * kDegree)};
}

std::optional<std::vector<PositionJets>> table_5(std::span<const double> choice) {
  const auto first = find_jets(first_position(0.0, true), {.s = choice[0], .tau = choice[1]});
  return std::vector{*first.jets, finite_position({0.0, 0.0}, 27.0 * kDegree)};
}

// The ratio m that another free point has in such a motion, infinite on the inflection circle: the
// way back from effective freedom to what a user specifies. Empty in the pole.
std::optional<double> find_ratio(const PositionJets& position, const Point& free_point) {
  const std::optional<SpecialFrame> frame = find_special_frame(position);
  const Point arm = frame ? free_point - frame->pole : Point(0.0, 0.0);
  const double r = std::abs(arm);
  if (!(r > 0.0)) {
    return std::nullopt;
  }
  // m = r / (r - j), j where the line of the point meets the inflection circle.
  const Point diameter = unit_vector(frame->angle) * Point(0.0, frame->diameter);
  return r / (r - dot(diameter, arm) / r);
}

// The reference was computed independently by a search of its own.
TEST(EffectiveFreedom, StandsForAFreePointAndItsRatio) {
  const auto jets = find_jets(first_position(30.0, false), {.s = -2.1655612406317544});

  EXPECT_NEAR(*find_ratio(*jets.jets, kFreePoint), 0.8671033547387643, 1e-12);
}

TEST(EffectiveFreedom, LeavesTheConditionsOfTheFreePointOut) {
  PositionSpecification given = first_position(0.0, true);
  given.is_burmester = true;
  const PositionJets expected = *find_jets(given).jets;
  PositionSpecification other = given;
  other.curvature->free_point = {9.0, -4.0};
  other.curvature->ratio = *find_ratio(expected, {9.0, -4.0});

  // The same diameter by another free point; the higher orders ask other things of it.
  const PositionJets found = *find_jets(other).jets;

  EXPECT_LT(std::abs(origin(found, 2) - origin(expected, 2)), 1e-13);
}

// The reference scans the arc in steps and passes over the pose in which crank and ground are in
// line: 3.439 deg, its margin, is the transmission angle in the first position.
TEST(Selection, HasTheReferencesLinkageOfTable3) {
  const std::vector<SelectionRange> ranges = {
      {.from = -2.1655612406317544, .to = -2.1655612406317544, .count = 1}};

  const Selection found = select_linkages(ranges, candidates_of(table_3, {}), 1);

  ASSERT_EQ(found.best.size(), 1U);
  const LinkageCandidate& best = found.best[0].candidate;
  EXPECT_NEAR(best.lengths->longest(), 2.6854622355962268, 1e-11);
  EXPECT_NEAR(best.ratio, 1.8319543172153978, 1e-11);
  EXPECT_NEAR(best.best().transmission[0], 3.439112677453697 * kDegree, 1e-10);
  EXPECT_LT(best.margin(), 3.439 * kDegree);
}

TEST(Selection, ImprovesTheBestLinkageOfTheGrid) {
  const std::vector<SelectionRange> coarse = {{.from = -20.0, .to = 20.0, .count = 41}};
  const std::vector<SelectionRange> fine = {{.from = -4.0, .to = -1.0, .count = 3001}};

  const Selection found = select_linkages(coarse, candidates_of(table_3, {}), 1);
  const Selection scanned = select_linkages(fine, candidates_of(table_3, {}), 1);

  ASSERT_EQ(found.best.size(), 1U);
  EXPECT_NEAR(found.best[0].candidate.margin(), scanned.best[0].candidate.margin(), 1e-7);
}

// At the choice of the reference, with its lengths and its margin.
TEST(Selection, HasTheReferencesLinkageOfTable5) {
  const std::vector<SelectionRange> ranges = {
      {.from = -19.952623149688797, .to = -19.952623149688797, .count = 1},
      {.from = 0.12742749857031335, .to = 0.12742749857031335, .count = 1}};

  const Selection found = select_linkages(ranges, candidates_of(table_5, {.ratio = 12.0}), 1);

  ASSERT_EQ(found.best.size(), 1U);
  const LinkageCandidate& best = found.best[0].candidate;
  EXPECT_NEAR(best.margin(), 70.09809749313409 * kDegree, 2e-4);
  EXPECT_NEAR(best.ratio, 9.968503723931825, 1e-9);
  EXPECT_NEAR(best.lengths->longest(), 39.573829836725594, 1e-9);
}

// do Valle 1983, table 4 (PPP-PP).
std::optional<std::vector<PositionJets>> table_4(std::span<const double> choice) {
  const auto first = find_jets(first_position(30.0, false), {.s = choice[0]});
  const auto second =
      find_jets({.at = {2.85, 0.075}, .angle = 55.0 * kDegree, .pole = Point(2.26, 2.26)});
  return std::vector{*first.jets, *second.jets};
}

// The grid of the reference: both signs of powers of ten in equal steps. The first number is the
// sign, the second the exponent.
const std::vector<SelectionRange> kSignAndExponent = {{.from = -1.0, .to = 1.0, .count = 2},
                                                      {.from = -2.0, .to = 2.0, .count = 150}};

TaskMaker by_exponent(const TaskMaker& by_s) {
  return [by_s](std::span<const double> choice) {
    return by_s(std::vector{choice[0] * std::pow(10.0, choice[1])});
  };
}

// The reference counts samples with a linkage free of defects, whatever its ratio of links.
TEST(Selection, FindsAsManyUsableSamplesAsTheReferenceInTable3) {
  const Selection found =
      select_linkages(kSignAndExponent, candidates_of(by_exponent(table_3), {}), 1);

  EXPECT_EQ(found.counts.samples, 300);
  EXPECT_EQ(found.counts.usable, 165);
}

TEST(Selection, FindsAsManyUsableSamplesAsTheReferenceInTable4) {
  const Selection found =
      select_linkages(kSignAndExponent, candidates_of(by_exponent(table_4), {}), 1);

  EXPECT_EQ(found.counts.samples, 300);
  EXPECT_EQ(found.counts.usable, 189);
}

// Signs and exponents of s and of tau. The reference counts 1172: of its 2400 linkages it judges
// one otherwise.
TEST(Selection, FindsAsManyUsableSamplesAsTheReferenceInTable5) {
  const std::vector<SelectionRange> ranges = {{.from = -1.0, .to = 1.0, .count = 2},
                                              {.from = -1.0, .to = 1.3, .count = 30},
                                              {.from = -1.0, .to = 1.0, .count = 2},
                                              {.from = -2.0, .to = 1.0, .count = 20}};
  const TaskMaker make = [](std::span<const double> choice) {
    return table_5(
        std::vector{choice[0] * std::pow(10.0, choice[1]), choice[2] * std::pow(10.0, choice[3])});
  };

  const Selection found =
      select_linkages(ranges, candidates_of(make, {.transmission = 0.0045 * kDegree}), 1);

  EXPECT_EQ(found.counts.samples, 2400);
  EXPECT_EQ(found.counts.usable, 1172);
}

// At the edge of that grid, s = -100.
TEST(Selection, HasTheReferencesLinkageOfTable4) {
  const std::vector<SelectionRange> ranges = {{.from = -100.0, .to = -100.0, .count = 1}};

  const Selection found = select_linkages(ranges, candidates_of(table_4, {}), 1);

  ASSERT_EQ(found.best.size(), 1U);
  const LinkageCandidate& best = found.best[0].candidate;
  EXPECT_NEAR(best.margin(), 44.43 * kDegree, 0.005 * kDegree);
  EXPECT_NEAR(best.ratio, 5.1, 0.005);
  EXPECT_NEAR(best.lengths->ground, 0.75776, 5e-6);
  EXPECT_NEAR(best.lengths->coupler, 0.715703, 5e-7);
  EXPECT_NEAR(std::min(best.lengths->crank_one, best.lengths->crank_other), 0.148575, 5e-7);
  EXPECT_NEAR(std::max(best.lengths->crank_one, best.lengths->crank_other), 0.186488, 5e-7);
  const auto jets = find_jets(first_position(30.0, false), {.s = -100.0});
  EXPECT_NEAR(*find_ratio(*jets.jets, kFreePoint), -0.120539, 5e-7);
}

// Whatever is done at once, in whatever order: here backwards.
TEST(Selection, DoesNotDependOnTheOrderOfItsSamples) {
  const ForEach backwards = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t i = count; i > 0; --i) {
      job(i - 1);
    }
  };
  const std::vector<SelectionRange> ranges = {{.from = -20.0, .to = 20.0, .count = 500}};
  const CandidateMaker make = candidates_of(table_3, {});

  const Selection one = select_linkages(ranges, make, 3);
  const Selection other = select_linkages(ranges, make, 3, backwards);

  ASSERT_EQ(one.best.size(), other.best.size());
  for (std::size_t i = 0; i < one.best.size(); ++i) {
    EXPECT_EQ(one.best[i].choice, other.best[i].choice);
    EXPECT_EQ(one.best[i].candidate.margin(), other.best[i].candidate.margin());
  }
}

TEST(Selection, KeepsToTheLimits) {
  const std::vector<SelectionRange> ranges = {{.from = -20.0, .to = -1.0, .count = 20},
                                              {.from = -1.0, .to = 1.0, .count = 21}};

  const Selection found =
      select_linkages(ranges, candidates_of(table_5, {.ratio = 6.0, .size = 30.0}), 5);

  ASSERT_FALSE(found.best.empty());
  EXPECT_LE(found.counts.usable, found.counts.with_linkage);
  for (const SelectedLinkage& one : found.best) {
    EXPECT_LE(one.candidate.ratio, 6.0 * (1.0 + 1e-11));
    EXPECT_LE(one.candidate.longest, 30.0 * (1.0 + 1e-11));
  }
}

// All samples once more, each task solved and judged by itself.
struct Trials {
  std::array<int, kDefectCount> defects{};
  int without_linkage = 0;
  double least_ratio = std::numeric_limits<double>::infinity();  // of those with that defect
};

Trials try_table_3(const SelectionRange& range, const LinkageLimits& limits) {
  Trials trials;
  for (int i = 0; i < range.count; ++i) {
    const double s = range.from + (range.to - range.from) / (range.count - 1) * i;
    const std::vector<PositionJets> positions = *table_3(std::vector{s});
    const auto ranked = rank_linkages(solve_burmester(positions).dyads, positions, limits);
    if (ranked.empty()) {
      ++trials.without_linkage;
      continue;
    }
    ++trials.defects[static_cast<std::size_t>(ranked.front().defect())];
    if (ranked.front().defect() == Defect::ratio) {
      trials.least_ratio = std::min(trials.least_ratio, ranked.front().ratio);
    }
  }
  return trials;
}

TEST(Selection, CountsEverySampleByWhatSpeaksAgainstIt) {
  const SelectionRange range = {.from = -20.0, .to = 20.0, .count = 200};
  const LinkageLimits limits = {.transmission = 2.0 * kDegree, .ratio = 2.0};
  const Trials expected = try_table_3(range, limits);

  const Selection found = select_linkages(std::span(&range, 1), candidates_of(table_3, limits), 1);

  EXPECT_EQ(found.counts.defects, expected.defects);
  EXPECT_EQ(found.counts.missing[static_cast<std::size_t>(Missing::dyads)],
            expected.without_linkage);
  EXPECT_EQ(found.counts.usable, found.counts.defects[0]);
}

TEST(Selection, HasAsTheNearestWhatMissesItsLimitLeast) {
  const SelectionRange range = {.from = -20.0, .to = 20.0, .count = 200};
  const LinkageLimits limits = {.ratio = 1.0};
  const Trials expected = try_table_3(range, limits);

  const Selection found = select_linkages(std::span(&range, 1), candidates_of(table_3, limits), 1);

  ASSERT_TRUE(found.nearest.has_value());
  EXPECT_EQ(found.nearest->candidate.defect(), Defect::ratio);
  const double step = (range.to - range.from) / (range.count - 1);
  const double best = found.nearest->choice.front();
  const Trials around =
      try_table_3({.from = best - step, .to = best + step, .count = 2001}, limits);
  EXPECT_LE(found.nearest->candidate.ratio, expected.least_ratio);
  EXPECT_LE(found.nearest->candidate.ratio, around.least_ratio * (1.0 + 1e-9));
}

// Every choice once more, without each of the limits in turn.
TEST(Selection, CountsWhatASingleLimitKeepsFromBeingUsable) {
  const SelectionRange range = {.from = -20.0, .to = 20.0, .count = 60};
  int by_ratio = 0;
  int by_angle = 0;
  for (const double ratio : {1.5, 2.0, 3.0}) {
    for (const double angle : {0.5 * kDegree, 1.0 * kDegree, 2.0 * kDegree}) {
      SCOPED_TRACE(testing::Message() << ratio << " " << angle);
      const LinkageLimits limits = {.transmission = angle, .ratio = ratio};
      const auto usable = [&](const LinkageLimits& of) {
        return try_table_3(range, of).defects[0];
      };
      const int with_all = usable(limits);
      const int any_angle = usable({.ratio = ratio}) - with_all;
      const int any_ratio = usable({.transmission = angle}) - with_all;

      const SelectionCounts counts =
          select_linkages(std::span(&range, 1), candidates_of(table_3, limits), 1).counts;

      // Of a choice with two such linkages the one that misses the milder limit counts.
      EXPECT_EQ(counts.one_limit[static_cast<std::size_t>(Defect::ratio)], any_ratio);
      EXPECT_LE(counts.one_limit[static_cast<std::size_t>(Defect::transmission)], any_angle);
      by_ratio += any_ratio;
      by_angle += counts.one_limit[static_cast<std::size_t>(Defect::transmission)];
    }
  }
  EXPECT_GT(by_ratio, 0);
  EXPECT_GT(by_angle, 0);
}

// Its dyads are cranks, and of some choices none is real.
TEST(Selection, ComesNearestToALinkageWithTheDyadsOfAnotherKind) {
  const SelectionRange range = {.from = -20.0, .to = 20.0, .count = 200};

  const Selection found =
      select_linkages(std::span(&range, 1),
                      candidates_of(table_3, {.type = LinkageType::slider_crank}),
                      1,
                      one_after_another,
                      shortfalls_of(table_3));

  EXPECT_EQ(found.counts.with_linkage, 0);
  EXPECT_EQ(found.counts.missing[static_cast<std::size_t>(Missing::dyads)],
            try_table_3(range, {}).without_linkage);
  EXPECT_EQ(found.counts.missing[static_cast<std::size_t>(Missing::kind)] +
                found.counts.missing[static_cast<std::size_t>(Missing::dyads)],
            200);
  ASSERT_TRUE(found.nearest_choice.has_value());
  EXPECT_GE(solve_burmester(*table_3(*found.nearest_choice)).dyads.size(), 2U);
}

// A linkage of whose margin alone is asked.
LinkageCandidate with_margin(double margin, double ratio) {
  LinkageCandidate one;
  one.ratio = ratio;
  one.verdicts[0].working_arc = TransmissionRange{.least = margin, .most = std::numbers::pi / 2};
  return one;
}

using Hill = std::function<double(double x, double y)>;

// Every choice has another ratio of links, so that these tell nothing.
CandidateMaker on_hill(const Hill& hill) {
  return [hill](std::span<const double> choice) {
    return std::optional(
        with_margin(hill(choice[0], choice[1]), 1.0 + choice[0] + 100.0 * choice[1]));
  };
}

double peak(double x, double y, double height) {
  return height * std::exp(-(x * x + y * y));
}

const std::vector<SelectionRange> kSquare(2, {.from = 0.0, .to = 10.0, .count = 41});

TEST(Selection, KeepsOneOfEachHill) {
  const Hill two = [](double x, double y) {
    return 0.1 + peak(x - 2.1, y - 3.2, 0.8) + peak(x - 7.3, y - 6.1, 0.5);
  };

  const Selection found = select_linkages(kSquare, on_hill(two), 10);

  ASSERT_EQ(found.best.size(), 2U);
  EXPECT_NEAR(found.best[0].choice[0], 2.1, 1e-4);
  EXPECT_NEAR(found.best[1].choice[1], 6.1, 1e-4);
}

// Steps along the axes stop anywhere on a sharp ridge: of what lies on it only the top is kept.
TEST(Selection, KeepsOneOfARidge) {
  const Hill ridge = [](double x, double y) {
    return 0.3 + 0.01 * x - 0.02 * std::abs(x - 0.37 * y - 3.0) + 0.001 * std::cos(9.0 * y);
  };

  const Selection found = select_linkages(kSquare, on_hill(ridge), 10);

  ASSERT_EQ(found.best.size(), 1U);
}

// Both hills are the same where the halves stand for the same.
TEST(Selection, KeepsOneOfTwoThatDifferByAnExchange) {
  const Hill two = [](double x, double y) {
    return 0.1 + peak(x - 2.1, y - 7.0, 0.8) + peak(x - 7.0, y - 2.1, 0.8);
  };

  const auto keep = [&](ChoiceHalves halves) {
    return select_linkages(kSquare, on_hill(two), 10, one_after_another, {}, halves).best.size();
  };

  EXPECT_EQ(keep(ChoiceHalves::differ), 2U);
  EXPECT_EQ(keep(ChoiceHalves::alike), 1U);
}

TEST(Selection, OfATaskWithoutMotionIsEmpty) {
  const std::vector<SelectionRange> ranges = {{.from = 0.0, .to = 1.0, .count = 3}};
  const TaskMaker none = [](auto) { return std::nullopt; };

  const Selection found =
      select_linkages(ranges, candidates_of(none, {}), 3, one_after_another, shortfalls_of(none));

  EXPECT_EQ(found.counts.missing[static_cast<std::size_t>(Missing::motion)], 3);
  EXPECT_FALSE(found.nearest_choice.has_value());
  EXPECT_EQ(found.counts.samples, 3);
  EXPECT_EQ(found.counts.with_linkage, 0);
  EXPECT_TRUE(found.best.empty());
}

}  // namespace
}  // namespace kinestat
