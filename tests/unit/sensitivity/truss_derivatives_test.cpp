// Derivatives of random trusses against the stiffness method in dual numbers.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sensitivity/solved_case.hpp"
#include "support/random.hpp"

namespace kinestat {
namespace {

// Pin-jointed bars: the first joints are free, the last three belong to the ground.
struct Truss {
  struct Bar {
    int from = 0;
    int to = 0;
    double stiffness = 1.0;  ///< E A [N]
  };

  int free_count = 0;
  std::vector<Eigen::Vector2d> joints;
  std::vector<Bar> bars;
  std::vector<Eigen::Vector2d> forces;  ///< on the free joints [N]
};

// Each free joint hangs on two of the ground, one on all three, and there are some bars more.
Truss make_truss(std::uint64_t seed) {
  Random random(seed);
  Truss truss;
  truss.free_count = random.whole(1, 4);
  // The stiffness method loses as many digits as these differ by.
  const auto stiffness = [&] { return std::pow(10.0, random.between(5.0, 7.0)); };
  for (int i = 0; i < truss.free_count + 3; ++i) {
    truss.joints.emplace_back(random.between(-1.0, 1.0) + i, random.between(-1.0, 1.0));
  }
  for (int i = 0; i < truss.free_count; ++i) {
    truss.bars.push_back({i, truss.free_count, stiffness()});
    truss.bars.push_back({i, truss.free_count + 1, stiffness()});
    truss.forces.emplace_back(random.magnitude(), random.magnitude());
  }
  truss.bars.push_back({0, truss.free_count + 2, stiffness()});
  for (int i = 0; i < truss.free_count; ++i) {
    const int from = random.whole(0, truss.free_count - 1);
    const int to = (from + random.whole(1, truss.free_count + 2)) % (truss.free_count + 3);
    truss.bars.push_back({from, to, stiffness()});
  }
  return truss;
}

// The numbers of a truss: coordinates of the joints, forces, and E A of the bars.
std::vector<double> numbers_of(const Truss& truss) {
  std::vector<double> numbers;
  for (const auto* points : {&truss.joints, &truss.forces}) {
    for (const Eigen::Vector2d& point : *points) {
      numbers.insert(numbers.end(), {point.x(), point.y()});
    }
  }
  for (const Truss::Bar& bar : truss.bars) {
    numbers.push_back(bar.stiffness);
  }
  return numbers;
}

// All numbers are parameters, n0, n1, …
std::string text_of(const Truss& truss) {
  const auto body = [&](int i) { return i < truss.free_count ? fmt::format("j{}", i) : "wall"; };
  const auto pair = [](std::size_t i) { return fmt::format("[n{}, n{}]", 2 * i, 2 * i + 1); };
  const std::vector<double> numbers = numbers_of(truss);
  std::string text = "kinestat: 1\nspace: planar\nstatics: {indeterminate: stiffness}\n";
  text += "ground: wall\nparameters:\n";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += fmt::format("  n{}: {:.17g}\n", i, numbers[i]);
  }
  text += "bodies:\n";
  for (int i = 0; i < truss.free_count; ++i) {
    text += fmt::format("  j{}:\n", i);
  }
  text += "couplings:\n";
  const std::size_t first = 2 * (truss.joints.size() + truss.forces.size());
  for (std::size_t b = 0; b < truss.bars.size(); ++b) {
    const Truss::Bar& bar = truss.bars[b];
    text += fmt::format("  b{}: {{type: cable, bodies: [{}, {}], from: {}, to: {}, ",
                        b,
                        body(bar.from),
                        body(bar.to),
                        pair(static_cast<std::size_t>(bar.from)),
                        pair(static_cast<std::size_t>(bar.to)));
    text += fmt::format("stiffness: {{F: n{0}/sqrt((n{1} - n{2})^2 + (n{3} - n{4})^2)}}}}\n",
                        first + b,
                        2 * bar.from,
                        2 * bar.to,
                        2 * bar.from + 1,
                        2 * bar.to + 1);
  }
  text += "loads:\n";
  for (std::size_t i = 0; i < truss.forces.size(); ++i) {
    text += fmt::format(
        "  p{}: {{body: j{}, at: {}, force: {}}}\n", i, i, pair(i), pair(truss.joints.size() + i));
  }
  return text + "cases: {one: {action: {}}}\n";
}

using DualMatrix = std::vector<std::vector<Dual>>;

// Without pivoting: the matrix is positive definite, its last column the right-hand side.
std::vector<Dual> solve(DualMatrix rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t r = 0; r < n; ++r) {
      const Dual factor = rows[r][k] / rows[k][k];
      for (std::size_t c = k; r != k && c <= n; ++c) {
        rows[r][c] = rows[r][c] - factor * rows[k][c];
      }
    }
  }
  std::vector<Dual> x;
  for (std::size_t k = 0; k < n; ++k) {
    x.push_back(rows[k][n] / rows[k][k]);
  }
  return x;
}

