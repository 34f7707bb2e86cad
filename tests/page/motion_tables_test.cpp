#include "pages/motion_tables.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

MotionTable motion_of(int positions) {
  MotionTable motion;
  for (int i = 0; i < positions; ++i) {
    motion.rows.push_back({.step = i, .values = {}, .status = "closed"});
  }
  return motion;
}

TEST(PositionTable, HasEveryPositionThatCanBeRead) {
  EXPECT_EQ(position_table(motion_of(1000)).rows().size(), 1000U);
}

// Every third of 2501 from 0 to 2499, and the last.
TEST(PositionTable, HasSomeOfManyAndTheirEnds) {
  const Table table = position_table(motion_of(2501));

  ASSERT_EQ(table.rows().size(), 835U);
  EXPECT_EQ(table.rows()[1].front(), "3");
  EXPECT_EQ(table.rows().back().front(), "2500");
}

}  // namespace
}  // namespace kinestat
