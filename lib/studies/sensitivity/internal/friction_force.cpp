#include "studies/sensitivity/internal/friction_force.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/rounding.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/dual_vector.hpp"

namespace kinestat {

namespace {

using MagnitudeOf = std::function<Dual(std::size_t)>;

// part · wrench of the coupling with those beside it, the actions having these magnitudes.
Vec3Of<Dual> pressing_force(const DualCase& values,
                            const FrictionLawOf<Dual>& law,
                            const PressingPartOf<Dual>& part,
                            const MagnitudeOf& magnitude_of) {
  Vec3Of<Dual> sum = Vec3Of<Dual>::Zero();
  const auto add = [&](CouplingId id, double sign) {
    const CouplingTopology& coupling = values.topology().coupling(id);
    for (int i = 0; i < coupling.action_count; ++i) {
      const auto a = static_cast<std::size_t>(coupling.first_action + i);
      const Vec3Of<Dual> share = part.part * values.unit_action(a).coordinates();
      sum += sign * magnitude_of(a) * share;
    }
  };
  add(law.coupling, 1.0);
  for (const CountedCoupling& other : part.beside) {
    add(other.coupling, other.sign);
  }
  return sum;
}

// Writes the laws as functions of the actions.
class LawReader {
 public:
  LawReader(const DualCase& values,
            const FactoredSide& equations,
            const std::vector<double>& magnitudes,
            const std::vector<std::vector<double>>& open)
      : values_(values),
        equations_(equations),
        magnitudes_(magnitudes),
        open_(open),
        row_errors_(equations.row_errors(magnitudes)) {}

  FrictionForce read(std::size_t friction) const {
    const FrictionLawOf<Dual>& law = values_.friction_law(friction);
    FrictionForce result;
    result.coupling = law.coupling;
    result.magnitude.value = law.constant;
    result.magnitude.open.assign(open_.size(), Dual(0.0));
    for (const PressingPartOf<Dual>& part : law.parts) {
      add_part(law, part, result);
    }
    result.magnitude.adjoint = adjoint_of(result.magnitude.value);
    add_pair(values_.topology().coupling(law.coupling),
             values_of(law.unit),
             equations_.basis(),
             result.push);
    return result;
  }

 private:
  // What equilibrium leaves open is no variable.
  Dual magnitude(std::size_t action) const {
    const bool is_open = is_completed(*values_.action(), static_cast<int>(action));
    const auto known = is_open ? std::nullopt : values_.magnitude(action);
    return known.value_or(Dual(magnitudes_[action]));
  }

  void add_part(const FrictionLawOf<Dual>& law,
                const PressingPartOf<Dual>& part,
                FrictionForce& result) const {
    const Vec3Of<Dual> force =
        pressing_force(values_, law, part, [&](std::size_t a) { return magnitude(a); });
    std::vector<Vec3Of<Dual>> open;
    for (const std::vector<double>& stress : open_) {
      open.push_back(
          pressing_force(values_, law, part, [&](std::size_t a) { return Dual(stress[a]); }));
    }
    const Vec3 direction = values_of(force);
    const double size = direction.norm();
    if (is_zero(force)) {
      add_corners(part, force, open, result.corners);
      return;
    }
    const bool is_negative = part.is_signed && direction.x() < 0.0;
    const Dual& weight = is_negative ? part.weight_if_negative : part.weight;
    result.magnitude.value += weight * sqrt(force.squaredNorm());
    for (std::size_t s = 0; s < open.size(); ++s) {
      for (int i = 0; i < 3; ++i) {
        result.magnitude.open[s] += Dual(weight.value * direction[i] / size) * open[s][i];
      }
    }
  }

  // Each component is off by what rounding did to the equations that determine the actions.
  bool is_zero(const Vec3Of<Dual>& force) const {
    for (int i = 0; i < 3; ++i) {
      const double size = std::abs(force[i].value);
      if (size > 0.0 && (size > most_rounding(force[i]) || size > rounding(force[i]))) {
        return false;
      }
    }
    return true;
  }

  double rounding(const Dual& value) const {
    return adjoint_of(value).rows.cwiseAbs().dot(row_errors_) + terms(value) * kDataRounding;
  }

  // No row of the inverse enlarges an error by more, or its column would not have had a pivot.
  double most_rounding(const Dual& value) const {
    double slopes = 0.0;
    for (const double slope : equations_.scaled(slopes_of(value))) {
      slopes += std::abs(slope);
    }
    return slopes * row_errors_.sum() / kRankZero + terms(value) * kDataRounding;
  }

  // What a value is the sum of.
  double terms(const Dual& value) const {
    const std::vector<double> slopes = slopes_of(value);
    double sum = 0.0;
    for (std::size_t a = 0; a < slopes.size(); ++a) {
      sum += std::abs(slopes[a] * magnitudes_[a]);
    }
    return sum;
  }

  void add_corners(const PressingPartOf<Dual>& part,
                   const Vec3Of<Dual>& force,
                   const std::vector<Vec3Of<Dual>>& open,
                   std::vector<Made>& corners) const {
    if (part.weight.value == 0.0 && part.weight_if_negative.value == 0.0) {
      return;
    }
    for (int i = 0; i < 3; ++i) {
      Made corner{.value = force[i], .open = {}, .adjoint = adjoint_of(force[i])};
      for (const Vec3Of<Dual>& one : open) {
        corner.open.push_back(one[i]);
      }
      corners.push_back(std::move(corner));
    }
  }

  std::vector<double> slopes_of(const Dual& value) const {
    const std::size_t first = values_.topology().freedoms.size();
    std::vector<double> slopes;
    for (std::size_t a = 0; a < magnitudes_.size(); ++a) {
      slopes.push_back(derivative(value, first + a));
    }
    return slopes;
  }

  AdjointSolution adjoint_of(const Dual& value) const {
    return equations_.solve_adjoint(slopes_of(value));
  }

  const DualCase& values_;
  const FactoredSide& equations_;
  const std::vector<double>& magnitudes_;
  const std::vector<std::vector<double>>& open_;
  VecX row_errors_;  ///< of the equations
};

}  // namespace

Wrench values_of(const WrenchOf<Dual>& wrench) {
  return {.moment = values_of(wrench.moment), .force = values_of(wrench.force)};
}

std::vector<FrictionForce> read_friction_forces(const DualCase& values,
                                                const FactoredSide& equations,
                                                const std::vector<double>& magnitudes,
                                                const std::vector<std::vector<double>>& open) {
  const LawReader reader(values, equations, magnitudes, open);
  std::vector<FrictionForce> result;
  for (std::size_t i = 0; i < values.friction_count(); ++i) {
    result.push_back(reader.read(i));
  }
  return result;
}

}  // namespace kinestat
