#include "studies/motion/picture/drawn_actions_maker.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "cases/case_status.hpp"
#include "cases/findings/case_findings.hpp"
#include "core/codes.hpp"
#include "mechanism/couplings/coupling_reactions.hpp"
#include "studies/motion/followed_configurations.hpp"
#include "studies/motion/task/columns/column_detail.hpp"
#include "studies/motion/task/columns/reaction_columns.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"
#include "studies/motion/task/friction_sliding.hpp"

namespace kinestat {

namespace {

// The same motion, of which actions alone are reported.
MotionPlan plan_of_actions(const MotionPlan& plan) {
  MotionPlan result = plan;
  result.report = MotionReport();
  result.report.action = true;
  return result;
}

bool has_actions(const MotionPlan& plan, const Mechanism& mechanism) {
  return plan.which >= 0 && mechanism.cases[static_cast<std::size_t>(plan.which)].asks_actions;
}

class ActionsMaker {
 public:
  ActionsMaker(const MechanismDescription& description,
               const Mechanism& mechanism,
               const FoundMotion& motion)
      : description_(description),
        mechanism_(mechanism),
        motion_(motion),
        plan_(plan_of_actions(motion.plan)),
        reactions_(coupling_reactions(mechanism)),
        configurations_(mechanism, motion.network, motion.solution) {}

  DrawnActions run(const std::vector<std::size_t>& shown, const DrawnMotion& drawn) {
    MotionDetail detail = detail_of(plan_, mechanism_);
    detail.closure_error = worst_closure_error(motion_.solution);
    MotionPositions positions(mechanism_, plan_, motion_.network, motion_.drawn, detail);
    std::vector<std::vector<std::optional<Vec3>>> forces;
    for (const std::size_t row : shown) {
      const MotionPosition position =
          positions.at(motion_.solution.configuration_at(static_cast<int>(row)),
                       motion_.solution.shares[row],
                       time_of_row(motion_, row));
      forces.push_back(reaction_forces(reactions_, mechanism_.topology, position));
      if (position.solved) {
        for (DrawnArrow& arrow :
             find_outer_actions(description_, positions.moved(), *position.solved)) {
          place(std::move(arrow), forces.size());
        }
      }
      result_.doubts.push_back(doubt(row, position, positions));
    }
    for (ActingArrow& arrow : outer_) {
      arrow.at.resize(shown.size());
    }
    result_.arrows = reaction_arrows(mechanism_, forces, drawn);
    std::ranges::move(outer_, std::back_inserter(result_.arrows));
    return std::move(result_);
  }

 private:
  // Of the last of that many positions.
  void place(DrawnArrow arrow, std::size_t count) {
    auto found = std::ranges::find_if(outer_, [&](const ActingArrow& one) {
      return one.kind == arrow.kind && one.is_axial == arrow.is_axial && one.name == arrow.name;
    });
    if (found == outer_.end()) {
      outer_.push_back({.kind = arrow.kind,
                        .name = std::move(arrow.name),
                        .is_axial = arrow.is_axial,
                        .at = {}});
      found = outer_.end() - 1;
    }
    found->at.resize(count);
    found->at.back() = PlacedVector{.at = arrow.at, .vector = arrow.vector};
  }

  FrictionSliding sliding_beside(std::size_t row, double steps, MotionPositions& positions) {
    const double share = share_at_step(motion_, static_cast<double>(row) + steps);
    const std::optional<Configuration> there = configurations_.at(share);
    return there ? sliding_at(mechanism_, plan_, positions.at(*there, share)) : FrictionSliding{};
  }

  // Whether what rests there slides one way before and the other way behind.
  bool reverses(const StaticSolution& action, std::size_t row, MotionPositions& positions) {
    if (row == 0 || row + 1 == motion_.solution.shares.size()) {
      return false;
    }
    const FrictionSliding before = sliding_beside(row, -kBesideRow, positions);
    const FrictionSliding behind = sliding_beside(row, kBesideRow, positions);
    const std::size_t count = std::min(before.rates.size(), behind.rates.size());
    for (std::size_t f = 0; f < count; ++f) {
      const bool rests = std::ranges::count(action.at_rest, mechanism_.frictions[f].coupling) > 0;
      if (rests && before.rates[f].dot(behind.rates[f]) < 0.0) {
        return true;
      }
    }
    return false;
  }

  // In the words of the finding that says it of the row.
  std::string doubt(std::size_t row, const MotionPosition& position, MotionPositions& positions) {
    if (position.state.is_singular || !position.solved) {
      return "the drives do not determine the motion";
    }
    const std::optional<StaticSolution>& action = position.solved->action;
    const bool is_known = action && !action->magnitudes.empty();
    if (is_known && impossible_status(positions.moved(), *position.solved).empty()) {
      return "";
    }
    const std::optional<ShiftAnalysis> no_shift;
    const CaseFindings found = find_case_findings(
        {.description = description_, .mechanism = positions.moved(), .shift = no_shift},
        *position.solved);
    const auto first = std::ranges::find(found.items(), Severity::error, &CaseFinding::severity);
    const auto said = first == found.items().end() ? found.items().begin() : first;
    const Code* const code = said == found.items().end() ? nullptr : find_code(said->code);
    if (action && action->status == SolveStatus::at_rest && reverses(*action, row, positions)) {
      return "friction reverses";
    }
    return code == nullptr ? "equilibrium has no answer" : std::string(code->title);
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  MotionPlan plan_;
  std::vector<CouplingReaction> reactions_;
  FollowedConfigurations configurations_;
  std::vector<ActingArrow> outer_;  // loads and actions of drives, up to the last position
  DrawnActions result_;
};

}  // namespace

DrawnActions make_drawn_actions(const MechanismDescription& description,
                                const Mechanism& mechanism,
                                const FoundMotion& motion,
                                const std::vector<std::size_t>& shown,
                                const DrawnMotion& drawn) {
  return has_actions(motion.plan, mechanism)
             ? ActionsMaker(description, mechanism, motion).run(shown, drawn)
             : DrawnActions{};
}

std::vector<ActingArrow> reaction_arrows(
    const Mechanism& mechanism,
    const std::vector<std::vector<std::optional<Vec3>>>& forces,
    const DrawnMotion& drawn) {
  std::vector<ActingArrow> arrows;
  const std::vector<CouplingReaction> reactions = coupling_reactions(mechanism);
  for (std::size_t r = 0; r < reactions.size(); ++r) {
    const CouplingId coupling = reactions[r].coupling;
    ActingArrow arrow{.kind = ArrowKind::reaction,
                      .name = mechanism.topology.coupling(coupling).name,
                      .is_axial = false,
                      .at = {}};
    for (std::size_t i = 0; i < forces.size(); ++i) {
      arrow.at.emplace_back();
      if (r < forces[i].size() && forces[i][r]) {
        const Geometry& there = drawn.positions[i].geometry;
        arrow.at.back() = PlacedVector{.at = there.points[static_cast<std::size_t>(coupling.value)],
                                       .vector = *forces[i][r]};
      }
    }
    arrows.push_back(std::move(arrow));
  }
  return arrows;
}

}  // namespace kinestat
