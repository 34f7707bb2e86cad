#include <cmath>
#include <kinestat.h>
#include <string>

#include <gtest/gtest.h>

#include "unit/interface/held.hpp"

namespace kinestat::interface_test {
namespace {

TEST(ReportHandle, HasTheNumbersOfTheSource) {
  const Report report = analyze(read(kRavigneaux));
  // Cazangi 2008, Tab. 5.15, three digits after the point.
  EXPECT_NEAR(number(report, "/cases/M1/ratio"), 2.847, 5e-4);
  EXPECT_NEAR(number(report, "/cases/MR/ratio"), -2.073, 5e-4);
  EXPECT_EQ(number(report, "/mobility/minimal/net_freedom"), 2.0);  // Eq. 5.45
}

TEST(ReportHandle, IsTheJsonOfTheProgram) {
  const Report report = analyze(read(kPlanetary));
  const std::string json = kinestat_json(report.get());
  EXPECT_EQ(json.substr(0, 2), "{\n");
  EXPECT_NE(json.find("\"ring held\""), std::string::npos);
}

TEST(ReportHandle, SaysWhatThereIsInsteadOfAWrongPlace) {
  const Report report = analyze(read(kPlanetary));
  double value = 7.0;
  EXPECT_EQ(kinestat_number(report.get(), "/cases/ring hold/ratio", &value), KINESTAT_USAGE);
  EXPECT_EQ(value, 7.0);
  EXPECT_NE(std::string(message().hint).find("ring held"), std::string::npos);
  EXPECT_EQ(kinestat_number(report.get(), "/cases", &value), KINESTAT_USAGE);
  EXPECT_EQ(kinestat_number(report.get(), "cases", &value), KINESTAT_USAGE);
  EXPECT_EQ(value, 7.0);
}

TEST(ReportHandle, AMissedPublishedValueHasAReport) {
  const Mechanism mechanism = read(kPlanetary);
  ASSERT_EQ(kinestat_set(mechanism.get(), "Ns", "30"), KINESTAT_DONE);
  kinestat_report* report = nullptr;
  EXPECT_EQ(kinestat_analyze(mechanism.get(), &report), KINESTAT_CHECK_FAILED);
  EXPECT_NE(report, nullptr);
  EXPECT_STREQ(message().code, "E0901");
  kinestat_free_report(report);
}

TEST(ReportHandle, AValueThatDoesNotExistIsNoNumber) {
  const Report report = analyze(parse(R"(
kinestat: 1
space: planar
ground: frame
bodies: [crank, slide]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, slide], at: [1, 0]}
actuators: {t: {coupling: a}, u: {coupling: b}}
cases:
  rest: {motion: {t: 0, u: 0}, input: t, output: u}
)"));
  ASSERT_NE(report, nullptr);
  EXPECT_TRUE(std::isnan(number(report, "/cases/rest/ratio")));  // 0/0
}

}  // namespace
}  // namespace kinestat::interface_test
