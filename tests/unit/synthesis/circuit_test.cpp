// The circuit in which a linkage is assembled, against linkages that are assembled here pose by
// pose over all that a circuit holds.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "studies/synthesis/synthesis.hpp"
#include "support/angles.hpp"
#include "support/random.hpp"

namespace kinestat {
namespace {

using enum LinkageCircuit;

constexpr int kPoses = 180;

double turn(const Point& a, const Point& b) {
  return (std::conj(a) * b).imag();
}

// Of the line from one point to another.
bool is_left(const Point& point, const Point& from, const Point& to) {
  return turn(to - from, point - from) > 0.0;
}

bool do_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return is_left(a, c, d) != is_left(b, c, d) && is_left(c, a, b) != is_left(d, a, b);
}

// The point at such distances from two others, to the left of the line from one to the other.
std::optional<Point> third_point(
    const Point& from, double distance, const Point& to, double other_distance, bool left_of_line) {
  const double base = std::abs(to - from);
  const double along =
      (base * base + distance * distance - other_distance * other_distance) / (2.0 * base);
  const double square = distance * distance - along * along;
  if (square < 0.0) {
    return std::nullopt;
  }
  return from + (to - from) / base * Point(along, (left_of_line ? 1.0 : -1.0) * std::sqrt(square));
}

// Pivots of a four-bar: the input's fixed one, its moving one, that of the output, its fixed one.
using Pivots = std::array<Point, 4>;

struct FourBar {
  double ground = 0.0;
  double input = 0.0;
  double coupler = 0.0;
  double output = 0.0;

  double excess() const {
    const auto [least, most] = std::minmax({ground, input, coupler, output});
    return 2.0 * (least + most) - (ground + input + coupler + output);
  }

  bool is_shortest(double link) const { return link == std::min({ground, input, coupler, output}); }
};

// Clearly Grashof, or clearly not.
FourBar random_four_bar(Random& random, bool is_grashof) {
  FourBar one;
  do {
    one = {.ground = random.between(0.3, 3.0),
           .input = random.between(0.3, 3.0),
           .coupler = random.between(0.3, 3.0),
           .output = random.between(0.3, 3.0)};
    const double all = one.ground + one.input + one.coupler + one.output;
    if (2.0 * std::max({one.ground, one.input, one.coupler, one.output}) > all - 0.1) {
      one = {};
    }
  } while (one.input == 0.0 || (is_grashof ? one.excess() > -0.1 : one.excess() < 0.1));
  return one;
}

// With the input at an angle from the line of centres.
std::optional<Pivots> pose_of_input(const FourBar& links, double angle, bool left_of_line) {
  const Point pin = std::polar(links.input, angle);
  const auto far = third_point(pin, links.coupler, links.ground, links.output, left_of_line);
  return far ? std::optional(Pivots{0.0, pin, *far, links.ground}) : std::nullopt;
}

// With the coupler at an angle from the input, as the coupler turns fully by it.
Pivots pose_of_coupler(const FourBar& links, double angle, bool left_of_line) {
  const Point far = links.input + std::polar(links.coupler, angle);
  const Point output = *third_point(0.0, links.ground, far, links.output, left_of_line);
  const Point turned = std::conj(output) / std::abs(output);
  return {0.0, links.input * turned, far * turned, links.ground};
}

PositionJets position_of(const Pivots& pivots) {
  return finite_position(pivots[1], std::arg(pivots[2] - pivots[1]));
}

// The moving frame at the input's pivot, along the coupler.
std::vector<Dyad> dyads_of(const FourBar& links) {
  return {{.circle_point = {0.0, 0.0}, .centre_point = {0.0, 0.0}, .length = links.input},
          {.circle_point = {links.coupler, 0.0},
           .centre_point = {links.ground, 0.0},
           .length = links.output}};
}

LinkageCandidate linkage_through(const std::vector<Dyad>& dyads,
                                 const PositionJets& one,
                                 const PositionJets& other) {
  return rank_linkages(dyads, std::vector{one, other}, {}).front();
}

LinkageCircuit mirror_of(LinkageCircuit which) {
  switch (which) {
    case open:
      return crossed;
    case crossed:
      return open;
    case left:
      return right;
    case right:
      return left;
    case single:
      break;
  }
  return single;
}

// Any two poses of the circuit, seen from the drive that was chosen; of a crank-rocker from the
// crank, which is the input here.
void expect_everywhere(const FourBar& links,
                       const std::vector<Pivots>& circuit,
                       LinkageCircuit expected,
                       Random& random) {
  const auto any = [&] { return position_of(random.one_of(circuit)); };
  for (int i = 0; i < 4; ++i) {
    const LinkageCandidate found = linkage_through(dyads_of(links), any(), any());
    const bool is_seen_from_output =
        found.best_drive == Drive::other && !links.is_shortest(links.input);
    EXPECT_TRUE(found.best().same_circuit);
    EXPECT_EQ(found.circuit, is_seen_from_output ? mirror_of(expected) : expected);
  }
}

// Norton, Design of Machinery: the two links next to the shortest one cross, or do not, with the
// input in the first quadrant; here where that begins. Over the turn they do both in both circuits.
TEST(Circuit, IsOpenOrCrossedByTheLinksNextToTheShortestJustBehindTheLineOfCentres) {
  Random random(25);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    FourBar links = random_four_bar(random, true);
    auto* shortest = std::min({&links.ground, &links.input, &links.coupler, &links.output},
                              [](const double* a, const double* b) { return *a < *b; });
    std::swap(*shortest, i % 2 == 0 ? links.ground : links.input);
    for (const bool side : {true, false}) {
      const auto crosses = [&](const Pivots& p) {
        return i % 2 == 0 ? do_cross(p[0], p[1], p[2], p[3]) : do_cross(p[1], p[2], p[3], p[0]);
      };
      std::vector<Pivots> circuit;
      for (int k = 0; k < kPoses; ++k) {
        circuit.push_back(*pose_of_input(links, 1e-4 + k * 2.0 * kPi / kPoses, side));
      }
      const LinkageCircuit expected = crosses(circuit.front()) ? crossed : open;

      EXPECT_NE(std::ranges::count_if(circuit, crosses), 0);
      EXPECT_NE(std::ranges::count_if(circuit, crosses), kPoses);
      for (const Pivots& p : circuit) {
        EXPECT_EQ(is_left(p[2], p[1], p[3]), expected == open);
      }
      expect_everywhere(links, circuit, expected, random);
    }
  }
}

