// Tapes against whole analyses, over files of the library.
#include "studies/sweep/task/sweep_tapes.hpp"

#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "unit/run/swept_file.hpp"
#include "unit/run/swept_rows.hpp"

namespace kinestat {
namespace {

/// A number of the library's file that is varied.
struct Varied {
  std::string parameter;
  double least = 0.0;
  double most = 0.0;
  std::string unit = {};  ///< of lengths and the like; empty: whole numbers
};

struct SweptLibraryFile {
  std::string path;
  std::vector<std::pair<std::string, std::string>> edits = {};  ///< of its text
  std::vector<Varied> varied = {};
  std::string report = {};
  bool has_tape = true;
  double share = 0.5;  ///< of the solved rows, at least, are of the tape

  friend void PrintTo(const SweptLibraryFile& file, std::ostream* out) { *out << file.path; }
};

// KINESTAT_DIFFERENTIAL raises the number of states.
int states_wanted() {
  const char* const wanted = std::getenv("KINESTAT_DIFFERENTIAL");
  return wanted == nullptr ? 60 : std::max(60, std::atoi(wanted));
}

std::string text_of(const SweptLibraryFile& file) {
  std::ifstream stream(KINESTAT_MECHANISMS "/" + file.path + ".yaml");
  std::ostringstream all;
  all << stream.rdbuf();
  std::string text = all.str();
  for (const std::string section : {"\npublished:", "\nmotion:", "\nsweep:"}) {
    if (const std::size_t at = text.find(section); at != std::string::npos) {
      const std::size_t end = text.find("\n\n", at + 1);
      text.erase(at, end == std::string::npos ? std::string::npos : end - at);
    }
  }
  for (const auto& [from, to] : file.edits) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  return text;
}

// Values of each parameter at random, so many that there are as many states as wanted.
std::string sweep_of(const SweptLibraryFile& file) {
  const auto count = static_cast<int>(
      std::ceil(std::pow(states_wanted(), 1.0 / static_cast<double>(file.varied.size())) - 1e-9));
  std::mt19937_64 random(20261126);
  std::string vary;
  for (const Varied& one : file.varied) {
    std::string values;
    for (int i = 0; i < count; ++i) {
      const double value = std::uniform_real_distribution<>(one.least, one.most)(random);
      values += (i == 0 ? "" : ", ") + (one.unit.empty() ? fmt::format("{}", std::floor(value))
                                                         : fmt::format("{} {}", value, one.unit));
    }
    vary += (vary.empty() ? "" : ", ") + fmt::format("{}: [{}]", one.parameter, values);
  }
  return fmt::format("{{vary: {{{}}}{}}}",
                     vary,
                     file.report.empty() ? "" : fmt::format(", report: [{}]", file.report));
}

// The planets of one set and the sun of another vary, and the rings with them.
const std::vector<std::pair<std::string, std::string>> kTeethOfGearbox = {
    {"  torque: 100 N*m", "  torque: 100 N*m\n  p3: 21\n  s4: 23"},
    {"planet3, teeth: 21", "planet3, teeth: p3"},
    {"teeth: 111", "teeth: 69 + 2*p3"},
    {"sun4, teeth: 23", "sun4, teeth: s4"},
    {"teeth: 85", "teeth: s4 + 62"}};

class TapeOfLibraryFile : public testing::TestWithParam<SweptLibraryFile> {};

TEST_P(TapeOfLibraryFile, GivesTheRowsOfWholeAnalyses) {
  const SweptLibraryFile& file = GetParam();
  SweptFile swept(text_of(file), sweep_of(file));
  SweepTask& task = swept.task();
  ASSERT_EQ(task.tapes.has_value(), file.has_tape);

  const std::vector<Row> analysed = analysed_rows(task);
  expect_near(rows_of(task, kLanes), analysed);
  if (file.has_tape) {
    const auto solved = std::ranges::count(analysed, "solved", &Row::status);
    EXPECT_GE(static_cast<double>(taped_states(task) * task.cases.size()),
              file.share * static_cast<double>(solved));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Library,
    TapeOfLibraryFile,
    testing::Values(
        SweptLibraryFile{.path = "transmissions/ravigneaux",
                         .edits = {{"\nactuators:",
                                    "\nlosses: {gear_external: 0.02, gear_internal: 0.01}"
                                    "\nactuators:"}},
                         .varied = {{"N1", 15, 35}, {"N2", 31, 64}, {"N5", 12, 30}},
                         .report = "ratio, torque_ratio, efficiency, recirculation, out, "
                                   "lossy.out, lossy.B2, f.Rx"},
        SweptLibraryFile{
            .path = "transmissions/ravigneaux_teeth",
            .varied = {{"N1", 17, 24}, {"w_in", -2, 2, "rad/s"}, {"T_in", 1, 9, "N*m"}},
            .report = "ratio, recirculation, out, C2"},
        SweptLibraryFile{.path = "transmissions/ravigneaux_with_losses",
                         .varied = {{"N1", 15, 35}, {"N2", 31, 64}, {"T_in", 1, 9, "N*m"}},
                         .report = "ratio, efficiency, recirculation"},
        SweptLibraryFile{.path = "transmissions/ravigneaux",
                         .edits = {{"\nactuators:",
                                    "\nlosses: {model: absolute, gear_external: 0.02, "
                                    "gear_internal: 0.01}\nactuators:"}},
                         .varied = {{"N1", 15, 35}, {"N2", 31, 64}, {"N5", 12, 30}},
                         .report = "efficiency, lossy.out"},
        SweptLibraryFile{.path = "transmissions/ravigneaux_input_shaft",
                         .varied = {{"N1", 15, 35}, {"N2", 31, 64}, {"T_in", 1, 9, "N*m"}},
                         .report = "ratio, step, efficiency, recirculation, out, lossy.out"},
        SweptLibraryFile{.path = "transmissions/zf_8hp70",
                         .edits = kTeethOfGearbox,
                         .varied = {{"p3", 18, 40}, {"s4", 20, 70}},
                         .report = "ratio, step, efficiency, recirculation, A, B, C, D, E"},
        SweptLibraryFile{.path = "transmissions/wolfrom",
                         .varied = {{"Zs", 18, 23}, {"Zp1", 18, 23}},
                         .report = "ratio, torque_ratio, out",
                         .share = 0.3},  // flanks change where the ring gears swap
        SweptLibraryFile{.path = "transmissions/prius_gen3",
                         .varied = {{"module", 1, 3, "mm"}, {"speed", -90, 90, "rpm"}},
                         .report = "recirculation, MG1, MG2, engine, out"},
        SweptLibraryFile{.path = "transmissions/bevel_differential",
                         .varied = {{"Ns", 12, 30}, {"Np", 8, 20}, {"torque", 100, 900, "N*m"}},
                         .report = "engine, left, right, recirculation"},
        SweptLibraryFile{.path = "gears/simple_planetary",
                         .edits = {{"Nr: 60", "Nr: Ns + 2*Np"},
                                   {"\nactuators:",
                                    "\nlosses: {gear_external: 0.02, gear_internal: 0.01}"
                                    "\nactuators:"}},
                         .varied = {{"Ns", 15, 50}, {"Np", 15, 50}},
                         .report = "ratio, efficiency, recirculation, lossy.Tc"},
        SweptLibraryFile{.path = "spatial/bennett",
                         .varied = {{"k", 5, 80}},
                         .report = "ratio",
                         .has_tape = false},  // no coordinates hold its motions

        SweptLibraryFile{
            .path = "spatial/rssr", .varied = {{"load", -9, 9, "N*m"}}, .report = "work, motor"},
        SweptLibraryFile{.path = "planar/toggle_press",
                         .varied = {{"x", 5, 40}, {"push", 100, 900, "N"}},
                         .report = "",
                         .has_tape = false}));  // friction and loads

// 24 and 48 teeth, p3 and 69, 31 and s4 give the distances of the planets from the main axis, on
// which all sets are: three of them are the same with 3 and 41, two with p3 = s4 - 38 or s4 = 41.
TEST(SweepTapes, AnswerWherePlanetsOfTwoSetsComeToStandOnOneLine) {
  SweptFile file(text_of({.path = "transmissions/zf_8hp70", .edits = kTeethOfGearbox}),
                 "{vary: {p3: [3, 20, 21, 22], s4: [23, 41, 58, 59, 60]}, "
                 "report: [ratio, efficiency, recirculation, A, B, C, D, E]}");
  ASSERT_TRUE(file.task().tapes.has_value());
  EXPECT_EQ(taped_states(file.task()), file.task().plan.state_count());
  expect_near(rows_of(file.task(), kLanes), analysed_rows(file.task()));
}

// With its ring off the main axis nothing holds the centres of ring and planet apart.
TEST(SweepTapes, SeeThatAMeshLosesItsCarrier) {
  std::string text = kTrain;
  text.replace(text.find("[housing, ring], at: [0, 0]"), 27, "[housing, ring], at: [0, e]");
  text.replace(text.find("{S: 24"), 6, "{e: 0, S: 24");
  text += "losses: {gear_external: 0.03, gear_internal: 0.01}\n";
  SweptFile file(text, "{vary: {e: [0, 0.000001, 1]}, cases: [back], report: [ratio, efficiency]}");
  ASSERT_TRUE(file.task().tapes.has_value());
  EXPECT_EQ(taped_states(file.task()), 1U);
  const std::vector<Row> rows = rows_of(file.task(), kLanes);
  EXPECT_FALSE(std::isnan(rows[0].values[1]));
  EXPECT_TRUE(std::isnan(rows[2].values[1]));
  expect_near(rows, analysed_rows(file.task()));
}

// Reductions of a set with its ring held, by the carrier model: η = (1 + η0 i0)/(1 + i0), where i0
// is R/S and η0 what both meshes leave with the carrier at rest (Pennestrì and Freudenstein 1993).
TEST(SweepTapes, FindTheEfficiencyOfASetInClosedForm) {
  const std::string text =
      std::string(kTrain) + "losses: {gear_external: 0.03, gear_internal: 0.01}\n";
  SweptFile file(text,
                 "{vary: {S: {from: 15, to: 40, step: 1}, P: {from: 15, to: 30, step: 1}}, "
                 "cases: [low], report: [efficiency, lossy.wheel]}");
  SweepTask& task = file.task();
  ASSERT_TRUE(task.tapes.has_value());
  EXPECT_EQ(taped_states(task), task.plan.state_count());

  for (const Row& row : rows_of(task, kLanes)) {
    const double s = 15.0 + static_cast<double>(row.state / 16);
    const double p = 15.0 + static_cast<double>(row.state % 16);
    const double basic = (s + 2 * p) / s;
    const double efficiency = (1 + 0.97 * 0.99 * basic) / (1 + basic);
    EXPECT_NEAR(row.values[0], efficiency, 1e-13);
    EXPECT_NEAR(row.values[1], -5.0 * (1 + basic) * efficiency, 1e-10);
  }
}

TEST(SweepTapes, AnswerNothingWhereAMeshDrivesTheOtherWayRound) {
  const std::string text =
      std::string(kTrain) + "losses: {gear_external: 0.03, gear_internal: 0.01}\n";
  SweptFile file(text,
                 "{vary: {torque: [-2 N*m, -1 N*m, 1 N*m, 2 N*m]}, cases: [low], "
                 "report: [ratio, efficiency, wheel]}");
  SweepTask& task = file.task();
  ASSERT_TRUE(task.tapes.has_value());

  // With a negative torque the motor brakes: every mesh drives the other way round.
  EXPECT_EQ(taped_states(task), 2U);
  expect_near(rows_of(task, kLanes), analysed_rows(task));
}

/// A slider-crank whose bearing has friction with other parameters than its own.
const char* const kRubbingCrank = R"(
kinestat: 1
space: planar
parameters: {mu: 0, T: 5 N*m}
ground: housing
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [housing, crank], at: [0, 0], friction: {mu: mu, radius: 0.05}}
  b: {type: revolute, bodies: [crank, rod], at: [0.3, 0.4]}
  c: {type: revolute, bodies: [rod, slider], at: [1.5, 0]}
  d: {type: prismatic, bodies: [housing, slider], axis: x, at: [1.5, 0]}
actuators: {motor: {coupling: a}, load: {coupling: d}}
cases:
  c: {motion: {motor: 1}, action: {motor: T}, input: motor, output: load}
)";

/// With a large loss it locks where the sun drives.
const char* const kOverhauling = R"(
kinestat: 1
space: planar
units: {length: mm}
parameters: {centres: 199, alpha: 20 deg, k: 0.001}
ground: housing
bodies: [sun, carrier, planet]
couplings:
  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  c: {type: revolute, bodies: [housing, carrier], at: [0, 0]}
  p: {type: revolute, bodies: [carrier, planet], at: [0, centres]}
  s: {type: gear, bodies: [sun, planet], at: [0, centres*100/199], tangent: x, pressure_angle: alpha}
  w: {type: gear, bodies: [housing, planet], at: [0, centres/2], tangent: x, pressure_angle: alpha}
actuators:
  sun_shaft: {coupling: a}
  carrier_shaft: {coupling: c}
losses: {meshes: {s: k}}
cases:
  reducing: {motion: {carrier_shaft: 100}, action: {carrier_shaft: 1 N*m}, input: carrier_shaft, output: sun_shaft}
  overhauling: {motion: {sun_shaft: 1}, action: {sun_shaft: 1 N*m}, input: sun_shaft, output: carrier_shaft}
  overhauling2: {motion: {sun_shaft: 1}, action: {carrier_shaft: -1 N*m}, input: sun_shaft, output: carrier_shaft}
)";

