// Mechanisms at the edge of what doubles can tell: each has the right rank and the right value, or
// is refused, or has both answers; it is never silently wrong. What is right follows from closed
// forms.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cases/findings/certainty_findings.hpp"
#include "cases/solve_cases.hpp"
#include "format/mechanism_reader.hpp"
#include "mechanism/bind/bind.hpp"

namespace kinestat {
namespace {

constexpr double kNineDigits = 1e-9;

std::optional<CertifiedAnalysis> analyse(const std::string& text, Accuracy accuracy) {
  Diagnostics found;
  const auto tree = read_yaml({.path = "test", .text = "kinestat: 1\n" + text}, {}, found);
  auto description = tree ? read_mechanism(*tree, found) : std::nullopt;
  auto mechanism = description ? bind(*description, found) : std::nullopt;
  for (const Diagnostic& item : found.items()) {
    ADD_FAILURE() << item.code << " in line " << item.where.line << ": " << item.message;
  }
  if (!mechanism) {
    return std::nullopt;
  }
  return solve_certified_cases("test",
                               {.description = *std::move(description),
                                .mechanism = *std::move(mechanism),
                                .shift = std::nullopt},
                               {.accuracy = accuracy});
}

struct Extreme {
  std::string name;
  std::string text;
  std::function<void(const std::string& text)> check;
};

void PrintTo(const Extreme& extreme, std::ostream* to) {
  *to << extreme.name;
}

// Checks of ranks

// The rank of rounded and of typed numbers is this one.
void expect_rank(const std::optional<RankCertainty>& found, int rank) {
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->rank, rank);
  EXPECT_FALSE(found->differs());
  EXPECT_LE(found->lower, rank);
  EXPECT_GE(found->upper, rank);
  EXPECT_TRUE(found->how == "structural" || found->exact_input.has_value()) << found->how;
}

// As typed it is `exact_input`; where doubles say something else, both answers are there.
void expect_exact_input_rank(const std::optional<RankCertainty>& found,
                             int exact_input,
                             int rounded) {
  ASSERT_TRUE(found.has_value());
  ASSERT_TRUE(found->exact_input.has_value() || found->how == "structural");
  EXPECT_EQ(found->exact_input ? found->exact_input->rank : found->rank, exact_input);
  EXPECT_TRUE(found->rank == exact_input || (found->rank == rounded && found->differs()));
}

// Checks of rates

std::optional<double> rate_of(const Analysis& analysis, const std::string& name) {
  const Topology& topology = analysis.mechanism.topology;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    if (topology.freedom_name(f) == name && !analysis.cases[0].motion->rates.empty()) {
      return analysis.cases[0].motion->rates[static_cast<std::size_t>(f)];
    }
  }
  return std::nullopt;
}

void expect_rate(const std::string& text, const std::string& name, double expected) {
  for (const Accuracy accuracy : {Accuracy::automatic, Accuracy::exact}) {
    SCOPED_TRACE(word_of(accuracy));
    const auto analysis = analyse(text, accuracy);
    ASSERT_TRUE(analysis.has_value());
    const auto rate = rate_of(analysis->analysis, name);
    ASSERT_TRUE(rate.has_value());
    EXPECT_NEAR(*rate, expected, kNineDigits * std::abs(expected));
    const auto& bound = analysis->analysis.cases[0].motion->answer.error_bound;
    ASSERT_TRUE(bound.has_value());
    EXPECT_LE(*bound, kNineDigits);
  }
}

// As typed there is an answer, which is right; the automatic way gives it or says that it exists.
void expect_rate_or_both_answers(const std::string& text,
                                 const std::string& name,
                                 double expected) {
  const auto exact = analyse(text, Accuracy::exact);
  ASSERT_TRUE(exact.has_value());
  const auto as_typed = rate_of(exact->analysis, name);
  ASSERT_TRUE(as_typed.has_value());
  EXPECT_NEAR(*as_typed, expected, kNineDigits * std::abs(expected));
  const auto automatic = analyse(text, Accuracy::automatic);
  ASSERT_TRUE(automatic.has_value());
  const auto rate = rate_of(automatic->analysis, name);
  if (rate) {
    EXPECT_NEAR(*rate, expected, kNineDigits * std::abs(expected));
  } else {
    EXPECT_TRUE(automatic->certainty.cases[0].has_exact_input_motion);
  }
}

