
#include "couplings/coupling_catalogue.hpp"

#include <ostream>

#include <gtest/gtest.h>

#include "math/elimination/rank.hpp"
#include "mechanism/couplings/reciprocity.hpp"

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

CouplingGeometry along(const Axis& axis) {
  CouplingGeometry geometry;
  geometry.axis = axis;
  return geometry;
}

ScrewGeometry screw(ScrewWord kind, const Axis& direction, const Vec3& at, double pitch = 0.0) {
  return {.kind = kind, .direction = direction, .at = at, .pitch = pitch};
}

Axis slanted() {
  return {.direction = Vec3(0.6, -0.8, 0.0), .keyword = 0};
}

Axis across_oblique() {
  return {.direction = Vec3(2.0, 1.0, 2.0) / 3.0, .keyword = 0};
}

struct Row {
  const char* name;
  CouplingType type;
  Space space;
  Axis axis;
  Axis second = {};
  bool is_contact = false;
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

class RowOfCatalogue : public testing::TestWithParam<Row> {
 protected:
  CouplingGeometry geometry() const {
    const bool is_planar = GetParam().space == Space::planar;
    CouplingGeometry result;
    result.at = is_planar ? Vec3(3.0, -2.0, 0.0) : Vec3(3.0, -2.0, 5.0);
    result.axis = GetParam().axis;
    result.second = GetParam().second;
    result.line_of_action = Vec3(0.6, 0.8, 0.0);
    result.pitch = 0.25;
    result.is_contact = GetParam().is_contact;
    result.from = Vec3(1.0, 1.0, is_planar ? 0.0 : -2.0);
    result.to = result.at;
    return result;
  }
};

TEST_P(RowOfCatalogue, FreedomsAndConstraintsAreReciprocal) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());

  for (const NamedTwist& freedom : screws.freedoms) {
    for (const NamedWrench& constraint : screws.constraints) {
      EXPECT_NEAR(power(constraint.screw, freedom.screw), 0.0, kTight)
          << constraint.name << " works on " << freedom.name;
    }
  }
}

TEST_P(RowOfCatalogue, ScrewsAreIndependent) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());
  MatX motions(6, static_cast<Eigen::Index>(screws.freedoms.size()));
  for (std::size_t i = 0; i < screws.freedoms.size(); ++i) {
    motions.col(static_cast<Eigen::Index>(i)) = screws.freedoms[i].screw.coordinates();
  }
  MatX actions(6, static_cast<Eigen::Index>(screws.constraints.size()));
  for (std::size_t i = 0; i < screws.constraints.size(); ++i) {
    actions.col(static_cast<Eigen::Index>(i)) = screws.constraints[i].screw.coordinates();
  }

  EXPECT_EQ(find_rank(motions).rank, static_cast<int>(screws.freedoms.size()));
  EXPECT_EQ(find_rank(actions).rank, static_cast<int>(screws.constraints.size()));
}

TEST_P(RowOfCatalogue, FreedomsAndConstraintsFillTheOrderOfTheSpace) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());
  const std::size_t order = GetParam().space == Space::planar ? 3 : 6;
  const std::size_t sum = screws.freedoms.size() + screws.constraints.size();

  switch (GetParam().type) {
    case CouplingType::gear:  // rolls about the pitch point, bears one force: Cazangi, Tab. 5.4
    case CouplingType::bevel_gear:
    case CouplingType::worm:
    case CouplingType::rack:
      EXPECT_EQ(sum, GetParam().is_contact ? order : 2U);
      break;
    case CouplingType::clutch:  // bears only the couple of its actuator
    case CouplingType::brake:
    case CouplingType::torque_converter:  // bears what its characteristic tells
      EXPECT_EQ(sum, 1U);
      break;
    default:
      EXPECT_EQ(sum, order);
  }
}

class PlanarRow : public RowOfCatalogue {};

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

TEST_P(RowOfCatalogue, TheInternalActionOfAFreedomWorksOnItAlone) {
  const CouplingScrews screws = coupling_screws(GetParam().type, GetParam().space, geometry());

  for (const NamedTwist& freedom : screws.freedoms) {
    const NamedWrench action = internal_action<double>(freedom, geometry().at);
    EXPECT_NEAR(power(action.screw, freedom.screw), 1.0, kTight) << freedom.name;
    EXPECT_EQ(action.is_couple, freedom.is_rotation);
  }
}

