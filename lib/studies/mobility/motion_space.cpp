#include "studies/mobility/motion_space.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/rounding.hpp"
#include "math/dense/readable_basis.hpp"
#include "math/elimination/data_zero.hpp"
#include "math/elimination/elimination.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "network/node_system.hpp"
#include "studies/mobility/passive_freedom.hpp"

namespace kinestat {

namespace {

// Rows of numbers: the rates in the order in which they are reported, then six of each moving body.
class MotionRows {
 public:
  MotionRows(const Mechanism& mechanism, const CoordinateBasis& basis)
      : mechanism_(mechanism), basis_(basis), order_(mechanism.topology.freedoms.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::vector<bool> is_actuated(order_.size());
    for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
      is_actuated[static_cast<std::size_t>(actuator.freedom)] = true;
    }
    std::stable_partition(order_.begin(), order_.end(), [&](int f) {
      return is_actuated[static_cast<std::size_t>(f)];
    });
  }

  Eigen::Index columns() const { return freedoms() + 6 * bodies(); }

  // Lengths count in that of the mechanism.
  VecX scales() const {
    VecX scales = VecX::Ones(columns());
    for (Eigen::Index i = 0; i < freedoms(); ++i) {
      const auto f = static_cast<std::size_t>(order_[static_cast<std::size_t>(i)]);
      if (!mechanism_.topology.freedoms[f].is_rotation) {
        scales[i] = mechanism_.geometry.length;
      }
    }
    for (Eigen::Index b = 0; b < bodies(); ++b) {
      scales.segment(freedoms() + 6 * b + 3, 3).setConstant(mechanism_.geometry.length);
    }
    return scales;
  }

  VecX row_of(const VecX& solution) const {
    VecX row(columns());
    for (Eigen::Index i = 0; i < freedoms(); ++i) {
      const int f = order_[static_cast<std::size_t>(i)];
      row[i] = solution[velocity_column(mechanism_.topology, basis_, f)] *
               rate_unit(mechanism_.topology, basis_, f);
    }
    for (int b = 0; b < bodies(); ++b) {
      row.segment<6>(freedoms() + 6 * b) = body_twist(solution, basis_, {b + 1}).coordinates();
    }
    return row;
  }

  VecX row_of(const PassiveFreedom& passive) const {
    VecX row = VecX::Zero(columns());
    for (Eigen::Index i = 0; i < freedoms(); ++i) {
      row[i] = passive.rates[order_[static_cast<std::size_t>(i)]];
    }
    for (std::size_t i = 0; i < passive.bodies.size(); ++i) {
      row.segment<6>(freedoms() + 6 * (passive.bodies[i].value - 1)) =
          passive.twists[i].coordinates();
    }
    return row;
  }

  FreeMotion motion_of(const VecX& row) const {
    FreeMotion motion;
    motion.rates.resize(freedoms());
    for (Eigen::Index i = 0; i < freedoms(); ++i) {
      motion.rates[order_[static_cast<std::size_t>(i)]] = row[i];
    }
    Eigen::Index first = 0;
    while (first + 1 < freedoms() && row[first] == 0.0) {
      ++first;
    }
    motion.first = order_[static_cast<std::size_t>(first)];
    motion.bodies.emplace_back();
    for (Eigen::Index b = 0; b < bodies(); ++b) {
      const Vec6 twist = row.segment<6>(freedoms() + 6 * b);
      motion.bodies.push_back(Twist::from_coordinates(twist));
    }
    return motion;
  }

 private:
  Eigen::Index freedoms() const { return static_cast<Eigen::Index>(order_.size()); }

  int bodies() const { return mechanism_.topology.body_count() - 1; }

  const Mechanism& mechanism_;
  const CoordinateBasis& basis_;
  std::vector<int> order_;  ///< freedoms as they are reported
};

// How far ω·v of bodies may be off, which their pitches are made of: by what rounding of the
// couplings does to the motions, and by what these miss. Their first rates are exact.
class PitchErrors {
 public:
  PitchErrors(const Mechanism& mechanism, const CoordinateBasis& basis)
      : mechanism_(mechanism), basis_(basis) {}

  // Takes from the linear velocities what is along the axis by rounding.
  void settle(std::vector<FreeMotion>& motions) {
    for (FreeMotion& motion : motions) {
      for (std::size_t b = 1; b < motion.bodies.size(); ++b) {
        Twist& twist = motion.bodies[b];
        const double product = twist.angular.dot(twist.linear);
        if (may_be_rounding(twist) &&
            zero_within_bound(product, bound_of(motion, b, motions)) == 0.0) {
          // What is no more than what is taken is rounding, too.
          const Vec3 taken = product / twist.angular.squaredNorm() * twist.angular;
          twist.linear = (twist.linear - taken).unaryExpr([&](double x) {
            return zero_within_bound(x, 2.0 * taken.norm());
          });
        }
      }
    }
  }

