#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "mechanism/bind/bind.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/motion.hpp"
#include "studies/synthesis/task/linkage_files.hpp"

namespace kinestat {

namespace {

constexpr int kCheckedSteps = 24;
constexpr int kCoupler = 2;  // body, after the frame and the driver

// One linkage and the drive of its best verdict.
class LinkageMover {
 public:
  LinkageMover(const SynthesisAnalysis& analysis,
               const SynthesisTask& task,
               const LinkageCandidate& candidate)
      : positions_(task.positions_of(candidate)), candidate_(candidate) {
    const MechanismDescription description = describe_linkage(analysis, task, candidate);
    Diagnostics ignored;
    std::optional<Mechanism> mechanism = bind(description, ignored);
    KINESTAT_EXPECTS(mechanism.has_value());
    mechanism_ = *std::move(mechanism);
    const std::vector<DrawnCoupling> drawn = bind_drawn_couplings(description, mechanism_);
    drive_ = mechanism_.topology.actuators.front().freedom;
    network_ = make_motion_network(mechanism_, drawn, {&drive_, 1});
  }

  LinkageCheck check() const {
    const DriveVerdict& verdict = candidate_.best();
    LinkageCheck result;
    const Way ahead = follow(1.0);
    const Way behind = follow(-1.0);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      result.reached.push_back(ahead.is_met[i] || behind.is_met[i]);
    }
    result.passes_in_order = verdict.passage == Passage::increasing ? ahead.is_in_order
                             : verdict.passage == Passage::decreasing
                                 ? behind.is_in_order
                                 : ahead.is_in_order || behind.is_in_order;
    result.worst = verdict.passage == Passage::increasing   ? ahead.worst
                   : verdict.passage == Passage::decreasing ? behind.worst
                                                            : 0.0;
    result.agrees = agrees(verdict, result);
    return result;
  }

 private:
  // The positions as one sense of the drive meets them.
  struct Way {
    std::vector<bool> is_met;
    bool is_in_order = true;
    double worst = 0.0;  ///< of those that it comes to; 1 where it comes not to all
  };

  Way follow(double sense) const {
    Way way;
    double last = 0.0;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const std::optional<double> moved = travel(i, sense);
      const std::optional<double> missed = miss(i, moved);
      way.is_met.push_back(missed && *missed <= tolerance());
      way.is_in_order = way.is_in_order && way.is_met.back() && sense * *moved >= last;
      way.worst = std::max(way.worst, missed.value_or(1.0));
      last = sense * moved.value_or(0.0);
    }
    return way;
  }

  // Positions that have a sense may be out of order although they come one after the other.
  bool agrees(const DriveVerdict& verdict, const LinkageCheck& check) const {
    const bool reaches_all = std::ranges::find(check.reached, false) == check.reached.end();
    if (verdict.passage != Passage::none) {
      return check.passes_in_order;
    }
    if (!verdict.same_circuit || !verdict.same_branch) {
      return !reaches_all;
    }
    const bool has_sense =
        std::ranges::any_of(positions_, [](const PositionJets& one) { return one.order() > 1; });
    return reaches_all && (has_sense || !check.passes_in_order);
  }

  bool is_cyclic() const {
    return input_of(candidate_.linkage, candidate_.best_drive).kind != DyadKind::slider;
  }

  // From the first position in one sense: a crank comes round to every position, a slider only to
  // those that lie there.
  std::optional<double> travel(std::size_t i, double sense) const {
    const std::vector<double>& at = candidate_.best().coordinates;
    const double way = sense * (at[i] - at[0]);
    if (way >= 0.0) {
      return sense * way;
    }
    return is_cyclic() ? std::optional(sense * (way + 2.0 * std::numbers::pi)) : std::nullopt;
  }

  // How far the coupler is from where the task wants it; empty if the drive does not come there.
  std::optional<double> miss(std::size_t i, const std::optional<double>& way) const {
    if (!way) {
      return std::nullopt;
    }
    BodyPose pose;
    if (*way != 0.0) {
      const MotionSolution solution = solve_motion(
          network_,
          {.drives = {{.freedom = drive_, .from = 0.0, .to = *way}}, .steps = kCheckedSteps});
      if (solution.status != MotionStatus::completed) {
        return std::nullopt;
      }
      const Configuration last = solution.configuration_at(solution.position_count() - 1);
      pose = body_poses(network_, last)[kCoupler];
    }
    const Point start = origin(positions_[0]);
    const Point wanted = origin(positions_[i]);
    const Vec3 point = pose.point({start.real(), start.imag(), 0.0});
    const double distance = std::hypot(point.x() - wanted.real(), point.y() - wanted.imag());
    const double turned = std::atan2(pose.rotation(1, 0), pose.rotation(0, 0));
    const double turn = positions_[i].angle[0] - positions_[0].angle[0];
    const double angle = std::abs(std::remainder(turned - turn, 2.0 * std::numbers::pi));
    return std::max(distance / mechanism_.geometry.length, angle);
  }

  // What the motion must keep to: 1e-9, or what the positions leave of the dyads' digits.
  double tolerance() const {
    double result = kConsistency;
    for (const Dyad* dyad : {&candidate_.linkage.one, &candidate_.linkage.other}) {
      result = std::max({result,
                         std::pow(10.0, -dyad->digits),
                         2.0 * dyad->deviation / mechanism_.geometry.length});
    }
    return result;
  }

  const std::vector<PositionJets>& positions_;
  const LinkageCandidate& candidate_;
  Mechanism mechanism_;
  MotionNetwork network_;
  int drive_ = 0;
};

bool has_digits(const LinkageCandidate& candidate) {
  return candidate.defect() != Defect::digits;
}

void check_task(const SynthesisAnalysis& analysis,
                const SynthesisOptions& options,
                SynthesisTask& task,
                Diagnostics& found) {
  task.checks.resize(task.linkages.size());
  for (std::size_t i = 0; i < task.linkages.size(); ++i) {
    const LinkageCandidate& candidate = task.linkages[i];
    const bool is_asked =
        options.verifies || options.written == WrittenLinkages::all || candidate.is_usable();
    if (!is_asked || !has_digits(candidate)) {
      continue;
    }
    task.checks[i] = LinkageMover(analysis, task, candidate).check();
    if (!task.checks[i]->agrees) {
      found.warning("W0802",
                    analysis.description.synthesis->where,
                    fmt::format("linkage {} of the task does not move as its verdict says", i),
                    "it may be close to a dead point or a change point; 'kinestat motion' on its "
                    "mechanism file shows what it does");
    }
  }
}

}  // namespace

void check_linkages(SynthesisAnalysis& analysis,
                    const SynthesisOptions& options,
                    Diagnostics& found) {
  for (SynthesisTask& task : analysis.tasks) {
    check_task(analysis, options, task, found);
  }
}

}  // namespace kinestat
