#include "studies/sensitivity/internal/friction_slopes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "math/dense/dense_solve.hpp"
#include "studies/sensitivity/internal/friction_force.hpp"

namespace kinestat {

namespace {

// Towards the parameter with the rates, the actions and frictions staying as they are.
Sum direct_sum(const DualCase& values, const RateSlopes& rates, const Dual& value, std::size_t p) {
  Sum sum;
  sum.add(derivative(value, values.first_parameter() + p));
  if (!rates.empty() && rates[p]) {
    for (std::size_t f = 0; f < rates[p]->size(); ++f) {
      sum.add(derivative(value, f) * (*rates[p])[f]);
    }
  }
  return sum;
}

// With derivatives towards the parameters alone. What is rounding beside the other components is
// zero.
Vec3Of<Dual> by_parameters(const DualCase& values,
                           const RateSlopes& rates,
                           const Vec3Of<Dual>& vector) {
  Vec3Of<Dual> result(vector[0].value, vector[1].value, vector[2].value);
  for (std::size_t p = 0; p < values.parameter_count(); ++p) {
    std::array<Sum, 3> sums;
    double size = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      sums[i] = direct_sum(values, rates, vector[static_cast<Eigen::Index>(i)], p);
      size = std::max(size, sums[i].size);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      sums[i].size = size;
      result[static_cast<Eigen::Index>(i)].derivatives.push_back(sums[i].rounded());
    }
  }
  return result;
}

WrenchOf<Dual> by_parameters(const DualCase& values,
                             const RateSlopes& rates,
                             const WrenchOf<Dual>& wrench) {
  return {.moment = by_parameters(values, rates, wrench.moment),
          .force = by_parameters(values, rates, wrench.force)};
}

// The frictions by one parameter after the other.
class FrictionChain {
 public:
  FrictionChain(const DualCase& values,
                const CoordinateBasis& basis,
                const RateSlopes& rates,
                std::vector<FrictionForce> forces)
      : values_(values), basis_(basis), rates_(rates), forces_(std::move(forces)) {
    const auto count = static_cast<Eigen::Index>(forces_.size());
    system_ = MatX::Identity(count, count);
    for (Eigen::Index r = 0; r < count; ++r) {
      for (Eigen::Index c = 0; c < count; ++c) {
        Sum by_other;
        add(at(r).magnitude.adjoint, at(c).push, by_other);
        system_(r, c) -= by_other.rounded();
      }
    }
  }

  // Of the direction of each friction, as far as the parameters turn it.
  void add_turns(std::vector<Change>& changes) const {
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      add_pair_changes(values_.topology().coupling(forces_[i].coupling),
                       by_parameters(values_, rates_, values_.friction_law(i).unit),
                       values_.friction(i).value,
                       basis_,
                       changes);
    }
  }

  // f - law(ψ(f)) = 0 differentiated; adds to the change what the frictions do. Empty where a
  // friction has no derivative.
  std::vector<double> slopes_by(std::size_t p, ParameterChanges& changes) const {
    VecX right(system_.rows());
    for (Eigen::Index i = 0; i < right.size(); ++i) {
      right[i] = slope(at(i).magnitude, p, changes.total[p]);
    }
    const std::optional<VecX> slopes = solve_dense(system_, right);
    if (!slopes || !has_rates(p)) {
      return {};
    }
    Change& change = changes.total[p];
    for (Eigen::Index i = 0; i < slopes->size(); ++i) {
      for (const auto& [row, size] : at(i).push.rows) {
        change.rows.emplace_back(row, size * (*slopes)[i]);
      }
    }
    const bool is_smooth = std::ranges::none_of(forces_, [&](const FrictionForce& one) {
      return shows_open(one.magnitude, p, changes) || leaves_corner(one, p, changes);
    });
    return is_smooth ? std::vector<double>(slopes->begin(), slopes->end()) : std::vector<double>();
  }

 private:
  const FrictionForce& at(Eigen::Index i) const { return forces_[static_cast<std::size_t>(i)]; }

