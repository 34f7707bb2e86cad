#include "studies/motion/joint_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "core/simulation_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/dense/span.hpp"
#include "studies/motion/internal/closure_parts.hpp"
#include "studies/motion/internal/closure_system.hpp"
#include "studies/motion/internal/largest.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/pivoted_qr.hpp"

namespace kinestat {

namespace {

// Beyond a change point, where the determinant has the other sign, the way goes on straight.
constexpr double kMostCorrectionBeyond = 0.01;

// A step is halved no finer than to this share of the way.
constexpr double kFinestPart = 0x1p-12;

const MotionJoint* joint_of_rate(const MotionNetwork& network, int rate) {
  const auto joint = std::ranges::find(network.joints, rate, &MotionJoint::rate);
  return joint == network.joints.end() ? nullptr : &*joint;
}

bool has_coordinate(const MotionJoint& joint) {
  return joint.coordinate >= 0 && joint.freedom >= 0 && joint.motion.kind != ElementaryKind::ball;
}

template <class Frames>
class Follower {
 public:
  explicit Follower(const MotionNetwork& network)
      : network_(network),
        system_(network),
        parts_(network, system_.is_length(), system_.rates_of_rows()) {
    for (const int rate : network.driven_rates) {
      const MotionJoint& joint = *joint_of_rate(network, rate);
      coordinates_.push_back(joint.coordinate);
      units_.push_back(joint.motion.kind == ElementaryKind::slide ? network.length : 1.0);
    }
    for (int rate = 0; rate < network.rate_count; ++rate) {
      if (std::ranges::find(network.driven_rates, rate) == network.driven_rates.end()) {
        unknown_.push_back(rate);
      }
    }
    const int surplus = system_.row_count() - (static_cast<int>(unknown_.size()) -
                                               static_cast<int>(network.passive_motions.size()));
    accepted_ = surplus > 0 ? kAcceptedClosureError : kTrialClosure;
    is_square_ = system_.row_count() == static_cast<int>(unknown_.size());
    step_.resize(at(network.rate_count));
    right_.resize(std::max(at(system_.row_count()), unknown_.size()) + 1);
    solved_.resize(unknown_.size());
  }

  void read_drives(const Configuration& configuration, std::span<double> drives) const {
    for (std::size_t d = 0; d < coordinates_.size(); ++d) {
      drives[d] = units_[d] * configuration.coordinates[at(coordinates_[d])];
    }
  }

  bool follow(Configuration& configuration, std::span<const double> drives) {
    to_.resize(drives.size());
    from_.resize(drives.size());
    for (std::size_t d = 0; d < drives.size(); ++d) {
      to_[d] = drives[d] / units_[d];
      from_[d] = configuration.coordinates[at(coordinates_[d])];
    }
    double share = 0.0;
    double part = 1.0;
    while (share < 1.0) {
      const double next = share + part < 1.0 ? share + part : 1.0;
      trial_ = configuration;
      if (try_part(next, trial_)) {
        std::swap(configuration, trial_);
        share = next;
        continue;
      }
      part *= 0.5;
      if (part < kFinestPart) {
        return to_ == from_;  // nothing leads on from a singular position, but it stands there
      }
    }
    return true;
  }

  std::optional<MatX> unit_rates(const Configuration& configuration) {
    stand_in(configuration);
    if (unknown_.size() - at(qr_.rank()) > network_.passive_motions.size()) {
      return std::nullopt;
    }
    MatX result = MatX::Zero(network_.rate_count, static_cast<Eigen::Index>(coordinates_.size()));
    for (std::size_t d = 0; d < coordinates_.size(); ++d) {
      const auto column = static_cast<Eigen::Index>(d);
      result(network_.driven_rates[d], column) = 1.0;
      answer(d, 1.0);
      for (std::size_t i = 0; i < unknown_.size(); ++i) {
        result(unknown_[i], column) = step_[at(unknown_[i])];
      }
    }
    return result;
  }

