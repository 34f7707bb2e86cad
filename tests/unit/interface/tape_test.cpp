#include <cmath>
#include <cstddef>
#include <kinestat.h>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "unit/interface/held.hpp"

namespace kinestat::interface_test {
namespace {

Tape record(const Mechanism& mechanism,
            const char* label,
            const std::vector<const char*>& inputs,
            const std::vector<const char*>& outputs) {
  kinestat_tape* handle = nullptr;
  kinestat_record(mechanism.get(),
                  label,
                  inputs.data(),
                  inputs.size(),
                  outputs.data(),
                  outputs.size(),
                  &handle);
  return Tape(handle);
}

struct Played {
  std::vector<double> outputs;
  std::vector<std::string> statuses;
};

Played play(const Tape& tape, const std::vector<double>& inputs, std::size_t states) {
  Played played;
  played.outputs.resize(states * kinestat_output_count(tape.get()));
  std::vector<const char*> statuses(states);
  EXPECT_EQ(
      kinestat_play(tape.get(), inputs.data(), states, played.outputs.data(), statuses.data()),
      KINESTAT_DONE)
      << kinestat_message_text();
  played.statuses.assign(statuses.begin(), statuses.end());
  return played;
}

TEST(TapeHandle, GivesTheRatiosOfWillis) {
  const Tape tape = record(read(kPlanetary), "ring held", {"Ns", "Np"}, {"ratio"});
  ASSERT_NE(tape, nullptr);
  std::vector<double> inputs;
  for (int sun = 17; sun < 60; ++sun) {
    for (int planet = 15; planet < 40; ++planet) {
      inputs.insert(inputs.end(), {double(sun), double(planet)});
    }
  }
  const std::size_t states = inputs.size() / 2;
  const Played played = play(tape, inputs, states);
  EXPECT_EQ(kinestat_is_played(tape.get()), 1);
  for (std::size_t i = 0; i < states; ++i) {
    const double sun = inputs[2 * i];
    const double ring = sun + 2.0 * inputs[2 * i + 1];
    EXPECT_NEAR(played.outputs[i], 1.0 + ring / sun, 1e-12);
    EXPECT_EQ(played.statuses[i], "solved");
  }
}

TEST(TapeHandle, StatesComeInAnyOrderAndNumber) {
  const Tape tape = record(read(kPlanetary), "ring held", {"Np", "Ns"}, {"ratio", "Tc"});
  const std::vector<std::vector<double>> some = {{18, 24}, {20, 20}, {31, 17}, {18, 24}, {64, 99}};
  std::vector<double> all;
  std::vector<double> alone;
  for (const std::vector<double>& one : some) {
    all.insert(all.end(), one.begin(), one.end());
    const Played played = play(tape, one, 1);
    alone.insert(alone.end(), played.outputs.begin(), played.outputs.end());
  }
  EXPECT_EQ(play(tape, all, some.size()).outputs, alone);
  EXPECT_NEAR(alone[0], 3.5, 1e-12);
  EXPECT_EQ(alone[0], alone[6]);
  EXPECT_NEAR(std::abs(alone[1]), 10.0 * 3.5, 1e-11);  // no losses: torques as the ratio
}

TEST(TapeHandle, AgreesWithAnAnalysisOfEachState) {
  const Mechanism mechanism = read(kRavigneaux);
  const Tape tape = record(mechanism, "M1", {"N1", "N2", "N5"}, {});
  ASSERT_NE(tape, nullptr) << kinestat_message_text();
  const std::vector<double> inputs = {19, 70, 15, 25, 66, 12, 33, 81, 30};
  const Played played = play(tape, inputs, 3);
  const std::size_t width = kinestat_output_count(tape.get());
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const char* names[] = {"N1", "N2", "N5"};
      kinestat_set(mechanism.get(), names[k], std::to_string(inputs[3 * i + k]).c_str());
    }
    const Report report = analyze(mechanism);
    ASSERT_NE(report, nullptr);
    for (std::size_t k = 0; k < width; ++k) {
      const std::string name = kinestat_output_name(tape.get(), k);
      if (name == "ratio") {
        const double ratio = number(report, "/cases/M1/ratio");
        EXPECT_NEAR(played.outputs[i * width + k], ratio, 1e-12 * std::abs(ratio));
      }
      if (name.find(".R") != std::string::npos) {
        const double action = number(report, "/cases/M1/statics/actions/" + name);
        EXPECT_NEAR(played.outputs[i * width + k], action, 1e-9 * (1.0 + std::abs(action))) << name;
      }
    }
  }
}

TEST(TapeHandle, CountsInTheUnitsOfTheFile) {
  const Tape tape =
      record(read(kPlanetary), "ring held", {"alpha", "Ns", "module"}, {"ratio", "Tc"});
  EXPECT_STREQ(kinestat_input_unit(tape.get(), 0), "deg");
  EXPECT_STREQ(kinestat_input_unit(tape.get(), 1), "");
  EXPECT_STREQ(kinestat_input_unit(tape.get(), 2), "mm");
  EXPECT_EQ(kinestat_input_unit(tape.get(), 3), nullptr);
  EXPECT_STREQ(kinestat_output_unit(tape.get(), 0), "");
  EXPECT_STREQ(kinestat_output_unit(tape.get(), 1), "N*m");
  EXPECT_EQ(kinestat_output_unit(tape.get(), 2), nullptr);
  const std::vector<double> two = play(tape, {20, 24, 2, 25, 24, 5}, 2).outputs;
  EXPECT_NEAR(two[0], 3.5, 1e-12);  // neither pressure angle nor module changes it
  EXPECT_NEAR(two[2], 3.5, 1e-12);
}

