#include "report/partial_archive.hpp"

#include <gtest/gtest.h>

#include "report/json_values.hpp"

namespace kinestat {

namespace {

struct Leaf {
  int size = 0;
};

const Record<Leaf>& leaf_record() {
  static const Record<Leaf> record("A leaf.", [](Record<Leaf>& keys) {
    keys.count("size", "Its size.", [](const Leaf& v) { return v.size; });
    keys.count("double", "Twice that.", [](const Leaf& v) { return 2 * v.size; });
  });
  return record;
}

// Sizes 1 to 4: one alone, two by name, one in a list.
struct Tree {};

const Record<Tree>& tree_record() {
  static const Record<Tree> record("A tree.", [](Record<Tree>& keys) {
    keys.part("top", leaf_record(), [](const Tree&) { return Leaf{1}; });
    keys.map("named", leaf_record(), "By name.", [](const Tree&, const Each<Leaf>& each) {
      each("left", {2});
      each("right", {3});
    });
    keys.list("listed", leaf_record(), "In a list.", [](const Tree&, const Each<Leaf>& each) {
      each({4});
    });
  });
  return record;
}

Json partial_tree(const WantedKeys& wanted) {
  const FileUnits units;
  PartialArchive archive(units, wanted);
  tree_record().write({}, archive);
  return Json::parse(archive.take());
}

TEST(PartialArchive, HasNullsWhereNobodyLooks) {
  EXPECT_EQ(partial_tree({}), Json::parse(R"({"top": null, "named": null, "listed": null})"));
}

TEST(PartialArchive, GoesDownToWhatIsWanted) {
  WantedKeys wanted;
  wanted.with("top").with("double");
  wanted.with("named").with("right").with("size");
  EXPECT_EQ(partial_tree(wanted), Json::parse(R"({"top": {"size": null, "double": 2},
      "named": {"left": {}, "right": {"size": 3, "double": null}}, "listed": null})"));
}

TEST(PartialArchive, HasListsWhole) {
  WantedKeys wanted;
  wanted.with("listed").with("0").with("size");
  EXPECT_EQ(partial_tree(wanted)["listed"], Json::parse(R"([{"size": 4, "double": 8}])"));
}

TEST(PartialArchive, TakesAWantedKeyOnce) {
  WantedKeys wanted;
  wanted.with("top").with("size");
  wanted.with("top").with("double");
  ASSERT_EQ(wanted.below.size(), 1U);
  EXPECT_EQ(partial_tree(wanted)["top"], Json::parse(R"({"size": 1, "double": 2})"));
}

}  // namespace

}  // namespace kinestat