/// Two inputs, of which the speeds agree with 20 teeth of both wheels alone.
const char* const kTwoInputs = R"(
kinestat: 1
space: planar
units: {length: mm}
parameters: {NA: 20, NC: 20}
ground: housing
bodies: [ga, gb, gc, shaft]
couplings:
  a: {type: revolute, bodies: [housing, ga]}
  b: {type: revolute, bodies: [housing, gb]}
  c: {type: revolute, bodies: [housing, gc]}
  o: {type: revolute, bodies: [housing, shaft]}
  C: {type: clutch, bodies: [ga, shaft]}
gears:
  module: 2 mm
  members:
    A: {body: ga, teeth: NA}
    B: {body: gb, teeth: 15, centre_distance: 35 mm}
    D: {body: gc, teeth: NC}
  meshes:
    ab: {members: [A, B]}
    bd: {members: [B, D]}
actuators: {in1: {coupling: a}, in2: {coupling: c}, out: {coupling: o}}
shift:
  input: [in1, in2]
  output: out
  elements: [C]
  input_motion: 10 rad/s
  names: {G: [C]}
)";

/// Two inputs on one shaft.
const char* const kSharedShaft = R"(
kinestat: 1
space: planar
units: {length: mm}
parameters: {N1: 20, N2: 40, T: 3 N*m, x: 0.1, y: 0.1}
ground: housing
bodies: [inp, outp]
couplings:
  I: {type: revolute, bodies: [housing, inp]}
  J: {type: revolute, bodies: [housing, inp], passive: []}
  O: {type: revolute, bodies: [housing, outp]}