std::vector<Row> planar_rows() {
  return {{"RevoluteInThePlane", CouplingType::revolute, Space::planar, keyword('z')},
          {"PrismaticInThePlaneAlongY", CouplingType::prismatic, Space::planar, keyword('y')},
          {"PrismaticInThePlaneOblique", CouplingType::prismatic, Space::planar, slanted()},
          {"PointContactInThePlane", CouplingType::point_contact, Space::planar, keyword('y')},
          {"CamInThePlaneOblique", CouplingType::cam, Space::planar, slanted()},
          {"PinInSlot", CouplingType::pin_in_slot, Space::planar, keyword('x')},
          {"PinInSlotOblique", CouplingType::pin_in_slot, Space::planar, slanted()},
          {"GearInThePlane", CouplingType::gear, Space::planar, keyword('z')},
          {"TeethInThePlane", CouplingType::gear, Space::planar, keyword('z'), {}, true},
          {"RackInThePlane", CouplingType::rack, Space::planar, keyword('z')},
          {"BrakeInThePlane", CouplingType::brake, Space::planar, keyword('z')},
          {"ConverterInThePlane", CouplingType::torque_converter, Space::planar, keyword('z')},
          {"CableInThePlane", CouplingType::cable, Space::planar, keyword('z')},
          {"RigidInThePlane", CouplingType::rigid, Space::planar, keyword('z')}};
}

std::vector<Row> spatial_rows() {
  return {{"RevoluteAboutX", CouplingType::revolute, Space::spatial, keyword('x')},
          {"RevoluteAboutMinusZ", CouplingType::revolute, Space::spatial, keyword('z', -1.0)},
          {"RevoluteOblique", CouplingType::revolute, Space::spatial, oblique()},
          {"PrismaticAlongY", CouplingType::prismatic, Space::spatial, keyword('y')},
          {"PrismaticOblique", CouplingType::prismatic, Space::spatial, oblique()},
          {"HelicalAlongX", CouplingType::helical, Space::spatial, keyword('x')},
          {"HelicalOblique", CouplingType::helical, Space::spatial, oblique()},
          {"CylindricalAlongMinusY", CouplingType::cylindrical, Space::spatial, keyword('y', -1)},
          {"CylindricalOblique", CouplingType::cylindrical, Space::spatial, oblique()},
          {"UniversalXZ", CouplingType::universal, Space::spatial, keyword('x'), keyword('z')},
          {"UniversalMixed", CouplingType::universal, Space::spatial, keyword('x'), oblique()},
          {"UniversalSkew", CouplingType::universal, Space::spatial, oblique(), slanted()},
          {"Spherical", CouplingType::spherical, Space::spatial, keyword('z')},
          {"PlanarNormalToY", CouplingType::planar, Space::spatial, keyword('y')},
          {"PlanarOblique", CouplingType::planar, Space::spatial, oblique()},
          {"PointContact", CouplingType::point_contact, Space::spatial, keyword('z', -1)},
          {"CamOblique", CouplingType::cam, Space::spatial, oblique()},
          {"LineContact", CouplingType::line_contact, Space::spatial, keyword('y'), keyword('x')},
          {"LineContactOblique",
           CouplingType::line_contact,
           Space::spatial,
           oblique(),
           across_oblique()},
          {"SphereInTube", CouplingType::sphere_in_tube, Space::spatial, keyword('x')},
          {"SphereInTubeOblique", CouplingType::sphere_in_tube, Space::spatial, oblique()},
          {"PinInSlotCountedInSpace", CouplingType::pin_in_slot, Space::spatial, slanted()},
          {"GearInSpace", CouplingType::gear, Space::spatial, keyword('z')},
          {"TeethInSpace", CouplingType::gear, Space::spatial, keyword('z'), {}, true},
          {"BevelGear", CouplingType::bevel_gear, Space::spatial, oblique()},
          {"Worm", CouplingType::worm, Space::spatial, oblique()},
          {"Cable", CouplingType::cable, Space::spatial, keyword('z')},
          {"Clutch", CouplingType::clutch, Space::spatial, keyword('z')},
          {"Converter", CouplingType::torque_converter, Space::spatial, keyword('x')},
          {"RigidInSpace", CouplingType::rigid, Space::spatial, keyword('z')}};
}

std::string name_of_row(const testing::TestParamInfo<Row>& row) {
  return row.param.name;
}

