#include "property/network_case.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "network/network_matrices.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// The columns of the textbook matrix, which follow the tree, in the order of the Topology.
MatX in_file_order(const LabelledMatrix& matrix, const std::vector<std::string>& names) {
  MatX result(matrix.value.rows(), matrix.value.cols());
  EXPECT_EQ(names.size(), matrix.columns.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto at = std::ranges::find(matrix.columns, names[i]);
    EXPECT_NE(at, matrix.columns.end()) << names[i];
    result.col(static_cast<Eigen::Index>(i)) = matrix.value.col(at - matrix.columns.begin());
  }
  return result;
}

std::vector<std::string> freedom_names(const Topology& topology) {
  std::vector<std::string> names;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    names.push_back(topology.freedom_name(f));
  }
  return names;
}

std::vector<std::string> action_names(const Topology& topology) {
  std::vector<std::string> names;
  for (int a = 0; a < topology.action_count(); ++a) {
    names.push_back(topology.action_name(a));
  }
  return names;
}

MatX passive_columns(const Topology& topology, const MatX& A_N) {
  std::vector<int> passive;
  for (int a = 0; a < topology.action_count(); ++a) {
    if (topology.actions[static_cast<std::size_t>(a)].actuator < 0) {
      passive.push_back(a);
    }
  }
  return A_N(Eigen::all, passive);
}

Primary make_primary(int index, double value) {
  Primary primary;
  primary.index = index;
  primary.value = value;
  return primary;
}

// Adds random undetermined magnitudes one by one, at most three, then a completion.
template <class Check>
std::vector<Primary> choose_primaries(Random& random, const Check& check) {
  constexpr int kOneByOne = 3;
  std::vector<Primary> primaries;
  for (int i = 0; i < kOneByOne; ++i) {
    const PrimaryCheck found = check(primaries);
    if (found.candidates.empty()) {
      return primaries;
    }
    const int index = random.one_of(found.candidates);
    primaries.push_back(make_primary(index, random.magnitude()));
  }
  const PrimaryCheck found = check(primaries);
  if (found.missing == 0) {
    return primaries;
  }
  if (found.completions.empty()) {
    ADD_FAILURE() << "no completion is proposed where " << found.missing << " are missing";
    return primaries;
  }
  for (const int index : random.one_of(found.completions)) {
    primaries.push_back(make_primary(index, random.magnitude()));
  }
  return primaries;
}

template <class Screw>
Mat6X coupling_sums(const std::vector<Screw>& screws,
                    const Topology& topology,
                    const VecX& magnitudes,
                    int CouplingTopology::*first,
                    int CouplingTopology::*count) {
  Mat6X sums = Mat6X::Zero(6, topology.coupling_count());
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    for (int i = coupling.*first; i < coupling.*first + coupling.*count; ++i) {
      sums.col(e) += magnitudes[i] * screws[static_cast<std::size_t>(i)].coordinates();
    }
  }
  return sums;
}

}  // namespace

bool is_clear(const RankEvidence& evidence) {
  return evidence.gap() >= kLeastGap &&
         (evidence.rank == 0 || evidence.smallest_pivot >= kFlattest);
}

NetworkCase make_network_case(Mechanism mechanism) {
  const bool is_planar =
      mechanism.space == Space::planar && mechanism.static_order != OrderChoice::spatial;
  const OrderChoice order = is_planar ? OrderChoice::planar : OrderChoice::spatial;
  const CoordinateBasis twist_basis = motion_basis(mechanism.geometry, order);
  const CoordinateBasis wrench_basis = action_basis(mechanism.geometry, order);
  const Topology& topology = mechanism.topology;
  const auto motions = motion_matrices(topology, mechanism.geometry, mechanism.graph, twist_basis);
  const auto actions = action_matrices(topology, mechanism.geometry, mechanism.graph, wrench_basis);
  const MatX A_N = in_file_order(actions.back(), action_names(topology));
  MatX M_N = in_file_order(motions.back(), freedom_names(topology));
  MatX A_P = passive_columns(topology, A_N);
  return {.mechanism = std::move(mechanism),
          .twist_basis = twist_basis,
          .wrench_basis = wrench_basis,
          .M_N = std::move(M_N),
          .A_N = A_N,
          .A_P = std::move(A_P)};
}

bool couplings_are_complementary(const Mechanism& mechanism, int order) {
  const Topology& topology = mechanism.topology;
  return std::ranges::all_of(topology.couplings, [&](const CouplingTopology& coupling) {
    int passive = 0;
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      passive += topology.actions[static_cast<std::size_t>(a)].actuator < 0 ? 1 : 0;
    }
    return coupling.freedom_count + passive == order;
  });
}

