#include "format/key_table.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "couplings/kinds.hpp"
#include "format/sections/sections.hpp"

namespace kinestat {
namespace {

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

// Each key of a mapping is counted once where it is there.
void expect_keys_once(const FormShape& shape, const std::string& path) {
  for (std::size_t i = 0; i < shape.keys.size(); ++i) {
    const FormKey& key = shape.keys[i];
    const auto first = std::ranges::find(shape.keys, key.key, &FormKey::key);
    EXPECT_EQ(first - shape.keys.begin(), static_cast<std::ptrdiff_t>(i)) << path << "/" << key.key;
    expect_keys_once(key.shape, path + "/" + std::string(key.key));
  }
  for (const FormShape& item : shape.items) {
    expect_keys_once(item, path);
  }
}

TEST(KeyTable, NoMappingOfTheFormatHasAKeyTwice) {
  expect_keys_once(file_sections().shape(), "");
}

TEST(KeyTable, SaysFormNeedUsualValueAndExampleAndTheMeaningBelow) {
  const std::string table = key_table("motion");

  EXPECT_TRUE(has_line(table, "  drive    NAME; needed; e.g. drive")) << table;
  EXPECT_TRUE(has_line(table, "           The driving actuator."));
  EXPECT_TRUE(has_line(table, "  steps    VALUE; default 100; e.g. 360"));
}

TEST(KeyTable, ListsBelowAKeyWhatStandsInItsValue) {
  const std::string table = key_table("motion");

  EXPECT_TRUE(has_line(table, "    body  NAME; needed; e.g. coupler")) << table;
  // The keys of an item of 'drives' are those beside it.
  EXPECT_EQ(table.find("drive   NAME"), table.rfind("drive   NAME"));
}

TEST(KeyTable, NamesEverySectionAndThePagesThatAreKnown) {
  const std::string table = section_table(
      [](std::string_view section) { return section == "sweep" ? "sweeps" : std::string(); });

  for (const FormKey& key : file_sections().shape().keys) {
    EXPECT_NE(("\n" + table).find("\n  " + std::string(key.key) + " "), std::string::npos)
        << key.key;
  }
  EXPECT_NE(table.find("; help sweeps"), std::string::npos);
  EXPECT_NE(table.find("\n  x-"), std::string::npos);
}

TEST(CouplingTable, SaysOfEveryTypeWhatItFreesBearsAndMeans) {
  const std::string table = coupling_table();

  for (const CouplingKind* kind : coupling_kinds()) {
    EXPECT_NE(("\n" + table).find("\n  " + std::string(kind->word) + " "), std::string::npos)
        << kind->word;
  }
  EXPECT_TRUE(has_line(table, "  revolute          wz                   Rx Ry Rz Tx Ty")) << table;
  EXPECT_TRUE(has_line(table, "  prismatic         vx                   Ry Rz Tx Ty Tz"));
  EXPECT_TRUE(has_line(table, "  universal         wx wz                Rx Ry Rz Ty"));
  EXPECT_TRUE(has_line(table, "  planar            wz vx vy             Rz Tx Ty"));
  EXPECT_TRUE(has_line(table, "  line_contact      wx wz vx vy          Rz Ty"));
  EXPECT_TRUE(has_line(table, "  pin_in_slot       wz vx                Ry"));
  EXPECT_TRUE(has_line(table, "  rigid             none                 Rx Ry Rz Tx Ty Tz"));
  EXPECT_TRUE(has_line(table, "  clutch            wz                   of its own name"));
  EXPECT_TRUE(has_line(table, "  screws            as listed            as listed"));
  EXPECT_TRUE(has_line(table, "                  slides along an axis: 1 freedom; needs axis"));
}

}  // namespace
}  // namespace kinestat
