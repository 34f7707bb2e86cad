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

}  // namespace
}  // namespace kinestat
