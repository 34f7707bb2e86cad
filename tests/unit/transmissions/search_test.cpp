#include "studies/transmissions/search.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "studies/transmissions/found_text.hpp"

namespace kinestat {
namespace {

struct SearchCounts {
  std::uint64_t structures;
  std::uint64_t layouts;
  std::uint64_t labelled;
  std::uint64_t layouts_found;
  std::uint64_t found;
  std::uint64_t points;
};

// Counted by a second program, those of two sets by brute force over roles, grid and chains too.
struct ReferenceTask {
  std::string name;
  TransmissionTask task;
  SearchCounts counts;
  std::optional<std::array<std::uint64_t, 2>> buildable = {};  // coaxial, sideways
};

struct Kinds {
  int simple;
  int double_planet;
};

TransmissionTask task_with(Kinds sets,
                           int elements,
                           int engaged,
                           LadderTask ladder,
                           std::vector<double> simple,
                           std::vector<double> double_planet = {}) {
  TransmissionTask task{.simple_sets = sets.simple,
                        .double_planet_sets = sets.double_planet,
                        .elements = elements,
                        .engaged = engaged,
                        .ladder = ladder};
  task.stationary_ratios[0].values = std::move(simple);
  task.stationary_ratios[1].values = std::move(double_planet);
  task.losses = {0.02, 0.03};
  return task;
}

std::vector<double> fifths_to(double last) {
  std::vector<double> values;
  for (int i = 8; i <= static_cast<int>(last * 5.0 + 0.5); ++i) {
    values.push_back(i / 5.0);
  }
  return values;
}

// NOLINTBEGIN
std::vector<ReferenceTask> reference_tasks() {
  return {
      {"TwoGears",
       task_with({1, 0},
                 2,
                 1,
                 {.forward = 2, .needs_direct = true, .first = {2.53, 4.27}, .step = {2.47, 4.33}},
                 fifths_to(3.2)),
       {3, 3, 18, 3, 3, 27}},
      {"ThreeGears",
       task_with({2, 0},
                 4,
                 2,
                 {.forward = 3,
                  .reverse = 1,
                  .needs_direct = true,
                  .first = {2.23, 2.97},
                  .step = {1.33, 1.97},
                  .reverse_ratio = {1.53, 2.97}},
                 fifths_to(2.8)),
       {22, 127, 4356, 53, 109, 1401}},
      {"FourGears",
       task_with({2, 0},
                 5,
                 2,
                 {.forward = 4,
                  .reverse = 1,
                  .needs_direct = true,
                  .first = {2.57, 3.23},
                  .last = {0.61, 0.81},
                  .step = {1.31, 1.97},
                  .reverse_ratio = {1.83, 2.93}},
                 fifths_to(2.8)),
       {22, 135, 4662, 20, 33, 257},
       {{23, 29}}},
      {"FourGearsOfARavigneauxSet",
       task_with({1, 1},
                 5,
                 2,
                 {.forward = 4,
                  .reverse = 1,
                  .needs_direct = true,
                  .first = {2.27, 2.73},
                  .last = {0.61, 0.81},
                  .step = {1.31, 1.97},
                  .reverse_ratio = {1.83, 2.93}},
                 fifths_to(2.8),
                 {2.0, 2.2, 2.4, 2.6, 2.8}),
       {22, 135, 9288, 17, 36, 159},
       {{22, 32}}},
      {"FourGearsOfThreeEngaged",
       task_with({2, 0},
                 5,
                 3,
                 {.forward = 4,
                  .reverse = 1,
                  .first = {2.27, 3.97},
                  .last = {0.53, 0.83},
                  .step = {1.23, 2.07},
                  .reverse_ratio = {1.53, 3.97}},
                 fifths_to(2.8)),
       {13, 57, 1944, 5, 7, 60}},
      {"SixGears",
       task_with({3, 0},
                 5,
                 2,
                 {.forward = 6,
                  .reverse = 1,
                  .needs_direct = true,
                  .first = {3.83, 4.77},
                  .last = {0.61, 0.77},
                  .step = {1.13, 1.87},
                  .reverse_ratio = {2.33, 3.87}},
                 fifths_to(2.8)),
       {203, 3903, 834012, 307, 424, 5650},
       {{153, 203}}},
      {"SixGearsOfLepelletiersClass",
       task_with({2, 1},
                 5,
                 2,
                 {.forward = 6,
                  .reverse = 1,
                  .first = {3.83, 4.57},
                  .last = {0.61, 0.74},
                  .step = {1.13, 1.87},
                  .reverse_ratio = {2.83, 4.17}},
                 {1.6, 1.9, 2.2, 2.5, 2.8},
                 {2.2, 2.5, 2.8, 3.1}),
       {203, 3903, 2500668, 346, 815, 2381},
       {{285, 414}}},
      {"SixGearsOfThreeEngaged",
       task_with({3, 0},
                 5,
                 3,
                 {.forward = 6,
                  .reverse = 1,
                  .needs_direct = true,
                  .first = {3.53, 5.07},
                  .last = {0.53, 0.87},
                  .step = {1.13, 1.93},
                  .reverse_ratio = {2.03, 5.47}},
                 {1.6, 2.0, 2.4, 2.8, 3.2}),
       {133, 1664, 358128, 342, 498, 2649}},
  };
}

ReferenceTask eight_gears() {
  return {"EightGears",
          task_with({4, 0},
                    5,
                    3,
                    {.forward = 8,
                     .reverse = 1,
                     .needs_direct = true,
                     .first = {4.03, 5.47},
                     .spread = {6.53, 8.97},
                     .step = {1.13, 1.77},
                     .reverse_ratio = {2.53, 4.97}},
                    {1.6, 2.0, 2.8, 3.6}),
          {1557, 28188, 36320508, 5504, 7175, 17644}};
}

// A slice: the structure of the 8HP with a free shaft.
ReferenceTask ten_gears() {
  ReferenceTask reference = {"TenGears",
                             task_with({4, 0},
                                       6,
                                       4,
                                       {.forward = 10,
                                        .reverse = 1,
                                        .needs_direct = true,
                                        .first = {4.23, 5.21},
                                        .last = {0.55, 0.71},
                                        .step = {1.06, 1.77},
                                        .reverse_ratio = {3.53, 5.97}},
                                       {1.6, 1.9, 2.2, 3.7}),
                             {1, 247, 319464, 21, 23, 81}};
  reference.task.free_shafts = 1;
  reference.task.structures = {1435, 1435};
  return reference;
}

// NOLINTEND

void expect_counts(const TransmissionSearch& search, const SearchCounts& expected) {
  const SearchStages& stages = search.stages;
  EXPECT_EQ(stages.structures, expected.structures);
  EXPECT_EQ(stages.layouts, expected.layouts);
  EXPECT_EQ(stages.labelled_layouts, expected.labelled);
  EXPECT_EQ(stages.layouts_found, expected.layouts_found);
  EXPECT_EQ(stages.found, expected.found);
  EXPECT_EQ(stages.points, expected.points);
  EXPECT_EQ(search.found.size(), expected.found);
}

class ReferenceTasks : public ::testing::TestWithParam<int> {
 protected:
  ReferenceTask reference_ = reference_tasks()[static_cast<std::size_t>(GetParam())];
};

TEST_P(ReferenceTasks, AreSolvedAsOftenAsTwoProgramsCounted) {
  expect_counts(search_transmissions(reference_.task, for_each_on_threads(0)), reference_.counts);
}

TEST_P(ReferenceTasks, AreBuildableAsOften) {
  if (!reference_.buildable) {
    GTEST_SKIP() << "not counted";
  }
  for (const auto& [layout, expected] :
       {std::pair(SectionLayout::coaxial, (*reference_.buildable)[0]),
        std::pair(SectionLayout::sideways, (*reference_.buildable)[1])}) {
    reference_.task.layout = layout;
    const SearchStages stages =
        search_transmissions(reference_.task, for_each_on_threads(0)).stages;
    EXPECT_EQ(stages.found, expected);
    EXPECT_EQ(stages.found + stages.not_buildable, reference_.counts.found);
  }
}

INSTANTIATE_TEST_SUITE_P(Reference, ReferenceTasks, ::testing::Range(0, 8), [](const auto& test) {
  return reference_tasks()[static_cast<std::size_t>(test.param)].name;
});

// Two minutes and a half on one core.
TEST(DISABLED_LongTasks, EightGearsOfFourSets) {
  expect_counts(search_transmissions(eight_gears().task, for_each_on_threads(0)),
                eight_gears().counts);
}

// A quarter of a minute.
TEST(DISABLED_LongTasks, TenGearsWithAFreeShaft) {
  expect_counts(search_transmissions(ten_gears().task, for_each_on_threads(0)), ten_gears().counts);
}

bool are_same(const FoundTransmission& a, const FoundTransmission& b) {
  return a.structure == b.structure && a.layout == b.layout && a.roles == b.roles &&
         a.stationary_ratios == b.stationary_ratios && a.elements == b.elements &&
         a.ladder == b.ladder && a.ratios == b.ratios && a.rank == b.rank;
}

TEST(TransmissionSearch, DoesNotHangOnThreads) {
  const TransmissionTask task = reference_tasks()[2].task;
  const auto one = search_transmissions(task, one_after_another).found;
  const auto many = search_transmissions(task, for_each_on_threads(0)).found;
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_TRUE(are_same(one[i], many[i]));
  }
}

TEST(TransmissionSearch, IsPutTogetherFromSharesThatWereWritten) {
  const TransmissionTask task = reference_tasks()[2].task;
  const TransmissionSearch whole = search_transmissions(task, one_after_another);
  std::map<std::size_t, std::string> kept;
  const SearchStore store = {
      .find = [&](std::size_t structure) -> std::optional<TransmissionSearch> {
        return kept.contains(structure) ? read_found(kept[structure]) : std::nullopt;
      },
      .keep = [&](std::size_t structure,
                  const TransmissionSearch& found) { kept[structure] = write_found(found); }};
  std::uint64_t structures = 0;
  for (const std::size_t place : {2, 0, 1}) {
    structures +=
        search_transmissions(task, one_after_another, {.place = place, .count = 3}, &store)
            .stages.structures;
  }
  EXPECT_EQ(structures, whole.stages.structures);
  EXPECT_EQ(kept.size(), whole.stages.structures);
  const auto is_never_searched = [](std::size_t, const TransmissionSearch&) { FAIL(); };
  const SearchStore read_only = {.find = store.find, .keep = is_never_searched};
  const TransmissionSearch joined = search_transmissions(task, one_after_another, {}, &read_only);
  EXPECT_EQ(write_found(joined), write_found(whole));
  ASSERT_EQ(joined.found.size(), whole.found.size());
  for (std::size_t i = 0; i < joined.found.size(); ++i) {
    EXPECT_TRUE(are_same(joined.found[i], whole.found[i]));
  }
}

TEST(TransmissionSearch, OtherTextIsNoneOfASearch) {
  const TransmissionTask task = reference_tasks()[0].task;
  const std::string text = write_found(search_transmissions(task, one_after_another));
  EXPECT_TRUE(read_found(text));
  EXPECT_FALSE(read_found(""));
  EXPECT_FALSE(read_found(text.substr(0, text.size() - 1)));
  EXPECT_FALSE(read_found(text.substr(1 + text.find('\n') / 2)));
  EXPECT_FALSE(read_found(text + "x"));
}

TEST(TransmissionSearch, InRangesFindsWhatAGridHas) {
  TransmissionTask task = reference_tasks()[2].task;
  const auto on_grid = search_transmissions(task, one_after_another).found;
  task.stationary_ratios[0] = {.range = {1.6, 2.8}};
  const TransmissionSearch in_ranges = search_transmissions(task, one_after_another);
  for (const FoundTransmission& one : on_grid) {
    const auto same = std::ranges::find_if(in_ranges.found, [&](const FoundTransmission& other) {
      return other.structure == one.structure && other.layout == one.layout &&
             other.roles == one.roles;
    });
    ASSERT_NE(same, in_ranges.found.end());
    EXPECT_LE(same->rank, one.rank + 1e-4);
  }
}

// Values that are not all tried are still all looked at before a layout is refuted.
TEST(TransmissionSearch, OfManyValuesFindsWhatAGridHas) {
  TransmissionTask task = reference_tasks()[2].task;
  std::vector<double> values;
  for (int i = 0; i <= 24; ++i) {
    values.push_back(1.6 + i / 20.0);
  }
  task.stationary_ratios[0] = {.range = {values.front(), values.back()}, .values = values};
  const TransmissionSearch on_grid = search_transmissions(task, one_after_another);
  task.stationary_ratios[0].tries_all = false;
  const TransmissionSearch searched = search_transmissions(task, one_after_another);
  EXPECT_EQ(searched.stages.undecided, 0U);
  EXPECT_EQ(searched.stages.found, on_grid.stages.found);
  EXPECT_EQ(searched.stages.layouts_found, on_grid.stages.layouts_found);
  for (const FoundTransmission& one : searched.found) {
    for (std::size_t s = 0; s < 2; ++s) {
      EXPECT_TRUE(std::ranges::count(values, one.stationary_ratios[s]) == 1);
    }
  }
}

TEST(TransmissionSearch, KeepsLimits) {
  TransmissionTask task = reference_tasks()[2].task;
  const auto free = search_transmissions(task, one_after_another);
  task.limits = {.element_torque = 3.0,
                 .element_slip = 3.0,
                 .shaft_speed = 3.0,
                 .planet_speed = 2.5,
                 .rotating_clutches = 3};
  const auto limited = search_transmissions(task, one_after_another);
  EXPECT_GT(limited.stages.found, 0U);
  EXPECT_LT(limited.stages.found, free.stages.found);
  EXPECT_EQ(limited.stages.found + limited.stages.over_limits + limited.stages.not_buildable,
            free.stages.found);
  constexpr double kSlack = 1.0 + 1e-8;
  for (const FoundTransmission& one : limited.found) {
    EXPECT_LE(one.figures.element_torque, 3.0 * kSlack);
    EXPECT_LE(one.figures.element_slip, 3.0 * kSlack);
    EXPECT_LE(one.figures.shaft_speed, 3.0 * kSlack);
    EXPECT_LE(one.figures.planet_speed, 2.5 * kSlack);
    EXPECT_LE(one.figures.rotating_clutches, 3U);
  }
}

// What is left out by a limit on parts is what has more of them.
TEST(TransmissionSearch, KeepsLimitsOfParts) {
  TransmissionTask task = reference_tasks()[2].task;
  task.layout = SectionLayout::coaxial;
  const TransmissionSearch free = search_transmissions(task, one_after_another);
  for (const std::uint64_t most : {0U, 1U, 2U}) {
    task.limits.hollow_shafts = most;
    const TransmissionSearch limited = search_transmissions(task, one_after_another);
    EXPECT_EQ(limited.stages.not_buildable, free.stages.not_buildable);
    EXPECT_EQ(limited.stages.found + limited.stages.over_limits, free.stages.found);
    for (const FoundTransmission& one : limited.found) {
      EXPECT_LE(one.figures.hollow_shafts, most);
    }
    for (const FoundTransmission& one : free.found) {
      const bool is_kept = std::ranges::any_of(limited.found, [&](const FoundTransmission& other) {
        return one.structure == other.structure && one.layout == other.layout &&
               one.roles == other.roles;
      });
      // Another placement of the elements may have fewer.
      EXPECT_TRUE(is_kept || one.figures.hollow_shafts > most);
    }
  }
}

TEST(TransmissionSearch, RanksByPartsAndThenByLosses) {
  TransmissionTask task = reference_tasks()[2].task;
  task.layout = SectionLayout::coaxial;
  task.rank = TransmissionRank::elements;
  const TransmissionSearch search = search_transmissions(task, one_after_another);
  ASSERT_FALSE(search.found.empty());
  for (const FoundTransmission& one : search.found) {
    EXPECT_NEAR(one.rank,
                static_cast<double>(one.figures.rotating_clutches) +
                    static_cast<double>(one.figures.hollow_shafts.value()) + 1.0 -
                    one.figures.mean_efficiency,
                1e-12);
  }
}

// With enough work the count is that of a search; with little it is less and says so.
TEST(TransmissionSearch, CountsWhatItWouldFind) {
  const std::vector<ReferenceTask> references = reference_tasks();
  std::vector<TransmissionTask> tasks = {references[2].task, references[2].task};
  tasks[1].layout = SectionLayout::coaxial;
  const std::uint64_t layouts = references[2].counts.layouts;
  const auto all = count_transmissions(tasks, layouts, 100'000'000, for_each_on_threads(0));
  EXPECT_EQ(all[0].found, references[2].counts.found);
  EXPECT_EQ(all[1].found, (*references[2].buildable)[0]);
  EXPECT_FALSE(all[0].is_of_a_part || all[1].is_of_a_part);
  const auto some = count_transmissions(tasks, layouts, 1000, one_after_another);
  EXPECT_LT(some[0].found, references[2].counts.found);
  EXPECT_TRUE(some[0].is_of_a_part && some[1].is_of_a_part);
}

TEST(TransmissionSearch, TellsHowFarItIs) {
  const TransmissionTask task = reference_tasks()[2].task;
  std::vector<SearchProgress> heard;
  const TransmissionSearch search =
      search_transmissions(task, one_after_another, {}, nullptr, [&](const SearchProgress& one) {
        heard.push_back(one);
      });
  ASSERT_EQ(heard.size(), search.stages.structures);
  EXPECT_TRUE(std::ranges::is_sorted(heard, {}, &SearchProgress::share));
  EXPECT_EQ(heard.back().structures, heard.back().total);
  EXPECT_EQ(heard.back().found, search.stages.found);
  EXPECT_EQ(heard.back().share, 1.0);
  EXPECT_EQ(heard.back().known_share, 0.0);
  EXPECT_EQ(search.stages.found, search_transmissions(task, one_after_another).stages.found);
}

}  // namespace
}  // namespace kinestat
