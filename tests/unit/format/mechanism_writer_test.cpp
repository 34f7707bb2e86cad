#include "format/mechanism_writer.hpp"

#include <variant>

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "support/read_text.hpp"

namespace kinestat {
namespace {

// A slider-crank whose names, units and numbers all need care.
constexpr const char* kSliderCrank =
    "kinestat: 1\n"
    "name: \"Crank \\\"1\\\": 50 # of \\\\ press\"\n"
    "source: \"closed form\"\n"
    "space: planar\n"
    "units: {length: mm, angle: deg, time: min, force: kN}\n"
    "\n"
    "ground: frame\n"
    "\n"
    "bodies:\n"
    "  crank:\n"
    "  rod: {reference: [9, 1e-05]}\n"
    "  slider:\n"
    "\n"
    "couplings:\n"
    "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
    "  b: {type: revolute, bodies: [crank, rod], at: [9, 12]}\n"
    "  c: {type: revolute, bodies: [rod, slider], at: [14, 2*sin(30 deg) - 1]}\n"
    "  d: {type: prismatic, bodies: [frame, slider], at: [\"min(14, 15)\", 0], axis: [-1, 0.5]}\n"
    "  e: {type: prismatic, bodies: [frame, slider], axis: -y}\n"
    "\n"
    "actuators:\n"
    "  drive: {coupling: a}\n"
    "  load: {coupling: d, freedom: v}\n"
    "\n"
    "cases:\n"
    "  \"first: position\":\n"
    "    motion: {drive: -1 rad/s}\n"
    "    input: [drive]\n"
    "    output: [load]\n";

MechanismDescription read_back(const std::string& text) {
  auto reading = read_text(text, read_mechanism);
  EXPECT_EQ(reading.complaints(), Complaints{});
  return reading.value.value_or(MechanismDescription{});
}

TEST(MechanismWriter, WritesWhatReadsBackAsTheSame) {
  EXPECT_EQ(mechanism_text(read_back(kSliderCrank), {}), kSliderCrank);
}

TEST(MechanismWriter, WritesOnlyUnitsThatOthersDoNotImply) {
  const MechanismDescription given = read_back(kSliderCrank);

  const MechanismDescription written = read_back(mechanism_text(given, {}));

  for (const QuantityKind kind : all_quantity_kinds()) {
    EXPECT_EQ(written.units.text(kind), given.units.text(kind));
    EXPECT_EQ(written.units.factor(kind), given.units.factor(kind));
  }
}

TEST(MechanismWriter, PutsTheHeadInCommentsThatStayComments) {
  const std::vector<std::string> head = {"First line", "", "second\nkinestat: 2"};

  const std::string text = mechanism_text(read_back(kSliderCrank), head);

  EXPECT_TRUE(text.starts_with("# First line\n#\n# second\\x0Akinestat: 2\nkinestat: 1\n")) << text;
  read_back(text);
}

}  // namespace
}  // namespace kinestat
