#include "report/diagnostics/diagnostic_text.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// The text of one error E0312 "wrong" at a place of a file "m.yaml".
std::string text_at(const std::string& file, SourceRange where, const std::string& hint = {}) {
  Diagnostics found;
  found.error("E0312", where, "wrong", hint);
  return diagnostics_text({.path = "m.yaml", .text = file}, found).plain();
}

TEST(DiagnosticText, ShowsThePlaceTheLineTheCaretAndTheHint) {
  EXPECT_EQ(text_at("a: 1\nb: rockr\n", {.line = 2, .column = 4, .length = 5}, "did you mean it?"),
            "m.yaml:2:4: error[E0312]: wrong\n"
            "    2 | b: rockr\n"
            "      |    ^^^^^\n"
            "  hint: did you mean it?\n");
}

TEST(DiagnosticText, OfTheWholeFileHasNoLine) {
  EXPECT_EQ(text_at("a: 1\n", {}), "m.yaml: error[E0312]: wrong\n");
}

TEST(DiagnosticText, KeepsTabsAboveTheCaret) {
  EXPECT_EQ(text_at("a:\tx\ty\n", {.line = 1, .column = 6, .length = 1}),
            "m.yaml:1:6: error[E0312]: wrong\n"
            "    1 | a:\tx\ty\n"
            "      |   \t \t^\n");
}

TEST(DiagnosticText, CountsCharactersOfUtf8) {
  EXPECT_EQ(text_at("größe: αβ x\n", {.line = 1, .column = 11, .length = 1}),
            "m.yaml:1:11: error[E0312]: wrong\n"
            "    1 | größe: αβ x\n"
            "      |           ^\n");
}

TEST(DiagnosticText, LeavesOutTheCarriageReturn) {
  EXPECT_EQ(text_at("a: 1\r\nb: 2\r\n", {.line = 1, .column = 4, .length = 1}),
            "m.yaml:1:4: error[E0312]: wrong\n"
            "    1 | a: 1\n"
            "      |    ^\n");
}

TEST(DiagnosticText, LeavesOutTheByteOrderMark) {
  EXPECT_EQ(text_at("\xEF\xBB\xBF"
                    "a: 1\n",
                    {.line = 1, .column = 1, .length = 1}),
            "m.yaml:1:1: error[E0312]: wrong\n"
            "    1 | a: 1\n"
            "      | ^\n");
}

TEST(DiagnosticText, MarksTheEndOfALineWithoutLineEnd) {
  EXPECT_EQ(text_at("a: [", {.line = 1, .column = 5, .length = 0}),
            "m.yaml:1:5: error[E0312]: wrong\n"
            "    1 | a: [\n"
            "      |     ^\n");
}

TEST(DiagnosticText, ShowsNoLineThatDoesNotExist) {
  EXPECT_EQ(text_at("a: 1\n", {.line = 7, .column = 1, .length = 1}),
            "m.yaml:7:1: error[E0312]: wrong\n");
}

TEST(DiagnosticText, ShowsNoLineWithControlCharacters) {
  EXPECT_EQ(text_at("a: \x1b[31m\n", {.line = 1, .column = 4, .length = 1}),
            "m.yaml:1:4: error[E0312]: wrong\n");
}

TEST(DiagnosticText, ShowsNoLineThatIsNotUtf8) {
  EXPECT_EQ(text_at("name: M\xFClheim\n", {.line = 1, .column = 8, .length = 1}),
            "m.yaml:1:8: error[E0312]: wrong\n");
}

TEST(DiagnosticText, ShowsNoVeryLongLine) {
  EXPECT_EQ(text_at(std::string(200, 'a') + "\n", {.line = 1, .column = 4, .length = 1}),
            "m.yaml:1:4: error[E0312]: wrong\n");
}

TEST(DiagnosticText, PutsNotesBeforeTheHint) {
  Diagnostics found;
  found.error("E0307", {.line = 2, .column = 1, .length = 1}, "twice", "rename one")
      .notes.push_back({{.line = 1, .column = 1, .length = 1}, "first declared here"});

  EXPECT_EQ(diagnostics_text({.path = "m.yaml", .text = "a: 1\na: 2\n"}, found).plain(),
            "m.yaml:2:1: error[E0307]: twice\n"
            "    2 | a: 2\n"
            "      | ^\n"
            "m.yaml:1:1: note: first declared here\n"
            "    1 | a: 1\n"
            "      | ^\n"
            "  hint: rename one\n");
}

TEST(DiagnosticText, NamesStandardInput) {
  Diagnostics found;
  found.warning("W0301", {}, "unused");

  EXPECT_EQ(diagnostics_text({.path = "-", .text = ""}, found).plain(),
            "<stdin>: warning[W0301]: unused\n");
}

TEST(DiagnosticText, ShowsTwentyErrorsAndCountsTheOthers) {
  Diagnostics found;
  for (int i = 0; i < 23; ++i) {
    found.error("E0312", {}, "wrong");
  }

  const std::string text = diagnostics_text({.path = "m.yaml", .text = ""}, found).plain();

  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 21);
  EXPECT_TRUE(text.ends_with("m.yaml: 3 more errors\n")) << text;
}

TEST(DiagnosticText, CountsWarningsApartFromErrors) {
  Diagnostics found;
  for (int i = 0; i < 20; ++i) {
    found.warning("W0301", {}, "unused");
  }
  found.error("E0312", {}, "wrong");

  const std::string text = diagnostics_text({.path = "m.yaml", .text = ""}, found).plain();

  EXPECT_TRUE(text.ends_with("m.yaml: error[E0312]: wrong\n")) << text;
}

TEST(DiagnosticText, ColorsTheSeverityTheCaretsAndTheHint) {
  Diagnostics found;
  found.error("E0312", {.line = 1, .column = 4, .length = 2}, "no such body", "write ab");

  EXPECT_EQ(diagnostics_text({.path = "m.yaml", .text = "a: xy\n"}, found).coloured(),
            "\x1b[1mm.yaml:1:4:\x1b[0m \x1b[1;31merror[E0312]:\x1b[0m no such body\n"
            "    1 | a: xy\n"
            "      | \x1b[1;31m   ^^\x1b[0m\n"
            "  \x1b[36mhint:\x1b[0m write ab\n");
}

}  // namespace
}  // namespace kinestat
