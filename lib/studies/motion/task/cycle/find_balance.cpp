#include "studies/motion/task/cycle/find_balance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/motion_tolerance.hpp"
#include "math/dense/least_squares.hpp"
#include "math/dense/span.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

namespace {

// For pictures.
constexpr int kPathPoints = 180;

// A place of mass 1 on a body, as drawn from its axis.
struct UnitWeight {
  BodyId body;
  Vec3 place = Vec3::Zero();
};

// What its force of inertia is (D'Alembert).
Vec3 force_of(const UnitWeight& weight, const MotionState& state) {
  const auto body = static_cast<std::size_t>(weight.body.value);
  const Vec3 arm = state.poses[body].rotation * weight.place;
  const Vec3& omega = state.twists[body].angular;
  const Vec3& alpha = state.twist_rates[body].angular;
  return -(alpha.cross(arm) + omega.cross(omega.cross(arm)));
}

class BalanceFinder {
 public:
  BalanceFinder(CycleSampler& sampler, std::span<const CounterweightPlan> plan)
      : sampler_(sampler), mechanism_(sampler.mechanism()), plan_(plan) {}

  std::variant<BalanceFigures, CycleProblem> run() {
    if (auto problem = why_no_mass(mechanism_)) {
      return *std::move(problem);
    }
    for (const CounterweightPlan& one : plan_) {
      if (auto problem = add_weights(one)) {
        return *std::move(problem);
      }
    }
    const auto found = sampler_.find([this](const MotionPosition& at) { return read(at); });
    if (!found) {
      return CycleProblem{
          "in some position of the motion there is no shaking force, or it jumps too often, or "
          "rounding leaves it too few digits",
          "the rows of the motion say where"};
    }
    return solve(*found);
  }

 private:
  std::optional<CycleProblem> add_weights(const CounterweightPlan& one) {
    const std::optional<CouplingId> axis = ground_axis(mechanism_.topology, one.body);
    if (!axis) {
      return CycleProblem{
          fmt::format("body '{}' does not turn about an axis of the ground",
                      mechanism_.topology.body(one.body).name),
          "name bodies that a revolute joins to the ground; they may carry counterweights",
          one.where};
    }
    if (mechanism_.space == Space::planar) {
      weights_.push_back({.body = one.body, .place = Vec3::UnitX()});
      weights_.push_back({.body = one.body, .place = Vec3::UnitY()});
      return std::nullopt;
    }
    const auto freedom =
        static_cast<std::size_t>(mechanism_.topology.coupling(*axis).first_freedom);
    const Vec3 along = mechanism_.geometry.motions[freedom].angular.normalized();
    const Vec3 across = along.unitOrthogonal();
    weights_.push_back({.body = one.body, .place = across});
    weights_.push_back({.body = one.body, .place = along.cross(across)});
    return std::nullopt;
  }

  // The shaking force, then that of each weight.
  std::optional<std::vector<CycleValue>> read(const MotionPosition& at) const {
    if (!at.solved || !at.solved->dynamics || !at.solved->dynamics->shaking ||
        at.state.twist_rates.empty()) {
      return std::nullopt;
    }
    double size = 0.0;
    for (const BodyDynamics& body : at.solved->dynamics->bodies) {
      size += body.inertial.force.norm();
    }
    std::vector<CycleValue> values;
    for (const double one : at.solved->dynamics->shaking->force) {
      values.push_back({.value = one, .size = size});
    }
    for (const UnitWeight& weight : weights_) {
      const Vec3 force = force_of(weight, at.state);
      for (const double one : force) {
        values.push_back({.value = one, .size = force.norm()});
      }
    }
    return values;
  }

  static Vec3 at_of(const VecX& values, Eigen::Index vector) {
    return values.segment<3>(3 * vector);
  }

  Vec3 left(const VecX& values) const {
    Vec3 force = at_of(values, 0);
    for (Eigen::Index w = 0; w < amounts_.size(); ++w) {
      force += amounts_[w] * at_of(values, 1 + w);
    }
    return force;
  }

  BalanceFigures solve(const LegendrePieces& found) {
    amounts_ = least_squares(found);
    BalanceFigures figures;
    const double least = kNoHarmonic * found.size(0);
    figures.before = figures_of(found, least, [](const VecX& v) { return at_of(v, 0); });
    figures.after = figures_of(found, least, [this](const VecX& v) { return left(v); });
    for (std::size_t w = 0; w < weights_.size(); w += 2) {
      const auto first = static_cast<Eigen::Index>(w);
      Vec3 sum = amounts_[first] * weights_[w].place + amounts_[first + 1] * weights_[w + 1].place;
      const double size = sum.norm();
      sum = sum.unaryExpr([size](double x) { return zero_within_bound(x, kNoHarmonic * size); });
      figures.counterweights.push_back(
          {.body = mechanism_.topology.body(weights_[w].body).name, .mass_radius = sum});
    }
    for (int i = 0; i <= kPathPoints; ++i) {
      const VecX there = found.values(static_cast<double>(i) / kPathPoints);
      figures.path.push_back({.before = at_of(there, 0), .after = left(there)});
    }
    return figures;
  }

  // Rows at the points of Gauss, so that the sum of squares is the integral.
  VecX least_squares(const LegendrePieces& found) const {
    const auto columns = static_cast<Eigen::Index>(weights_.size());
    std::vector<VecX> rows;
    found.for_each_point(1.0, [&](double, double weight, const VecX& values) {
      rows.emplace_back(std::sqrt(weight) * values);
    });
    MatX A(3 * static_cast<Eigen::Index>(rows.size()), columns);
    VecX b(A.rows());
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto first = 3 * static_cast<Eigen::Index>(r);
      b.segment<3>(first) = -at_of(rows[r], 0);
      for (Eigen::Index w = 0; w < columns; ++w) {
        A.block<3, 1>(first, w) = at_of(rows[r], 1 + w);
      }
    }
    const std::vector<int> chosen = independent_columns(A);
    MatX kept(A.rows(), static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t c = 0; c < chosen.size(); ++c) {
      kept.col(static_cast<Eigen::Index>(c)) = A.col(chosen[c]);
    }
    VecX amounts = VecX::Zero(columns);
    if (!chosen.empty()) {
      const VecX solved = NormalEquations(kept).solve(kept.transpose() * b);
      for (std::size_t c = 0; c < chosen.size(); ++c) {
        amounts[chosen[c]] = solved[static_cast<Eigen::Index>(c)];
      }
    }
    return amounts;
  }

  template <class Force>
  ShakingForce figures_of(const LegendrePieces& found, double least, const Force& force) const {
    double square = 0.0;
    found.for_each_point(1.0, [&](double, double weight, const VecX& values) {
      square += weight * force(values).squaredNorm();
    });
    const GreatestValue greatest =
        found.greatest([&](double time) { return force(found.values(time)).norm(); });
    return {.rms = zero_within_bound(std::sqrt(square), least),
            .greatest = zero_within_bound(greatest.value, least),
            .greatest_at = sampler_.drive_at(greatest.argument)};
  }

  CycleSampler& sampler_;
  const Mechanism& mechanism_;
  std::span<const CounterweightPlan> plan_;
  std::vector<UnitWeight> weights_;  // two a body
  VecX amounts_;                     // of each [kg·m]
};

}  // namespace

std::variant<BalanceFigures, CycleProblem> find_balance(CycleSampler& sampler,
                                                        std::span<const CounterweightPlan> plan) {
  return BalanceFinder(sampler, plan).run();
}

}  // namespace kinestat
