#include "statics/one_sided_action.hpp"

#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "statics/action.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

// A foot on a floor; beside it, and with nothing in common, a press of 2e11 N.
const char* const kFootBesidePress =
    "space: planar\n"
    "ground: frame\n"
    "bodies: [foot, press]\n"
    "couplings:\n"
    "  p: {type: prismatic, bodies: [frame, foot], at: [0, 0], axis: y}\n"
    "  k: {type: point_contact, bodies: [frame, foot], at: [0, 0], normal: y}\n"
    "  q: {type: prismatic, bodies: [frame, press], at: [5, 0], axis: y}\n"
    "actuators:\n"
    "  big: {coupling: q}\n"
    "loads:\n"
    "  lift: {body: foot, at: [0, 0], force: [0, 0.001]}\n"
    "  press: {body: press, at: [5, 0], force: [0, -200000000000]}\n"
    "cases:\n"
    "  one: {action: {}}\n";

struct Foot {
  Mechanism mechanism = mechanism_of(kFootBesidePress);
  StaticSolution solution;
  int contact = find_contact_forces(mechanism.topology).front();

  Foot() {
    const Case& which = mechanism.cases.front();
    const std::vector<BodyWrench> loads = wrenches_of(which.loads);
    solution = solve_action(mechanism,
                            action_basis(mechanism.geometry, OrderChoice::minimal, loads),
                            which.actions,
                            loads);
    EXPECT_EQ(solution.status, SolveStatus::solved);
  }

  std::vector<int> pulling() const { return find_pulling_contacts(mechanism, solution); }
};

// The floor would have to pull with the millinewton that lifts the foot.
TEST(PullingContacts, DoNotDependOnOtherForces) {
  const Foot foot;

  EXPECT_EQ(foot.solution.magnitudes[static_cast<std::size_t>(foot.contact)], -0.001);
  EXPECT_EQ(foot.pulling(), std::vector{foot.contact});
}

TEST(PullingContacts, AreNoneWhereTheForceMayBeZero) {
  Foot foot;
  foot.solution.answer.bounds.assign(foot.solution.magnitudes.size(), 0.002);

  EXPECT_TRUE(foot.pulling().empty());
}

TEST(PullingContacts, AreNoneWhereTheForceIsNotKnown) {
  Foot foot;
  foot.solution.magnitudes[static_cast<std::size_t>(foot.contact)] = std::nullopt;

  EXPECT_TRUE(foot.pulling().empty());
}

}  // namespace
}  // namespace kinestat
