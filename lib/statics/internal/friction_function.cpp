#include "statics/internal/friction_function.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/tolerance.hpp"
#include "math/dense/dense_solve.hpp"

namespace kinestat {

namespace {

// The magnitude, with its gradient.
struct Evaluated {
  double value = 0.0;
  double terms = 0.0;  // the sizes of what it sums
  VecX gradient;
};

Evaluated evaluate(const FrictionFunction& function, const VecX& f) {
  Evaluated result{.value = function.constant,
                   .terms = std::abs(function.constant),
                   .gradient = VecX::Zero(f.size())};
  for (const PressingForce& force : function.forces) {
    const Vec3 v = force.constant + force.slopes * f;
    const double size = v.norm();
    const bool is_negative = force.part->is_signed && v.x() < 0.0;
    const double weight = is_negative ? force.part->weight_if_negative : force.part->weight;
    if (size > 0.0) {
      result.value += weight * size;
      result.terms +=
          weight * (force.constant.norm() + force.slopes.colwise().norm().dot(f.cwiseAbs()));
      result.gradient += (weight / size) * (force.slopes.transpose() * v);
    }
  }
  return result;
}

class Continuation {
 public:
  explicit Continuation(const std::vector<FrictionFunction>& functions) : functions_(functions) {
    for (const FrictionFunction& function : functions) {
      size_ += std::abs(evaluate(function, VecX::Zero(count())).value);
    }
  }

  // Empty if the friction grows beyond all bounds on the way.
  std::optional<VecX> run() const {
    VecX f = VecX::Zero(count());
    double share = 0.0;
    double step = 1.0;
    while (share < 1.0) {
      const double next = std::min(1.0, share + step);
      const std::optional<VecX> found = newton(f, next);
      if (found && is_near(*found, f, next - share)) {
        f = *found;
        share = next;
        step *= 2.0;
      } else {
        step /= 2.0;
      }
      if (step < kLeastFrictionStep || f.cwiseAbs().sum() > kUnboundedFriction * size_) {
        return std::nullopt;
      }
    }
    return f;
  }

  // Of the whole friction, from anywhere.
  std::optional<VecX> solve_from(const VecX& start) const { return newton(start, 1.0); }

 private:
  Eigen::Index count() const { return static_cast<Eigen::Index>(functions_.size()); }

  // A branch that is followed changes little in a small step; another one is a jump away.
  bool is_near(const VecX& found, const VecX& before, double step) const {
    const double jump = (found - before).cwiseAbs().sum();
    return jump <= 4.0 * step * (size_ + before.cwiseAbs().sum()) + 0.5 * before.cwiseAbs().sum();
  }

  // Near a jam, where frictions amplify each other, what rounding leaves of the equations moves
  // them by more than rounding: there they are found once the equations hold to rounding.
  std::optional<VecX> newton(VecX f, double share) const {
    constexpr int kMostSteps = 40;
    for (int i = 0; i < kMostSteps; ++i) {
      VecX difference = f;
      MatX jacobian = MatX::Identity(count(), count());
      bool holds = true;
      for (Eigen::Index r = 0; r < count(); ++r) {
        const Evaluated one = evaluate(functions_[static_cast<std::size_t>(r)], f);
        difference[r] -= share * one.value;
        holds = holds &&
                std::abs(difference[r]) <= kCancellation * (std::abs(f[r]) + share * one.terms);
        jacobian.row(r) -= share * one.gradient.transpose();
      }
      const std::optional<VecX> correction = solve_dense(jacobian, difference);
      if (!correction) {
        return std::nullopt;
      }
      f -= *correction;
      // No friction is negative by more than what the search leaves open.
      const double size = f.cwiseAbs().sum() + size_;
      const double left_open = (holds ? kConsistency : kCancellation) * size;
      if (correction->cwiseAbs().sum() <= left_open) {
        return (f.array() >= -left_open).all() ? std::optional(f) : std::nullopt;
      }
    }
    return std::nullopt;
  }