TEST(TapeHandle, AStateThatCannotBeHasItsCode) {
  const Tape tape = record(read(kPlanetary), "ring held", {"module"}, {"ratio"});
  const Played played = play(tape, {2.0, 0.0, 3.0}, 3);
  EXPECT_EQ(played.statuses[0], "solved");
  EXPECT_NE(played.statuses[1], "solved");
  EXPECT_TRUE(std::isnan(played.outputs[1]));
  EXPECT_NEAR(played.outputs[2], 3.5, 1e-12);
}

const std::string kFourBar =
    "kinestat: 1\n"
    "space: planar\n"
    "parameters: {y: 5, weight: 2}\n"
    "ground: frame\n"
    "bodies: {crank: {mass: weight}, coupler: , rocker: }\n"
    "couplings:\n"
    "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
    "  b: {type: revolute, bodies: [crank, coupler], at: [1, 3]}\n"
    "  c: {type: revolute, bodies: [coupler, rocker], at: [6, y]}\n"
    "  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}\n"
    "actuators: {motor: {coupling: a}, work: {coupling: d}}\n"
    "cases: {one: {motion: {motor: 1 rad/s}}}\n";

TEST(TapeHandle, RowsOfALaterCallAreLookedAtLikeTheFirst) {
  const Tape tape = record(parse(kFourBar), "one", {"y", "weight"}, {"d.wz"});
  ASSERT_NE(tape, nullptr) << kinestat_message_text();
  EXPECT_EQ(play(tape, {5.0, 2.0}, 1).statuses[0], "solved");
  const Played later = play(tape, {5.0, -1.0, 5.0, 3.0}, 2);
  EXPECT_EQ(later.statuses[0], "E0305");
  EXPECT_TRUE(std::isnan(later.outputs[0]));
  EXPECT_EQ(later.statuses[1], "solved");
}

TEST(TapeHandle, RefusesWhatItCannotRecord) {
  const Mechanism mechanism = read(kPlanetary);
  EXPECT_EQ(record(mechanism, "ring held", {"Nx"}, {"ratio"}), nullptr);
  EXPECT_STREQ(message().code, "E0103");
  EXPECT_EQ(record(mechanism, "ring held", {}, {"ratio"}), nullptr);
  EXPECT_EQ(record(mechanism, "ring hold", {"Ns"}, {"ratio"}), nullptr);
  EXPECT_NE(std::string(kinestat_message_text()).find("ring held"), std::string::npos);
  EXPECT_EQ(record(mechanism, nullptr, {"Ns"}, {"ratio"}), nullptr);  // which of three?
  EXPECT_NE(std::string(message().hint).find("carrier held"), std::string::npos);
  EXPECT_EQ(record(mechanism, "ring held", {"Ns"}, {"Tx"}), nullptr);
  EXPECT_STREQ(message().code, "E0103");
  EXPECT_EQ(record(mechanism, "ring held", {"Ns", "Ns"}, {"ratio"}), nullptr);
}

TEST(TapeHandle, RefusesWhatIsNoNumber) {
  const Tape tape = record(read(kPlanetary), "ring held", {"Ns", "Np"}, {"ratio"});
  const double inputs[] = {24, 18, 20, std::numeric_limits<double>::quiet_NaN()};
  double outputs[] = {-1, -1};
  EXPECT_EQ(kinestat_play(tape.get(), inputs, 2, outputs, nullptr), KINESTAT_USAGE);
  EXPECT_EQ(outputs[0], -1);
  EXPECT_NE(std::string(message().text).find("'Np' is nan in state 1"), std::string::npos);
  EXPECT_EQ(kinestat_play(tape.get(), inputs, 0, outputs, nullptr), KINESTAT_DONE);
  EXPECT_EQ(kinestat_play(tape.get(), nullptr, 0, nullptr, nullptr), KINESTAT_DONE);
  EXPECT_EQ(kinestat_play(tape.get(), nullptr, 1, outputs, nullptr), KINESTAT_USAGE);
}

TEST(TapeHandle, ThreadsHaveTheirOwn) {
  const std::vector<double> inputs = {19, 70, 15, 25, 66, 12};
  std::vector<double> outputs[2];
  std::vector<std::thread> threads;
  for (std::vector<double>& mine : outputs) {
    threads.emplace_back([&] {
      const Tape tape = record(read(kRavigneaux), "M1", {"N1", "N2", "N5"}, {"ratio", "B2"});
      for (int i = 0; i < 100; ++i) {
        mine = play(tape, inputs, 2).outputs;
      }
    });
  }
  for (std::thread& one : threads) {
    one.join();
  }
  EXPECT_EQ(outputs[0], outputs[1]);
}

// With the sanitizers of memory, which look for what is lost.
TEST(TapeHandle, ManyCallsLoseNothing) {
  const Mechanism mechanism = read(kPlanetary);
  const Report report = analyze(mechanism);
  const Tape tape = record(mechanism, "ring held", {"Ns", "Np"}, {"ratio"});
  constexpr int kCalls = 50'000;
  double value = 0.0;
  for (int i = 0; i < kCalls; ++i) {
    const double inputs[] = {17.0 + i % 40, 18.0};
    ASSERT_EQ(kinestat_play(tape.get(), inputs, 1, &value, nullptr), KINESTAT_DONE);
    ASSERT_EQ(kinestat_number(report.get(), "/cases/ring held/ratio", &value), KINESTAT_DONE);
  }
  for (int i = 0; i < 20; ++i) {
    ASSERT_NE(analyze(read(kPlanetary)), nullptr);
  }
}

}  // namespace
}  // namespace kinestat::interface_test
