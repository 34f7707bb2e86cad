#include "studies/sensitivity/affine.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/rounding.hpp"
#include "core/tolerance.hpp"

namespace kinestat {
namespace {

using Function = std::function<double(const std::vector<double>&)>;

// Fits functions of the parameters, each of size 1 or more.
std::vector<std::optional<AffineValue>> fit(const std::vector<FreeParameter>& parameters,
                                            const std::vector<Function>& functions) {
  std::vector<Magnitudes> at_probes;
  for (const std::vector<double>& probe : affine_probes(parameters)) {
    std::vector<BoundedNumber> values;
    for (const Function& function : functions) {
      const double value = function(probe);
      values.push_back({.value = value, .bound = kDataRounding * std::abs(value)});
    }
    at_probes.emplace_back(std::move(values));
  }
  const std::vector<double> scale(functions.size(), 1.0);
  return fit_affine(parameters, affine_probes(parameters), at_probes, scale);
}

const std::vector<FreeParameter> kTwo = {{.value = 3.0, .step = 1.0}, {.value = -2.0, .step = 4.0}};

TEST(Affine, ProbesEachParameterAloneAndThenAllTogether) {
  const auto probes = affine_probes(kTwo);

  ASSERT_EQ(probes.size(), 6U);
  EXPECT_EQ(probes[0], (std::vector<double>{3.0, -2.0}));
  EXPECT_EQ(probes[1], (std::vector<double>{4.0, -2.0}));
  EXPECT_EQ(probes[2], (std::vector<double>{3.0, 2.0}));
  for (std::size_t p = 3; p < 6; ++p) {
    EXPECT_NE(probes[p][0], 3.0);
    EXPECT_NE(probes[p][1], -2.0);
  }
}

TEST(Affine, FindsConstantAndCoefficients) {
  const auto fits = fit(kTwo, {[](const auto& p) { return 7.0 + 2.0 * p[0] - 0.5 * p[1]; }});

  ASSERT_TRUE(fits[0]);
  EXPECT_NEAR(fits[0]->constant, 7.0, 1e-13);
  EXPECT_NEAR(fits[0]->coefficients[0], 2.0, 1e-13);
  EXPECT_NEAR(fits[0]->coefficients[1], -0.5, 1e-13);
}

TEST(Affine, WritesRoundingAsZero) {
  const auto fits = fit(kTwo, {[](const auto& p) { return p[0] + kEpsilon * p[1]; }});

  ASSERT_TRUE(fits[0]);
  EXPECT_EQ(fits[0]->coefficients[1], 0.0);
  EXPECT_EQ(fits[0]->constant, 0.0);
}

// 3.3 + 0.1 is no double: what the parameter itself rounds is neither slope nor constant.
TEST(Affine, WritesRoundingOfTheParameterAsZero) {
  const std::vector<FreeParameter> one = {{.value = 3.3, .step = 0.1}};
  std::vector<Magnitudes> at_probes;
  for (const std::vector<double>& probe : affine_probes(one)) {
    at_probes.push_back(std::vector<BoundedNumber>{{.value = probe[0]}});
  }

  const auto fits = fit_affine(one, affine_probes(one), at_probes, std::vector<double>{1.0});

  ASSERT_TRUE(fits[0]);
  EXPECT_NEAR(fits[0]->coefficients[0], 1.0, 1e-13);
  EXPECT_EQ(fits[0]->constant, 0.0);
}

// The second magnitude is known to the millionth of a millionth only.
TEST(Affine, TellsASmallSlopeFromWhatAMagnitudeMayBeOffBy) {
  std::vector<Magnitudes> at_probes;
  for (const std::vector<double>& probe : affine_probes(kTwo)) {
    const double value = 1e-13 * probe[0];
    at_probes.push_back(std::vector<BoundedNumber>{{.value = value, .bound = 1e-28},
                                                   {.value = value, .bound = 1e-12}});
  }

  const auto fits =
      fit_affine(kTwo, affine_probes(kTwo), at_probes, std::vector<double>{100.0, 100.0});

  ASSERT_TRUE(fits[0] && fits[1]);
  EXPECT_NEAR(fits[0]->coefficients[0], 1e-13, 1e-27);
  EXPECT_EQ(fits[1]->coefficients[0], 0.0);
  EXPECT_EQ(fits[1]->constant, 0.0);
}

TEST(Affine, RefusesWhatIsNotAffine) {
  const auto fits = fit(kTwo,
                        {[](const auto& p) { return p[0] * p[0]; },
                         [](const auto& p) { return p[0] * p[1]; },
                         [](const auto& p) { return std::abs(p[1] - 1.0); },
                         [](const auto& p) { return 1.0 / (p[0] + 10.0); },
                         [](const auto&) { return std::numeric_limits<double>::quiet_NaN(); }});

  for (std::size_t m = 0; m < fits.size(); ++m) {
    EXPECT_FALSE(fits[m]) << m;
  }
}

// From round values in round steps, as files have them.
TEST(Affine, RefusesStaircasesAndWavesOfAnyRoundPeriod) {
  const std::vector<FreeParameter> parameters = {{.value = 10.5, .step = 1000.0},
                                                 {.value = 10.0, .step = 10.0}};
  for (const double period : {1.0, 10.0, 0.5, 0.25, 0.01, 1e-3, 1e-5}) {
    const auto fits =
        fit(parameters,
            {[&](const auto& p) { return period * std::floor(p[0] / period); },
             [&](const auto& p) { return period * std::round(p[1] / period); },
             [&](const auto& p) {
               return p[0] + 3.0 * std::sin(2.0 * std::numbers::pi * p[1] / period);
             },
             [&](const auto& p) { return std::floor(p[0] / period) - std::floor(p[1] / period); }});
    for (std::size_t m = 0; m < fits.size(); ++m) {
      EXPECT_FALSE(fits[m]) << m << " with period " << period;
    }
  }
}

TEST(Affine, KnowsNothingWhereAProbeHasNoSolution) {
  std::vector<Magnitudes> at_probes(affine_probes(kTwo).size(),
                                    std::vector{BoundedNumber{.value = 1.0}});
  at_probes[2].reset();

  EXPECT_FALSE(fit_affine(kTwo, affine_probes(kTwo), at_probes, std::vector<double>{1.0})[0]);
}

}  // namespace
}  // namespace kinestat