  MatX free_motions(const Configuration& configuration) {
    system_.evaluate(configuration.coordinates, configuration.angles);
    PivotedQr whole;
    const int rates = network_.rate_count;
    whole.factor(system_.jacobian(), system_.row_count(), rates, kSize);
    const std::vector<double>& null = whole.null_vectors();
    MatX motions(rates, rates - whole.rank());
    std::ranges::copy(null, motions.data());
    // What no other body feels is taken out of them.
    const auto passive = static_cast<Eigen::Index>(network_.passive_motions.size());
    if (passive == 0 || motions.cols() < passive) {
      return motions;
    }
    MatX idle(rates, passive);
    for (Eigen::Index p = 0; p < passive; ++p) {
      idle.col(p) = network_.passive_motions[static_cast<std::size_t>(p)];
    }
    const MatX basis = orthonormal_range(idle);
    motions -= basis * (basis.transpose() * motions);
    return orthonormal_range(motions);
  }

 private:
  void stand_in(const Configuration& configuration) {
    system_.evaluate(configuration.coordinates, configuration.angles);
    factor();
  }

  void factor() {
    const int rows = system_.row_count();
    matrix_.resize(at(rows) * unknown_.size());
    double* to = matrix_.data();
    for (const int column : unknown_) {
      to = std::copy_n(system_.jacobian().data() + column * rows, rows, to);
    }
    qr_.factor(matrix_, rows, static_cast<int>(unknown_.size()), kSize);
  }

  // What the unknown joints do in answer to a drive, into the step.
  void answer(std::size_t drive, double by) {
    const int rows = system_.row_count();
    const double* column = system_.jacobian().data() + network_.driven_rates[drive] * rows;
    std::ranges::fill(right_, 0.0);
    for (int r = 0; r < rows; ++r) {
      right_[at(r)] = -by * column[r];
    }
    qr_.solve(right_, solved_);
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
      step_[at(unknown_[i])] = solved_[i];
    }
  }

  bool try_part(double share, Configuration& trial) {
    stand_in(trial);
    const double sign = qr_.sign();
    if (unknown_.size() - at(qr_.rank()) > network_.passive_motions.size()) {
      return false;
    }
    const int rows = system_.row_count();
    std::ranges::fill(step_, 0.0);
    std::ranges::fill(right_, 0.0);
    for (std::size_t d = 0; d < coordinates_.size(); ++d) {
      const double by =
          from_[d] + share * (to_[d] - from_[d]) - trial.coordinates[at(coordinates_[d])];
      const int rate = network_.driven_rates[d];
      step_[at(rate)] = by;
      const double* column = system_.jacobian().data() + rate * rows;
      for (int r = 0; r < rows; ++r) {
        right_[at(r)] -= by * column[r];
      }
    }
    qr_.solve(right_, solved_);
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
      step_[at(unknown_[i])] = solved_[i];
    }
    if (!(system_.total_turn(step_) < kMostTurnInStep)) {
      return false;
    }
    const double stride = largest(step_);
    system_.move(step_, trial.coordinates);
    for (std::size_t d = 0; d < coordinates_.size(); ++d) {
      trial.coordinates[at(coordinates_[d])] =
          share == 1.0 ? to_[d] : from_[d] + share * (to_[d] - from_[d]);
    }
    double moved = 0.0;
    if (!close(trial, moved)) {
      return false;
    }
    const bool turns_over = is_square_ && !(sign * qr_.sign() > 0.0);
    const double most = turns_over ? kMostCorrectionBeyond : kMostCorrection;
    return moved <= most * stride + kLeastCorrection;
  }

  bool close(Configuration& trial, double& moved) {
    double last = kFarCorrection;
    for (int round = 0; round < kMostRounds; ++round) {
      stand_in(trial);
      const double missed = system_.largest_residual();
      if (!std::isfinite(missed)) {
        return false;
      }
      if (missed <= kEpsilon) {
        break;
      }
      std::ranges::fill(right_, 0.0);
      std::ranges::transform(
          system_.residuals(), right_.begin(), [](double residual) { return -residual; });
      qr_.solve(right_, solved_);
      const double size = largest(solved_);
      const bool is_closed = missed <= kMotionClosure;
      if (size > last && !is_closed) {
        return false;
      }
      const bool is_last = parts_.largest(system_.residuals()) <= kMotionClosure ||
                           size <= kLeastCorrection || size > last;
      last = size;
      std::ranges::fill(step_, 0.0);
      for (std::size_t i = 0; i < unknown_.size(); ++i) {
        step_[at(unknown_[i])] = solved_[i];
      }
      moved += size;
      system_.move(step_, trial.coordinates);
      if (is_last) {
        break;
      }
    }
    if (!(system_.largest_residual() <=
          std::max(accepted_, kTurnRoundings * kEpsilon * largest(trial.coordinates)))) {
      return false;
    }
    system_.follow_angles(trial.angles);
    return true;
  }