 private:
  static bool may_be_rounding(const Twist& twist) {
    const double product = twist.angular.dot(twist.linear);
    return product != 0.0 &&
           std::abs(product) <= kRankZero * twist.angular.norm() * twist.linear.norm();
  }

  double bound_of(const FreeMotion& motion, std::size_t body, const std::vector<FreeMotion>& all) {
    if (!held_) {
      std::vector<int> first;
      for (const FreeMotion& one : all) {
        first.push_back(velocity_column(mechanism_.topology, basis_, one.first));
      }
      system_ = velocity_system(mechanism_.topology, mechanism_.geometry, basis_);
      held_.emplace(system_, first);
    }
    const AdjointSolution adjoint =
        held_->solve_adjoint(gradient_of(motion.bodies[body], static_cast<int>(body)));
    return adjoint.rows.cwiseAbs().dot(errors_of(motion));
  }

  // Of ω·v, towards the unknowns.
  VecX gradient_of(const Twist& twist, int body) const {
    VecX gradient = VecX::Zero(system_.columns);
    const int first = basis_.order() * (body - 1);
    for (int c = first; c < first + basis_.order(); ++c) {
      const Twist unit = body_twist(VecX::Unit(system_.columns, c), basis_, {body});
      gradient[c] = twist.angular.dot(unit.linear) + twist.linear.dot(unit.angular);
    }
    return gradient;
  }

  VecX errors_of(const FreeMotion& motion) const {
    VecX x = VecX::Zero(system_.columns);
    for (int f = 0; f < mechanism_.topology.freedom_count(); ++f) {
      x[velocity_column(mechanism_.topology, basis_, f)] =
          motion.rates[f] / rate_unit(mechanism_.topology, basis_, f);
    }
    for (std::size_t b = 1; b < motion.bodies.size(); ++b) {
      x.segment(basis_.order() * (static_cast<Eigen::Index>(b) - 1), basis_.order()) =
          basis_.coordinates_of(motion.bodies[b].coordinates());
    }
    VecX missed = VecX::Zero(system_.rows);
    for (const SparseEntry& entry : system_.entries) {
      missed[entry.row] += entry.value * x[entry.column];
    }
    return missed.cwiseAbs() +
           row_errors(system_, {}, {.rows = basis_.order(), .share = kDataRounding}, x);
  }

  const Mechanism& mechanism_;
  const CoordinateBasis& basis_;
  SparseMatrix system_;
  std::optional<Elimination> held_;  ///< factored when a pitch is first in doubt
};

}  // namespace

MotionSpace find_motion_space(const Mechanism& mechanism, const CoordinateBasis& basis) {
  const Elimination elimination(velocity_system(mechanism.topology, mechanism.geometry, basis), {});
  const MotionRows rows(mechanism, basis);
  MotionSpace space;
  space.net_freedom = static_cast<int>(elimination.free_columns().size());
  const std::size_t size = elimination.free_columns().size();
  if (size == 0 || size * static_cast<std::size_t>(rows.columns()) > kLongestList) {
    return space;
  }
  const std::vector<PassiveFreedom> found = find_passive_freedoms(mechanism, basis);
  std::vector<VecX> all;
  for (const VecX& solution : elimination.null_vectors()) {
    all.push_back(rows.row_of(solution));
  }
  std::vector<FreeMotion> passive;
  MatX reported(0, rows.columns());
  for (const PassiveFreedom& one : found) {
    const VecX row = rows.row_of(one);
    const MatX beside = readable_basis(row.transpose(), rows.scales(), reported);
    if (beside.rows() == 0) {
      continue;  // it follows from those before
    }
    reported.conservativeResize(reported.rows() + 1, Eigen::NoChange);
    reported.row(reported.rows() - 1) = row.transpose();
    passive.push_back(rows.motion_of(readable_basis(row.transpose(), rows.scales()).row(0)));
    passive.back().passive = one.bodies;
  }
  const MatX basis_rows = readable_basis(rows_of(all, rows.columns()), rows.scales(), reported);
  for (Eigen::Index j = 0; j < basis_rows.rows(); ++j) {
    space.motions.push_back(rows.motion_of(basis_rows.row(j)));
  }
  space.motions.insert(space.motions.end(), passive.begin(), passive.end());
  PitchErrors(mechanism, basis).settle(space.motions);
  return space;
}

}  // namespace kinestat
