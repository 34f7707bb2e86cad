#include "core/diagnostic.hpp"

#include <gtest/gtest.h>

#include "core/contract.hpp"

namespace kinestat {
namespace {

TEST(Diagnostics, BeginWithoutErrors) {
  const Diagnostics found;

  EXPECT_FALSE(found.has_errors());
  EXPECT_TRUE(found.items().empty());
}

TEST(Diagnostics, CountErrorsOnly) {
  Diagnostics found;

  found.warning("W0301", {}, "parameter 'a' is never used");
  EXPECT_FALSE(found.has_errors());
  found.error("E0312", {}, "one");
  found.error("E0313", {}, "two");

  EXPECT_TRUE(found.has_errors());
  EXPECT_EQ(found.error_count(), 2);
}

TEST(Diagnostics, KeepTheOrderInWhichTheyWereFound) {
  Diagnostics found;

  found.error("E0313", {}, "first");
  found.warning("W0301", {}, "second");
  found.error("E0312", {}, "third");

  ASSERT_EQ(found.items().size(), 3U);
  EXPECT_EQ(found.items()[0].message, "first");
  EXPECT_EQ(found.items()[1].severity, Severity::warning);
  EXPECT_EQ(found.items()[2].code, "E0312");
}

TEST(Diagnostics, KeepPlaceHintAndNotes) {
  Diagnostics found;

  found.error("E0307", {.line = 5, .column = 26, .length = 5}, "declared twice", "rename one")
      .notes.push_back({{.line = 5, .column = 10, .length = 5}, "first declared here"});

  const Diagnostic& one = found.items().front();
  EXPECT_EQ(one.where, (SourceRange{.line = 5, .column = 26, .length = 5}));
  EXPECT_EQ(one.hint, "rename one");
  ASSERT_EQ(one.notes.size(), 1U);
  EXPECT_EQ(one.notes.front().where.column, 10);
}

TEST(Diagnostics, ShowWhatIsNotPrintableAsBytes) {
  Diagnostics found;

  found.error("E0304", {}, "'load:\u00A0' is empty", "write 'a\nb'");
  found.warning("W0301", {}, "parameter '\x1B' is never used", "remove '\xFF'");

  EXPECT_EQ(found.items()[0].message, "'load:\\xC2\\xA0' is empty");
  EXPECT_EQ(found.items()[0].hint, "write 'a\\x0Ab'");
  EXPECT_EQ(found.items()[1].message, "parameter '\\x1B' is never used");
  EXPECT_EQ(found.items()[1].hint, "remove '\\xFF'");
}

TEST(Diagnostics, RefuseACodeThatIsNotListed) {
  Diagnostics found;

  EXPECT_THROW(found.error("E9999", {}, "unheard of"), ContractViolation);
  EXPECT_THROW(found.warning("W9999", {}, "unheard of"), ContractViolation);
}

}  // namespace
}  // namespace kinestat
