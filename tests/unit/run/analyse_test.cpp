#include "run/analyse.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "unit/run/mechanism_file.hpp"

namespace kinestat {
namespace {

constexpr const char* kCase = "  one: {motion: {load: 1 rad/s}}\n";

TEST(AnalyseFiles, RefuseOneNameTwiceBeforeTheyWrite) {
  const MechanismFile first(kCase);
  const MechanismFile second(kCase);
  const MechanismFile reports(kCase);
  AnalyseOptions options;
  options.output.folder = reports.folder();

  const Outcome outcome = analyse_files({first.path(), second.path()}, options);

  EXPECT_EQ(outcome.status, ExitStatus::usage);
  EXPECT_TRUE(outcome.report.is_empty());
  EXPECT_FALSE(std::filesystem::exists(reports.folder() + "/four_bar.report.json"));
}

TEST(AnalyseFiles, AcceptOneNameTwiceWithoutAFolder) {
  const MechanismFile first(kCase);
  const MechanismFile second(kCase);

  EXPECT_EQ(analyse_files({first.path(), second.path()}, {}).status, ExitStatus::done);
}

TEST(AnalyseFiles, WriteATableForEveryPassThatRan) {
  const MechanismFile file(kCase);
  AnalyseOptions options;
  options.output.folder = file.folder();

  const Outcome outcome = analyse_files({file.path()}, options);

  EXPECT_EQ(outcome.err.plain(), "");
  EXPECT_TRUE(std::filesystem::exists(file.folder() + "/four_bar.report.json"));
  EXPECT_TRUE(std::filesystem::exists(file.folder() + "/four_bar.kinematics.csv"));
  EXPECT_FALSE(std::filesystem::exists(file.folder() + "/four_bar.statics.csv"));
}

TEST(AnalyseFiles, PrintNothingWhenQuiet) {
  const MechanismFile file(kCase);
  AnalyseOptions options;
  options.is_quiet = true;

  EXPECT_TRUE(analyse_files({file.path()}, options).report.is_empty());
}

TEST(AnalyseFiles, GoOnAfterAFileThatFails) {
  const MechanismFile file(kCase);

  const Outcome outcome = analyse_files({file.folder() + "/none.yaml", file.path()}, {});

  EXPECT_EQ(outcome.status, ExitStatus::environment);
  EXPECT_NE(outcome.report.text().find("Case one"), std::string::npos);
}

TEST(AnalyseFiles, StopAfterAFileThatFailsWhenAsked) {
  const MechanismFile file(kCase);
  AnalyseOptions options;
  options.fail_fast = true;

  EXPECT_TRUE(
      analyse_files({file.folder() + "/none.yaml", file.path()}, options).report.is_empty());
}

TEST(CheckFiles, SayOkForAFileThatIsGood) {
  const MechanismFile file(kCase);

  EXPECT_EQ(check_files({file.path()}, {}).out, file.path() + ": ok\n");
}

}  // namespace
}  // namespace kinestat
