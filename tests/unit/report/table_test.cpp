#include "report/table.hpp"

#include <gtest/gtest.h>

#include "core/contract.hpp"

namespace kinestat {
namespace {

TEST(Table, AlignsTheFirstColumnLeftAndTheOthersRight) {
  Table table({"Freedom", "rate"});
  table.add({"a.wz", "1"});
  table.add({"b.wz", "-2.5"});

  EXPECT_EQ(table.text(""),
            "Freedom  rate\n"
            "a.wz        1\n"
            "b.wz     -2.5\n");
}

TEST(Table, CountsCharactersAndNotBytes) {
  Table table({"Größe", "α [°]"});
  table.add({"öäü", "1"});
  table.add({"abcdef", "12345"});

  EXPECT_EQ(table.text(""),
            "Größe   α [°]\n"
            "öäü         1\n"
            "abcdef  12345\n");
}

TEST(Table, BeginsEveryLineWithTheIndent) {
  Table table({"a"});
  table.add({"b"});

  EXPECT_EQ(table.text("  "), "  a\n  b\n");
}

TEST(Table, EndsNoLineWithSpaces) {
  Table table({"name", "value"});
  table.add({"x", ""});

  EXPECT_EQ(table.text(""), "name  value\nx\n");
}

TEST(Table, IsEmptyUntilARowIsAdded) {
  Table table({"a"});
  EXPECT_TRUE(table.is_empty());

  table.add({"b"});

  EXPECT_FALSE(table.is_empty());
}

TEST(Table, RefusesARowOfAnotherWidth) {
  Table table({"a", "b"});

  EXPECT_THROW(table.add({"c"}), ContractViolation);
}

TEST(Table, PartsItsColumnsWhereTheyAreWiderThanTheLayout) {
  Table table({"Body", "x [mm]", "y [mm]", "z [mm]"});
  table.add({"rod", "1", "2", "3"});

  EXPECT_EQ(table.text("  ", {.width = 22}),
            "  Body  x [mm]  y [mm]\n"
            "  rod        1       2\n"
            "\n"
            "  Body  z [mm]\n"
            "  rod        3\n");
}

TEST(Table, KeepsOneColumnAPartWhereNoneFits) {
  Table table({"Body", "x [mm]", "y [mm]"});
  table.add({"rod", "1", "2"});

  EXPECT_EQ(table.text("", {.width = 4}),
            "Body  x [mm]\n"
            "rod        1\n"
            "\n"
            "Body  y [mm]\n"
            "rod        2\n");
}

TEST(Table, MarksItsHeadWhereThereAreColors) {
  Table table({"Body", "x"});
  table.add({"rod", "1"});

  EXPECT_EQ(table.text("", {.is_coloured = true}), "\x1b[1mBody  x\x1b[0m\nrod   1\n");
}

}  // namespace
}  // namespace kinestat
