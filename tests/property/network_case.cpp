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

// Adds up to two random undetermined magnitudes one by one, then a completion.
template <class Check>
std::vector<Primary> choose_primaries(Random& random, const Check& check) {
  std::vector<Primary> primaries;
  PrimaryCheck found = check(primaries);
  for (int i = random.whole(0, 2); i > 0 && !found.candidates.empty(); --i) {
    const int index = random.one_of(found.candidates);
    primaries.push_back(make_primary(index, random.magnitude()));
    found = check(primaries);
  }
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

// What is proposed to be removed from up to three primaries too many leaves independent ones.
template <class Check>
void expect_good_removals(std::vector<Primary> primaries, int count, const Check& check) {
  const std::size_t right = primaries.size();
  for (int index = 0; index < count && primaries.size() < right + 3; ++index) {
    if (std::ranges::find(primaries, index, &Primary::index) == primaries.end()) {
      primaries.push_back(make_primary(index, 1.0));
    }
  }
  const PrimaryCheck found = check(primaries);
  EXPECT_EQ(found.removals.empty(), found.dependences.empty());
  for (const std::vector<int>& removal : found.removals) {
    EXPECT_EQ(removal.size(), found.dependences.size());
    std::vector<Primary> rest = primaries;
    std::erase_if(rest, [&](const Primary& one) {
      return std::ranges::find(removal, one.index) != removal.end();
    });
    const PrimaryCheck after = check(rest);
    EXPECT_TRUE(after.dependences.empty());
    EXPECT_EQ(after.missing, found.missing);
  }
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

int passive_count(const Topology& topology, const CouplingTopology& coupling) {
  int count = 0;
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    count += topology.actions[static_cast<std::size_t>(a)].actuator < 0 ? 1 : 0;
  }
  return count;
}

bool couplings_are_complementary(const Mechanism& mechanism, int order) {
  const Topology& topology = mechanism.topology;
  return std::ranges::all_of(topology.couplings, [&](const CouplingTopology& coupling) {
    return coupling.freedom_count + passive_count(topology, coupling) == order;
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
  const auto check = [&](const std::vector<Primary>& primaries) {
    std::vector<int> columns;
    for (const Primary& primary : primaries) {
      columns.push_back(first + primary.index);
    }
    return check_primaries(Elimination(system, columns), {.first_column = first}, rate_units);
  };
  std::vector<Primary> chosen = choose_primaries(random, check);
  expect_good_removals(chosen, topology.freedom_count(), check);
  return chosen;
}

std::vector<Primary> choose_actions(const NetworkCase& network, Random& random) {
  const Topology& topology = network.mechanism.topology;
  const SparseMatrix system =
      action_system(topology, network.mechanism.geometry, network.wrench_basis);
  std::vector<double> action_units;
  for (int a = 0; a < topology.action_count(); ++a) {
    action_units.push_back(action_unit(topology, network.wrench_basis, a));
  }
  const auto check = [&](const std::vector<Primary>& primaries) {
    std::vector<int> columns;
    for (const Primary& primary : primaries) {
      columns.push_back(primary.index);
    }
    return check_primaries(Elimination(system, columns), {}, action_units);
  };
  std::vector<Primary> chosen = choose_primaries(random, check);
  expect_good_removals(chosen, topology.action_count(), check);
  return chosen;
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
