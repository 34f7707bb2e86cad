#include "mechanism/check/report_name_check.hpp"

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"
#include "support/read_text.hpp"

namespace kinestat {
namespace {

TEST(ReportNameCheck, KnowsTheFreedomsAndActionsOfACoupling) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);
  const std::vector<Name> names = {{.text = "a.wz", .where = {.line = 1, .column = 1, .length = 4}},
                                   {.text = "b.Rx", .where = {.line = 2, .column = 1, .length = 4}},
                                   {.text = "b.vx", .where = {.line = 3, .column = 1, .length = 4}},
                                   {.text = "velocity", .where = {}}};
  Diagnostics found;

  check_report_quantities(names, false, mechanism.topology, found);

  EXPECT_EQ(complaints_of(found),
            (Complaints{"3:1 E0313 'b.vx' is neither a freedom nor an action of coupling 'b'"}));
  EXPECT_EQ(found.items()[0].hint, "did you mean 'b.Rx'? it has b.wz, b.Rx, b.Ry");
}

}  // namespace
}  // namespace kinestat