  bool has_rates(std::size_t p) const { return rates_.empty() || rates_[p].has_value(); }

  double direct_slope(const Dual& value, std::size_t p) const {
    return direct_sum(values_, rates_, value, p).rounded();
  }

  double slope(const Made& made, std::size_t p, const Change& change) const {
    Sum sum;
    sum.add(direct_slope(made.value, p));
    add(made.adjoint, change, sum);
    return sum.rounded();
  }

  bool shows_open(const Made& made, std::size_t p, const ParameterChanges& changes) const {
    for (std::size_t s = 0; s < made.open.size(); ++s) {
      if (moves(made.adjoint, changes.by_open[s][p], direct_slope(made.open[s], p))) {
        return true;
      }
    }
    return false;
  }

  bool leaves_corner(const FrictionForce& one,
                     std::size_t p,
                     const ParameterChanges& changes) const {
    return std::ranges::any_of(one.corners, [&](const Made& force) {
      return shows_open(force, p, changes) ||
             moves(force.adjoint, changes.total[p], direct_slope(force.value, p));
    });
  }

  const DualCase& values_;
  const CoordinateBasis& basis_;
  const RateSlopes& rates_;
  std::vector<FrictionForce> forces_;
  MatX system_;  ///< d(f - law)/df
};

}  // namespace

bool friction_depends_on_rates(const DualCase& values) {
  const std::size_t rates = values.topology().freedoms.size();
  const auto depends = [&](const Dual& number) {
    return !number.derivatives.empty() &&
           std::any_of(number.derivatives.begin(),
                       number.derivatives.begin() + static_cast<std::ptrdiff_t>(rates),
                       [](double slope) { return slope != 0.0; });
  };
  const auto law_depends = [&](const FrictionLawOf<Dual>& law) {
    return depends(law.constant) || std::ranges::any_of(law.unit.moment, depends) ||
           std::ranges::any_of(law.unit.force, depends);
  };
  for (std::size_t i = 0; i < values.friction_count(); ++i) {
    if (law_depends(values.friction_law(i))) {
      return true;
    }
  }
  return std::ranges::any_of(values.action()->open_friction, [&](CouplingId coupling) {
    return law_depends(values.law_of(coupling));
  });
}

void add_open_frictions(const DualCase& values,
                        const FactoredSide& equations,
                        const RateSlopes& rates,
                        ParameterChanges& changes) {
  for (const CouplingId id : values.action()->open_friction) {
    const CouplingTopology& coupling = values.topology().coupling(id);
    const WrenchOf<Dual> unit = values.law_of(id).unit;
    Change push;
    push.known.assign(values.which().actions.size(), 0.0);
    add_pair(coupling, values_of(unit), equations.basis(), push);
    changes.open.push_back(equations.solve(push));
    changes.by_open.emplace_back(values.parameter_count());
    add_action_changes(changes.open.back(), values, equations.basis(), changes.by_open.back());
    add_pair_changes(coupling,
                     by_parameters(values, rates, unit),
                     1.0,
                     equations.basis(),
                     changes.by_open.back());
  }
}

std::vector<std::vector<double>> add_friction_changes(const DualCase& values,
                                                      const FactoredSide& equations,
                                                      const std::vector<double>& magnitudes,
                                                      const RateSlopes& rates,
                                                      ParameterChanges& changes) {
  if (values.friction_count() == 0) {
    return {};
  }
  const FrictionChain chain(values,
                            equations.basis(),
                            rates,
                            read_friction_forces(values, equations, magnitudes, changes.open));
  chain.add_turns(changes.total);
  std::vector<std::vector<double>> slopes;
  for (std::size_t p = 0; p < values.parameter_count(); ++p) {
    slopes.push_back(chain.slopes_by(p, changes));
    changes.is_possible[p] = changes.is_possible[p] && !slopes.back().empty();
  }
  return slopes;
}

}  // namespace kinestat
