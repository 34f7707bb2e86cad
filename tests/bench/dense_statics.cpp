#include "dense_statics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "network/network_matrices.hpp"

// Solves A X = B by Gaussian elimination with partial pivoting, in place.
extern "C" void dgesv_(const int* n,
                       const int* nrhs,
                       double* A,
                       const int* lda,
                       int* pivots,
                       double* B,
                       const int* ldb,
                       int* info);

namespace kinestat::bench {

namespace {

constexpr double kAgreement = 1e-10;

}  // namespace

DenseStatics::DenseStatics(const Mechanism& mechanism,
                           const CoordinateBasis& basis,
                           const Case& which) {
  const Topology& topology = mechanism.topology;
  std::vector<std::string> primary;
  for (const Primary& one : which.actions) {
    primary.push_back(topology.action_name(one.index));
  }
  const LabelledMatrix A_N =
      action_matrices(topology, mechanism.geometry, mechanism.graph, basis).back();
  const std::vector<LabelledMatrix> parts = partition_of(A_N, primary);
  A_NS_ = parts[0].value;
  names_ = parts[0].columns;
  VecX known(static_cast<Eigen::Index>(primary.size()));
  for (Eigen::Index i = 0; i < known.size(); ++i) {
    const auto place = std::ranges::find(primary, parts[1].columns[static_cast<std::size_t>(i)]);
    known[i] = which.actions[static_cast<std::size_t>(place - primary.begin())].value;
  }
  right_ = -parts[1].value * known;
  pivots_.resize(names_.size());
}

void DenseStatics::solve() {
  copy();
  const int n = static_cast<int>(size());
  const int one = 1;
  int info = 0;
  dgesv_(&n, &one, A_.data(), &n, pivots_.data(), x_.data(), &n, &info);
  if (info != 0) {
    throw std::runtime_error("dgesv finds the statics singular");
  }
}

bool DenseStatics::agrees(const Topology& topology, const StaticSolution& solution) {
  solve();
  const double largest = x_.cwiseAbs().maxCoeff();
  for (int a = 0; a < topology.action_count(); ++a) {
    const auto place = std::ranges::find(names_, topology.action_name(a));
    if (place == names_.end()) {
      continue;
    }
    const double magnitude =
        solution.magnitudes.at(static_cast<std::size_t>(a)).value_or(std::nan(""));
    if (!(std::abs(magnitude - x_[place - names_.begin()]) <= kAgreement * largest)) {
      return false;
    }
  }
  return true;
}

}  // namespace kinestat::bench
