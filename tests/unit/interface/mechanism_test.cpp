#include <kinestat.h>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "unit/interface/held.hpp"

namespace kinestat::interface_test {
namespace {

std::vector<std::string> names(const Mechanism& mechanism, int which) {
  std::vector<std::string> result;
  while (const char* name = kinestat_name(mechanism.get(), which, result.size())) {
    result.emplace_back(name);
  }
  return result;
}

TEST(MechanismHandle, NamesWhatTheFileNames) {
  const Mechanism mechanism = read(kPlanetary);
  ASSERT_NE(mechanism, nullptr);
  EXPECT_EQ(names(mechanism, KINESTAT_PARAMETERS),
            (std::vector<std::string>{"Ns", "Np", "Nr", "module", "alpha"}));
  EXPECT_EQ(names(mechanism, KINESTAT_ACTUATORS), (std::vector<std::string>{"Ts", "Tr", "Tc"}));
  EXPECT_EQ(names(mechanism, KINESTAT_CASES),
            (std::vector<std::string>{"ring held", "carrier held", "sun held"}));
  EXPECT_TRUE(names(mechanism, 3).empty());
}

TEST(MechanismHandle, TellsTheVersionOfTheProject) {
  EXPECT_STREQ(kinestat_version(), KINESTAT_VERSION);
}

TEST(MechanismHandle, AFileThatIsNotThereHasNone) {
  kinestat_mechanism* handle = nullptr;
  EXPECT_EQ(kinestat_read_file("/nowhere/crank.yaml", &handle), KINESTAT_ENVIRONMENT);
  EXPECT_EQ(handle, nullptr);
  ASSERT_EQ(kinestat_message_count(), 1U);
  EXPECT_STREQ(message().code, "E0151");
  EXPECT_STREQ(message().file, "/nowhere/crank.yaml");
}

TEST(MechanismHandle, AWrongTextIsToldWithItsPlace) {
  const Mechanism mechanism = parse(R"(kinestat: 1
space: planar
ground: frame
bodies: [crank]
couplings:
  a: {type: revolute, bodies: [frame, crnk], at: [0, 0]}
)");
  EXPECT_EQ(mechanism, nullptr);
  ASSERT_GE(kinestat_message_count(), 1U);
  EXPECT_EQ(message().is_error, 1);
  EXPECT_EQ(message().line, 6);
  EXPECT_EQ(message().column, 39);
  EXPECT_STREQ(message().file, "text");
  EXPECT_NE(std::string(kinestat_message_text()).find("text:6:39: error[E0312]"),
            std::string::npos);
}

TEST(MechanismHandle, NullsAreRefusedAndFreed) {
  kinestat_mechanism* handle = nullptr;
  EXPECT_EQ(kinestat_read_file(nullptr, &handle), KINESTAT_USAGE);
  EXPECT_STREQ(message().code, "E0103");
  EXPECT_EQ(kinestat_read_file("x", nullptr), KINESTAT_USAGE);
  EXPECT_EQ(kinestat_set(nullptr, "a", "1"), KINESTAT_USAGE);
  EXPECT_EQ(kinestat_name(nullptr, KINESTAT_CASES, 0), nullptr);
  EXPECT_EQ(kinestat_message_at(0, nullptr), 0);
  kinestat_free_mechanism(nullptr);
  kinestat_free_report(nullptr);
  kinestat_free_tape(nullptr);
}

TEST(MechanismHandle, ASuccessfulCallHasNoMessagesOfTheOneBefore) {
  (void)read("/nowhere/crank.yaml");
  const Mechanism mechanism = read(kPlanetary);
  EXPECT_EQ(kinestat_message_count(), 0U);
  EXPECT_STREQ(kinestat_message_text(), "");
}

TEST(MechanismHandle, AParameterIsSetAsOnTheCommandLine) {
  const Mechanism mechanism = read(kPlanetary);
  EXPECT_EQ(kinestat_set(mechanism.get(), "Ns", "20"), KINESTAT_DONE);
  EXPECT_EQ(kinestat_set(mechanism.get(), "Np", "Ns"), KINESTAT_DONE);
  EXPECT_EQ(kinestat_set(mechanism.get(), "Ns", "30"), KINESTAT_DONE);
  // Willis, with the ring of 90 teeth that fits.
  EXPECT_NEAR(number(analyze(mechanism), "/cases/ring held/ratio"), 1.0 + 90.0 / 30.0, 1e-12);
}

TEST(MechanismHandle, AWrongValueLeavesTheOldOne) {
  const Mechanism mechanism = read(kPlanetary);
  EXPECT_EQ(kinestat_set(mechanism.get(), "Ms", "20"), KINESTAT_USAGE);
  EXPECT_NE(std::string(message().hint).find("Ns"), std::string::npos);
  EXPECT_EQ(kinestat_set(mechanism.get(), "module", "20 deg"), KINESTAT_USAGE);
  EXPECT_EQ(kinestat_set(mechanism.get(), "Ns", "2 +"), KINESTAT_USAGE);
  EXPECT_EQ(kinestat_set(mechanism.get(), "Ns", "many"), KINESTAT_USAGE);
  EXPECT_EQ(kinestat_set(mechanism.get(), "Ns", "1/0"), KINESTAT_USAGE);
  EXPECT_EQ(kinestat_set(mechanism.get(), "Ns", "Nr"), KINESTAT_USAGE);  // which uses Ns
  EXPECT_NEAR(number(analyze(mechanism), "/cases/ring held/ratio"), 3.5, 1e-12);
}

}  // namespace
}  // namespace kinestat::interface_test