TEST(Circuit, OfADoubleRockerIsLeftOrRightOfTheLineOfCentres) {
  Random random(25);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    FourBar links = random_four_bar(random, true);
    auto* shortest = std::min({&links.ground, &links.input, &links.coupler, &links.output},
                              [](const double* a, const double* b) { return *a < *b; });
    std::swap(*shortest, links.coupler);
    for (const bool side : {true, false}) {
      std::vector<Pivots> circuit;
      for (int k = 0; k < kPoses; ++k) {
        circuit.push_back(pose_of_coupler(links, k * 2.0 * kPi / kPoses, side));
      }
      const bool is_on_left = circuit.front()[1].imag() > 0.0;

      for (const Pivots& p : circuit) {
        EXPECT_EQ(p[1].imag() > 0.0, is_on_left);
        EXPECT_EQ(p[2].imag() > 0.0, is_on_left);
      }
      expect_everywhere(links, circuit, is_on_left ? left : right, random);
    }
  }
}

TEST(Circuit, IsSingleWithoutALinkThatTurnsFully) {
  Random random(25);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const FourBar links = random_four_bar(random, false);
    std::vector<Pivots> all;
    for (int k = 0; k < kPoses; ++k) {
      if (const auto pose = pose_of_input(links, 0.01 + k * 2.0 * kPi / kPoses, k % 2 == 0)) {
        all.push_back(*pose);
      }
    }
    expect_everywhere(links, all, single, random);
  }
}

TEST(Circuit, IsNoneOfPositionsInBoth) {
  const FourBar links{.ground = 4.0, .input = 1.0, .coupler = 3.5, .output = 2.5};
  const LinkageCandidate found = linkage_through(dyads_of(links),
                                                 position_of(*pose_of_input(links, 0.7, true)),
                                                 position_of(*pose_of_input(links, 0.7, false)));

  EXPECT_EQ(found.defect(), Defect::circuit);
  EXPECT_EQ(found.circuit, std::nullopt);
}

