#include "mechanism/coupling_catalogue.hpp"

#include <gtest/gtest.h>

#include "math/rank.hpp"

namespace kinestat {
namespace {

constexpr double kTight = 1e-14;

template <class Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) {
    names.push_back(item.name);
  }
  return names;
}

using Names = std::vector<std::string>;

Axis keyword(char letter, double sign = 1.0) {
  return {.direction = sign * Vec3::Unit(letter - 'x'), .keyword = letter};
}

Axis oblique() {
  return {.direction = Vec3(1.0, 2.0, -2.0) / 3.0, .keyword = 0};
}

struct Row {
  const char* name;
  CouplingType type;
  Space space;
  Axis axis;
};

class CatalogueRow : public testing::TestWithParam<Row> {
 protected:
  CouplingGeometry geometry() const {
    return {.at = GetParam().space == Space::planar ? Vec3(3.0, -2.0, 0.0) : Vec3(3.0, -2.0, 5.0),
            .axis = GetParam().axis,
            .line_of_action = Vec3(0.6, 0.8, 0.0)};
  }
};

TEST_P(CatalogueRow, FreedomsAndConstraintsAreReciprocal) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());

  for (const NamedTwist& freedom : screws.freedoms) {
    for (const NamedWrench& constraint : screws.constraints) {
      EXPECT_NEAR(power(constraint.screw, freedom.screw), 0.0, kTight)
          << constraint.name << " works on " << freedom.name;
    }
  }
}

TEST_P(CatalogueRow, ScrewsAreIndependent) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());
  MatX actions(6, static_cast<Eigen::Index>(screws.constraints.size()));
  for (std::size_t i = 0; i < screws.constraints.size(); ++i) {
    actions.col(static_cast<Eigen::Index>(i)) = screws.constraints[i].screw.coordinates();
  }

  EXPECT_EQ(find_rank(actions).rank, static_cast<int>(screws.constraints.size()));
}

TEST_P(CatalogueRow, FreedomsAndConstraintsFillTheOrderOfTheSpace) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());
  const std::size_t order = GetParam().space == Space::planar ? 3 : 6;
  const std::size_t sum = screws.freedoms.size() + screws.constraints.size();

  switch (GetParam().type) {
    case CouplingType::gear:  // rolls about the pitch point, bears one force: Cazangi, Tab. 5.4
      EXPECT_EQ(sum, 2U);
      break;
    case CouplingType::clutch:  // bears only the couple of its actuator
    case CouplingType::brake:
      EXPECT_EQ(sum, 1U);
      break;
    case CouplingType::revolute:
    case CouplingType::prismatic:
    case CouplingType::rigid:
      EXPECT_EQ(sum, order);
      break;
    default:
      FAIL() << "not in the catalogue";
  }
}

class PlanarRow : public CatalogueRow {};

TEST_P(PlanarRow, ScrewsStayInThePlane) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());

  for (const NamedTwist& freedom : screws.freedoms) {
    const Vec6 c = freedom.screw.coordinates();
    EXPECT_EQ(Vec3(c[0], c[1], c[5]), Vec3::Zero()) << freedom.name;
  }
  for (const NamedWrench& constraint : screws.constraints) {
    const Vec6 c = constraint.screw.coordinates();
    EXPECT_EQ(Vec3(c[0], c[1], c[5]), Vec3::Zero()) << constraint.name;
  }
}

TEST_P(CatalogueRow, TheInternalActionOfAFreedomWorksOnItAlone) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());

  for (const NamedTwist& freedom : screws.freedoms) {
    const NamedWrench action = internal_action(freedom, geometry().at);
    EXPECT_NEAR(power(action.screw, freedom.screw), 1.0, kTight) << freedom.name;
    EXPECT_EQ(action.is_couple, freedom.is_rotation);
  }
}

std::vector<Row> planar_rows() {
  return {{"RevoluteInThePlane", CouplingType::revolute, Space::planar, keyword('z')},
          {"PrismaticInThePlaneAlongY", CouplingType::prismatic, Space::planar, keyword('y')},
          {"PrismaticInThePlaneOblique",
           CouplingType::prismatic,
           Space::planar,
           {.direction = Vec3(0.6, -0.8, 0.0), .keyword = 0}},
          {"GearInThePlane", CouplingType::gear, Space::planar, keyword('z')},
          {"BrakeInThePlane", CouplingType::brake, Space::planar, keyword('z')},
          {"RigidInThePlane", CouplingType::rigid, Space::planar, keyword('z')}};
}

