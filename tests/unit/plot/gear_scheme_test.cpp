#include "draw/train/gear_scheme.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "draw/train/scheme_axes.hpp"
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

// Developed sections: shafts stand beside the main axis.
class Developed : public testing::TestWithParam<std::string> {
 protected:
  const SchemeWheel& wheel(int w) const { return train_.wheels[static_cast<std::size_t>(w)]; }

  const DrawnWheel& drawn(int w) const {
    return *std::ranges::find(layout_.wheels, w, &DrawnWheel::wheel);
  }

  bool is_linked(std::size_t mesh) const {
    return std::ranges::any_of(layout_.links, [mesh](const DrawnLink& link) {
      return link.mesh == static_cast<int>(mesh);
    });
  }

  // Heights of a wheel on both sides of its axis.
  static std::pair<double, double> span(const DrawnWheel& one) {
    return {one.is_whole ? 2 * one.axis - one.high : one.low, one.high};
  }

  static double right_of(const DrawnShaft& shaft) { return std::max(shaft.from.x, shaft.to.x); }

  static double left_of(const DrawnShaft& shaft) { return std::min(shaft.from.x, shaft.to.x); }

  static double top_of(const DrawnShaft& shaft) { return -std::min(shaft.from.y, shaft.to.y); }

  static double bottom_of(const DrawnShaft& shaft) { return -std::max(shaft.from.y, shaft.to.y); }

  // Whether a line of the body, or the disc or the hub of one of its wheels, has the point.
  bool touches(int body, PixelPoint point) const {
    constexpr double kNear = 0.01;
    const bool has_line = std::ranges::any_of(layout_.shafts, [&](const DrawnShaft& shaft) {
      return shaft.body == body && left_of(shaft) <= point.x + kNear &&
             point.x <= right_of(shaft) + kNear && bottom_of(shaft) <= -point.y + kNear &&
             -point.y <= top_of(shaft) + kNear;
    });
    return has_line || std::ranges::any_of(layout_.wheels, [&](const DrawnWheel& one) {
             return wheel(one.wheel).body == body && one.left <= point.x && point.x <= one.right;
           });
  }

  const SchemeTrain train_ = train_of(GetParam());
  const SchemeLayout layout_ = lay_out_scheme(train_);
};

TEST_P(Developed, HasAWayForEverything) {
  EXPECT_GT(train_.axis_count, 1);
  EXPECT_TRUE(layout_.is_complete);
  EXPECT_EQ(layout_.crossings, 0);
}

// The pitch circles of two axes next to each other touch between them, in one plane; others are
// joined by a broken line from rim to rim.
TEST_P(Developed, WheelsInMeshTouchOrAreLinked) {
  for (std::size_t m = 0; m < train_.meshes.size(); ++m) {
    const DrawnWheel& one = drawn(train_.meshes[m].first);
    const DrawnWheel& other = drawn(train_.meshes[m].second);
    const bool is_parallel = wheel(one.wheel).axis != wheel(other.wheel).axis;
    if (!is_parallel) {
      continue;
    }
    const DrawnWheel& lower = one.axis < other.axis ? one : other;
    const DrawnWheel& upper = one.axis < other.axis ? other : one;
    const double gap = span(upper).first - span(lower).second;
    if (is_linked(m)) {
      const auto link = std::ranges::find(layout_.links, static_cast<int>(m), &DrawnLink::mesh);
      EXPECT_NEAR(-link->points.front().y, span(lower).second, 0.01);
      EXPECT_NEAR(-link->points.back().y, span(upper).first, 0.01);
      EXPECT_GT(gap, 1.0);
    } else {
      EXPECT_NEAR(gap, 0.0, 0.01) << wheel(one.wheel).name << " " << wheel(other.wheel).name;
      EXPECT_LT(lower.left, upper.right);
      EXPECT_LT(upper.left, lower.right);
    }
  }
}

TEST_P(Developed, NoWheelsOverlap) {
  for (const DrawnWheel& one : layout_.wheels) {
    for (const DrawnWheel& other : layout_.wheels) {
      const bool is_of_one_axis = wheel(one.wheel).axis == wheel(other.wheel).axis;
      const bool is_pair = one.wheel < other.wheel && one.left < other.right &&
                           other.left < one.right && !is_of_one_axis;
      if (is_pair) {
        EXPECT_LE(std::min(span(one).second, span(other).second) -
                      std::max(span(one).first, span(other).first),
                  0.01)
            << wheel(one.wheel).name << " " << wheel(other.wheel).name;
      }
    }
  }
}

