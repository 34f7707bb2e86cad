#include "power/power_graph.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// Three bodies that move along x at 1, 2 and 4 m/s, joined in a ring by couplings that push with
// 10, 20 and 7.5 N.
class Ring : public ::testing::Test {
 protected:
  Ring() {
    for (const char* name : {"ground", "one", "two", "three"}) {
      mechanism_.topology.bodies.push_back({.name = name, .where = {}});
    }
    motion_.bodies = {{}, moving(1.0), moving(2.0), moving(4.0)};
    join("a", 1, 2, 10.0);
    join("b", 2, 3, 20.0);
    join("c", 3, 1, 7.5);
  }

  static Twist moving(double speed) { return speed * unit_translation(Vec3::UnitX()); }

  // A coupling whose force along x transmits that power to the head and takes it from the tail: as
  // the two move differently, the coupling itself gives or takes the difference.
  void join(const std::string& name, int tail, int head, double force) {
    CouplingTopology coupling;
    coupling.name = name;
    coupling.type = CouplingType::prismatic;
    coupling.tail = BodyId{tail};
    coupling.head = BodyId{head};
    mechanism_.topology.couplings.push_back(coupling);
    const Wrench wrench = force * unit_force(Vec3::UnitX(), Vec3::Zero());
    action_.wrenches.emplace_back(wrench);
    flow_.into_head.emplace_back(power(wrench, motion_.bodies[static_cast<std::size_t>(head)]));
    flow_.out_of_tail.emplace_back(power(wrench, motion_.bodies[static_cast<std::size_t>(tail)]));
  }

  PowerGraph graph() const { return find_power_graph(mechanism_, which_, motion_, action_, flow_); }

  Mechanism mechanism_;
  Case which_;
  KinematicSolution motion_;
  StaticSolution action_;
  PowerFlow flow_;
};

TEST_F(Ring, HandsOnTheLesserOfWhatLeavesAndWhatArrives) {
  const PowerGraph result = graph();

  ASSERT_EQ(result.arcs.size(), 3U);
  EXPECT_EQ(result.arcs[0].power, 10.0);  // 10 N at 1 m/s, of 20 W that arrive
  EXPECT_EQ(result.arcs[1].power, 40.0);
  EXPECT_EQ(result.arcs[2].power, 7.5);  // of 30 W that leave
}

TEST_F(Ring, SumsWhatEveryBodyReceivesAndGives) {
  const PowerGraph result = graph();

  EXPECT_EQ(result.bodies[1]->received, 7.5);
  EXPECT_EQ(result.bodies[1]->given, 10.0);
  EXPECT_EQ(result.bodies[2]->received, 20.0);
  EXPECT_EQ(result.bodies[2]->given, 40.0);
}

TEST_F(Ring, IsALoopInTheSenseOfTheFlow) {
  const PowerGraph result = graph();

  ASSERT_EQ(result.circulating.size(), 1U);
  EXPECT_EQ(result.circulating[0].bodies, std::vector<BodyId>({BodyId{1}, BodyId{2}, BodyId{3}}));
  EXPECT_EQ(result.circulating[0].arcs, std::vector<std::size_t>({0, 1, 2}));
  EXPECT_FALSE(result.circulating[0].rolls);
}

TEST_F(Ring, IsNoLoopWhereACouplingPullsTheOtherWay) {
  action_.wrenches[2] = -1.0 * *action_.wrenches[2];
  flow_.into_head[2] = -*flow_.into_head[2];
  flow_.out_of_tail[2] = -*flow_.out_of_tail[2];

  const PowerGraph result = graph();

  EXPECT_EQ(result.arcs[2].from, BodyId{1});
  EXPECT_EQ(result.arcs[2].to, BodyId{3});
  EXPECT_TRUE(result.circulating.empty());
}

TEST_F(Ring, HasNoArcThroughACouplingThatFeedsBothSidesOrNeither) {
  motion_.bodies[3] = moving(-4.0);
  flow_.into_head[1] = -80.0;
  flow_.out_of_tail[2] = -30.0;

  const PowerGraph result = graph();

  for (const PowerArc& arc : result.arcs) {
    EXPECT_EQ(arc.coupling, CouplingId{0});
  }
}

// A belt with the strands "a" of 10 W and "d" of 4 N back at 2 m/s.
TEST_F(Ring, CountsTheStrandsOfABeltAsOne) {
  join("d", 2, 1, 4.0);
  for (const std::size_t strand : {0U, 3U}) {
    mechanism_.topology.couplings[strand].type = CouplingType::cable;
  }
  mechanism_.topology.couplings.erase(mechanism_.topology.couplings.begin() + 1,
                                      mechanism_.topology.couplings.begin() + 3);
  action_.wrenches.erase(action_.wrenches.begin() + 1, action_.wrenches.begin() + 3);
  for (auto* powers : {&flow_.into_head, &flow_.out_of_tail}) {
    powers->erase(powers->begin() + 1, powers->begin() + 3);
  }
  flow_.input = 6.0;

  const PowerGraph result = graph();

  EXPECT_EQ(result.arcs.size(), 2U);
  EXPECT_TRUE(result.circulating.empty());
  EXPECT_EQ(result.recirculation, 1.0);  // 10 - 4 of 6 W
}

TEST_F(Ring, HasAFactorOnlyWithAnInput) {
  EXPECT_FALSE(graph().recirculation.has_value());
  flow_.input = 16.0;
  EXPECT_EQ(graph().recirculation, 2.5);
}

TEST_F(Ring, LeavesOpenWhatAnOpenWrenchTouches) {
  action_.wrenches[1] = std::nullopt;
  flow_.into_head[1] = std::nullopt;

  const PowerGraph result = graph();

  EXPECT_EQ(result.arcs.size(), 2U);
  EXPECT_TRUE(result.bodies[1].has_value());
  EXPECT_FALSE(result.bodies[2].has_value());
  EXPECT_FALSE(result.bodies[3].has_value());
}

// A millionth of a millionth of the power of the others is power, too.
TEST_F(Ring, HandsOnSmallPowers) {
  join("d", 1, 3, 1e-12);

  const PowerGraph result = graph();

  ASSERT_EQ(result.arcs.size(), 4U);
  EXPECT_DOUBLE_EQ(result.arcs[3].power, 1e-12);
  EXPECT_EQ(result.net.size(), 4U);
}

// Powers whose product is less than the smallest number.
TEST_F(Ring, HandsOnPowersHoweverSmall) {
  join("d", 1, 3, 1e-170);

  ASSERT_EQ(graph().arcs.size(), 4U);
  EXPECT_DOUBLE_EQ(graph().arcs[3].power, 1e-170);
}

// Strands that give back what they take, but for rounding: 0.1 + 0.2 and 0.3 N.
TEST_F(Ring, HasNoNetPowerWhereStrandsBalance) {
  mechanism_.topology.couplings.clear();
  action_.wrenches.clear();
  flow_.into_head.clear();
  flow_.out_of_tail.clear();
  motion_.bodies[2] = moving(1.0);
  join("there", 1, 2, 0.1 + 0.2);
  join("back", 2, 1, 0.3);
  for (CouplingTopology& strand : mechanism_.topology.couplings) {
    strand.type = CouplingType::cable;
  }

  EXPECT_EQ(graph().arcs.size(), 2U);
  EXPECT_TRUE(graph().net.empty());
}

}  // namespace
}  // namespace kinestat
