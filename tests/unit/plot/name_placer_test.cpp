#include "draw/name_placer.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(NamePlacer, PutsNamesBesideEachOther) {
  NamePlacer placer;
  std::vector<PixelBox> boxes;

  for (int i = 0; i < 12; ++i) {
    const PlacedName placed = placer.place({.x = 0.0, .y = 0.0}, "coupler", {}, 6.0);
    for (const PixelBox& other : boxes) {
      EXPECT_FALSE(placed.box.overlaps(other)) << i;
    }
    boxes.push_back(placed.box);
  }
}

TEST(NamePlacer, KeepsOffWhatIsDrawn) {
  NamePlacer placer;
  const PixelBox taken = {.left = 0.0, .top = -60.0, .right = 120.0, .bottom = 0.0};
  placer.keep_off(taken);

  const PlacedName placed = placer.place({.x = 0.0, .y = 0.0}, "a", {}, 6.0);

  EXPECT_FALSE(placed.box.overlaps(taken));
}

TEST(NamePlacer, KeepsOffLines) {
  NamePlacer placer;
  placer.keep_off({.x = -100.0, .y = 0.0}, {.x = 100.0, .y = 0.0});

  const PlacedName placed = placer.place({.x = 0.0, .y = 0.0}, "rocker", {}, 6.0);

  EXPECT_TRUE(placed.box.bottom <= 0.0 || placed.box.top >= 0.0);
}

TEST(NamePlacer, LeavesSomeAirBetweenANameAndALine) {
  NamePlacer placer;
  placer.keep_off({.x = -100.0, .y = 0.0}, {.x = 100.0, .y = 0.0});

  const PlacedName placed = placer.place({.x = 0.0, .y = 0.0}, "in", {}, 3.0);

  EXPECT_TRUE(placed.box.bottom <= -2.0 || placed.box.top >= 2.0);
}

TEST(NamePlacer, LeadsALineToANameThatIsFarAway) {
  NamePlacer placer;
  bool needs_line = false;

  for (int i = 0; i < 40; ++i) {
    needs_line = placer.place({.x = 0.0, .y = 0.0}, "planet", {}, 6.0).needs_line || needs_line;
  }

  EXPECT_TRUE(needs_line);
}

// Beyond the wall is the nearest place, 22 px nearer than the next.
TEST(NamePlacer, LeadsALineAcrossOthersOnlyForMuchLess) {
  NamePlacer placer;
  placer.keep_off({.left = -60.0, .top = -50.0, .right = 30.0, .bottom = 50.0});
  placer.keep_off({.x = 34.0, .y = -310.0}, {.x = 34.0, .y = 300.0});
  NamePlacer pricing = placer;
  pricing.price_crossings();

  const PlacedName nearest = placer.place({.x = 0.0, .y = 0.0}, "planet", {}, 6.0);
  const PlacedName placed = pricing.place({.x = 0.0, .y = 0.0}, "planet", {}, 6.0);

  EXPECT_GT(nearest.line_end.x, 34.0);
  EXPECT_TRUE(placed.needs_line);
  EXPECT_LT(placed.line_end.x, 34.0);
}

TEST(NamePlacer, PutsNamesFarAwayRatherThanUponLines) {
  NamePlacer placer;
  for (double y = -120.0; y <= 120.0; y += 6.0) {
    placer.keep_off({.x = -150.0, .y = y}, {.x = 150.0, .y = y});
  }

  const PlacedName placed = placer.place({.x = 0.0, .y = 0.0}, "rocker", {}, 6.0);

  EXPECT_TRUE(placed.is_free);
  EXPECT_TRUE(placed.needs_line);
}

TEST(NamePlacer, StaysWithinItsArea) {
  const PixelBox area = {.left = 0.0, .top = 0.0, .right = 300.0, .bottom = 200.0};
  NamePlacer placer(area);

  const PlacedName placed = placer.place({.x = 299.0, .y = 1.0}, "at the corner", {}, 6.0);

  EXPECT_TRUE(placed.is_free);
  EXPECT_LE(placed.box.right, area.right);
  EXPECT_GE(placed.box.top, area.top);
}

TEST(NamePlacer, TellsWhereThereIsNoRoom) {
  NamePlacer placer(PixelBox{.left = 0.0, .top = 0.0, .right = 20.0, .bottom = 20.0});

  EXPECT_FALSE(placer.place({.x = 10.0, .y = 10.0}, "far too long", {}, 6.0).is_free);
}

TEST(NamePlacer, TakesTheAnchorThatHasRoom) {
  NamePlacer placer;
  for (double y = -60.0; y <= 60.0; y += 4.0) {
    placer.keep_off({.x = -80.0, .y = y}, {.x = 80.0, .y = y});
  }
  const std::vector<PixelPoint> anchors = {{.x = 0.0, .y = 0.0}, {.x = 200.0, .y = 0.0}};

  const PlacedName placed = placer.place(anchors, "ring", {}, 6.0);

  EXPECT_FALSE(placed.needs_line);
  EXPECT_GT(placed.box.left, 100.0);
}

}  // namespace
}  // namespace kinestat