// Texts

struct Point {
  double x = 0.0;
  double y = 0.0;
};

double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}

Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}

// Places are texts, so that they may be expressions; the rates are those of revolutes a and d.
std::string four_bar(const std::vector<std::string>& places, const std::string& known) {
  return fmt::format(
      "space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
      "  a: {{type: revolute, bodies: [frame, crank], at: {}}}\n"
      "  b: {{type: revolute, bodies: [crank, coupler], at: {}}}\n"
      "  c: {{type: revolute, bodies: [coupler, rocker], at: {}}}\n"
      "  d: {{type: revolute, bodies: [frame, rocker], at: {}}}\n"
      "cases:\n  one: {{motion: {{{}: 1}}}}\n",
      places[0],
      places[1],
      places[2],
      places[3],
      known);
}

// ω_d / ω_a from ω_a AB + ω_coupler BC = ω_d DC.
double rocker_ratio(Point a, Point b, Point c, Point d) {
  return cross(b - a, c - b) / cross(c - d, c - b);
}

std::string planet_train(int planets, double unit) {
  std::string text = fmt::format(
      "space: planar\nparameters: {{u: {:.0e} m}}\nground: housing\nbodies: [sun, ring, carrier",
      unit);
  for (int k = 0; k < planets; ++k) {
    text += fmt::format(", p{}", k);
  }
  text +=
      "]\ncouplings:\n"
      "  S: {type: revolute, bodies: [housing, sun], at: [0, 0]}\n"
      "  R: {type: revolute, bodies: [housing, ring], at: [0, 0]}\n"
      "  C: {type: revolute, bodies: [housing, carrier], at: [0, 0]}\n";
  for (int k = 0; k < planets; ++k) {
    const std::string turn = fmt::format("360 deg*{}/{}", k, planets);
    const auto at = [&](int radius) {
      return fmt::format("[{}*u*cos({}), {}*u*sin({})]", radius, turn, radius, turn);
    };
    const std::string tangent = fmt::format("[-sin({}), cos({})]", turn, turn);
    text += fmt::format(
        "  P{0}: {{type: revolute, bodies: [carrier, p{0}], at: {1}}}\n"
        "  s{0}: {{type: gear, bodies: [sun, p{0}], at: {2}, tangent: {4}, pressure_angle: 20 "
        "deg}}\n"
        "  r{0}: {{type: gear, bodies: [ring, p{0}], at: {3}, tangent: {4}, pressure_angle: 20 "
        "deg, internal: true}}\n",
        k,
        at(21),
        at(12),
        at(30),
        tangent);
  }
  return text;
}

// Willis: two of sun, ring and carrier move freely, whatever the planets are, so that rank M_N = F
// - 2 = 3n + 1, and rank A_N = 3 (n + 3) - 2; one planet lies in line with the axis, as in all.
Extreme planets(int count, double unit) {
  return {fmt::format("{}_planets_in_units_of_{:.0f}", count, std::log10(unit) + 100.0),
          planet_train(count, unit),
          [count](const std::string& text) {
            for (const Accuracy accuracy : {Accuracy::automatic, Accuracy::exact}) {
              SCOPED_TRACE(word_of(accuracy));
              const auto analysis = analyse(text, accuracy);
              ASSERT_TRUE(analysis.has_value());
              expect_rank(analysis->certainty.motion_rank, 3 * count + 1);
              expect_rank(analysis->certainty.action_rank, 3 * count + 7);
            }
          }};
}

