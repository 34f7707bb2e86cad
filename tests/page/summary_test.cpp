#include <algorithm>

#include <gtest/gtest.h>

#include "cases/report/case_text.hpp"
#include "cases/solve_cases.hpp"
#include "files/load_file.hpp"
#include "pages/page_parts.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"

namespace kinestat {
namespace {

std::vector<std::string> summary_sentences(const FilePage& page) {
  std::vector<std::string> sentences = result_sentences(page);
  for (const std::string& one : count_sentences(page)) {
    sentences.push_back(one);
  }
  return sentences;
}

FilePage page_of(const std::string& file) {
  const std::string path = std::string(KINESTAT_MECHANISMS) + "/" + file;
  FilePage page;
  std::optional<Loaded> loaded = load(path, {}, page.source, page.found);
  EXPECT_TRUE(loaded) << file;
  if (loaded) {
    page.analysis = solve_cases(path, *std::move(loaded));
  }
  return page;
}

std::vector<std::string> sentences_of(const std::string& file) {
  return summary_sentences(page_of(file));
}

bool has(const std::vector<std::string>& sentences, const std::string& wanted) {
  return std::ranges::find(sentences, wanted) != sentences.end();
}

// e - n + 1 = 6 - 5 + 1 circuits.
TEST(Summary, CountsBodiesCouplingsAndCircuits) {
  const auto sentences = sentences_of("gears/simple_planetary.yaml");

  EXPECT_TRUE(
      has(sentences, "5 bodies and 6 couplings (4 revolute, 2 gear) form 2 independent circuits."))
      << testing::PrintToString(sentences);
}

// F_N = F - m = 6 - 4; redundant are λl - m, for λ = 6 and 3 and l = 2.
TEST(Summary, ReadsTheMobilityOfAPlanetarySet) {
  const auto sentences = sentences_of("gears/simple_planetary.yaml");

  EXPECT_TRUE(has(sentences, "Mobility 2: 2 given rates determine all others."));
  EXPECT_TRUE(has(sentences, "Redundant constraints: 8 in space, 2 in the plane."));
}

// Willis: 1 + 60/24, 1 + 24/60, -60/24.
TEST(Summary, TellsTheRatiosOfAPlanetarySet) {
  const FilePage page = page_of("gears/simple_planetary.yaml");
  const std::string cases = overview_blocks(*page.analysis).text();

  EXPECT_TRUE(has(summary_sentences(page), "3 cases are solved."));
  EXPECT_NE(cases.find("ring held       3.5"), std::string::npos) << cases;
  EXPECT_NE(cases.find("sun held        1.4"), std::string::npos) << cases;
  EXPECT_NE(cases.find("carrier held   -2.5"), std::string::npos) << cases;
}

// Sarrus 1853: six revolutes, one translation, one redundant constraint.
TEST(Summary, ReadsTheMobilityOfASpatialLinkage) {
  const auto sentences = sentences_of("spatial/sarrus.yaml");

  EXPECT_TRUE(has(sentences, "Mobility 1: one given rate determines all others."));
  EXPECT_TRUE(has(sentences, "Redundant constraints: 1 in space."));
}

// Cazangi 2008, table 5.5: six pairs of four elements, four of them gears; ratios 2.847 to 1.
TEST(Summary, CountsTheGearsOfATransmission) {
  const auto sentences = sentences_of("transmissions/ravigneaux_input_shaft.yaml");

  EXPECT_TRUE(
      has(sentences,
          "A gear engages 2 of 4 shift elements; 4 of 6 combinations give a gear; the ratio "
          "spread of the forward gears is 2.84689."))
      << testing::PrintToString(sentences);
  EXPECT_TRUE(has(sentences, "4 gears are solved."));
}

TEST(Summary, TellsAllDrivesInOneSentence) {
  FilePage page;
  page.motion.emplace().table.drives = {
      {.name = "x", .freedom = "a.vx", .unit = "m", .from = 0.0, .to = 2.0, .reached = 2.0},
      {.name = "y", .freedom = "b.wz", .unit = "deg", .from = 1.0, .to = 3.0, .reached = 3.0}};

  EXPECT_TRUE(has(summary_sentences(page), "Drive x goes from 0 to 2 m; y from 1 to 3 deg."));
}

TEST(Summary, TellsWhichCasesAreOpen) {
  FilePage page;
  std::optional<Loaded> loaded =
      load(std::string(KINESTAT_MECHANISMS) + "/planar/four_bar.yaml", {}, page.source, page.found);
  ASSERT_TRUE(loaded);
  page.analysis = solve_cases("four_bar.yaml", *std::move(loaded));
  ASSERT_FALSE(page.analysis->cases.empty());
  page.analysis->cases.resize(1);
  CaseAnalysis& one = page.analysis->cases.front();
  one.which.label = "drawn";
  one.motion = KinematicSolution();
  one.motion->status = SolveStatus::underdetermined;
  one.action.reset();

  EXPECT_TRUE(has(summary_sentences(page), "No case is solved: drawn (motions indeterminate)."));

  one.motion->status = SolveStatus::solved;
  one.action.emplace().status = SolveStatus::at_rest;
  page.motion.emplace();

  EXPECT_TRUE(has(summary_sentences(page),
                  "In the drawn position no case is solved: drawn (actions at rest)."));
}

TEST(Summary, IsEmptyForAFileThatCannotBeRead) {
  EXPECT_TRUE(summary_sentences({}).empty());
}

std::vector<std::string> sentences_of_task(const std::string& file) {
  const std::string path = std::string(KINESTAT_MECHANISMS) + "/synthesis/" + file;
  FilePage page;
  page.description = load_description(path, {}, page.source, page.found);
  page.synthesis = find_synthesis(path, page.description.value(), {}, page.found);
  return summary_sentences(page);
}

// The file says how many combinations it tries; `kinestat synthesis` counts the usable ones.
TEST(Summary, CountsTheChoicesOfASelection) {
  FilePage page;
  page.synthesis = SynthesisAnalysis{};
  page.synthesis->selection = SelectionCounts{};
  page.synthesis->selection->samples = 4096;
  page.synthesis->selection->usable = 388;
  page.synthesis->tasks.resize(1);
  page.synthesis->tasks.front().linkages.resize(1);

  const auto expect = [&page](std::string_view start) {
    const auto sentences = summary_sentences(page);
    EXPECT_TRUE(std::ranges::any_of(sentences, [&](const std::string& one) {
      return one.starts_with(start);
    })) << testing::PrintToString(sentences);
  };
  expect("388 of 4096 choices have a usable linkage; the best is ");
  page.synthesis->selection->usable = 1;
  expect("1 of 4096 choices has a usable linkage; the best is ");
}

// The file asks for what a known inverted slider-crank does: closed form.
TEST(Summary, NamesTheBestLinkageInWords) {
  const auto sentences = sentences_of_task("oscillating_slider.yaml");

  EXPECT_TRUE(has(sentences, "4 dyads are real."));
  EXPECT_TRUE(std::ranges::any_of(sentences, [](const std::string& one) {
    return one.find("the best is an inverted-slider-crank, ") != std::string::npos;
  })) << testing::PrintToString(sentences);
}

// Cardan's motion: the points of a circle that rolls in one twice as large draw its diameters.
TEST(Summary, TellsOfAFamilyOfDyads) {
  const auto sentences = sentences_of_task("elliptic_trammel.yaml");

  EXPECT_TRUE(
      has(sentences, "A family of dyads: a whole circle of points moves on straight lines."))
      << testing::PrintToString(sentences);
  EXPECT_FALSE(has(sentences, "No linkage is found."));
}

TEST(Summary, SaysThatADriveCannotRun) {
  FilePage page;
  page.motion = PageMotion{};
  page.motion->table.drives.resize(1);
  page.motion->table.drives.front().name = "motor";
  page.motion->table.drives.front().unit = "deg";
  page.motion->table.drives.front().to = 90.0;
  page.motion->table.end = MotionEnd::drives_locked;

  EXPECT_TRUE(has(summary_sentences(page), "Drive motor goes from 0 to 90 deg, but cannot run."));
}

TEST(Summary, NamesOnlyWhatAMotionPasses) {
  FilePage page;
  page.motion = PageMotion{};
  page.motion->table.events.resize(2);
  page.motion->table.events[0].kind = "dead_point";
  page.motion->table.events[1].kind = "dead_point";

  EXPECT_TRUE(has(summary_sentences(page), "It passes 2 dead points."));
}

}  // namespace
}  // namespace kinestat
