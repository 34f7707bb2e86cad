#include "mechanism/unanalysed.hpp"

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "mechanism/bind/bind.hpp"
#include "support/read_text.hpp"

namespace kinestat {
namespace {

MechanismDescription description_of(const std::string& rest, const std::string& coupling) {
  const std::string text =
      "kinestat: 1\nspace: planar\nground: f\nbodies: [g]\ncouplings:\n  a: " + coupling + "\n" +
      rest;
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, found);
  const auto description = root ? read_mechanism(*root, found) : std::nullopt;
  EXPECT_EQ(complaints_of(found), Complaints{});
  return description.value_or(MechanismDescription{});
}

constexpr const char* kHinge = "{type: revolute, bodies: [f, g], at: [0, 0]}";
constexpr const char* kMisdrawn = "{type: revolute, bodies: [f, g], at: {f: [0, 0], g: [0, 1]}}";

// "what" of each, with an exclamation mark where it decides.
std::vector<std::string> list_of(const std::string& rest, const std::string& coupling = kHinge) {
  std::vector<std::string> list;
  for (const Unanalysed& one : find_unanalysed(description_of(rest, coupling))) {
    list.push_back(one.what + (one.decides ? "!" : ""));
  }
  return list;
}

using List = std::vector<std::string>;

TEST(Unanalysed, IsNothingInAFileOfThisVersion) {
  EXPECT_EQ(list_of("cases: {c: {motion: {a.wz: 1}}}\n"), List{});
  EXPECT_EQ(list_of("statics: {indeterminate: minimum_norm}\n"), List{});
  EXPECT_EQ(list_of("motion: {drive: m, to: 1}\nactuators: {m: {coupling: a}}\n"), List{});
}

TEST(Unanalysed, DecidesWhereTheAnswerWouldBeWrongWithoutIt) {
  EXPECT_EQ(list_of("", kMisdrawn), List{"revolute 'a' has a point on each of its bodies!"});
}

TEST(Unanalysed, FrictionWithoutALawDecidesOnlyTheStatics) {
  const std::string rigid = "{type: rigid, bodies: [f, g], at: [0, 0], friction: 0.1}";

  EXPECT_EQ(list_of("cases: {c: {motion: {a.wz: 1}}}\n", rigid), List{"friction of rigid 'a'"});
  EXPECT_EQ(list_of("cases: {c: {action: {a.Rx: 1}}}\n", rigid), List{"friction of rigid 'a'!"});
  EXPECT_EQ(list_of("gravity: [0, -9.81]\ncases: {c: {motion: {a.wz: 1}}}\n", rigid),
            List{"friction of rigid 'a'!"});
}

TEST(Unanalysed, IsNoFrictionWithALaw) {
  EXPECT_EQ(list_of("cases: {c: {action: {a.Rx: 1}}}\n",
                    "{type: revolute, bodies: [f, g], at: [0, 0], friction: {tau: 1}}"),
            List{});
}

TEST(Unanalysed, IsAnErrorOfTheAnalysisAndAWarningOfTheCheck) {
  const auto description = description_of("", kMisdrawn);
  Diagnostics of_bind;
  Diagnostics of_check;

  EXPECT_FALSE(bind(description, of_bind));
  EXPECT_TRUE(check(description, of_check));

  EXPECT_EQ(complaints_of(of_bind),
            Complaints{"6:43 E0315 revolute 'a' has a point on each of its bodies; only 'kinestat "
                       "motion' closes the gap between "
                       "them"});
  EXPECT_EQ(complaints_of(of_check),
            Complaints{"6:43 W0302 revolute 'a' has a point on each of its bodies; only 'kinestat "
                       "motion' closes the gap between "
                       "them"});
}

TEST(Unanalysed, IsNoMisclosureForAPassThatClosesIt) {
  Diagnostics found;

  EXPECT_TRUE(bind_unassembled(description_of("", kMisdrawn), found));

  EXPECT_EQ(complaints_of(found), Complaints{});
}

TEST(Unanalysed, ComesAfterWhatIsWrong) {
  const auto description = description_of("gravity: [0, -9.81 mm]\n", kMisdrawn);
  Diagnostics found;

  EXPECT_FALSE(bind(description, found));

  ASSERT_EQ(found.items().size(), 1U);
  EXPECT_EQ(found.items()[0].code, "E0309");
}

}  // namespace
}  // namespace kinestat
