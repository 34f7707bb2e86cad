#include "studies/transmissions/corner_ranges.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "studies/transmissions/gear_figures.hpp"
#include "support/random.hpp"

namespace kinestat {
namespace {

struct SetsAndEngaged {
  int sets;
  int engaged;
};

class CornerRanges : public ::testing::TestWithParam<SetsAndEngaged> {
 protected:
  Random random_{static_cast<std::uint64_t>(10 * GetParam().sets + GetParam().engaged)};
  std::vector<TransmissionStructure> structures_ =
      enumerate_structures(GetParam().sets, GetParam().engaged, 0);

  const TransmissionStructure& random_structure() {
    return structures_[static_cast<std::size_t>(
        random_.whole(0, static_cast<int>(structures_.size()) - 1))];
  }

  RoleChoice random_roles() {
    const int sets = GetParam().sets;
    return {.roles = static_cast<std::uint32_t>(
                random_.whole(0, static_cast<int>(std::pow(6, sets)) - 1)),
            .double_planet = static_cast<std::uint32_t>(random_.whole(0, (1 << sets) - 1))};
  }

  StationaryBox random_box() {
    StationaryBox box;
    for (std::size_t s = 0; s < static_cast<std::size_t>(GetParam().sets); ++s) {
      box.from[s] = random_.between(1.2, 3.0);
      box.to[s] = box.from[s] * random_.between(1.01, 1.6);
    }
    return box;
  }

  StationaryPoint random_point(const StationaryBox& box) {
    StationaryPoint point{};
    for (std::size_t s = 0; s < point.size(); ++s) {
      point[s] = random_.between(box.from[s], box.to[s]);
    }
    return point;
  }
};

std::vector<std::uint32_t> gears_of(const GenericTrain& train) {
  std::vector<std::uint32_t> gears;
  for (std::uint32_t i = 0; i < train.states().size(); ++i) {
    if (train.states()[i].is_gear) {
      gears.push_back(i);
    }
  }
  return gears;
}

TEST_P(CornerRanges, HoldEveryPointInside) {
  int closed = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const GenericTrain train(random_structure(), GetParam().engaged);
    const auto gears = gears_of(train);
    const RoleChoice roles = random_roles();
    const StationaryBox box = random_box();
    RatioTable table(train);
    table.set_corners(roles, box);
    std::vector<ClosedRange> ranges(gears.size());
    table.ranges(gears, ranges);
    std::array<StationaryPoint, kRatioLanes> points;
    std::ranges::generate(points, [&] { return random_point(box); });
    table.set_points(roles, points);
    std::vector<RatioLanes> ratios(gears.size());
    table.ratios(gears, ratios);
    for (std::size_t i = 0; i < gears.size(); ++i) {
      closed += std::isfinite(ranges[i].to) ? 1 : 0;
      for (const double ratio : ratios[i].at) {
        const double slack = 1e-11 * std::abs(ratio);
        ASSERT_GE(ratio, ranges[i].from - slack);
        ASSERT_LE(ratio, ranges[i].to + slack);
      }
    }
  }
  EXPECT_GT(closed, 0);
}

// The sums of minors against the whole train, solved by elimination.
TEST_P(CornerRanges, HaveTheRatiosOfTheWholeTrain) {
  for (int trial = 0; trial < 10; ++trial) {
    const GenericTrain train(random_structure(), GetParam().engaged);
    const auto gears = gears_of(train);
    const RoleChoice roles = random_roles();
    std::array<StationaryPoint, kRatioLanes> points;
    points.fill(random_point(random_box()));
    RatioTable table(train);
    table.set_points(roles, points);
    std::vector<RatioLanes> ratios(gears.size());
    table.ratios(gears, ratios);
    for (int draw = 0; draw < 20; ++draw) {
      ClassMask engaged = 0;
      while (std::popcount(engaged) < GetParam().engaged) {
        engaged |= ClassMask{1} << random_.whole(0, static_cast<int>(train.classes().size()) - 1);
      }
      const auto gear = std::ranges::find(gears, train.state_of(engaged));
      if (gear == gears.end()) {
        continue;
      }
      const int shafts = train.structure().shafts;
      MatX equations = MatX::Zero(shafts + 1, shafts);
      Eigen::Index row = 0;
      for (int s = 0; s < GetParam().sets; ++s, ++row) {
        const auto at = static_cast<std::size_t>(s);
        const auto equation = set_equation(roles, s, points[0][at]);
        for (std::size_t t = 0; t < 3; ++t) {
          equations(row, train.structure().sets[at][t]) = equation[t];
        }
      }
      for (std::size_t k = 0; k < train.classes().size(); ++k) {
        if ((engaged >> k & 1U) != 0) {
          equations(row, train.classes()[k].front()[0]) = 1.0;
          equations(row++, train.classes()[k].front()[1]) = -1.0;
        }
      }
      equations(row++, kHousing) = 1.0;
      equations(row++, kInput) = 1.0;
      VecX right = VecX::Zero(shafts + 1);
      right[row - 1] = 1.0;
      const VecX speeds = equations.topRows(row).fullPivLu().solve(right.head(row));
      EXPECT_NEAR(ratios[static_cast<std::size_t>(gear - gears.begin())].at[0] * speeds[kOutput],
                  1.0,
                  1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Random,
                         CornerRanges,
                         ::testing::Values(SetsAndEngaged{1, 1},
                                           SetsAndEngaged{2, 1},
                                           SetsAndEngaged{2, 2},
                                           SetsAndEngaged{3, 2},
                                           SetsAndEngaged{3, 3},
                                           SetsAndEngaged{4, 3}),
                         [](const auto& test) {
                           return fmt::format(
                               "OfSets{}Engaged{}", test.param.sets, test.param.engaged);
                         });

}  // namespace
}  // namespace kinestat
