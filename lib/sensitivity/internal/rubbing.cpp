#include "sensitivity/internal/rubbing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/tolerance.hpp"
#include "math/dual_vector.hpp"

namespace kinestat {

namespace {

using MagnitudeOf = std::function<Dual(std::size_t)>;

// part · wrench of the coupling, its actions having these magnitudes.
Vec3Of<Dual> pressing_force(const DualCase& values,
                            const FrictionLawOf<Dual>& law,
                            const PressingPartOf<Dual>& part,
                            const MagnitudeOf& magnitude_of) {
  const CouplingTopology& coupling = values.topology().coupling(law.coupling);
  Vec3Of<Dual> sum = Vec3Of<Dual>::Zero();
  for (int i = 0; i < coupling.action_count; ++i) {
    const auto a = static_cast<std::size_t>(coupling.first_action + i);
    const Vec3Of<Dual> share = part.part * values.unit_action(a).coordinates();
    sum += magnitude_of(a) * share;
  }
  return sum;
}

// The largest force in a case, couples over its size: zero is what is rounding of this.
double largest_force(const DualCase& values) {
  double largest = 0.0;
  for (std::size_t a = 0; a < values.topology().actions.size(); ++a) {
    const double size = std::abs(values.action()->magnitudes[a].value_or(0.0));
    const bool is_couple = values.topology().actions[a].is_couple;
    largest = std::max(largest, is_couple ? size / values.mechanism().geometry.length : size);
  }
  return largest;
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
        zero_(kReportsAgreeInZero * largest_force(values)) {}

  Rubbing read(std::size_t friction) const {
    const FrictionLawOf<Dual>& law = values_.friction_law(friction);
    Rubbing result;
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
                Rubbing& result) const {
    const Vec3Of<Dual> force =
        pressing_force(values_, law, part, [&](std::size_t a) { return magnitude(a); });
    std::vector<Vec3Of<Dual>> open;
    for (const std::vector<double>& stress : open_) {
      open.push_back(
          pressing_force(values_, law, part, [&](std::size_t a) { return Dual(stress[a]); }));
    }
    const Vec3 direction = values_of(force);
    const double size = direction.norm();
    if (size <= zero_) {
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

  AdjointSolution adjoint_of(const Dual& value) const {
    const std::size_t first = values_.topology().freedoms.size();
    std::vector<double> slopes;
    for (std::size_t a = 0; a < magnitudes_.size(); ++a) {
      slopes.push_back(derivative(value, first + a));
    }
    return equations_.solve_adjoint(slopes);
  }

  const DualCase& values_;
  const FactoredSide& equations_;
  const std::vector<double>& magnitudes_;
  const std::vector<std::vector<double>>& open_;
  double zero_;  ///< [N]
};

}  // namespace

Wrench values_of(const WrenchOf<Dual>& wrench) {
  return {.moment = values_of(wrench.moment), .force = values_of(wrench.force)};
}

std::vector<Rubbing> read_rubbings(const DualCase& values,
                                   const FactoredSide& equations,
                                   const std::vector<double>& magnitudes,
                                   const std::vector<std::vector<double>>& open) {
  const LawReader reader(values, equations, magnitudes, open);
  std::vector<Rubbing> result;
  for (std::size_t i = 0; i < values.friction_count(); ++i) {
    result.push_back(reader.read(i));
  }
  return result;
}

}  // namespace kinestat
