#include "property/network_answers.hpp"

#include <utility>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include "network/node_system.hpp"

namespace kinestat {

namespace {

template <class Screw>
Mat6X coupling_sums(const std::vector<Screw>& screws,
                    const Mechanism& mechanism,
                    const VecX& magnitudes,
                    std::pair<int CouplingTopology::*, int CouplingTopology::*> range) {
  const Topology& topology = mechanism.topology;
  Mat6X sums(6, topology.coupling_count());
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    Screw sum;
    for (int i = coupling.*range.first; i < coupling.*range.first + coupling.*range.second; ++i) {
      sum = sum + magnitudes[i] * screws[static_cast<std::size_t>(i)];
    }
    sums.col(e) = about_world<double>(sum, mechanism.geometry.origin).coordinates();
  }
  return sums;
}

// In a basis of the network, about the mechanism's origin.
template <class Screw>
VecX in_basis(const Vec6& screw, const CoordinateBasis& basis, const Vec3& origin) {
  return basis.coordinates_of(
      about_world<double>(Screw::from_coordinates(screw), -origin).coordinates());
}

VecX fit(const MatX& columns, const VecX& target) {
  if (columns.cols() == 0) {
    return VecX::Zero(0);
  }
  return columns.colPivHouseholderQr().solve(target);
}

}  // namespace

VecX rates_of(const KinematicSolution& solution) {
  return Eigen::Map<const VecX>(solution.rates.data(),
                                static_cast<Eigen::Index>(solution.rates.size()));
}

VecX magnitudes_of(const StaticSolution& solution) {
  VecX result(static_cast<Eigen::Index>(solution.magnitudes.size()));
  for (Eigen::Index a = 0; a < result.size(); ++a) {
    const std::optional<double>& magnitude = solution.magnitudes[static_cast<std::size_t>(a)];
    EXPECT_TRUE(magnitude.has_value()) << "action " << a;
    result[a] = magnitude.value_or(0.0);
  }
  return result;
}

Mat6X body_twists(const Mechanism& mechanism, const KinematicSolution& solution) {
  Mat6X result(6, static_cast<Eigen::Index>(solution.bodies.size()));
  for (Eigen::Index b = 0; b < result.cols(); ++b) {
    const Twist& twist = solution.bodies[static_cast<std::size_t>(b)];
    result.col(b) = about_world<double>(twist, mechanism.geometry.origin).coordinates();
  }
  return result;
}

Mat6X coupling_twists(const Mechanism& mechanism, const VecX& rates) {
  return coupling_sums(mechanism.geometry.motions,
                       mechanism,
                       rates,
                       {&CouplingTopology::first_freedom, &CouplingTopology::freedom_count});
}

Mat6X coupling_wrenches(const Mechanism& mechanism, const VecX& magnitudes) {
  return coupling_sums(mechanism.geometry.actions,
                       mechanism,
                       magnitudes,
                       {&CouplingTopology::first_action, &CouplingTopology::action_count});
}

Mat6X internal_wrenches(const Mechanism& mechanism, const VecX& magnitudes) {
  const std::vector<ActuatorTopology>& actuators = mechanism.topology.actuators;
  Mat6X result(6, static_cast<Eigen::Index>(actuators.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const int action = actuators[static_cast<std::size_t>(i)].action;
    const Wrench wrench =
        magnitudes[action] * mechanism.geometry.actions[static_cast<std::size_t>(action)];
    result.col(i) = about_world<double>(wrench, mechanism.geometry.origin).coordinates();
  }
  return result;
}

VecX freedom_rates(const NetworkCase& network, const Mat6X& twists) {
  const Topology& topology = network.mechanism.topology;
  const Geometry& geometry = network.mechanism.geometry;
  const CoordinateBasis& basis = network.twist_basis;
  VecX result(topology.freedom_count());
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    MatX columns(basis.order(), coupling.freedom_count);
    VecX units(coupling.freedom_count);
    for (int i = 0; i < coupling.freedom_count; ++i) {
      const int f = coupling.first_freedom + i;
      units[i] = rate_unit(topology, basis, f);
      columns.col(i) = units[i] * basis.coordinates_of(
                                      geometry.motions[static_cast<std::size_t>(f)].coordinates());
    }
    const VecX x = fit(columns, in_basis<Twist>(twists.col(e), basis, geometry.origin));
    result.segment(coupling.first_freedom, coupling.freedom_count) = units.cwiseProduct(x);
  }
  return result;
}

VecX action_magnitudes(const NetworkCase& network, const Mat6X& wrenches, const Mat6X& internal) {
  const Topology& topology = network.mechanism.topology;
  const Geometry& geometry = network.mechanism.geometry;
  const CoordinateBasis& basis = network.wrench_basis;
  VecX result(topology.action_count());
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    VecX rest = in_basis<Wrench>(wrenches.col(e), basis, geometry.origin);
    MatX passive(basis.order(), 0);
    VecX units(coupling.action_count);
    for (int i = 0; i < coupling.action_count; ++i) {
      const int a = coupling.first_action + i;
      const int actuator = topology.actions[static_cast<std::size_t>(a)].actuator;
      units[i] = action_unit(topology, basis, a);
      const VecX column =
          units[i] *
          basis.coordinates_of(geometry.actions[static_cast<std::size_t>(a)].coordinates());
      if (actuator < 0) {
        passive.conservativeResize(Eigen::NoChange, i + 1);
        passive.col(i) = column;
      } else {
        const VecX part = in_basis<Wrench>(internal.col(actuator), basis, geometry.origin);
        result[a] = units[i] * fit(column, part)[0];
        rest -= part;
      }
    }
    const Eigen::Index count = passive.cols();
    result.segment(coupling.first_action, count) =
        units.head(count).cwiseProduct(fit(passive, rest));
  }
  return result;
}

}  // namespace kinestat
