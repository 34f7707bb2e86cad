#include "report/table_archive.hpp"

#include <gtest/gtest.h>

namespace kinestat {

namespace {

// A change of gears, and the torques of the elements that are held meanwhile.
struct Change {
  double time = 0.0;
};

const Record<Change>& change_of_gears() {
  static const Record<Change> record("A change.", [](Record<Change>& keys) {
    keys.quantity("time", QuantityKind::time, "Its time.", [](const Change& v) { return v.time; });
    keys.numbers("held",
                 QuantityKind::moment,
                 "By the elements.",
                 [](const Change& v, const EachNumber& each) {
                   each("C1", v.time, QuantityKind::moment);
                   each("C2", 2.0 * v.time, QuantityKind::moment);
                 });
  });
  return record;
}

struct Gearbox {};

const Record<Gearbox>& changes_record() {
  static const Record<Gearbox> record("Changes.", [](Record<Gearbox>& keys) {
    keys.map("shift",
             change_of_gears(),
             "By name.",
             [](const Gearbox&, const Each<Change>& each) {
               each("up", {1.0});
               each("down", {3.0});
             })
        .in_tables_is(TableRole::table);
  });
  return record;
}

TEST(TableArchive, NamesWhatContainsAnElementAndTheElement) {
  const FileUnits units;
  const std::vector<NamedTable> tables = tables_of(changes_record(), Gearbox(), "box", units);

  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables.front().text,
            std::string(kCsvHeader) +
                "box,,shift,up,time,1.0,s,solved\n"
                "box,,shift,up,held/C1,1.0,N*m,solved\n"
                "box,,shift,up,held/C2,2.0,N*m,solved\n"
                "box,,shift,down,time,3.0,s,solved\n"
                "box,,shift,down,held/C1,3.0,N*m,solved\n"
                "box,,shift,down,held/C2,6.0,N*m,solved\n");
}

}  // namespace

}  // namespace kinestat