  const std::vector<FrictionFunction>& functions_;
  double size_ = 0.0;
};

// Whether changes of frictions change them by less, in any sense of what presses: there is one
// solution. The sizes of the gradients have a spectral radius below 1 (Perov).
bool is_contraction(const std::vector<FrictionFunction>& functions) {
  const auto count = static_cast<Eigen::Index>(functions.size());
  MatX system = MatX::Identity(count, count);
  for (Eigen::Index r = 0; r < count; ++r) {
    for (const PressingForce& force : functions[static_cast<std::size_t>(r)].forces) {
      const double negative = force.part->is_signed ? force.part->weight_if_negative : 0.0;
      const double weight = std::max(force.part->weight, negative);
      system.row(r) -= weight * force.slopes.colwise().norm();
    }
  }
  const std::optional<VecX> x = solve_dense(system, VecX(VecX::Ones(count)));
  return x && (x->array() > 0.0).all();
}

// The frictions with what presses going on in its direction, some of it reversed: a linear system.
std::optional<VecX> solve_reversed(const std::vector<FrictionFunction>& functions,
                                   const VecX& f,
                                   std::uint32_t reversed) {
  MatX system = MatX::Identity(f.size(), f.size());
  VecX right = VecX::Zero(f.size());
  int part = 0;
  for (Eigen::Index r = 0; r < f.size(); ++r) {
    const FrictionFunction& function = functions[static_cast<std::size_t>(r)];
    right[r] = function.constant;
    for (const PressingForce& force : function.forces) {
      const Vec3 v = force.constant + force.slopes * f;
      const double sense = ((reversed >> static_cast<unsigned>(part)) & 1U) != 0U ? -1.0 : 1.0;
      const Vec3 direction = v.isZero(0.0) ? Vec3::Zero() : Vec3(sense * v.normalized());
      const bool is_negative = force.part->is_signed && direction.x() < 0.0;
      const double weight = is_negative ? force.part->weight_if_negative : force.part->weight;
      right[r] += weight * direction.dot(force.constant);
      system.row(r) -= weight * (direction.transpose() * force.slopes);
      ++part;
    }
  }
  return solve_dense(system, right);
}

}  // namespace

std::optional<VecX> follow_friction(const std::vector<FrictionFunction>& functions) {
  return Continuation(functions).run();
}

std::optional<VecX> find_other_friction(const std::vector<FrictionFunction>& functions,
                                        const VecX& f) {
  if (is_contraction(functions)) {
    return std::nullopt;
  }
  int parts = 0;
  for (const FrictionFunction& function : functions) {
    parts += static_cast<int>(function.forces.size());
  }
  // All choices of a few, of more at least those in which a few of the first are reversed.
  constexpr int kMostReversed = 8;
  const std::uint32_t choices = 1U << static_cast<unsigned>(std::min(parts, kMostReversed));
  const Continuation search(functions);
  for (std::uint32_t reversed = 1; reversed < choices; ++reversed) {
    const std::optional<VecX> start = solve_reversed(functions, f, reversed);
    const std::optional<VecX> found = start ? search.solve_from(*start) : std::nullopt;
    if (found && (*found - f).norm() > kConsistency * (found->norm() + f.norm())) {
      return found;
    }
  }
  return std::nullopt;
}

std::optional<VecX> solve_friction(const std::vector<FrictionFunction>& functions,
                                   const FrictionCondition& condition,
                                   VecX start) {
  const Eigen::Index last = start.size() - 1;
  VecX f = std::move(start);
  constexpr int kMostSteps = 60;
  for (int i = 0; i < kMostSteps; ++i) {
    VecX difference = f;
    MatX jacobian = MatX::Identity(f.size(), f.size());
    for (Eigen::Index r = 0; r < last; ++r) {
      const Evaluated one = evaluate(functions[static_cast<std::size_t>(r)], f);
      difference[r] -= one.value;
      jacobian.row(r) -= one.gradient.transpose();
    }
    difference[last] = condition.constant + condition.slopes.dot(f);
    jacobian.row(last) = condition.slopes.transpose();
    const std::optional<VecX> correction = solve_dense(jacobian, difference);
    if (!correction || !correction->allFinite()) {
      return std::nullopt;
    }
    f -= *correction;
    if (correction->norm() <= kCancellation * f.norm()) {
      const double left_open = kCancellation * f.norm();
      return (f.head(last).array() >= -left_open).all() ? std::optional(f) : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace kinestat