// What a bar does: its unknown displacements with their shares in its stretch, and its stiffness.
struct Stretch {
  std::vector<std::pair<std::size_t, Dual>> shares;
  Dual stiffness;
};

Stretch stretch_of(const Truss& truss, const std::vector<Dual>& numbers, std::size_t b) {
  const Truss::Bar& bar = truss.bars[b];
  const auto from = static_cast<std::size_t>(bar.from);
  const auto to = static_cast<std::size_t>(bar.to);
  std::array<Dual, 2> line = {numbers[2 * to] - numbers[2 * from],
                              numbers[2 * to + 1] - numbers[2 * from + 1]};
  const Dual length = sqrt(line[0] * line[0] + line[1] * line[1]);
  const std::size_t first = 2 * (truss.joints.size() + truss.forces.size());
  Stretch result{.shares = {}, .stiffness = numbers[first + b] / length};
  for (std::size_t i = 0; i < 2; ++i) {
    if (bar.from < truss.free_count) {
      result.shares.emplace_back(2 * from + i, -line[i] / length);
    }
    if (bar.to < truss.free_count) {
      result.shares.emplace_back(2 * to + i, line[i] / length);
    }
  }
  return result;
}

// The displacements of the joints from K u = P, the tension of each bar from how much it is
// stretched.
std::vector<Dual> tensions_of(const Truss& truss) {
  const std::vector<double> plain = numbers_of(truss);
  std::vector<Dual> numbers;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    numbers.push_back(make_variable(plain[i], i, plain.size()));
  }
  const std::size_t n = 2 * static_cast<std::size_t>(truss.free_count);
  DualMatrix rows(n, std::vector<Dual>(n + 1));
  for (std::size_t b = 0; b < truss.bars.size(); ++b) {
    const Stretch bar = stretch_of(truss, numbers, b);
    for (const auto& [r, by_r] : bar.shares) {
      for (const auto& [c, by_c] : bar.shares) {
        rows[r][c] = rows[r][c] + bar.stiffness * by_r * by_c;
      }
    }
  }
  for (std::size_t r = 0; r < n; ++r) {
    rows[r][n] = numbers[2 * truss.joints.size() + r];
  }
  const std::vector<Dual> u = solve(std::move(rows));
  std::vector<Dual> tensions(truss.bars.size());
  for (std::size_t b = 0; b < tensions.size(); ++b) {
    const Stretch bar = stretch_of(truss, numbers, b);
    for (const auto& [r, share] : bar.shares) {
      tensions[b] = tensions[b] + bar.stiffness * share * u[r];
    }
  }
  return tensions;
}

class TrussDerivatives : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Seed, TrussDerivatives, ::testing::Range(0, 30));

TEST_P(TrussDerivatives, AreThoseOfTheStiffnessMethod) {
  const Truss truss = make_truss(static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(text_of(truss));
  const Solved solved(text_of(truss));
  const std::vector<double> numbers = numbers_of(truss);
  const std::vector<Dual> expected = tensions_of(truss);

  ASSERT_FALSE(solved.action.completion.actions.empty());
  double force = 0.0;
  for (const Dual& tension : expected) {
    force = std::max(force, std::abs(tension.value));
  }
  for (std::size_t b = 0; b < expected.size(); ++b) {
    const auto slopes = solved.derivatives_of(fmt::format("b{}.F", b));
    for (std::size_t p = 0; p < numbers.size(); ++p) {
      ASSERT_TRUE(slopes[p].has_value()) << "b" << b << " by n" << p;
      const double size = force / std::abs(numbers[p]) + std::abs(derivative(expected[b], p));
      EXPECT_NEAR(*slopes[p], derivative(expected[b], p), 1e-9 * size) << "b" << b << " by n" << p;
    }
  }
}

}  // namespace
}  // namespace kinestat
