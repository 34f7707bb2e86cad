#include "studies/motion/picture/animation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "mechanism/bind/bind.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/motion/task/motion_choice.hpp"
#include "unit/plot/library_analysis.hpp"
#include "unit/plot/picture_text.hpp"

namespace kinestat {
namespace {

// A mechanism of the library, its motion, and the picture of that.
struct LibraryAnimation {
  MovingMechanism moving;
  FoundMotion found;
  Picture picture;
};

// With as many steps as are given, or with those of its file.
LibraryAnimation library_animation(const std::string& name, const std::string& steps = "") {
  SourceFile source;
  Diagnostics found;
  const std::string path = std::string(KINESTAT_SOURCE_DIR) + "/mechanisms/" + name;
  std::optional<MechanismDescription> description = load_description(path, {}, source, found);
  if (!steps.empty()) {
    MotionChoice choice;
    choice.steps = steps;
    (void)apply(choice, *description, found);
  }
  const auto mechanism = bind(*description, found);
  std::optional<FoundMotion> motion = find_motion(*description, *mechanism, found);
  MovingMechanism moving = moving_mechanism(path, *description, *mechanism, *motion);
  Picture picture = draw_animation(moving, motion->table);
  return {.moving = std::move(moving), .found = *std::move(motion), .picture = std::move(picture)};
}

std::vector<double> numbers_of(const std::string& text) {
  std::istringstream stream(std::regex_replace(text, std::regex(";"), " "));
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) {
    numbers.push_back(number);
  }
  return numbers;
}

// The values of one kind of movement in the first group of a body, as many as belong together.
std::vector<double> values_of(const Picture& picture,
                              const std::string& body,
                              const std::string& type) {
  const std::string& text = picture.elements;
  const std::size_t from = text.find("data-body=\"" + body + "\"");
  const std::string group = text.substr(from, text.find("</g>", from) - from);
  std::smatch match;
  const std::regex pattern("type=\"" + type + "\"[^>]* values=\"([^\"]*)\"");
  return std::regex_search(group, match, pattern) ? numbers_of(match[1]) : std::vector<double>();
}

// A point of the picture, moved by the values of a body.
PixelPoint moved(const Picture& picture, const std::string& body, std::size_t i, PixelPoint p) {
  const std::vector<double> shifts = values_of(picture, body, "translate");
  const std::vector<double> turns = values_of(picture, body, "rotate");
  const double angle = turns[3 * i] * std::numbers::pi / 180;
  const double x = p.x - turns[3 * i + 1];
  const double y = p.y - turns[3 * i + 2];
  // As SVG turns: clockwise, for y points down.
  p = {.x = turns[3 * i + 1] + std::cos(angle) * x - std::sin(angle) * y,
       .y = turns[3 * i + 2] + std::sin(angle) * x + std::cos(angle) * y};
  return shifts.empty() ? p : PixelPoint{.x = p.x + shifts[2 * i], .y = p.y + shifts[2 * i + 1]};
}

PixelPoint on_picture(const Picture& picture, double x, double y) {
  const double k = attribute(picture, "data-scale");
  return {.x = attribute(picture, "data-x0") + k * x, .y = attribute(picture, "data-y0") - k * y};
}

double distance(PixelPoint a, PixelPoint b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// The motor of the four-bar turns once, anticlockwise and evenly, about a hinge that rests. Angles
// do not jump at half a turn.
TEST(Animation, TurnsACrankEvenlyAboutItsHinge) {
  const Picture picture = library_animation("planar/four_bar.yaml").picture;
  const PixelPoint hinge = on_picture(picture, 0.0, 0.0);
  const std::vector<double> turns = values_of(picture, "crank-1", "rotate");
  const std::size_t steps = turns.size() / 3 - 1;

  EXPECT_GE(steps, 60U);
  EXPECT_LE(steps, 120U);
  EXPECT_TRUE(values_of(picture, "crank-1", "translate").empty());
  for (std::size_t i = 0; i <= steps; ++i) {
    const double turn = -360.0 * static_cast<double>(i) / static_cast<double>(steps);
    EXPECT_NEAR(turns[3 * i], turn, 0.006);
    EXPECT_NEAR(turns[3 * i + 1], hinge.x, 0.006);
    EXPECT_NEAR(turns[3 * i + 2], hinge.y, 0.006);
  }
}

// Hinges b (1, 3) and c (6, 5) hold the links together at every key frame: written are hundredths
// of a pixel and of a degree.
TEST(Animation, HoldsLinksTogether) {
  const Picture picture = library_animation("planar/four_bar.yaml").picture;
  const PixelPoint b = on_picture(picture, 1.0, 3.0);
  const PixelPoint c = on_picture(picture, 6.0, 5.0);
  const std::size_t count = values_of(picture, "coupler-2", "rotate").size() / 3;

  ASSERT_EQ(values_of(picture, "crank-1", "rotate").size(), 3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const PixelPoint b_now = moved(picture, "coupler-2", i, b);
    const PixelPoint c_now = moved(picture, "coupler-2", i, c);
    EXPECT_LT(distance(moved(picture, "crank-1", i, b), b_now), 0.1) << i;
    EXPECT_LT(distance(moved(picture, "rocker-3", i, c), c_now), 0.1) << i;
    EXPECT_NEAR(distance(b_now, c_now), distance(b, c), 0.01) << i;
  }
}

// The slider of the slider-crank, rod 13 and crank 15 from (9, 12), is at x = 15 cos φ +
// sqrt(169 - 225 sin² φ); the crank does not turn fully, and so goes there and back.
TEST(Animation, GoesThereAndBackWhereAMotionDoesNotClose) {
  const Picture picture = library_animation("planar/slider_crank.yaml").picture;
  const double k = attribute(picture, "data-scale");
  const std::vector<double> shifts = values_of(picture, "slider-3", "translate");
  const std::size_t last = shifts.size() / 2 - 1;
  const double drawn = std::atan2(12.0, 9.0);

  ASSERT_EQ(last % 2, 0U);
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t there = i <= last / 2 ? i : last - i;
    const double share = static_cast<double>(there) / static_cast<double>(last / 2);
    const double angle = drawn - share * 110.0 * std::numbers::pi / 180;
    const double s = 15 * std::sin(angle);
    const double x = 15 * std::cos(angle) + std::sqrt(169 - s * s);
    EXPECT_NEAR(shifts[2 * i], k * (x - 14.0), 0.006) << i;
    EXPECT_NEAR(shifts[2 * i + 1], 0.0, 0.006) << i;
  }
  EXPECT_FALSE(has(picture, "keyTimes"));
  EXPECT_TRUE(values_of(picture, "slider-3", "rotate").empty());
}

// The motion of the RSSR linkage begins 30 degrees before the drawn position: nothing is seen of
// that but its own frame.
TEST(Animation, ShowsOneFrameAtATimeOfASpatialLinkage) {
  const LibraryAnimation animation = library_animation("spatial/rssr.yaml");
  const Picture& picture = animation.picture;
  const std::size_t frames = animation.moving.motion.positions.size();

  EXPECT_EQ(count_of(picture, "data-frame="), frames);
  EXPECT_EQ(count_of(picture, "calcMode=\"discrete\""), frames);
  EXPECT_EQ(count_of(picture, "display=\"none\""), frames - 1);
  EXPECT_TRUE(has(picture, "<g data-frame=\"0\">"));
  EXPECT_FALSE(has(picture, "data-layer=\"still\""));
  EXPECT_FALSE(has(picture, "animateTransform"));
}

// Of a rope only the frames are seen; sheaves turn.
TEST(Animation, DrawsCablesFrameByFrame) {
  const Picture picture = library_animation("cables/block_and_tackle.yaml").picture;
  const std::size_t frames = count_of(picture, "data-frame=");

  EXPECT_GT(frames, 20U);
  EXPECT_EQ(count_of(picture, "data-cable=\"rope_1\""), frames);
  EXPECT_EQ(count_of(picture, "display=\"none\""), frames - 1);
  EXPECT_TRUE(has(picture, "animateTransform"));
}

// What turns moves by itself; of what changes its length only the frames are seen.
TEST(Animation, StretchesSpringsFrameByFrame) {
  const Picture picture = library_animation("planar/tailgate.yaml").picture;
  const std::size_t frames = count_of(picture, "data-frame=");

  EXPECT_GT(frames, 20U);
  EXPECT_EQ(count_of(picture, "data-spring=\"strut\""), frames);
  EXPECT_TRUE(has(picture, "animateTransform"));
}

// What comes last in a motion that closes is what comes first.
TEST(Animation, DrawsNoFrameTwiceOfAMotionThatCloses) {
  const LibraryAnimation animation = library_animation("spatial/bennett.yaml");

  EXPECT_EQ(count_of(animation.picture, "data-frame="),
            animation.moving.motion.positions.size() - 1);
}

TEST(Animation, LeavesOutNamesThatWouldHaveToMove) {
  const Picture picture = library_animation("planar/four_bar.yaml").picture;

  EXPECT_FALSE(has(picture, ">rocker</text>"));
  EXPECT_TRUE(has(picture, ">coupler.1</text>"));
}

TEST(Animation, SaysInWordsHowItMoves) {
  const Picture round = library_animation("planar/four_bar.yaml").picture;
  const Picture back = library_animation("planar/slider_crank.yaml").picture;

  EXPECT_EQ(round.title, "Mechanism in motion: Four-bar linkage");
  EXPECT_TRUE(has(round.description, "again and again: Tin from 0 to 6.283 rad"))
      << round.description;
  EXPECT_TRUE(has(back.description, "there and back: Tin from 0 to ")) << back.description;
}

// As many steps as the motion has, or the same ones divided or left out evenly.
TEST(Animation, KeepsToTheStepsOfTheMotion) {
  for (const std::string name : {"planar/four_bar.yaml", "planar/watt_six_bar.yaml"}) {
    const LibraryAnimation animation = library_animation(name);
    const std::vector<double>& asked = animation.found.solution.shares;
    const std::vector<double>& shown = animation.moving.motion.shares;
    for (const double share : asked) {
      EXPECT_TRUE(
          std::ranges::any_of(shown, [&](double one) { return std::abs(one - share) < 1e-12; }))
          << name << " " << share;
    }
  }
}

// Of 5001 positions every sixth would be a point of the path, but most of these nobody sees.
TEST(Animation, ShowsSomeOfManyPositions) {
  const Picture picture = library_animation("planar/four_bar.yaml", "5000").picture;
  const std::string& text = picture.elements;
  const std::size_t path = text.find("<title>coupler.1</title>");
  const std::size_t begin = text.find(" d=\"", path);
  const std::string data = text.substr(begin, text.find("\" ", begin) - begin);

  EXPECT_LE(values_of(picture, "crank-1", "rotate").size(), 3U * 121);
  EXPECT_GE(values_of(picture, "crank-1", "rotate").size(), 3U * 100);
  EXPECT_GE(std::ranges::count(data, 'L'), 50);
  EXPECT_LE(std::ranges::count(data, 'L'), 1001);
}

}  // namespace
}  // namespace kinestat
