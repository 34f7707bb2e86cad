#include "property/network_answers.hpp"

#include <utility>

#include <Eigen/QR>
#include <gtest/gtest.h>

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

// Finds the magnitudes of unit screws of a coupling from their sum.
template <class Screw>
class Fit {
 public:
  Fit(const Mechanism& mechanism, double length)
      : origin_(mechanism.geometry.origin),
        length_(length > 0.0 ? length : mechanism.geometry.length) {}

  void add(const Screw& unit) {
    columns_.conservativeResize(Eigen::NoChange, columns_.cols() + 1);
    columns_.rightCols<1>() = weighed(unit);
  }

  // By least squares of columns of equal length; `sum` is about the world origin.
  VecX magnitudes(const Vec6& sum) const {
    if (columns_.cols() == 0) {
      return VecX::Zero(0);
    }
    const VecX sizes = columns_.colwise().norm();
    const MatX normalised = columns_ * sizes.cwiseInverse().asDiagonal();
    const Vec6 target =
        weighed(about_world<double>(Screw::from_coordinates(sum), LocalOrigin(-origin_.place())));
    return VecX(normalised.colPivHouseholderQr().solve(target)).cwiseQuotient(sizes);
  }

 private:
  Vec6 weighed(const Twist& twist) const {
    return Twist{.angular = twist.angular, .linear = twist.linear / length_}.coordinates();
  }

  Vec6 weighed(const Wrench& wrench) const {
    return Wrench{.moment = wrench.moment / length_, .force = wrench.force}.coordinates();
  }

  LocalOrigin origin_;
  double length_;
  Mat6X columns_ = Mat6X(6, 0);
};

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

VecX freedom_rates(const NetworkCase& network, const Mat6X& twists, double length) {
  const Topology& topology = network.mechanism.topology;
  VecX result(topology.freedom_count());
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    Fit<Twist> fit(network.mechanism, length);
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      fit.add(network.mechanism.geometry.motions[static_cast<std::size_t>(f)]);
    }
    result.segment(coupling.first_freedom, coupling.freedom_count) = fit.magnitudes(twists.col(e));
  }
  return result;
}

VecX action_magnitudes(const NetworkCase& network,
                       const Mat6X& wrenches,
                       const Mat6X& internal,
                       double length) {
  const Topology& topology = network.mechanism.topology;
  const std::vector<Wrench>& screws = network.mechanism.geometry.actions;
  VecX result(topology.action_count());
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    Vec6 rest = wrenches.col(e);
    Fit<Wrench> passive(network.mechanism, length);
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      const Wrench& screw = screws[static_cast<std::size_t>(a)];
      const int actuator = topology.actions[static_cast<std::size_t>(a)].actuator;
      if (actuator < 0) {
        passive.add(screw);
      } else {
        Fit<Wrench> alone(network.mechanism, length);
        alone.add(screw);
        result[a] = alone.magnitudes(internal.col(actuator))[0];
        rest -= internal.col(actuator);
      }
    }
    result.segment(coupling.first_action, passive_count(topology, coupling)) =
        passive.magnitudes(rest);
  }
  return result;
}

}  // namespace kinestat
