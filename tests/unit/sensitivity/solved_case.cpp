#include "sensitivity/solved_case.hpp"

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "io/yaml_tree.hpp"
#include "kinematics/velocity.hpp"
#include "mechanism/bind/bind.hpp"
#include "network/bases.hpp"
#include "statics/friction_solve.hpp"
#include "statics/indeterminacy.hpp"
#include "support/read_text.hpp"

namespace kinestat {

namespace {

// With friction, if there is any, and completed if the file asks for it.
StaticSolution solve_statics(const Mechanism& mechanism, const KinematicSolution& motion) {
  std::vector<FrictionLaw> laws;
  for (const auto& law : find_friction_laws(mechanism, mechanism.cases.front(), motion)) {
    laws.push_back(law.value());
  }
  const Case& which = mechanism.cases.front();
  const std::vector<BodyWrench> loads = wrenches_of(which.loads);
  const CoordinateBasis basis = action_basis(mechanism.geometry, OrderChoice::minimal, loads);
  return resolve_indeterminacy(mechanism,
                               basis,
                               which.actions,
                               loads,
                               solve_with_friction(mechanism, basis, which.actions, loads, laws));
}

}  // namespace

Solved::Solved(const std::string& text) {
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, found);
  description = read_mechanism(root.value(), found).value_or(MechanismDescription{});
  auto bound = bind(description, found);
  EXPECT_EQ(complaints_of(found), Complaints{});
  mechanism = std::move(bound).value();
  std::vector<int> all;
  for (std::size_t i = 0; i < description.parameters.size(); ++i) {
    all.push_back(static_cast<int>(i));
  }
  derivatives = bind_derivatives(description, mechanism, all);
  const Case& which = mechanism.cases.front();
  motion = solve_velocity(
      mechanism, motion_basis(mechanism.geometry, OrderChoice::minimal), which.motions);
  action = solve_statics(mechanism, motion);
}

DualCase Solved::values() const {
  return {mechanism,
          0,
          motion.status == SolveStatus::solved ? &motion : nullptr,
          action.magnitudes.empty() ? nullptr : &action,
          derivatives};
}

std::vector<std::optional<double>> Solved::derivatives_of(const std::string& name) const {
  const DualCase dual = values();
  const AdjointBases bases = find_adjoint_bases(mechanism, derivatives);
  CaseAdjoint adjoint(dual, bases);
  return adjoint.derivatives_of(find_reported_value(dual, name).value());
}

}  // namespace kinestat
