#include "power/tooth_ratio.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

struct Bound {
  MechanismDescription description;
  Mechanism mechanism;
};

Bound bound(const std::string& text) {
  const SourceFile source{.path = "test", .text = "kinestat: 1\n" + text};
  Diagnostics found;
  Bound result;
  result.description = *read_mechanism(*read_yaml(source, {}, found), found);
  result.mechanism = *bind(result.description, found);
  EXPECT_TRUE(found.items().empty());
  return result;
}

const std::string kTrain = R"(
space: planar
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  S: {type: revolute, bodies: [housing, sun]}
  R: {type: revolute, bodies: [housing, ring]}
  C: {type: revolute, bodies: [carrier, housing]}
  P: {type: revolute, bodies: [carrier, planet]}
gears:
  module: 2 mm
  members:
    sun: {body: sun, teeth: 27}
    planet: {body: planet, teeth: 17}
    ring: {body: ring, teeth: 61, internal: true}
  meshes:
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
actuators: {in: {coupling: S}, held: {coupling: R}, out: {coupling: C}}
cases:
  low: {motion: {in: 3 rad/s, held: 0}, input: in, output: out}
  overdrive: {motion: {held: -7 rad/s, in: 0}, input: held, output: out}
  two speeds: {motion: {in: 3 rad/s, held: 1 rad/s}, input: in, output: out}
  direct: {motion: {in: 3 rad/s, held: 3 rad/s}, input: [in, held], output: out}
)";

std::string fraction_of(const Bound& train, std::size_t c, double ratio) {
  const auto found =
      tooth_ratio(train.description, train.mechanism, train.mechanism.cases[c], ratio);
  return found ? found->str() : "";
}

// Willis: 1 + 61/27 and 1 + 27/61; C turns the other way, as its tail is the carrier.
TEST(ToothRatio, IsTheFractionOfWillis) {
  const Bound train = bound(kTrain);
  EXPECT_EQ(fraction_of(train, 0, -88.0 / 27.0), "-88/27");
  EXPECT_EQ(fraction_of(train, 1, -88.0 / 61.0), "-88/61");
  EXPECT_EQ(fraction_of(train, 3, -1.0), "-1");
}

TEST(ToothRatio, IsNoneOfTwoSpeedsOrOfAnotherAnswer) {
  const Bound train = bound(kTrain);
  EXPECT_EQ(fraction_of(train, 2, -1.0), "");
  EXPECT_EQ(fraction_of(train, 0, 3.0), "");
}

// Beside the train a pair of gears that is drawn by its line of action, without teeth.
TEST(ToothRatio, IsNoneWithAMeshThatHasNoTeeth) {
  std::string text = kTrain;
  text.replace(text.find("carrier, planet]"), 16, "carrier, planet, idler]");
  text.replace(text.find("gears:\n"),
               0,
               "  I: {type: revolute, bodies: [housing, idler], at: [0, 200 mm]}\n"
               "  ri: {type: gear, bodies: [ring, idler], at: [0, 100 mm], line_of_action: x}\n");
  EXPECT_EQ(fraction_of(bound(text), 0, -88.0 / 27.0), "");
}

TEST(ToothRatio, IsNoneOfAMechanismWithoutTeeth) {
  const Bound crank =
      bound(kSliderCrank + "cases: {turns: {motion: {Tin: 1 rad/s}, input: Tin, output: Fout}}\n");
  EXPECT_EQ(fraction_of(crank, 0, 1.0), "");
}

}  // namespace
}  // namespace kinestat
