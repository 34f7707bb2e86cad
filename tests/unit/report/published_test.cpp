#include "report/published.hpp"

#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr SourceRange kPointer{.line = 1, .column = 2, .length = 3};
constexpr SourceRange kNumber{.line = 1, .column = 9, .length = 1};

// A report with names that need escapes in a pointer.
Json report() {
  return Json::parse(R"({
    "cases": {"M1": {"ratio": 2.5, "status": "solved", "power": null}, "up/down": {"ratio": 3.0},
              "a~b": {"ratio": 4.0}, "~1": {"ratio": 5.0}},
    "rows": [10.0, 20.0]
  })");
}

// What is said about one published value.
Diagnostics check(const std::string& pointer,
                  double is,
                  double tolerance = 0.0,
                  const std::string& set_by = "") {
  MechanismDescription description;
  description.parameters = {{.name = {.text = "a", .where = {}}, .value = {}, .set_by = set_by}};
  description.published = {{.pointer = {.text = pointer, .where = kPointer},
                            .is = is,
                            .tolerance = tolerance,
                            .where = "Tab. 1",
                            .is_where = kNumber}};
  Diagnostics found;
  check_published(report(), description, found);
  return found;
}

std::string message(const Diagnostics& found) {
  return found.items().size() == 1 ? found.items().front().message : "not one message";
}

TEST(Published, IsSilentAboutAValueThatIsMet) {
  EXPECT_TRUE(check("/cases/M1/ratio", 2.5).items().empty());
}

TEST(Published, CountsTheToleranceItselfAsMet) {
  EXPECT_TRUE(check("/cases/M1/ratio", 2.25, 0.25).items().empty());
}

TEST(Published, SaysWhatIsMissedAndByHowMuch) {
  const Diagnostics found = check("/cases/M1/ratio", 2.0, 0.25);

  EXPECT_EQ(message(found),
            "published value 2.0 is missed: /cases/M1/ratio is 2.5, off by 0.5 "
            "(tolerance 0.25; Tab. 1)");
  EXPECT_EQ(found.items().front().code, "E0901");
  EXPECT_EQ(found.items().front().where, kNumber);
}

TEST(Published, NamesTheNumberOfTheCommandLineThatIsNotOfTheFile) {
  EXPECT_EQ(check("/cases/M1/ratio", 2.0, 0.25, "a=3").items().front().hint,
            "the value is that of the file as it is, without --set 'a=3'");
}

TEST(Published, ReadsAnEscapedSlash) {
  EXPECT_TRUE(check("/cases/up~1down/ratio", 3.0).items().empty());
}

TEST(Published, ReadsAnEscapedTilde) {
  EXPECT_TRUE(check("/cases/a~0b/ratio", 4.0).items().empty());
}

TEST(Published, ReadsAnEscapedTildeBeforeAOneAsTheseTwo) {
  EXPECT_TRUE(check("/cases/~01/ratio", 5.0).items().empty());
}

TEST(Published, ReadsAnIndex) {
  EXPECT_TRUE(check("/rows/1", 20.0).items().empty());
}

TEST(Published, RefusesAnIndexBeyondTheEnd) {
  const Diagnostics found = check("/rows/2", 20.0);

  EXPECT_EQ(message(found), "'/rows' has no '2'");
  EXPECT_EQ(found.items().front().code, "E0902");
}

TEST(Published, NamesHowFarAPointerLeadsAndWhatIsThere) {
  const Diagnostics found = check("/cases/M1/ratoi", 2.5);

  EXPECT_EQ(message(found), "'/cases/M1' has no 'ratoi'");
  EXPECT_EQ(found.items().front().hint, "did you mean 'ratio'? there are ratio, status, power");
  EXPECT_EQ(found.items().front().where, kPointer);
}

TEST(Published, RefusesAPointerWithoutSlash) {
  EXPECT_EQ(message(check("cases/M1/ratio", 2.5)), "a pointer begins with '/'");
}

TEST(Published, RefusesATextAndANull) {
  EXPECT_EQ(check("/cases/M1/status", 2.5).items().front().code, "E0902");
  EXPECT_EQ(check("/cases/M1/power", 2.5).items().front().hint,
            "the case has no answer there; see its status");
}

TEST(Published, RefusesTheWholeReport) {
  EXPECT_EQ(check("", 2.5).items().front().code, "E0902");
}

}  // namespace
}  // namespace kinestat
