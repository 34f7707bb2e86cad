#include "studies/sensitivity/internal/compatibility.hpp"

#include <cmath>
#include <iterator>
#include <utility>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Of each action, as functions of the parameters.
std::vector<Dual> compliances_of(const DualCase& values) {
  const MechanismDerivatives& derivatives = values.derivatives();
  if (values.mechanism().indeterminate == IndeterminateChoice::stiffness) {
    return derivatives.compliances;
  }
  std::vector<Dual> result;
  for (const ActionLabel& action : values.topology().actions) {
    result.push_back(action.is_couple ? Dual(1.0) / (derivatives.length * derivatives.length)
                                      : Dual(1.0));
  }
  return result;
}

Sum product(const std::vector<double>& a, const std::vector<double>& b) {
  Sum sum;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum.add(a[i] * b[i]);
  }
  return sum;
}

// What the parameter takes from the work of the self-stress on the elongations, by compliances that
// change: -Nᵀ dC ψ.
Sum compliance_gap(const std::vector<double>& stress,
                   const std::vector<Dual>& compliances,
                   const std::vector<double>& magnitudes,
                   std::size_t parameter) {
  Sum gap;
  for (std::size_t a = 0; a < magnitudes.size(); ++a) {
    if (stress[a] != 0.0 && magnitudes[a] != 0.0) {
      gap.add(-stress[a] * derivative(compliances[a], parameter) * magnitudes[a]);
    }
  }
  return gap;
}

// √C N.
MatX weighted_columns(const std::vector<std::vector<double>>& stresses,
                      const std::vector<double>& compliances) {
  MatX result(std::ssize(compliances), std::ssize(stresses));
  for (std::size_t s = 0; s < stresses.size(); ++s) {
    for (std::size_t a = 0; a < compliances.size(); ++a) {
      result(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(s)) =
          std::sqrt(compliances[a]) * stresses[s][a];
    }
  }
  return result;
}

}  // namespace

Compatibility::Compatibility(const DualCase& values,
                             const FactoredSide& equations,
                             const std::vector<double>& magnitudes,
                             const ParameterChanges& changes)
    : is_stressed_(values.parameter_count(), false) {
  const std::vector<Dual> compliances = compliances_of(values);
  std::vector<double> shortenings;
  for (std::size_t a = 0; a < magnitudes.size(); ++a) {
    compliances_.push_back(compliances[a].value);
    shortenings.push_back(-compliances_[a] * magnitudes[a]);
  }
  const AdjointSolution displacements = equations.solve_adjoint(shortenings);
  for (std::size_t s = 0; s < changes.by_open.size(); ++s) {
    const bool is_completed = s < changes.completed_count;
    if (is_completed) {
      stresses_.push_back(changes.open[s]);
      gaps_.emplace_back();
      is_lost_.emplace_back();
    }
    for (std::size_t p = 0; p < values.parameter_count(); ++p) {
      const Change& change = changes.by_open[s][p];
      if (is_completed) {
        gaps_[s].push_back(compliance_gap(stresses_[s], compliances, magnitudes, p));
        kinestat::add(displacements, change, gaps_[s].back());
        is_lost_[s].push_back(!equations.allows(change));
      } else {
        is_stressed_[p] = is_stressed_[p] || moves(displacements, change);
      }
    }
  }
  equations_ = NormalEquations(weighted_columns(stresses_, compliances_));
}

VecX Compatibility::shares(const std::vector<double>& slopes) const {
  VecX work(std::ssize(stresses_));
  for (Eigen::Index s = 0; s < work.size(); ++s) {
    work[s] = product(stresses_[static_cast<std::size_t>(s)], slopes).rounded();
  }
  // With C all columns of N are of similar size, so that shares compare.
  const VecX shares = equations_.solve(std::move(work));
  const double rounding = kCancellation * shares.cwiseAbs().maxCoeff();
  return (shares.array().abs() <= rounding).select(0.0, shares);
}

std::vector<double> Compatibility::remaining(const std::vector<double>& slopes,
                                             const VecX& shares) const {
  std::vector<double> result;
  for (std::size_t a = 0; a < slopes.size(); ++a) {
    Sum sum;
    sum.add(slopes[a]);
    for (std::size_t s = 0; s < stresses_.size(); ++s) {
      sum.add(-compliances_[a] * stresses_[s][a] * shares[static_cast<Eigen::Index>(s)]);
    }
    result.push_back(sum.rounded());
  }
  return result;
}

bool Compatibility::allows(const VecX& shares, std::size_t parameter) const {
  for (std::size_t s = 0; s < stresses_.size(); ++s) {
    const bool is_in_use = shares[static_cast<Eigen::Index>(s)] != 0.0;
    if (is_in_use && (is_lost_[s][parameter] || is_stressed_[parameter])) {
      return false;
    }
  }
  return true;
}

void Compatibility::add(const VecX& shares, std::size_t parameter, Sum& sum) const {
  for (std::size_t s = 0; s < stresses_.size(); ++s) {
    const double share = shares[static_cast<Eigen::Index>(s)];
    if (share != 0.0) {
      const Sum& gap = gaps_[s][parameter];
      sum.value += share * gap.value;
      sum.size += std::abs(share) * gap.size;
    }
  }
}

}  // namespace kinestat
