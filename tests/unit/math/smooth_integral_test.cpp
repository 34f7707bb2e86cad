#include "math/dense/smooth_integral.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

template <class Function>
double integral_of(const std::vector<double>& nodes, const Function& function) {
  std::vector<double> values;
  std::vector<double> lines;
  for (const double node : nodes) {
    values.push_back(function(node));
  }
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    lines.push_back(0.5 * (nodes[i + 1] - nodes[i]) * (values[i] + values[i + 1]));
  }
  SmoothIntegral integral;
  integral.place(nodes);
  integral.look(values);
  return integral.of(values, lines);
}

// Of x^k from 0 to 2 it is 2^(k + 1) / (k + 1).
TEST(SmoothIntegral, IsThatOfPolynomialsUpToTheFifthDegree) {
  const std::vector<double> nodes = {0.0, 0.1, 0.3, 0.45, 0.7, 1.0, 1.2, 1.5, 1.6, 1.9, 2.0};
  for (int k = 0; k <= 5; ++k) {
    EXPECT_NEAR(integral_of(nodes, [&](double x) { return 1.0 + std::pow(x, k); }),
                2.0 + std::pow(2.0, k + 1) / (k + 1),
                k > 3 ? 1e-3 : 1e-13)
        << k;
  }
}

TEST(SmoothIntegral, OfASineIsFarNearerThanStraightLines) {
  std::vector<double> nodes;
  for (int i = 0; i <= 12; ++i) {
    nodes.push_back(i * std::numbers::pi / 12.0);
  }
  EXPECT_NEAR(integral_of(nodes, [](double x) { return std::sin(x); }), 2.0, 1e-5);
}

// Straight lines meet at 5: they are exact, and polynomials through both would not be.
TEST(SmoothIntegral, FollowsStraightLinesBesideACornerAtANode) {
  std::vector<double> nodes;
  for (int i = 0; i <= 12; ++i) {
    nodes.push_back(i);
  }
  EXPECT_NEAR(integral_of(nodes, [](double x) { return std::max(x - 5.0, 0.0); }), 24.5, 1e-12);
}

TEST(SmoothIntegral, OfTwoNodesIsThatOfALine) {
  EXPECT_DOUBLE_EQ(integral_of({1.0, 3.0}, [](double x) { return x; }), 4.0);
}

// Of a whole turn in equal steps equal weights are exact up to the harmonic of their number; of a
// kinked function they are not taken.
TEST(SmoothIntegral, OfWhatReturnsHasEqualWeights) {
  std::vector<double> nodes;
  for (int i = 0; i <= 12; ++i) {
    nodes.push_back(i);
  }
  const auto angle = [](double step) { return step * std::numbers::pi / 6.0; };
  EXPECT_NEAR(integral_of(nodes,
                          [&](double x) {
                            return 2.0 + std::cos(angle(x)) + 0.3 * std::sin(5.0 * angle(x));
                          }),
              24.0,
              1e-13);
  EXPECT_NEAR(integral_of(nodes, [&](double x) { return (x - 6.0) * (x - 6.0); }), 144.0, 1e-12);
}

}  // namespace
}  // namespace kinestat
