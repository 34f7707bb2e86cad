#include <gtest/gtest.h>

#include "draw/axes.hpp"

namespace kinestat {
namespace {

using Places = std::vector<double>;

TEST(SpreadPlaces, LeavesWhatIsFarApart) {
  EXPECT_EQ(spread_places({0.0, 20.0, 50.0}, 15.0), Places({0.0, 20.0, 50.0}));
}

TEST(SpreadPlaces, MovesNeighboursApartAroundTheirMean) {
  EXPECT_EQ(spread_places({10.0, 12.0}, 10.0), Places({6.0, 16.0}));
}

TEST(SpreadPlaces, KeepsTheDistanceAlsoToThoseItRunsInto) {
  const Places places = spread_places({0.0, 14.0, 15.0, 16.0, 40.0}, 10.0);

  for (std::size_t i = 1; i < places.size(); ++i) {
    EXPECT_GE(places[i] - places[i - 1], 10.0 - 1e-12);
  }
}

TEST(SpreadPlaces, OfNothingIsNothing) {
  EXPECT_TRUE(spread_places({}, 10.0).empty());
}

}  // namespace
}  // namespace kinestat