std::vector<Primary> choose_motions(const NetworkCase& network, Random& random) {
  const Topology& topology = network.mechanism.topology;
  const SparseMatrix system =
      velocity_system(topology, network.mechanism.geometry, network.twist_basis);
  const int first = velocity_column(topology, network.twist_basis, 0);
  std::vector<double> rate_units;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    rate_units.push_back(rate_unit(topology, network.twist_basis, f));
  }
  return choose_primaries(random, [&](const std::vector<Primary>& primaries) {
    std::vector<int> columns;
    for (const Primary& primary : primaries) {
      columns.push_back(first + primary.index);
    }
    return check_primaries(Elimination(system, columns), first, rate_units);
  });
}

std::vector<Primary> choose_actions(const NetworkCase& network, Random& random) {
  const Topology& topology = network.mechanism.topology;
  const SparseMatrix system =
      action_system(topology, network.mechanism.geometry, network.wrench_basis);
  std::vector<double> action_units;
  for (int a = 0; a < topology.action_count(); ++a) {
    action_units.push_back(action_unit(topology, network.wrench_basis, a));
  }
  return choose_primaries(random, [&](const std::vector<Primary>& primaries) {
    std::vector<int> columns;
    for (const Primary& primary : primaries) {
      columns.push_back(primary.index);
    }
    return check_primaries(Elimination(system, columns), 0, action_units);
  });
}

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

Mat6X coupling_twists(const Mechanism& mechanism, const VecX& rates) {
  return coupling_sums(mechanism.geometry.motions,
                       mechanism.topology,
                       rates,
                       &CouplingTopology::first_freedom,
                       &CouplingTopology::freedom_count);
}

Mat6X coupling_wrenches(const Mechanism& mechanism, const VecX& magnitudes) {
  return coupling_sums(mechanism.geometry.actions,
                       mechanism.topology,
                       magnitudes,
                       &CouplingTopology::first_action,
                       &CouplingTopology::action_count);
}

VecX action_magnitudes(const Mechanism& mechanism,
                       const Mat6X& wrenches,
                       const std::vector<double>& internal) {
  const Topology& topology = mechanism.topology;
  VecX result = VecX::Zero(topology.action_count());
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    const CouplingTopology& coupling = topology.couplings[e];
    Vec6 rest = wrenches.col(static_cast<Eigen::Index>(e));
    Mat6X passive(6, 0);
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      const int actuator = topology.actions[static_cast<std::size_t>(a)].actuator;
      const Vec6 screw = mechanism.geometry.actions[static_cast<std::size_t>(a)].coordinates();
      if (actuator < 0) {
        passive.conservativeResize(Eigen::NoChange, passive.cols() + 1);
        passive.rightCols<1>() = screw;
      } else {
        result[a] = internal[static_cast<std::size_t>(actuator)];
        rest -= result[a] * screw;
      }
    }
    if (passive.cols() > 0) {
      // In units of the mechanism's length, so that the least squares weigh moments and forces
      // alike.
      const double length = mechanism.geometry.length;
      VecX units = VecX::Ones(passive.cols());
      for (Eigen::Index c = 0; c < units.size(); ++c) {
        const auto a = static_cast<std::size_t>(coupling.first_action + c);
        units[c] = topology.actions[a].is_couple ? length : 1.0;
      }
      passive.topRows<3>() /= length;
      rest.head<3>() /= length;
      const Eigen::ColPivHouseholderQR<MatX> qr(passive * units.asDiagonal());
      result.segment(coupling.first_action, passive.cols()) =
          units.cwiseProduct(VecX(qr.solve(rest)));
    }
  }
  return result;
}

VecX solve_partition(const MatX& N, const std::vector<Primary>& primaries) {
  VecX result = VecX::Zero(N.cols());
  std::vector<int> secondary;
  for (const Primary& primary : primaries) {
    result[primary.index] = primary.value;
  }
  for (int c = 0; c < N.cols(); ++c) {
    if (std::ranges::find(primaries, c, &Primary::index) == primaries.end()) {
      secondary.push_back(c);
    }
  }
  if (secondary.empty() || N.rows() == 0) {
    return result;
  }
  const VecX right = -N * result;
  const MatX N_S = N(Eigen::all, secondary);
  const Eigen::ColPivHouseholderQR<MatX> qr(N_S);
  const VecX solved = qr.solve(right);
  for (std::size_t i = 0; i < secondary.size(); ++i) {
    result[secondary[i]] = solved[static_cast<Eigen::Index>(i)];
  }
  return result;
}

double size_of(const MatX& values) {
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

}  // namespace kinestat