gears:
  module: 2 mm
  members:
    g1: {body: inp, teeth: N1}
    g2: {body: outp, teeth: N2, centre_distance: 60 mm}
  meshes:
    m1: {members: [g1, g2]}
actuators: {in: {coupling: I}, in2: {coupling: J}, out: {coupling: O}}
cases:
  c0: {motion: {in: 1}, action: {in: T, in2: -(x+y)*10 N*m}, input: [in, in2], output: out}
)";

/// The screws of s leave two constraints with e = 0, otherwise one: its actions come and go.
const char* const kScrews = R"(
kinestat: 1
space: planar
parameters: {e: 0, F: 5 N}
ground: frame
bodies: [table]
couplings:
  s: {type: screws, bodies: [frame, table], freedoms: [{translation: x}, {translation: [1, e]}]}
  g: {type: prismatic, bodies: [frame, table], axis: x, at: [0, 1], passive: []}
  h: {type: prismatic, bodies: [frame, table], axis: x, at: [0, 1], passive: []}
actuators: {a: {coupling: g}, b: {coupling: h}}
cases:
  c: {action: {a: F}}
)";

void expect_rows_of_analyses(const char* text, const std::string& sweep) {
  SweptFile file(text, sweep);
  const std::vector<Row> analysed = analysed_rows(file.task());
  expect_near(rows_of(file.task(), kLanes), analysed);
}

