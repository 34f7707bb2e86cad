#include "draw/train/gear_scheme.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "draw/train/scheme_layout.hpp"
#include "draw/train/scheme_radii.hpp"
#include "library_analysis.hpp"

namespace kinestat {
namespace {

SchemeTrain train_of(const std::string& name) {
  return find_scheme_train(library_analysis(name), {}).value();
}

// Half sections: r of a wheel on the main axis, y of a planet's pin.
double miss_of(const SchemeTrain& train, const SchemeRadii& radii, const SchemeMesh& mesh) {
  const auto wheel = [&](int i) { return train.wheels[static_cast<std::size_t>(i)]; };
  const auto r = [&](int i) { return radii.wheels[static_cast<std::size_t>(i)]; };
  const auto y = [&](int i) { return radii.planets[static_cast<std::size_t>(wheel(i).planet)]; };
  const int a = mesh.first;
  const int b = mesh.second;
  if (wheel(a).planet >= 0 && wheel(b).planet >= 0) {
    return std::abs(y(a) - y(b)) - r(a) - r(b);
  }
  const int main = wheel(a).planet < 0 ? a : b;
  const int planet = main == a ? b : a;
  return wheel(main).is_ring ? r(main) - y(planet) - r(planet) : r(main) + r(planet) - y(planet);
}

class Scheme : public testing::TestWithParam<std::string> {};

TEST_P(Scheme, WheelsInMeshTouch) {
  const SchemeTrain train = train_of(GetParam());

  const SchemeRadii radii = find_radii(train);

  for (const SchemeMesh& mesh : train.meshes) {
    EXPECT_NEAR(miss_of(train, radii, mesh), 0.0, 1e-6 * train.wheels.front().radius);
  }
}

TEST_P(Scheme, RadiiStayPositive) {
  const SchemeRadii radii = find_radii(train_of(GetParam()));

  for (const double radius : radii.wheels) {
    EXPECT_GT(radius, 0.0);
  }
}

// In a column no wheel lies in the way of another: planets between suns and rings.
TEST_P(Scheme, WheelsOfAColumnStandApart) {
  const SchemeTrain train = train_of(GetParam());

  const SchemeLayout layout = lay_out_scheme(train);

  for (const DrawnWheel& one : layout.wheels) {
    for (const DrawnWheel& other : layout.wheels) {
      const bool is_pair =
          one.wheel < other.wheel && one.left < other.right && other.left < one.right;
      const auto is_planet = [&](const DrawnWheel& drawn) {
        return train.wheels[static_cast<std::size_t>(drawn.wheel)].planet >= 0;
      };
      if (is_pair && is_planet(one) && is_planet(other)) {
        EXPECT_LE(std::min(one.high, other.high) - std::max(one.low, other.low), 0.01);
      }
    }
  }
}

TEST_P(Scheme, EveryElementHasItsPlace) {
  const SchemeTrain train = train_of(GetParam());

  const SchemeLayout layout = lay_out_scheme(train);

  for (std::size_t i = 0; i < train.elements.size(); ++i) {
    const bool is_there = std::ranges::any_of(layout.elements, [i](const DrawnElement& drawn) {
      return drawn.element == static_cast<int>(i);
    });
    EXPECT_TRUE(is_there) << train.elements[i].name;
  }
}

TEST_P(Scheme, IsTheSameEveryTime) {
  const Analysis analysis = library_analysis(GetParam());

  EXPECT_EQ(draw_gear_scheme(analysis).value().elements,
            draw_gear_scheme(analysis).value().elements);
}

INSTANTIATE_TEST_SUITE_P(OfTheLibrary,
                         Scheme,
                         testing::Values("transmissions/ravigneaux.yaml",
                                         "transmissions/ravigneaux_teeth.yaml",
                                         "transmissions/simpson_a727.yaml",
                                         "transmissions/simpson_4hp22.yaml",
                                         "transmissions/lepelletier_6hp26.yaml",
                                         "transmissions/zf_8hp70.yaml",
                                         "transmissions/ravigneaux_4hp14.yaml",
                                         "transmissions/wolfrom.yaml",
                                         "transmissions/prius_gen3.yaml",
                                         "gears/simple_planetary.yaml"),
                         [](const auto& test) {
                           std::string name = test.param.substr(test.param.find('/') + 1);
                           return name.substr(0, name.find('.'));
                         });

// Teeth 19, 41, 85, 15, 14 and 22 of Cazangi 2008, chapter 5: (19 + 15)/2 + (15 + 14)/2 =
// (41 + 22)/2, so that all axes lie in one plane and every radius is that of the teeth.
TEST(SchemeRadii, AreTrueWhereTheTrainFitsInOnePlane) {
  const SchemeTrain train = train_of("transmissions/ravigneaux_teeth.yaml");

  const SchemeRadii radii = find_radii(train);

  for (std::size_t w = 0; w < train.wheels.size(); ++w) {
    EXPECT_NEAR(radii.wheels[w], train.wheels[w].radius, 1e-9) << train.wheels[w].name;
  }
  EXPECT_NEAR(radii.planets[0], 17.0, 1e-9);
  EXPECT_NEAR(radii.planets[1], 31.5, 1e-9);
}

// The same train written as couplings between pitch points, and in teeth.
TEST(SchemeTrain, IsTheSameFromPitchPointsAsFromTeeth) {
  const SchemeTrain points = train_of("transmissions/ravigneaux.yaml");
  const SchemeTrain teeth = train_of("transmissions/ravigneaux_teeth.yaml");

  ASSERT_EQ(points.wheels.size(), teeth.wheels.size());
  ASSERT_EQ(points.meshes.size(), teeth.meshes.size());
  for (std::size_t m = 0; m < points.meshes.size(); ++m) {
    const auto radius = [m](const SchemeTrain& train, int SchemeMesh::*which) {
      return train.wheels[static_cast<std::size_t>(train.meshes[m].*which)].radius;
    };
    EXPECT_NEAR(radius(points, &SchemeMesh::first), radius(teeth, &SchemeMesh::first), 1e-9);
    EXPECT_NEAR(radius(points, &SchemeMesh::second), radius(teeth, &SchemeMesh::second), 1e-9);
  }
}

SchemeElementKind kind_of(const Analysis& analysis, std::size_t which, std::string_view name) {
  const SchemeTrain train = find_scheme_train(analysis, {.which = which}).value();
  return std::ranges::find(train.elements, name, &SchemeElement::name)->kind;
}

// Its cases drive it from one shaft and from the other.
TEST(SchemeTrain, IsDrivenByTheInputOfItsCase) {
  const Analysis analysis = library_analysis("gears/self_locking_planetary.yaml");

  EXPECT_EQ(kind_of(analysis, 0, "carrier_shaft"), SchemeElementKind::input);
  EXPECT_EQ(kind_of(analysis, 0, "sun_shaft"), SchemeElementKind::output);
  EXPECT_EQ(kind_of(analysis, 1, "sun_shaft"), SchemeElementKind::input);
  EXPECT_EQ(kind_of(analysis, 1, "carrier_shaft"), SchemeElementKind::output);
}

// Its first case holds the ring, which drives the second.
TEST(SchemeTrain, IsHeldByWhatItsCaseHolds) {
  const Analysis analysis = library_analysis("gears/simple_planetary.yaml");

  EXPECT_EQ(kind_of(analysis, 0, "Tr"), SchemeElementKind::brake);
  EXPECT_EQ(kind_of(analysis, 1, "Tr"), SchemeElementKind::input);
}

// Table of the 6HP26: the second gear engages A and C.
TEST(SchemeTrain, KnowsWhatAGearEngages) {
  const Analysis analysis = library_analysis("transmissions/lepelletier_6hp26.yaml");
  std::size_t second = 0;
  while (analysis.cases[second].which.label != "2") {
    ++second;
  }

  const SchemeTrain train = find_scheme_train(analysis, {.which = second}).value();

  std::string engaged;
  for (const SchemeElement& element : train.elements) {
    const bool shifts =
        element.kind == SchemeElementKind::clutch || element.kind == SchemeElementKind::brake;
    engaged += shifts && element.is_engaged ? element.name : "";
  }
  EXPECT_EQ(engaged, "AC");
}

TEST(GearScheme, IsEmptyWithoutGears) {
  EXPECT_FALSE(draw_gear_scheme(library_analysis("planar/four_bar.yaml")).has_value());
}

}  // namespace
}  // namespace kinestat
