#include "files/outcome.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(StatusOf, IsDoneWithoutMessages) {
  EXPECT_EQ(status_of(Diagnostics(), Strictness::strict), ExitStatus::done);
}

TEST(StatusOf, IsThatOfTheWorstCode) {
  Diagnostics found;
  found.error("E0602", {}, "no equilibrium");
  found.error("E0901", {}, "missed");

  EXPECT_EQ(status_of(found, Strictness::normal), ExitStatus::no_answer);
}

TEST(StatusOf, CountsWarningsOnlyWhenStrict) {
  Diagnostics found;
  found.warning("W0301", {}, "unused");

  EXPECT_EQ(status_of(found, Strictness::normal), ExitStatus::done);
  EXPECT_EQ(status_of(found, Strictness::strict), ExitStatus::check_failed);
}

TEST(AddDiagnostics, KeepsAWorseStatusOfAnEarlierFile) {
  Outcome outcome;
  outcome.status = ExitStatus::no_answer;
  Diagnostics found;
  found.error("E0901", {}, "missed");

  add_diagnostics({.path = "m.yaml", .text = ""}, found, Strictness::normal, outcome);

  EXPECT_EQ(outcome.status, ExitStatus::no_answer);
  EXPECT_EQ(outcome.err.plain(), "m.yaml: error[E0901]: missed\n");
}

TEST(AddBug, NamesTheFileAndIsTheWorstStatus) {
  Outcome outcome;
  outcome.status = ExitStatus::no_answer;

  add_bug("m.yaml", "a < b", outcome);

  EXPECT_EQ(static_cast<int>(outcome.status), 70);
  EXPECT_TRUE(outcome.err.plain().starts_with("m.yaml: error[E0155]: internal error: a < b\n"))
      << outcome.err.plain();
}

TEST(AddDiagnostics, WritesALineOfJsonForAFileWithoutMessages) {
  Outcome outcome;
  outcome.form = DiagnosticsForm::json;

  add_diagnostics({.path = "m.yaml", .text = ""}, {}, Strictness::normal, outcome);

  EXPECT_EQ(
      outcome.err.plain(),
      "{\"kinestat\":{\"diagnostics\":1},\"file\":\"m.yaml\",\"status\":0,\"diagnostics\":[]}\n");
}

TEST(AddMessage, IsOfTheProgramAndNotOfAFile) {
  Outcome outcome;

  add_message("E0101", "a command is missing", "give one", outcome);

  EXPECT_EQ(outcome.err.plain(),
            "kinestat: error[E0101]: a command is missing\n  hint: give one\n");
  EXPECT_EQ(outcome.status, ExitStatus::usage);
}

}  // namespace
}  // namespace kinestat