// Neither a disc nor a rim has the line of a shaft of another body on it: what runs through a wheel
// stays within its hub.
TEST_P(Developed, NoShaftRunsThroughAnotherBodysWheel) {
  for (const DrawnWheel& one : layout_.wheels) {
    if (!one.is_whole) {
      continue;
    }
    const double disc = one.discs.front();
    for (const DrawnShaft& shaft : layout_.shafts) {
      if (shaft.body == wheel(one.wheel).body || right_of(shaft) < disc || disc < left_of(shaft)) {
        continue;
      }
      const double highest = top_of(shaft) - one.axis;
      const double lowest = bottom_of(shaft) - one.axis;
      const bool is_outside = lowest > one.high - one.axis || highest < one.axis - one.high;
      const bool is_within = highest < one.hub - 1.0 && lowest > 1.0 - one.hub;
      EXPECT_TRUE(is_outside || is_within) << wheel(one.wheel).name;
    }
  }
}

TEST_P(Developed, EveryClutchTouchesBothBodies) {
  for (std::size_t i = 0; i < train_.elements.size(); ++i) {
    const SchemeElement& element = train_.elements[i];
    const auto place =
        std::ranges::find(layout_.elements, static_cast<int>(i), &DrawnElement::element);
    ASSERT_NE(place, layout_.elements.end()) << element.name;
    if (element.kind == SchemeElementKind::clutch) {
      EXPECT_TRUE(touches(element.body, place->at)) << element.name;
      EXPECT_TRUE(touches(element.other, place->beyond)) << element.name;
      EXPECT_FALSE(touches(element.other, place->at)) << element.name;
    }
  }
}

// Two bodies on one line would look like one.
TEST_P(Developed, NoTwoShaftsShareALine) {
  for (const DrawnShaft& one : layout_.shafts) {
    for (const DrawnShaft& other : layout_.shafts) {
      if (one.body < other.body) {
        const bool is_apart = right_of(one) < left_of(other) || right_of(other) < left_of(one) ||
                              top_of(one) < bottom_of(other) || top_of(other) < bottom_of(one);
        EXPECT_TRUE(is_apart) << one.body << " " << other.body;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfTheLibrary,
                         Developed,
                         testing::Values("transmissions/dual_clutch_six_speed.yaml",
                                         "transmissions/vw_02e_dsg.yaml",
                                         "transmissions/truck_twelve_speed.yaml",
                                         "transmissions/muncie_m20.yaml",
                                         "transmissions/saturn_mp3.yaml",
                                         "transmissions/vw_02j.yaml",
                                         "transmissions/kawasaki_zg1400.yaml",
                                         "transmissions/suzuki_b_king.yaml",
                                         "transmissions/suzuki_lt_f500f.yaml",
                                         "transmissions/toyota_p311.yaml",
                                         "sweeps/year_train.yaml"),
                         [](const auto& test) {
                           std::string name = test.param.substr(test.param.find('/') + 1);
                           return name.substr(0, name.find('.'));
                         });

// Radii from the teeth: (15 + 57)/2 times 2.5 mm is the distance of a1 and w1.
TEST(SchemeRadii, AreWorkingRadiiOfShaftsBesideEachOther) {
  const SchemeTrain train = train_of("transmissions/dual_clutch_six_speed.yaml");
  const auto radius = [&](std::string_view name) {
    return std::ranges::find(train.wheels, name, &SchemeWheel::name)->radius;
  };

  EXPECT_NEAR(radius("a1 15"), 0.01875, 1e-12);
  EXPECT_NEAR(radius("w1 57"), 0.07125, 1e-12);
  EXPECT_NEAR(radius("f 70"), 0.105, 1e-12);
}

// The inner shaft runs within the hollow one, and the lay shafts within their idlers.
TEST(SchemeAxes, KnowWhatRunsWithinWhat) {
  const Analysis analysis = library_analysis("transmissions/dual_clutch_six_speed.yaml");
  const SchemeTrain train = find_scheme_train(analysis, {}).value();
  const std::vector<int> order = find_axis_order(train);
  const SchemeRadii radii = find_radii(train, order);
  const std::map<int, SchemeExtent> extents =
      find_extents(train, order_columns(train, radii, find_columns(train, radii)));
  const auto level = [&](std::string_view name) {
    const auto& bodies = analysis.mechanism.topology.bodies;
    const auto at = std::ranges::find(bodies, name, &BodyTopology::name);
    return extents.at(static_cast<int>(at - bodies.begin())).level;
  };

  EXPECT_EQ(level("inner"), 0);
  EXPECT_EQ(level("hollow"), 1);
  EXPECT_EQ(level("lay1"), 0);
  EXPECT_EQ(level("idler3"), 1);
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
