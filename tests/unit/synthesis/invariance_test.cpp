// The dyads move with the positions, whatever their order, place, size and handedness.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "known_linkage.hpp"
#include "near_dyad.hpp"
#include "studies/synthesis/dyads/burmester.hpp"

namespace kinestat {
namespace {

using Positions = std::vector<PositionJets>;

std::vector<Positions> tasks() {
  const std::vector<std::vector<int>> forms = {
      {5}, {4, 1}, {3, 2}, {3, 1, 1}, {2, 2, 1}, {2, 1, 1, 1}, {1, 1, 1, 1, 1}};
  Random random(99);
  std::vector<Positions> result;
  for (int i = 0; result.size() < 70; ++i) {
    const KnownLinkage linkage = random_linkage(random, DyadKind::crank, DyadKind::crank);
    const Positions positions =
        random_positions(random, linkage, forms[static_cast<std::size_t>(i) % forms.size()]);
    if (!positions.empty()) {
      result.push_back(positions);
    }
  }
  return result;
}

// A change of the fixed frame: what it makes of jets, of circle points and of centres.
struct Change {
  std::function<PositionJets(const PositionJets&)> of_positions;
  std::function<Point(const Point&)> of_circle_points;
  std::function<Point(const Point&)> of_centres;
  double size = 1.0;  ///< of the coordinates afterwards
};

Point identity(const Point& z) {
  return z;
}

void set_origin(PositionJets& jets, std::size_t k, const Point& value) {
  jets.x[k] = value.real();
  jets.y[k] = value.imag();
}

void expect_same(const Change& change) {
  for (const Positions& task : tasks()) {
    Positions changed;
    for (const PositionJets& jets : task) {
      changed.push_back(change.of_positions(jets));
    }
    const BurmesterSolution before = solve_burmester(task);

    const BurmesterSolution after = solve_burmester(changed);

    EXPECT_EQ(after.imaginary_count, before.imaginary_count);
    ASSERT_EQ(after.dyads.size(), before.dyads.size());
    for (const Dyad& dyad : before.dyads) {
      Dyad expected = dyad;
      expected.circle_point = change.of_circle_points(dyad.circle_point);
      expected.centre_point = change.of_centres(dyad.centre_point);
      const Dyad found = nearest_dyad(after.dyads, expected);
      const double allowed = 10.0 * std::pow(10.0, -std::min(dyad.digits, found.digits));
      EXPECT_LT(distance(found, expected), std::max(allowed, 1e-13));
      EXPECT_GT(found.digits, 4.0);
    }
  }
}

TEST(Invariance, UnderARigidMotion) {
  const Point turn = unit_vector(1.1);
  const Point shift(3.0, -2.0);
  expect_same({.of_positions =
                   [&](PositionJets jets) {
                     for (std::size_t k = 0; k < jets.x.size(); ++k) {
                       set_origin(
                           jets,
                           k,
                           turn * Point(jets.x[k], jets.y[k]) + (k == 0 ? shift : Point(0.0, 0.0)));
                     }
                     jets.angle[0] += 1.1;
                     return jets;
                   },
               .of_circle_points = identity,
               .of_centres = [&](const Point& w) { return turn * w + shift; }});
}

TEST(Invariance, UnderAShiftOfTheOriginByAMillion) {
  const Point shift(1e6, -1e6);
  expect_same({.of_positions =
                   [&](PositionJets jets) {
                     set_origin(jets, 0, Point(jets.x[0], jets.y[0]) + shift);
                     return jets;
                   },
               .of_circle_points = identity,
               .of_centres = [&](const Point& w) { return w + shift; }});
}

TEST(Invariance, UnderAChangeOfTheMovingOrigin) {
  const Point offset(0.7, 1.9);
  expect_same({.of_positions =
                   [&](PositionJets jets) {
                     const std::vector<Point> moved = point_jets(jets, offset);
                     for (std::size_t k = 0; k < jets.x.size(); ++k) {
                       set_origin(jets, k, moved[k]);
                     }
                     return jets;
                   },
               .of_circle_points = [&](const Point& z) { return z - offset; },
               .of_centres = identity});
}

TEST(Invariance, UnderScaling) {
  for (const double scale : {1e-6, 25.4, 1e9}) {
    SCOPED_TRACE(scale);
    for (const Positions& task : tasks()) {
      Positions scaled = task;
      for (PositionJets& jets : scaled) {
        for (std::size_t k = 0; k < jets.x.size(); ++k) {
          set_origin(jets, k, scale * Point(jets.x[k], jets.y[k]));
        }
      }
      const BurmesterSolution before = solve_burmester(task);

      const BurmesterSolution after = solve_burmester(scaled);

      ASSERT_EQ(after.dyads.size(), before.dyads.size());
      std::vector<Dyad> back = after.dyads;
      for (Dyad& dyad : back) {
        dyad.circle_point /= scale;
        dyad.centre_point /= scale;
      }
      for (const Dyad& dyad : before.dyads) {
        EXPECT_LT(nearest(back, dyad), std::max(10.0 * std::pow(10.0, -dyad.digits), 1e-13));
      }
    }
  }
}

TEST(Invariance, UnderReflection) {
  expect_same({.of_positions =
                   [](PositionJets jets) {
                     for (std::size_t k = 0; k < jets.x.size(); ++k) {
                       jets.y[k] = -jets.y[k];
                       jets.angle[k] = -jets.angle[k];
                     }
                     return jets;
                   },
               .of_circle_points = [](const Point& z) { return std::conj(z); },
               .of_centres = [](const Point& w) { return std::conj(w); }});
}

TEST(Invariance, UnderAnotherUnitOfTheParameter) {
  expect_same({.of_positions =
                   [](PositionJets jets) {
                     double factor = 1.0;
                     for (std::size_t k = 0; k < jets.x.size(); ++k) {
                       jets.x[k] *= factor;
                       jets.y[k] *= factor;
                       jets.angle[k] *= factor;
                       factor *= 1000.0;
                     }
                     return jets;
                   },
               .of_circle_points = identity,
               .of_centres = identity});
}

TEST(Invariance, UnderReordering) {
  for (const Positions& task : tasks()) {
    Positions turned = task;
    std::rotate(turned.begin(),
                turned.begin() + static_cast<std::ptrdiff_t>(task.size() / 2),
                turned.end());
    const BurmesterSolution before = solve_burmester(task);

    const BurmesterSolution after = solve_burmester(turned);

    ASSERT_EQ(after.dyads.size(), before.dyads.size());
    for (const Dyad& dyad : before.dyads) {
      EXPECT_LT(nearest(after.dyads, dyad), std::max(10.0 * std::pow(10.0, -dyad.digits), 1e-13));
    }
  }
}

}  // namespace
}  // namespace kinestat