  const MotionNetwork& network_;
  ClosureSystem<Frames> system_;
  ClosureParts parts_;
  PivotedQr qr_;
  std::vector<int> coordinates_;  // of the drives
  std::vector<double> units_;     // likewise
  std::vector<int> unknown_;
  double accepted_ = 0.0;
  bool is_square_ = false;
  std::vector<double> matrix_;
  std::vector<double> right_;
  std::vector<double> solved_;
  std::vector<double> step_;
  std::vector<double> from_;
  std::vector<double> to_;
  Configuration trial_;
};

}  // namespace

struct JointFollower::Solver {
  explicit Solver(const MotionNetwork& network) {
    if (network.space == Space::planar) {
      planar.emplace(network);
    } else {
      spatial.emplace(network);
    }
  }

  template <class Do>
  auto with(Do act) {
    return planar ? act(*planar) : act(*spatial);
  }

  std::optional<Follower<PlanarFrames>> planar;
  std::optional<Follower<SpatialFrames>> spatial;
};

JointFollower::JointFollower(const MotionNetwork& network)
    : solver_(std::make_unique<Solver>(network)) {}

JointFollower::~JointFollower() = default;

void JointFollower::read_drives(const Configuration& configuration,
                                std::span<double> drives) const {
  solver_->with([&](auto& one) { one.read_drives(configuration, drives); });
}

bool JointFollower::follow(Configuration& configuration, std::span<const double> drives) {
  return solver_->with([&](auto& one) { return one.follow(configuration, drives); });
}

std::optional<MatX> JointFollower::unit_rates(const Configuration& configuration) {
  return solver_->with([&](auto& one) { return one.unit_rates(configuration); });
}

MatX JointFollower::free_motions(const Configuration& configuration) {
  return solver_->with([&](auto& one) { return one.free_motions(configuration); });
}

int rate_of_freedom(const MotionNetwork& network, int freedom) {
  for (const MotionJoint& joint : network.joints) {
    if (joint.freedom == freedom && joint.rate >= 0 && has_coordinate(joint)) {
      return joint.rate;
    }
  }
  return -1;
}

MotionNetwork with_drives(MotionNetwork network, std::span<const int> rates) {
  network.driven_rates.assign(rates.begin(), rates.end());
  network.driven_freedoms.clear();
  for (const int rate : rates) {
    network.driven_freedoms.push_back(joint_of_rate(network, rate)->freedom);
  }
  return network;
}

std::vector<int> independent_rates(const MotionNetwork& network,
                                   MatX motions,
                                   std::span<const int> first) {
  std::vector<int> chosen;
  // A slide is as large as it is in its part of the mechanism.
  for (const MotionJoint& joint : network.joints) {
    if (joint.rate >= 0 && joint.freedom >= 0 && joint.motion.kind == ElementaryKind::slide) {
      motions.row(joint.rate) *= network.length / network.part_lengths[at(joint.freedom)];
    }
  }
  const double largest_entry = motions.size() > 0 ? motions.cwiseAbs().maxCoeff() : 0.0;
  // Takes the motion of a joint out of what is left to tell apart.
  const auto take = [&](int rate) {
    const VecX row = motions.row(rate).transpose();
    const double length = row.norm();
    if (!(length > kIndependentJoint * largest_entry)) {
      return false;
    }
    const VecX unit = row / length;
    motions -= (motions * unit) * unit.transpose();
    chosen.push_back(rate);
    return true;
  };
  for (const int rate : first) {
    take(rate);
  }
  while (static_cast<Eigen::Index>(chosen.size()) < motions.cols()) {
    int best = -1;
    double longest = 0.0;
    for (const MotionJoint& joint : network.joints) {
      if (joint.rate < 0 || !has_coordinate(joint) ||
          std::ranges::find(chosen, joint.rate) != chosen.end()) {
        continue;
      }
      const double length = motions.row(joint.rate).norm();
      if (length > longest) {
        longest = length;
        best = joint.rate;
      }
    }
    if (best < 0 || !take(best)) {
      break;
    }
  }
  return chosen;
}

}  // namespace kinestat