// The moving frame at the crank pin, along the rod, the slide along x. Where crank or rod turns
// fully the slider stays on one side of the crank's pivot.
TEST(Circuit, OfASliderCrankIsWhereTheSliderIs) {
  Random random(25);
  std::array<int, 3> counts{};
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const double crank = random.between(0.3, 3.0);
    const double rod = random.between(0.3, 3.0);
    const double offset = random.between(-1.0, 1.0);
    const double reach = std::abs(crank - rod) - std::abs(offset);
    if (std::abs(reach) < 0.05 || crank + rod < std::abs(offset) + 0.1) {
      continue;
    }
    std::array<std::vector<PositionJets>, 2> all;
    for (int k = 0; k < 2 * kPoses; ++k) {
      const Point pin = std::polar(crank, k / 2 * 2.0 * kPi / kPoses);
      const double rise = offset - pin.imag();
      if (std::abs(rise) < rod) {
        const double run = (k % 2 == 0 ? 1.0 : -1.0) * std::sqrt(rod * rod - rise * rise);
        const bool is_ahead = reach < 0.0 || pin.real() + run > 0.0;
        all[is_ahead ? 0 : 1].push_back(finite_position(pin, std::atan2(rise, run)));
      }
    }
    for (std::size_t c = 0; c < (reach < 0.0 ? 1U : 2U); ++c) {
      const Point first = origin(all[c].front()) + std::polar(rod, all[c].front().angle[0]);
      const std::vector<Dyad> dyads = {
          {.length = crank},
          {.kind = DyadKind::slider, .circle_point = {rod, 0.0}, .centre_point = first}};
      for (std::size_t k = 0; k < all[c].size(); k += 7) {
        const LinkageCandidate found = linkage_through(dyads, all[c].front(), all[c][k]);
        EXPECT_TRUE(found.best().same_circuit);
        EXPECT_EQ(found.circuit, reach < 0.0 ? single : (c == 0 ? open : crossed));
      }
    }
    ++counts[reach < 0.0 ? 0 : (crank < rod ? 1 : 2)];
  }
  EXPECT_GT(std::ranges::min(counts), 20);
}

// The line of the plane runs along x of the moving frame, at a distance from the crank pin; its
// fixed point lies on x. Where the line always passes the pin's circle by more than that distance
// the fixed point stays ahead of the pin, or behind it.
TEST(Circuit, OfAnInvertedSliderCrankIsWhereItsFixedPointIs) {
  Random random(25);
  std::array<int, 2> counts{};
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const double crank = random.between(0.3, 3.0);
    const double ground = random.between(0.3, 3.0);
    const double away = random.between(-1.0, 1.0);
    const double reach = std::abs(ground - crank) - std::abs(away);
    if (std::abs(reach) < 0.05) {
      continue;
    }
    const std::vector<Dyad> dyads = {{.length = crank},
                                     {.kind = DyadKind::inverted_slider,
                                      .circle_point = {0.0, away},
                                      .centre_point = {ground, 0.0}}};
    std::array<std::vector<PositionJets>, 2> all;
    for (int k = 0; k < 2 * kPoses; ++k) {
      const Point pin = std::polar(crank, 0.01 + k / 2 * 2.0 * kPi / kPoses);
      const double square = std::norm(ground - pin) - away * away;
      if (square > 0.0) {
        const double along = (k % 2 == 0 ? 1.0 : -1.0) * std::sqrt(square);
        const double angle = std::arg(ground - pin) - std::atan2(away, along);
        all[reach < 0.0 || along > 0.0 ? 0 : 1].push_back(finite_position(pin, angle));
      }
    }
    for (std::size_t c = 0; c < (reach < 0.0 ? 1U : 2U); ++c) {
      for (std::size_t k = 0; k < all[c].size(); k += 7) {
        const LinkageCandidate found = linkage_through(dyads, all[c].front(), all[c][k]);
        EXPECT_TRUE(found.best().same_circuit);
        EXPECT_EQ(found.circuit, reach < 0.0 ? single : (c == 0 ? open : crossed));
      }
    }
    ++counts[reach < 0.0 ? 0 : 1];
  }
  EXPECT_GT(std::ranges::min(counts), 20);
}

// What is asked for in vain is a reason, and the reason alone.
TEST(Circuit, ThatIsNotAskedForSpeaksAgainstALinkage) {
  const FourBar links{.ground = 4.0, .input = 1.0, .coupler = 3.5, .output = 2.5};
  const std::vector positions = {position_of(*pose_of_input(links, 0.7, true)),
                                 position_of(*pose_of_input(links, 1.2, true))};
  const auto found = [&](std::vector<LinkageCircuit> circuits) {
    return rank_linkages(dyads_of(links), positions, {.circuits = std::move(circuits)}).front();
  };

  EXPECT_TRUE(found({open}).is_usable());
  EXPECT_TRUE(found({single, open}).is_usable());
  EXPECT_EQ(found({crossed, single}).defect(), Defect::other_circuit);
  EXPECT_EQ(found({crossed, single}).defects.count(), 1U);
}

}  // namespace
}  // namespace kinestat