Extreme scaled_four_bar(const std::string& name, const std::string& place) {
  const auto at = [&](const char* x, const char* y) {
    return fmt::format(fmt::runtime("[" + place + ", " + place + "]"), x, y);
  };
  return {name,
          four_bar({at("0", "0"), at("1", "3"), at("6", "5"), at("7", "0")}, "a.wz"),
          [](const std::string& text) {
            expect_rate(text, "d.wz", rocker_ratio({0, 0}, {1, 3}, {6, 5}, {7, 0}));
          }};
}

Extreme small_crank(int power) {
  const double size = std::pow(10.0, -power);
  return {fmt::format("crank_of_1e_{}", power),
          four_bar({"[0, 0]", fmt::format("[1e-{0}, 3e-{0}]", power), "[6, 5]", "[7, 0]"}, "a.wz"),
          [size](const std::string& text) {
            expect_rate_or_both_answers(
                text, "d.wz", rocker_ratio({0, 0}, {size, 3 * size}, {6, 5}, {7, 0}));
          }};
}

// Crank and coupler in line but for 10^-power: the rocker drives the crank with -2 (2 + δ)/δ.
Extreme dead_point(int power, bool is_oblique) {
  const std::string delta = fmt::format("1e-{}", power);
  const auto place = [&](const std::string& x, const std::string& y) {
    return is_oblique ? fmt::format("[0.6*{0} - 0.8*({1}), 0.8*{0} + 0.6*({1})]", x, y)
                      : fmt::format("[{}, {}]", x, y);
  };
  const double offset = std::pow(10.0, -power);
  return {fmt::format("dead_point_{}1e_{}", is_oblique ? "oblique_" : "", power),
          four_bar({"[0, 0]", place("1", "0"), place("3", delta), place("3", "-2")}, "d.wz"),
          [offset](const std::string& text) {
            expect_rate_or_both_answers(text, "a.wz", -2.0 * (2.0 + offset) / offset);
          }};
}

// Wheels in a row, each 3.5 times as fast as the one before, the other way round.
Extreme chain(int stages, bool is_driven_at_end) {
  std::string bodies = "w0";
  std::string couplings = "  a0: {type: revolute, bodies: [frame, w0], at: [0, 0]}\n";
  for (int i = 1; i <= stages; ++i) {
    bodies += fmt::format(", w{}", i);
    couplings += fmt::format(
        "  a{0}: {{type: revolute, bodies: [frame, w{0}], at: [{1}, 0]}}\n"
        "  g{0}: {{type: gear, bodies: [w{2}, w{0}], at: [{3}, 0], line_of_action: y}}\n",
        i,
        4.5 * i,
        i - 1,
        4.5 * i - 1.0);
  }
  const std::string known = fmt::format("a{}.wz", is_driven_at_end ? stages : 0);
  const std::string asked = fmt::format("a{}.wz", is_driven_at_end ? 0 : stages);
  const double ratio = std::pow(-3.5, is_driven_at_end ? -stages : stages);
  return {fmt::format("chain_of_{}_driven_at_{}", stages, is_driven_at_end ? "end" : "start"),
          fmt::format("space: planar\nground: frame\nbodies: [{}]\ncouplings:\n{}cases:\n  one: "
                      "{{motion: {{{}: 1}}}}\n",
                      bodies,
                      couplings,
                      known),
          [=](const std::string& text) { expect_rate(text, asked, ratio); }};
}

