#include "mechanism/internal/load_check.hpp"

#include <gtest/gtest.h>

#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

TEST(LoadCheck, AcceptsForcesAndCouples) {
  EXPECT_EQ(complaints_about("loads:\n"
                             "  wind: {body: block, at: [0, 0, 1 m], force: [1, 2, 3 kN]}\n"
                             "  drag: {body: housing, couple: [0, 0, T]}\n"),
            Complaints{});
}

TEST(LoadCheck, ReportsABodyThatIsNotDeclared) {
  EXPECT_EQ(complaints_about("loads: {wind: {body: blok, couple: [0, 0, 1]}}\n"),
            (Complaints{"30:22 E0312 load 'wind' acts on body 'blok', which is not declared"}));
}

TEST(LoadCheck, WantsLengthsForcesAndMoments) {
  EXPECT_EQ(complaints_about(
                "loads:\n"
                "  w: {body: block, at: [1 N, 0, 0], force: [0, 1 mm, 0], couple: [0, 0, 1 N]}\n"),
            (Complaints{"31:25 E0309 a force stands where a length is expected",
                        "31:48 E0309 a length stands where a force is expected",
                        "31:73 E0309 a force stands where a moment is expected"}));
}

TEST(LoadCheck, LooksAtTheLoadsOfCases) {
  EXPECT_EQ(complaints_of(
                check_of("kinestat: 1\n"
                         "space: planar\n"
                         "ground: frame\n"
                         "bodies: [crank]\n"
                         "couplings: {a: {type: revolute, bodies: [frame, crank], at: [0, 0]}}\n"
                         "cases: {one: {loads: {wind: {body: rod, couple: 3 mm}}}}\n")),
            (Complaints{"6:36 E0312 load 'wind' acts on body 'rod', which is not declared",
                        "6:49 E0309 a length stands where a moment is expected"}));
}

}  // namespace
}  // namespace kinestat