std::vector<Row> spatial_rows() {
  return {{"RevoluteAboutX", CouplingType::revolute, Space::spatial, keyword('x')},
          {"RevoluteAboutMinusZ", CouplingType::revolute, Space::spatial, keyword('z', -1.0)},
          {"RevoluteOblique", CouplingType::revolute, Space::spatial, oblique()},
          {"PrismaticAlongY", CouplingType::prismatic, Space::spatial, keyword('y')},
          {"PrismaticOblique", CouplingType::prismatic, Space::spatial, oblique()},
          {"GearInSpace", CouplingType::gear, Space::spatial, keyword('z')},
          {"Clutch", CouplingType::clutch, Space::spatial, keyword('z')},
          {"RigidInSpace", CouplingType::rigid, Space::spatial, keyword('z')}};
}

std::string name_of_row(const testing::TestParamInfo<Row>& row) {
  return row.param.name;
}

INSTANTIATE_TEST_SUITE_P(Planar, CatalogueRow, testing::ValuesIn(planar_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Spatial, CatalogueRow, testing::ValuesIn(spatial_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Planar, PlanarRow, testing::ValuesIn(planar_rows()), name_of_row);

TEST(CatalogueNames, FollowAKeywordAxis) {
  const CouplingScrews screws =
      coupling_screws(CouplingType::revolute, Space::spatial, {.axis = keyword('x')});

  EXPECT_EQ(names_of(screws.freedoms), Names({"wx"}));
  EXPECT_EQ(names_of(screws.constraints), Names({"Rx", "Ry", "Rz", "Ty", "Tz"}));
}

TEST(CatalogueNames, OfANegativeAxisAreThoseOfThePositiveOne) {
  const CouplingScrews screws =
      coupling_screws(CouplingType::revolute, Space::spatial, {.axis = keyword('z', -1.0)});

  EXPECT_EQ(names_of(screws.freedoms), Names({"wz"}));
  EXPECT_EQ(screws.freedoms.front().screw.angular, Vec3(0.0, 0.0, -1.0));
}

TEST(CatalogueNames, OfAVectorAxisAreNumbered) {
  const CouplingScrews revolute =
      coupling_screws(CouplingType::revolute, Space::spatial, {.axis = oblique()});
  const CouplingScrews prismatic =
      coupling_screws(CouplingType::prismatic, Space::spatial, {.axis = oblique()});

  EXPECT_EQ(names_of(revolute.freedoms), Names({"w"}));
  EXPECT_EQ(names_of(revolute.constraints), Names({"Rx", "Ry", "Rz", "T1", "T2"}));
  EXPECT_EQ(names_of(prismatic.freedoms), Names({"v"}));
  EXPECT_EQ(names_of(prismatic.constraints), Names({"R1", "R2", "Tx", "Ty", "Tz"}));
}

TEST(CatalogueNames, OfAPlanarSliderAlongYAreThoseOfTheSource) {
  // Alves 2023, Eq. 3.23: U (along x) and T (about z) at the prismatic couplings a and b.
  const CouplingScrews screws =
      coupling_screws(CouplingType::prismatic, Space::planar, {.axis = keyword('y')});

  EXPECT_EQ(names_of(screws.freedoms), Names({"vy"}));
  EXPECT_EQ(names_of(screws.constraints), Names({"Rx", "Tz"}));
}

TEST(CatalogueCouples, AcrossAVectorAxisAreT1OnTheLeastAlignedWorldAxisAndT2) {
  const Axis axis{.direction = Vec3(0.6, 0.8, 0.0), .keyword = 0};
  const CouplingScrews screws =
      coupling_screws(CouplingType::revolute, Space::spatial, {.axis = axis});

  // k = z is perpendicular to the axis, so t1 = z and t2 = a x z.
  EXPECT_EQ(screws.constraints[3].screw.moment, Vec3(0.0, 0.0, 1.0));
  EXPECT_TRUE(screws.constraints[4].screw.moment.isApprox(Vec3(0.8, -0.6, 0.0)));
}

}  // namespace
}  // namespace kinestat
