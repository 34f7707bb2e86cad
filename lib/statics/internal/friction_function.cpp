#include "statics/internal/friction_function.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/dense_solve.hpp"

namespace kinestat {

namespace {

// The magnitude, with its gradient.
struct Evaluated {
  double value = 0.0;
  VecX gradient;
};

Evaluated evaluate(const FrictionFunction& function, const VecX& f) {
  Evaluated result{.value = function.constant, .gradient = VecX::Zero(f.size())};
  for (const PressingForce& force : function.forces) {
    const Vec3 v = force.constant + force.slopes * f;
    const double size = v.norm();
    const bool is_negative = force.part->is_signed && v.x() < 0.0;
    const double weight = is_negative ? force.part->weight_if_negative : force.part->weight;
    if (size > 0.0) {
      result.value += weight * size;
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

 private:
  Eigen::Index count() const { return static_cast<Eigen::Index>(functions_.size()); }

  // A branch that is followed changes little in a small step; another one is a jump away.
  bool is_near(const VecX& found, const VecX& before, double step) const {
    const double jump = (found - before).cwiseAbs().sum();
    return jump <= 4.0 * step * (size_ + before.cwiseAbs().sum()) + 0.5 * before.cwiseAbs().sum();
  }

  std::optional<VecX> newton(VecX f, double share) const {
    constexpr int kMostSteps = 40;
    for (int i = 0; i < kMostSteps; ++i) {
      VecX difference = f;
      MatX jacobian = MatX::Identity(count(), count());
      for (Eigen::Index r = 0; r < count(); ++r) {
        const Evaluated one = evaluate(functions_[static_cast<std::size_t>(r)], f);
        difference[r] -= share * one.value;
        jacobian.row(r) -= share * one.gradient.transpose();
      }
      const std::optional<VecX> correction = solve_dense(jacobian, difference);
      if (!correction) {
        return std::nullopt;
      }
      f -= *correction;
      // No friction is negative by more than what the search leaves open.
      const double left_open = kCancellation * (f.cwiseAbs().sum() + size_);
      if (correction->cwiseAbs().sum() <= left_open) {
        return (f.array() >= -left_open).all() ? std::optional(f) : std::nullopt;
      }
    }
    return std::nullopt;
  }

  const std::vector<FrictionFunction>& functions_;
  double size_ = 0.0;
};

}  // namespace

std::optional<VecX> follow_friction(const std::vector<FrictionFunction>& functions) {
  return Continuation(functions).run();
}

}  // namespace kinestat