INSTANTIATE_TEST_SUITE_P(Planar, RowOfCatalogue, testing::ValuesIn(planar_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Spatial, RowOfCatalogue, testing::ValuesIn(spatial_rows()), name_of_row);
INSTANTIATE_TEST_SUITE_P(Planar, PlanarRow, testing::ValuesIn(planar_rows()), name_of_row);

TEST(CatalogueNames, FollowAKeywordAxis) {
  const CouplingScrews screws =
      coupling_screws(CouplingType::revolute, Space::spatial, along(keyword('x')));

  EXPECT_EQ(names_of(screws.freedoms), Names({"wx"}));
  EXPECT_EQ(names_of(screws.constraints), Names({"Rx", "Ry", "Rz", "Ty", "Tz"}));
}

// A positive d.vx that moved towards -x would say the opposite of its name.
TEST(CatalogueNames, OfANegativeAxisHaveNoLetterAlongIt) {
  const CouplingScrews revolute =
      coupling_screws(CouplingType::revolute, Space::spatial, along(keyword('z', -1.0)));
  const CouplingScrews prismatic =
      coupling_screws(CouplingType::prismatic, Space::planar, along(keyword('x', -1.0)));
  const CouplingScrews contact =
      coupling_screws(CouplingType::point_contact, Space::planar, along(keyword('y', -1.0)));

  EXPECT_EQ(names_of(revolute.freedoms), Names({"w"}));
  EXPECT_EQ(revolute.freedoms.front().screw.angular, Vec3(0.0, 0.0, -1.0));
  EXPECT_EQ(names_of(revolute.constraints), Names({"Rx", "Ry", "Rz", "Tx", "Ty"}));
  EXPECT_EQ(names_of(prismatic.freedoms), Names({"v"}));
  EXPECT_EQ(names_of(prismatic.constraints), Names({"Ry", "Tz"}));
  EXPECT_EQ(prismatic.constraints.front().screw.force, Vec3(0.0, 1.0, 0.0));
  EXPECT_EQ(names_of(contact.freedoms), Names({"wz", "vx"}));
  EXPECT_EQ(names_of(contact.constraints), Names({"R"}));
}

TEST(CatalogueNames, OfAVectorAxisAreNumbered) {
  const CouplingScrews revolute =
      coupling_screws(CouplingType::revolute, Space::spatial, along(oblique()));
  const CouplingScrews prismatic =
      coupling_screws(CouplingType::prismatic, Space::spatial, along(oblique()));

  EXPECT_EQ(names_of(revolute.freedoms), Names({"w"}));
  EXPECT_EQ(names_of(revolute.constraints), Names({"Rx", "Ry", "Rz", "T1", "T2"}));
  EXPECT_EQ(names_of(prismatic.freedoms), Names({"v"}));
  EXPECT_EQ(names_of(prismatic.constraints), Names({"R1", "R2", "Tx", "Ty", "Tz"}));
}

TEST(CatalogueNames, OfAPlanarSliderAlongYAreThoseOfTheSource) {
  // Alves 2023, Eq. 3.23: U (along x) and T (about z) at the prismatic couplings a and b.
  const CouplingScrews screws =
      coupling_screws(CouplingType::prismatic, Space::planar, along(keyword('y')));

  EXPECT_EQ(names_of(screws.freedoms), Names({"vy"}));
  EXPECT_EQ(names_of(screws.constraints), Names({"Rx", "Tz"}));
}

TEST(CatalogueCouples, AcrossAVectorAxisAreT1OnTheLeastAlignedWorldAxisAndT2) {
  const Axis axis{.direction = Vec3(0.6, 0.8, 0.0), .keyword = 0};
  const CouplingScrews screws =
      coupling_screws(CouplingType::revolute, Space::spatial, along(axis));

  // k = z is perpendicular to the axis, so t1 = z and t2 = a x z.
  EXPECT_EQ(screws.constraints[3].screw.moment, Vec3(0.0, 0.0, 1.0));
  EXPECT_TRUE(screws.constraints[4].screw.moment.isApprox(Vec3(0.8, -0.6, 0.0)));
}

TEST(CatalogueNames, OfTheOtherTypesFollowTheFormatPage) {
  const auto names = [](CouplingType type, const Axis& axis, const Axis& second) {
    CouplingGeometry geometry = along(axis);
    geometry.second = second;
    const CouplingScrews screws = coupling_screws(type, Space::spatial, geometry);
    return std::pair(names_of(screws.freedoms), names_of(screws.constraints));
  };
  using enum CouplingType;

  EXPECT_EQ(names(helical, keyword('z'), {}),
            std::pair(Names({"w"}), Names({"Rx", "Ry", "Ra", "Tx", "Ty"})));
  EXPECT_EQ(names(cylindrical, oblique(), {}),
            std::pair(Names({"w", "v"}), Names({"R1", "R2", "T1", "T2"})));
  EXPECT_EQ(names(universal, keyword('x'), keyword('z')),
            std::pair(Names({"wx", "wz"}), Names({"Rx", "Ry", "Rz", "Ty"})));
  EXPECT_EQ(names(universal, oblique(), slanted()),
            std::pair(Names({"w1", "w2"}), Names({"Rx", "Ry", "Rz", "T"})));
  EXPECT_EQ(names(planar, keyword('y'), {}),
            std::pair(Names({"wy", "vx", "vz"}), Names({"Ry", "Tx", "Tz"})));
  EXPECT_EQ(names(point_contact, oblique(), {}),
            std::pair(Names({"wx", "wy", "wz", "v1", "v2"}), Names({"R"})));
  EXPECT_EQ(names(line_contact, keyword('y'), keyword('x')),
            std::pair(Names({"wx", "wy", "vx", "vz"}), Names({"Ry", "Tz"})));
  EXPECT_EQ(names(line_contact, oblique(), across_oblique()),
            std::pair(Names({"w1", "w2", "v1", "v2"}), Names({"R", "T"})));
  EXPECT_EQ(names(cable, keyword('z'), {}),
            std::pair(Names({"w1", "w2", "w3", "w4", "w5"}), Names({"F"})));
}

TEST(CatalogueCable, PullsTheHeadTowardsTheTail) {
  CouplingGeometry geometry;
  geometry.from = Vec3(1.0, 0.0, 0.0);
  geometry.to = Vec3(1.0, 2.0, 0.0);
  const CouplingScrews screws = coupling_screws(CouplingType::cable, Space::planar, geometry);

  EXPECT_EQ(screws.constraints.front().screw.force, Vec3(0.0, -1.0, 0.0));
}

TEST(CatalogueHelical, AdvancesByItsPitchAndBearsAWrenchOfTheOppositeOne) {
  CouplingGeometry geometry = along(keyword('z'));
  geometry.at = Vec3(2.0, 0.0, 0.0);
  geometry.pitch = 0.5;
  const CouplingScrews screws = coupling_screws(CouplingType::helical, Space::spatial, geometry);

  EXPECT_EQ(velocity_at(screws.freedoms[0].screw, geometry.at), Vec3(0.0, 0.0, 0.5));
  EXPECT_EQ(moment_at(screws.constraints[2].screw, geometry.at), Vec3(0.0, 0.0, -0.5));
}

TEST(CatalogueScrews, TheComplementOfARotationIsWhatARevoluteBears) {
  CouplingGeometry geometry;
  geometry.at = Vec3(3.0, -2.0, 5.0);
  geometry.freedoms = {screw(ScrewWord::rotation, keyword('x'), geometry.at)};
  const CouplingScrews listed = coupling_screws(CouplingType::screws, Space::spatial, geometry);
  geometry.axis = keyword('x');
  const CouplingScrews revolute = coupling_screws(CouplingType::revolute, Space::spatial, geometry);

  EXPECT_EQ(names_of(listed.constraints), names_of(revolute.constraints));
  for (std::size_t i = 0; i < revolute.constraints.size(); ++i) {
    EXPECT_TRUE(listed.constraints[i].screw.coordinates().isApprox(
        revolute.constraints[i].screw.coordinates(), kTight));
  }
}

TEST(CatalogueScrews, EitherSideIsTheComplementOfTheOther) {
  const Vec3 p(1.0, 2.0, -1.0);
  const Vec3 q(-300.0, 40.0, 7.0);
  CouplingGeometry freedoms;
  freedoms.at = p;
  freedoms.freedoms = {screw(ScrewWord::rotation, oblique(), p, 0.3),
                       screw(ScrewWord::rotation, slanted(), q),
                       screw(ScrewWord::translation, keyword('z'), p)};
  CouplingGeometry constraints;
  constraints.at = p;
  constraints.constraints = {screw(ScrewWord::force, oblique(), q, -2.0),
                             screw(ScrewWord::couple, slanted(), p)};

  for (const CouplingGeometry& geometry : {freedoms, constraints}) {
    const CouplingScrews screws = coupling_screws(CouplingType::screws, Space::spatial, geometry);
    EXPECT_EQ(screws.freedoms.size() + screws.constraints.size(), 6U);
    EXPECT_LT(reciprocity_error(screws, 300.0), 1e-13);
  }
}

TEST(CatalogueScrews, InThePlaneStayThere) {
  CouplingGeometry geometry;
  geometry.freedoms = {screw(ScrewWord::rotation, keyword('z'), Vec3(1.0, 2.0, 0.0))};
  const CouplingScrews screws = coupling_screws(CouplingType::screws, Space::planar, geometry);

  EXPECT_EQ(names_of(screws.constraints), Names({"Rx", "Ry"}));
}

TEST(CatalogueScrews, OfTheSameNameAreNumbered) {
  CouplingGeometry geometry;
  geometry.freedoms = {screw(ScrewWord::rotation, oblique(), Vec3::Zero()),
                       screw(ScrewWord::rotation, keyword('z'), Vec3::Zero()),
                       screw(ScrewWord::rotation, slanted(), Vec3::UnitX())};
  const CouplingScrews screws = coupling_screws(CouplingType::screws, Space::spatial, geometry);

  EXPECT_EQ(names_of(screws.freedoms), Names({"w1", "wz", "w2"}));
}

TEST(CatalogueReciprocity, ShowsAWormWhoseTeethWouldGivePower) {
  CouplingGeometry geometry;
  geometry.line_of_action = Vec3(0.0, 0.6, 0.8);
  geometry.relative = screw(ScrewWord::rotation, keyword('z'), Vec3::Zero(), 0.5);
  const CouplingScrews screws = coupling_screws(CouplingType::worm, Space::spatial, geometry);

  EXPECT_NEAR(reciprocity_error(screws, 1.0), 0.8 * 0.5, kTight);
}

// The derivatives of screws by dual numbers agree with central differences, for every row.
TEST_P(RowOfCatalogue, DerivativesAgreeWithDifferences) {
  const auto geometry_at = [&](auto x) {
    using Scalar = decltype(x);
    CouplingGeometryOf<Scalar> g;
    const CouplingGeometry drawn = geometry();
    const auto moved = [&](const Vec3& v, double along) {
      Vec3Of<Scalar> result;
      for (int i = 0; i < 3; ++i) {
        result[i] = Scalar(v[i]) + Scalar(along * (i + 1)) * x;
      }
      return result;
    };
    const bool is_planar = GetParam().space == Space::planar;
    const auto turned = [&](const Vec3& v) {  // about z in the plane, about x in space
      using std::cos, std::sin;
      const int a = is_planar ? 0 : 1;
      Vec3Of<Scalar> result = v.template cast<Scalar>();
      result[a] = cos(x) * Scalar(v[a]) - sin(x) * Scalar(v[a + 1]);
      result[a + 1] = sin(x) * Scalar(v[a]) + cos(x) * Scalar(v[a + 1]);
      return result;
    };
    g.at = moved(drawn.at, is_planar ? 0.0 : 0.3);
    g.at[0] = g.at[0] + x;
    g.axis = {.direction = turned(drawn.axis.direction), .keyword = 0};
    g.second = {.direction = turned(drawn.second.direction), .keyword = 0};
    g.line_of_action = turned(drawn.line_of_action);
    g.pitch = Scalar(drawn.pitch) * (Scalar(1.0) + x);
    g.is_contact = drawn.is_contact;
    g.from = moved(drawn.from, 0.0);
    g.to = g.at;
    return g;
  };
  const auto screws_at = [&](auto x) {
    return coupling_screws(GetParam().type, GetParam().space, geometry_at(x));
  };
  constexpr double kStep = 1e-5;
  const auto dual = screws_at(make_variable(0.0, 0, 1));
  const auto before = screws_at(-kStep);
  const auto after = screws_at(kStep);

  const auto compare = [&](const auto& duals, const auto& lows, const auto& highs) {
    for (std::size_t i = 0; i < duals.size(); ++i) {
      const auto slope = duals[i].screw.coordinates();
      const Vec6 difference =
          (highs[i].screw.coordinates() - lows[i].screw.coordinates()) / (2.0 * kStep);
      for (int c = 0; c < 6; ++c) {
        EXPECT_NEAR(derivative(slope[c], 0), difference[c], 1e-8) << duals[i].name << " " << c;
      }
    }
  };
  compare(dual.freedoms, before.freedoms, after.freedoms);
  compare(dual.constraints, before.constraints, after.constraints);
}

}  // namespace
}  // namespace kinestat
