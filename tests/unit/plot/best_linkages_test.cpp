#include "studies/synthesis/picture/best_linkages.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "library_analysis.hpp"
#include "picture_text.hpp"

namespace kinestat {
namespace {

// Of the six linkages of this task some have defects.
TEST(BestLinkages, AreTheUsableOnesTheBestFirst) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/crank_rocker.yaml");
  const std::vector<LinkageCandidate>& all = analysis.tasks[0].linkages;

  const std::vector<LinkagePlace> best = find_best_linkages(analysis);

  EXPECT_EQ(static_cast<std::ptrdiff_t>(best.size()),
            std::ranges::count(all, Defect::none, &LinkageCandidate::defect));
  ASSERT_FALSE(best.empty());
  for (std::size_t i = 1; i < best.size(); ++i) {
    EXPECT_GE(all[best[i - 1].number].margin(), all[best[i].number].margin());
  }
}

TEST(BestLinkages, AreOfASelectionThoseOfItsChoices) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/do_valle_table_5.yaml");

  for (const LinkagePlace& place : find_best_linkages(analysis)) {
    EXPECT_TRUE(!analysis.selection || place.number == 0);
  }
}

// The positions of table 2 lie in two circuits.
TEST(BestLinkages, WithoutAUsableOneAreTheNearest) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/do_valle_table_2.yaml");

  const std::vector<LinkagePlace> best = find_best_linkages(analysis);

  ASSERT_EQ(best.size(), 1U);
  EXPECT_TRUE(has(draw_best_linkages(analysis), "circuit defect"));
}

TEST(BestLinkages, AreDrawnOnceEach) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/crank_rocker.yaml");

  const Picture picture = draw_best_linkages(analysis);

  EXPECT_EQ(count_of(picture, "margin "), find_best_linkages(analysis).size());
}

}  // namespace
}  // namespace kinestat
