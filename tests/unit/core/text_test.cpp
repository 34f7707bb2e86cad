#include "core/text.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

using Names = std::vector<std::string>;

const Names kBodies = {"frame", "crank", "coupler", "rocker"};

TEST(NearestName, ForgivesALeftOutLetter) {
  EXPECT_EQ(nearest_name("rockr", kBodies), "rocker");
}

TEST(NearestName, CountsTwoSwappedLettersAsOneMistake) {
  // Two plain substitutions would be too many for a word of four letters.
  EXPECT_EQ(nearest_name("laod", Names{"load"}), "load");
}

TEST(NearestName, FindsAnotherCase) {
  EXPECT_EQ(nearest_name("FRAME", kBodies), "frame");
}

TEST(NearestName, PrefersTheNearerOfTwo) {
  EXPECT_EQ(nearest_name("sun22", Names{"sun1", "sun2"}), "sun2");
}

TEST(NearestName, PrefersTheFirstOfTwoAtTheSameDistance) {
  EXPECT_EQ(nearest_name("sun3", Names{"sun1", "sun2"}), "sun1");
}

TEST(NearestName, ForgivesAThirdOfTheWord) {
  EXPECT_EQ(nearest_name("couplxx", Names{"coupler"}), "coupler");
}

TEST(NearestName, IsEmptyForMoreThanAThirdOfTheWord) {
  EXPECT_EQ(nearest_name("coupxxx", Names{"coupler"}), "");
}

TEST(NearestName, IsEmptyIfNoLetterWouldRemain) {
  EXPECT_EQ(nearest_name("e", Names{"a", "b"}), "");
}

TEST(NearestName, FindsAOneLetterNameInAnotherCase) {
  EXPECT_EQ(nearest_name("A", Names{"b", "a"}), "a");
}

TEST(NearestName, IsEmptyWithoutCandidates) {
  EXPECT_EQ(nearest_name("crank", Names{}), "");
}

TEST(NearestName, IsEmptyForAVeryLongWord) {
  const std::string word(65, 'a');

  EXPECT_EQ(nearest_name(word, Names{word}), "");
}

TEST(NearestName, PassesOverAVeryLongCandidate) {
  EXPECT_EQ(nearest_name("rockr", Names{std::string(65, 'r'), "rocker"}), "rocker");
}

TEST(DidYouMean, AsksForTheNearestName) {
  EXPECT_EQ(did_you_mean("cranc", kBodies), "did you mean 'crank'?");
}

TEST(DidYouMean, IsEmptyWithoutANearName) {
  EXPECT_EQ(did_you_mean("piston", kBodies), "");
}

TEST(QuotedList, IsEmptyForNoName) {
  EXPECT_EQ(quoted_list(Names{}), "");
}

TEST(QuotedList, QuotesOneName) {
  EXPECT_EQ(quoted_list(Names{"a"}), "'a'");
}

TEST(QuotedList, JoinsTheLastByAnd) {
  EXPECT_EQ(quoted_list(Names{"a", "b", "c"}), "'a', 'b' and 'c'");
}

TEST(QuotedList, CountsTheNamesBeyondItsLimit) {
  EXPECT_EQ(quoted_list(Names{"a", "b", "c", "d"}, 2), "'a', 'b' and 2 more");
}

TEST(PlainList, SeparatesByCommas) {
  EXPECT_EQ(plain_list(Names{"a", "b", "c"}), "a, b, c");
}

TEST(PlainList, ShowsAllNamesAtItsLimit) {
  EXPECT_EQ(plain_list(Names{"a", "b"}, 2), "a, b");
}

TEST(PlainList, CountsTheNamesBeyondItsLimit) {
  EXPECT_EQ(plain_list(Names{"a", "b", "c"}, 2), "a, b and 1 more");
}

TEST(PlainList, IsEmptyForNoName) {
  EXPECT_EQ(plain_list(Names{}), "");
}

TEST(DurationText, HasItsTwoLargestUnits) {
  EXPECT_EQ(duration_text(0.0), "0 s");
  EXPECT_EQ(duration_text(0.234), "0.23 s");
  EXPECT_EQ(duration_text(9.94), "9.9 s");
  EXPECT_EQ(duration_text(9.96), "10 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min 0 s");
  EXPECT_EQ(duration_text(3599.0), "59 min 59 s");
  EXPECT_EQ(duration_text(2 * 3600.0 + 119.0), "2 h 1 min");
  EXPECT_EQ(duration_text(3 * 86400.0 + 3601.0), "3 d 1 h");
}

}  // namespace
}  // namespace kinestat