// Three cranks on one coupler; they stay parallel, whatever their length: M_N has 6 columns and
// one motion.
Extreme parallel_cranks(const std::string& name,
                        const std::vector<std::string>& places,
                        bool is_parallel_as_typed) {
  std::string couplings;
  for (std::size_t i = 0; i < 3; ++i) {
    couplings += fmt::format(
        "  g{0}: {{type: revolute, bodies: [frame, crank{0}], at: {1}}}\n"
        "  t{0}: {{type: revolute, bodies: [crank{0}, bar], at: {2}}}\n",
        i,
        places[2 * i],
        places[2 * i + 1]);
  }
  return {name,
          "space: planar\nground: frame\nbodies: [crank0, crank1, crank2, bar]\ncouplings:\n" +
              couplings,
          [is_parallel_as_typed](const std::string& text) {
            const auto analysis = analyse(text, Accuracy::automatic);
            ASSERT_TRUE(analysis.has_value());
            expect_exact_input_rank(
                analysis->certainty.motion_rank, is_parallel_as_typed ? 5 : 6, 5);
          }};
}

// Bennett's linkage is one of a regulus of lines: four of them span three dimensions. One of them
// beside its place by what rounding to so many decimals leaves makes it four; 0 rounds nothing.
Extreme bennett(int decimals) {
  const double root = std::sqrt(2.0);
  const auto exact_input = [&](int factor) {
    return decimals == 0 ? fmt::format("{}*sqrt(2)", factor)
                         : fmt::format("{:.{}f}", factor * root, decimals);
  };
  return {fmt::format("bennett_with_{}_decimals", decimals),
          fmt::format(
              "space: spatial\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
              "  a: {{type: revolute, bodies: [frame, crank], at: [2*sqrt(2), 0, sqrt(2)], axis: "
              "[-3, 1, 3]}}\n"
              "  b: {{type: revolute, bodies: [crank, coupler], at: [{}, {}, -sqrt(2)], axis: [0, "
              "2, 3]}}\n"
              "  c: {{type: revolute, bodies: [coupler, rocker], at: [-2*sqrt(2), 0, sqrt(2)], "
              "axis: [3, -1, 3]}}\n"
              "  d: {{type: revolute, bodies: [frame, rocker], at: [-sqrt(2), -3*sqrt(2), "
              "-sqrt(2)], axis: [0, -2, 3]}}\n",
              exact_input(1),
              exact_input(3)),
          [decimals](const std::string& text) {
            const auto analysis = analyse(text, Accuracy::automatic);
            ASSERT_TRUE(analysis.has_value());
            expect_exact_input_rank(analysis->certainty.motion_rank, decimals == 0 ? 3 : 4, 3);
          }};
}

// Three parallel axes and one that leans by 10^-power: its turning leaves the plane.
Extreme leaning_axis(int power) {
  return {
      fmt::format("axis_that_leans_by_1e_{}", power),
      fmt::format("space: spatial\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
                  "  a: {{type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}}\n"
                  "  b: {{type: revolute, bodies: [crank, coupler], at: [1, 3, 0], axis: z}}\n"
                  "  c: {{type: revolute, bodies: [coupler, rocker], at: [6, 5, 0], axis: z}}\n"
                  "  d: {{type: revolute, bodies: [frame, rocker], at: [7, 0, 0], axis: [1e-{}, 0, "
                  "1]}}\n",
                  power),
      [](const std::string& text) {
        const auto analysis = analyse(text, Accuracy::automatic);
        ASSERT_TRUE(analysis.has_value());
        expect_exact_input_rank(analysis->certainty.motion_rank, 4, 3);
      }};
}

// A closed chain of revolutes on a parabola: rank 3 in the plane.
Extreme serial_loop(int joints) {
  std::string bodies;
  std::string couplings;
  for (int i = 0; i < joints; ++i) {
    const auto body = [&](int k) {
      return k == 0 || k == joints ? std::string("frame") : fmt::format("b{}", k);
    };
    bodies += i == 0 ? "" : fmt::format("{}b{}", i == 1 ? "" : ", ", i);
    couplings += fmt::format("  j{}: {{type: revolute, bodies: [{}, {}], at: [{}, {}]}}\n",
                             i,
                             body(i),
                             body(i + 1),
                             i,
                             1.0 * i * i / joints);
  }
  return {
      fmt::format("serial_loop_of_{}", joints),
      fmt::format("space: planar\nground: frame\nbodies: [{}]\ncouplings:\n{}", bodies, couplings),
      [](const std::string& text) {
        const auto analysis = analyse(text, Accuracy::automatic);
        ASSERT_TRUE(analysis.has_value());
        expect_rank(analysis->certainty.motion_rank, 3);
      }};
}

