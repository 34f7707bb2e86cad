#include "mechanism/gears/internal/planet_set.hpp"

#include <map>

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "mechanism/bind/bind.hpp"
#include "support/read_text.hpp"

namespace kinestat {
namespace {

using Counts = std::map<std::string, int>;

// Of the actions that planets share. A sun, a ring and a chain of two planets between them.
Counts shared(const std::string& first, const std::string& second) {
  const std::string text =
      "kinestat: 1\nspace: planar\nground: housing\n"
      "bodies: [sun, ring, carrier, inner, outer]\n"
      "couplings:\n"
      "  S: {type: revolute, bodies: [housing, sun]}\n"
      "  R: {type: revolute, bodies: [housing, ring]}\n"
      "  C: {type: revolute, bodies: [housing, carrier]}\n"
      "  P: {type: revolute, bodies: [carrier, inner]}\n"
      "  Q: {type: revolute, bodies: [outer, carrier]}\n"
      "gears:\n  module: 1\n  members:\n"
      "    sun: {body: sun, teeth: 34}\n"
      "    inner: {body: inner, teeth: 20" +
      first +
      "}\n"
      "    outer: {body: outer, teeth: 26" +
      second +
      "}\n"
      "    ring: {body: ring, teeth: 82, internal: true}\n"
      "  meshes:\n"
      "    s: {members: [sun, inner], carrier: carrier}\n"
      "    p: {members: [inner, outer], carrier: carrier}\n"
      "    r: {members: [ring, outer], carrier: carrier}\n";
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, found);
  const auto description = root ? read_mechanism(*root, found) : std::nullopt;
  const auto mechanism = description ? bind(*description, found) : std::nullopt;
  Counts result;
  for (std::size_t a = 0; mechanism && a < mechanism->planet_counts.size(); ++a) {
    if (mechanism->planet_counts[a] > 1) {
      result[mechanism->topology.action_name(static_cast<int>(a))] = mechanism->planet_counts[a];
    }
  }
  EXPECT_FALSE(found.has_errors());
  return result;
}

TEST(PlanetSet, HasTheActionsOfOnePlanetWithoutACount) {
  EXPECT_EQ(shared("", ""), Counts{});
  EXPECT_EQ(shared(", count: 1", ""), Counts{});
}

// Bearings and meshes of both planets, whichever of the two has the count.
TEST(PlanetSet, SharesTheActionsOfPlanetsThatMesh) {
  const Counts expected = {
      {"P.Rx", 3}, {"P.Ry", 3}, {"Q.Rx", 3}, {"Q.Ry", 3}, {"s.Rc", 3}, {"p.Rc", 3}, {"r.Rc", 3}};

  EXPECT_EQ(shared(", count: 3", ""), expected);
  EXPECT_EQ(shared("", ", count: 3"), expected);
  EXPECT_EQ(shared(", count: 3", ", count: 3"), expected);
}

}  // namespace
}  // namespace kinestat