TEST(SweepTapes, SeeFrictionThatTheFileItselfHasNot) {
  expect_rows_of_analyses(kRubbingCrank, "{vary: {mu: {values: [0, 0.1, 0.2]}}, report: [load]}");
  expect_rows_of_analyses(kRubbingCrank, "{vary: {mu: {values: [0.1, 0.2, 0]}}, report: [load]}");
}

TEST(SweepTapes, SeeThatLossesLockWhateverIsReported) {
  for (const std::string report : {"recirculation", "lossy.carrier_shaft", "efficiency"}) {
    SCOPED_TRACE(report);
    expect_rows_of_analyses(
        kOverhauling, "{vary: {k: {values: [0.05, 0.03, 0.001, 0]}}, report: [" + report + "]}");
  }
  SweptFile file(kOverhauling, "{vary: {k: {values: [0.05]}}, report: [recirculation]}");
  EXPECT_EQ(rows_of(file.task(), kLanes).at(1).status, "self_locking");
}

TEST(SweepTapes, SeeInputsThatContradictEachOther) {
  const std::string sweep = "{vary: {NC: {values: [20, 21, 30]}}, report: [o.wz, c.wz]}";
  SweptFile file(kTwoInputs, sweep);
  const std::vector<Row> rows = rows_of(file.task(), kLanes);
  EXPECT_EQ(rows[0].status, "solved");
  EXPECT_EQ(rows[1].status, "locked");
  EXPECT_EQ(rows[2].status, "locked");
}

TEST(SweepTapes, SeeInputsThatCancel) {
  expect_rows_of_analyses(
      kSharedShaft,
      "{vary: {y: {values: [0.1, 0.1999999999999999, 0.1999999999999995, 0.19999999999999]}}, "
      "report: [recirculation]}");
}

// a holds 5 N, and b, beside it, the opposite.
TEST(SweepTapes, FindActionsByNameWhereOthersComeAndGo) {
  for (const std::string values : {"[0, 1, 2]", "[2, 1, 0]"}) {
    SweptFile file(kScrews, "{vary: {e: {values: " + values + "}}, report: [b, a]}");
    for (const Row& row : rows_of(file.task(), kLanes)) {
      EXPECT_EQ(row.values, (std::vector<double>{-5.0, 5.0}));
    }
  }
}

}  // namespace
}  // namespace kinestat