std::vector<Extreme> extremes() {
  std::vector<Extreme> list;
  for (int count = 1; count <= 12; ++count) {
    list.push_back(planets(count, 1.0));
  }
  for (const int power : {-9, -6, 9}) {
    list.push_back(planets(3, std::pow(10.0, power)));
    list.push_back(planets(5, std::pow(10.0, power)));
  }
  for (const int power : {-9, -6, -3, 0, 3, 6, 9}) {
    list.push_back(
        scaled_four_bar(fmt::format("unit_{}", power + 100), fmt::format("{{}}e{} m", power)));
  }
  for (const char* shift : {"1e3", "1e6", "1e9"}) {
    list.push_back(
        scaled_four_bar(fmt::format("origin_{}_away", shift), fmt::format("{{}} + {}", shift)));
    list.push_back(scaled_four_bar(fmt::format("small_origin_{}_away", shift),
                                   fmt::format("{{}}e-3 + {}", shift)));
  }
  for (const int power : {3, 6, 9, 12}) {
    list.push_back(small_crank(power));
  }
  for (int power = 2; power <= 16; power += 2) {
    list.push_back(dead_point(power, false));
    list.push_back(dead_point(power, true));
  }
  for (const int stages : {10, 40, 80}) {
    list.push_back(chain(stages, false));
    list.push_back(chain(stages, true));
  }
  list.push_back(
      parallel_cranks("parallel_cranks_in_decimals",
                      {"[0, 0]", "[0.1, 0.3]", "[4, 0]", "[4.1, 0.3]", "[8.2, 0.7]", "[8.3, 1]"},
                      true));
  list.push_back(parallel_cranks(
      "parallel_cranks_with_roots",
      {"[0, 0]", "[sqrt(3), 1]", "[4, 0]", "[4 + sqrt(3), 1]", "[8, 0]", "[8 + sqrt(3), 1]"},
      true));
  list.push_back(parallel_cranks(
      "parallel_cranks_with_rounded_roots",
      {"[0, 0]", "[sqrt(3), 1]", "[4, 0]", "[4 + sqrt(3), 1]", "[8, 0]", "[9.7320508075689, 1]"},
      false));
  for (const int decimals : {0, 3, 6, 9, 12, 14}) {
    list.push_back(bennett(decimals));
  }
  for (const int power : {3, 6, 9, 12, 15}) {
    list.push_back(leaning_axis(power));
  }
  for (const int joints : {10, 100, 400}) {
    list.push_back(serial_loop(joints));
  }
  return list;
}

class ExtremeMechanism : public ::testing::TestWithParam<Extreme> {};

INSTANTIATE_TEST_SUITE_P(Of,
                         ExtremeMechanism,
                         ::testing::ValuesIn(extremes()),
                         [](const auto& one) { return one.param.name; });

TEST_P(ExtremeMechanism, IsRightOrRefusedOrHasBothAnswers) {
  GetParam().check(GetParam().text);
}

// Refinement keeps 32 digits of the fastest wheel, 43 decades above the slowest.
TEST(ChainOfEightyStages, RefinedAloneSaysThatDigitsAreMissing) {
  const auto found = analyse(chain(80, false).text, Accuracy::high);
  ASSERT_TRUE(found.has_value());

  Diagnostics findings;
  add_certainty_findings(found->analysis, found->certainty, findings);

  ASSERT_EQ(findings.items().size(), 1U);
  EXPECT_EQ(findings.items()[0].code, "W0502");
}

TEST(ListOfExtremes, HasAtLeastSixty) {
  EXPECT_GE(extremes().size(), 60U);
}

}  // namespace
}  // namespace kinestat
