#include "statics/internal/friction_function.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "core/tolerance.hpp"
#include "math/dense/dense_solve.hpp"

namespace kinestat {

namespace {

// What presses, and its share of the friction: weight · |pressing|.
struct Share {
  const PressingForce* force = nullptr;
  Vec3 pressing = Vec3::Zero();
  double size = 0.0;
  double weight = 0.0;

  double value() const { return weight * size; }
};

double weight_of(const PressingPart& part, const Vec3& pressing) {
  return part.is_signed && pressing.x() < 0.0 ? part.weight_if_negative : part.weight;
}

double largest_weight(const PressingPart& part) {
  return part.is_signed ? std::max(part.weight, part.weight_if_negative) : part.weight;
}

Share share_of(const PressingForce& force, const VecX& f) {
  const Vec3 pressing = force.constant + force.slopes * f;
  return {.force = &force,
          .pressing = pressing,
          .size = pressing.norm(),
          .weight = weight_of(*force.part, pressing)};
}

// The number of forces from there on of which one alone presses: one or two.
std::size_t rivals(const FrictionFunction& function, std::size_t first) {
  std::size_t end = first + 1;
  while (end < function.forces.size() && function.forces[end].part->is_instead) {
    ++end;
  }
  return end - first;
}

// The one that presses among so many.
Share largest_share(std::span<const PressingForce> rivals, const VecX& f) {
  Share largest = share_of(rivals.front(), f);
  for (const PressingForce& force : rivals.subspan(1)) {
    const Share other = share_of(force, f);
    largest = other.value() > largest.value() ? other : largest;
  }
  return largest;
}

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
  const std::span<const PressingForce> forces(function.forces);
  for (std::size_t i = 0; i < forces.size();) {
    const std::size_t count = rivals(function, i);
    const Share one = largest_share(forces.subspan(i, count), f);
    i += count;
    if (one.size > 0.0) {
      result.value += one.value();
      result.terms += one.weight * (one.force->constant.norm() +
                                    one.force->slopes.colwise().norm().dot(f.cwiseAbs()));
      result.gradient += (one.weight / one.size) * (one.force->slopes.transpose() * one.pressing);
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
    const FrictionFunction& function = functions[static_cast<std::size_t>(r)];
    for (std::size_t i = 0; i < function.forces.size();) {
      VecX largest = VecX::Zero(count);
      for (const std::size_t end = i + rivals(function, i); i < end; ++i) {
        const PressingForce& force = function.forces[i];
        const VecX change = largest_weight(*force.part) * force.slopes.colwise().norm().transpose();
        largest = largest.cwiseMax(change);
      }
      system.row(r) -= largest.transpose();
    }
  }
  const std::optional<VecX> x = solve_dense(system, VecX(VecX::Ones(count)));
  return x && (x->array() > 0.0).all();
}

// Of one or two, the one that presses; reversed the other one, or the only one the other way.
Share chosen_share(std::span<const PressingForce> rivals, const VecX& f, bool is_reversed) {
  Share one = largest_share(rivals, f);
  if (!is_reversed) {
    return one;
  }
  if (rivals.size() > 1) {
    return share_of(one.force == &rivals.front() ? rivals.back() : rivals.front(), f);
  }
  one.pressing = -one.pressing;
  one.weight = weight_of(*one.force->part, one.pressing);
  return one;
}

// The frictions with what presses going on in its direction, some of it reversed: a linear system.
std::optional<VecX> solve_reversed(const std::vector<FrictionFunction>& functions,
                                   const VecX& f,
                                   std::uint32_t reversed) {
  MatX system = MatX::Identity(f.size(), f.size());
  VecX right = VecX::Zero(f.size());
  unsigned choice = 0;
  for (Eigen::Index r = 0; r < f.size(); ++r) {
    const FrictionFunction& function = functions[static_cast<std::size_t>(r)];
    const std::span<const PressingForce> forces(function.forces);
    right[r] = function.constant;
    for (std::size_t i = 0; i < forces.size(); ++choice) {
      const std::size_t count = rivals(function, i);
      const Share one =
          chosen_share(forces.subspan(i, count), f, ((reversed >> choice) & 1U) != 0U);
      i += count;
      if (one.size > 0.0) {
        const Vec3 direction = (one.weight / one.size) * one.pressing;
        right[r] += direction.dot(one.force->constant);
        system.row(r) -= direction.transpose() * one.force->slopes;
      }
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
  unsigned parts = 0;
  for (const FrictionFunction& function : functions) {
    for (std::size_t i = 0; i < function.forces.size(); i += rivals(function, i)) {
      ++parts;
    }
  }
  // All choices of a few, of more at least those in which a few of the first are reversed.
  constexpr unsigned kMostReversed = 8;
  const std::uint32_t choices = 1U << std::min(parts, kMostReversed);
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
