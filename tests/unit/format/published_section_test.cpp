#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto published_of(const std::string& text) {
  return read_text(text, [](const YamlNode& root, Diagnostics& found) {
    const YamlNode& node = *root.find("published");
    return published().read({.node = node,
                             .what = "'published'",
                             .where = node.where,
                             .place = node.where,
                             .space = Space::planar,
                             .found = found});
  });
}

TEST(PublishedSection, KeepsValueToleranceAndPlace) {
  const auto reading =
      published_of("published: [{value: /a/b, is: 5/2, tolerance: 1e-3, where: Eq. 3}]\n");

  EXPECT_EQ(reading.complaints(), Complaints{});
  ASSERT_EQ(reading.value->size(), 1U);
  EXPECT_EQ((*reading.value)[0].pointer.text, "/a/b");
  EXPECT_EQ((*reading.value)[0].is, 2.5);
  EXPECT_EQ((*reading.value)[0].tolerance, 1e-3);
  EXPECT_EQ((*reading.value)[0].where, "Eq. 3");
}

TEST(PublishedSection, TakesWholeNumbersWithoutTolerance) {
  const auto reading = published_of(
      "published: [{value: /a, is: 2}, {value: /a, is: -2.0}, {value: /a, is: 6/3}]\n");

  EXPECT_EQ(reading.complaints(), Complaints{});
  ASSERT_EQ(reading.value->size(), 3U);
  EXPECT_EQ((*reading.value)[0].tolerance, 0.0);
}

TEST(PublishedSection, WantsAToleranceForOtherNumbers) {
  const auto reading = published_of(
      "published:\n- {value: /a, is: 2.5}\n- {value: /a, is: 1/3}\n"
      "- {value: /a, is: 2.5, tolerence: 1}\n- {value: /a, is: 2, tolerance: -1}\n");

  EXPECT_EQ(reading.complaints(),
            (Complaints{"2:3 E0303 a published value lacks the key 'tolerance'",
                        "3:3 E0303 a published value lacks the key 'tolerance'",
                        "4:24 E0302 a published value has no key 'tolerence'",
                        "5:33 E0305 a tolerance cannot be negative"}));
  EXPECT_EQ(reading.found.items()[0].hint,
            "add for example 'tolerance: 1e-3'; only a whole number needs none");
}

}  // namespace
}  // namespace kinestat
