// Each oracle lets pass what agrees, and ends the process where a number is another.

#include "fuzz/report_oracles.hpp"

#include <array>
#include <string>

#include <gtest/gtest.h>

namespace kinestat::fuzz {
namespace {

Json report_of(double rate, const char* precision = "double") {
  const Json evidence = {
      {"precision", precision}, {"refers_to", "numbers as typed"}, {"error_bound", 1e-12}};
  const Json side = {
      {"status", "solved"}, {"freedoms", {{"a.wz", rate}, {"b.wz", -2.0}}}, {"evidence", evidence}};
  return {{"cases", {{"c", {{"kinematics", side}, {"ratio", rate}}}}},
          {"diagnostics", Json::array()}};
}

Json motion_of(double rate, double drive = 0.0) {
  Json columns = Json::array();
  for (const auto& [name, element, quantity] : {std::array{"T/drive", "T", "drive"},
                                                std::array{"a.wz/velocity", "a.wz", "velocity"},
                                                std::array{"status", "", "status"}}) {
    columns.push_back({{"name", name}, {"element", element}, {"quantity", quantity}});
  }
  return {{"motion",
           {{"case", "c"},
            {"columns", columns},
            {"rows", Json::array({Json::array({drive, rate, "solved"})})}}}};
}

Json row_of(double rate) {
  return {
      {"swept", 1.0}, {"case", "c"}, {"ratio", rate}, {"a.wz [rad/s]", rate}, {"status", "solved"}};
}

TEST(ReportOracles, HoldAccuraciesToTheirBounds) {
  check_accuracies(report_of(1.0), report_of(1.0 + 1e-13), false);
  check_accuracies(report_of(1.0), report_of(1.0 + 1e-8), true);
  EXPECT_DEATH(check_accuracies(report_of(1.0), report_of(1.0 + 1e-8), false), "a.wz");
  EXPECT_DEATH(check_accuracies(report_of(1.0), report_of(1.0 + 1e-4), true), "a.wz");
  EXPECT_DEATH(check_accuracies(report_of(1.0), report_of(0.0), false), "a.wz");
}

TEST(ReportOracles, FindEveryNumberOfATableInTheReport) {
  const std::string head = "mechanism,case,pass,element,quantity,value,unit,status\n";
  check_table(report_of(0.5), head + "m,c,kinematics,\"a, b\",velocity,0.5,rad/s,solved\n");
  check_table(report_of(0.5), head + "m,c,kinematics,a.wz,rate,,rad/s,solved\n");
  for (const char* const row : {"m,c,kinematics,a.wz,rate,0.6,rad/s,solved\n",
                                "m,c,kinematics,a.wz,rate,nan,rad/s,solved\n",
                                "m,c,kinematics,a.wz,rate,half,rad/s,solved\n",
                                "m,c,kinematics,a.wz,velocity,0.5,rad/s\n"}) {
    EXPECT_DEATH(check_table(report_of(0.5), head + row), "broken") << row;
  }
  EXPECT_DEATH(check_table(report_of(0.5), "mechanism,case\n"), "broken");
}

TEST(ReportOracles, FindTheReportInTheText) {
  check_text(report_of(1.0 / 3), "Case c\n  a.wz   0.333333  rad/s\n");
  EXPECT_DEATH(check_text(report_of(1.0 / 3), "Case c\n  a.wz   0.333343  rad/s\n"), "a.wz");
}

TEST(ReportOracles, HoldTheFirstRowOfAMotionToTheAnalysis) {
  check_first_row(report_of(1.5), motion_of(1.5));
  check_first_row(report_of(1.5), motion_of(1.6, 0.1));  // it begins elsewhere
  Json warned = report_of(1.5);
  warned["diagnostics"].push_back({{"code", "W0309"}});
  check_first_row(warned, motion_of(0.0));  // places are lost in rounding, and the file is told so
  EXPECT_DEATH(check_first_row(report_of(1.5), motion_of(1.5001)), "a.wz");
}

TEST(ReportOracles, HoldTheRowOfASweepToTheAnalysis) {
  check_sweep_row(report_of(1.5), row_of(1.5));
  EXPECT_DEATH(check_sweep_row(report_of(1.5), row_of(1.5001)), "ratio");
  check_sweep_row(report_of(1.5, "refined"), row_of(1.5001));  // doubles prove less
  EXPECT_DEATH(check_sweep_row(report_of(1.5, "refined"), row_of(1.6)), "ratio");
}

}  // namespace
}  // namespace kinestat::fuzz
