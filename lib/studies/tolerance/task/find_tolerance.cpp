#include "studies/tolerance/task/find_tolerance.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cases/chosen_case.hpp"
#include "core/index.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "mechanism/label_kind.hpp"
#include "studies/motion/moved_mechanism.hpp"
#include "studies/motion/task/drive_counts.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/motion/task/motion_findings.hpp"
#include "studies/motion/task/motion_position.hpp"
#include "studies/motion/task/motion_table_maker.hpp"
#include "studies/tolerance/task/read_tolerances.hpp"

namespace kinestat {

namespace {

class ToleranceJob {
 public:
  ToleranceJob(const Analysis& analysis, const ToleranceChoice& choice, Diagnostics& found)
      : analysis_(analysis),
        mechanism_(analysis.mechanism),
        choice_(choice),
        found_(found),
        errors_before_(found.error_count()),
        plan_(bind_motion(analysis.description, analysis.mechanism)) {}

  std::optional<FoundTolerance> run() {
    check_positions();
    return choice_.along ? along_motion() : drawn_cases();
  }

 private:
  bool has_errors() const { return found_.error_count() > errors_before_; }

  std::span<const TracedPoint> points() const {
    return plan_ ? std::span<const TracedPoint>(plan_->trace) : std::span<const TracedPoint>();
  }

  static FoundTolerance answer_with(const ReadTolerances& tolerances) {
    return {.place = tolerances.place, .angle = tolerances.angle, .cases = {}};
  }

  // Nothing holds an idle freedom, whose rate is assumed.
  static Case as_typed(Case which) {
    std::erase_if(which.motions, &Primary::is_assumed);
    return which;
  }

  // Teeth touch on the flank that the load of a case presses, if it has one.
  Mechanism on_loaded_flanks(const std::vector<int>& coast_flanks) const {
    Mechanism loaded = mechanism_;
    load_coast_flanks(coast_flanks, loaded.geometry);
    return loaded;
  }

  // Empty iff an error was added.
  std::optional<ReadTolerances> read(std::span<const Case> cases) {
    const int errors_before = found_.error_count();
    ReadTolerances result =
        read_tolerances(mechanism_.topology, analysis_.description.units, cases, choice_, found_);
    return found_.error_count() > errors_before ? std::nullopt : std::optional(std::move(result));
  }

  std::optional<FoundTolerance> drawn_cases() {
    std::vector<Case> cases;
    for (const CaseAnalysis& one : analysis_.cases) {
      cases.push_back(as_typed(one.which));
    }
    const std::optional<ReadTolerances> tolerances = read(cases);
    if (!is_case_known() || !tolerances) {
      return {};
    }
    FoundTolerance result = answer_with(*tolerances);
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const CaseAnalysis& one = analysis_.cases[c];
      const bool is_asked = choice_.case_label.empty() || choice_.case_label == one.which.label;
      if (is_asked && one.motion && one.motion->status == SolveStatus::solved) {
        result.cases.push_back(tolerance_of(on_loaded_flanks(one.coast_flanks),
                                            cases[c],
                                            watched_of(cases[c]),
                                            tolerances->of_cases[c]));
      }
    }
    check_answered(result.cases);
    return has_errors() ? std::nullopt : std::optional(std::move(result));
  }

  // The drives of the motion are held at each of its steps, up to where it ends.
  std::optional<FoundTolerance> along_motion() {
    if (!plan_) {
      found_.error("E0303",
                   {},
                   "--along: the file has no section 'motion'",
                   "add motion: {drive: NAME, to: VALUE}");
      return {};
    }
    Case held;
    for (const PlannedDrive& drive : plan_->drives) {
      held.motions.push_back({.index = drive.freedom,
                              .given = mechanism_.topology.actuators[at(drive.actuator)].name,
                              .where = drive.where});
    }
    const std::optional<ReadTolerances> tolerances = read({&held, 1});
    MotionPlan plan = *plan_;
    plan.which = -1;  // positions alone
    plan.report = {};
    std::optional<FoundMotion> motion =
        tolerances ? follow_motion(analysis_.description, mechanism_, std::move(plan), found_)
                   : std::nullopt;
    if (!motion || has_errors()) {
      return {};
    }
    FoundTolerance result = answer_with(*tolerances);
    result.is_along = true;
    PositionFindings of_positions;
    motion->table = make_motion_table(analysis_.description,
                                      mechanism_,
                                      *motion,
                                      {.columns = std::vector<std::string>(),
                                       .dead_points = false,
                                       .extremes = std::vector<std::string>()},
                                      of_positions);
    add_motion_findings(*motion, analysis_.description, mechanism_, found_);
    result.cases = steps_of(*motion, held, tolerances->of_cases.front());
    return result.cases.empty() ? std::nullopt : std::optional(std::move(result));
  }

  std::vector<CaseTolerance> steps_of(const FoundMotion& motion,
                                      const Case& held,
                                      const PartTolerances& tolerances) const {
    const std::vector<WatchedPosition> drawn = watched_of(held);
    MotionPositions positions(mechanism_, motion.plan, motion.network, motion.drawn, {});
    Mechanism moved = mechanism_;
    const std::optional<WholeRange> count =
        drive_counts(analysis_.description, mechanism_.topology, motion.plan).front();
    const QuantityKind kind = position_kind(
        mechanism_.topology.freedoms[at(motion.plan.drives.front().freedom)].is_rotation);
    std::vector<CaseTolerance> result;
    for (int p = 0; p < motion.solution.position_count(); ++p) {
      const Configuration configuration = motion.solution.configuration_at(p);
      const MotionPosition position = positions.at(configuration, motion.solution.shares[at(p)]);
      CaseTolerance step;
      if (!position.state.is_singular) {
        move_mechanism(
            motion.network, motion.drawn, configuration, position.state.poses, mechanism_, moved);
        moved.closure_error = worst_closure_error(motion.solution);
        step = tolerance_of(moved, held, moved_with(drawn, position), tolerances);
      }
      step.drive = DrivePlace{
          .name = held.motions.front().given,
          .value = {
              .value = shown_drive(analysis_.description, mechanism_.topology, motion, count, 0, p),
              .unit = analysis_.description.units.text(kind)}};
      step.label = fmt::format("step {}", p);
      result.push_back(std::move(step));
    }
    return result;
  }

  // Points of bodies stand elsewhere now.
  static std::vector<WatchedPosition> moved_with(std::vector<WatchedPosition> watched,
                                                 const MotionPosition& position) {
    for (WatchedPosition& one : watched) {
      if (auto* const body = std::get_if<BodyDisplacement>(&one.of)) {
        if (body->at) {
          body->at = position.state.poses[at(body->body.value)].point(*body->at);
        }
      }
    }
    return watched;
  }

  // False iff an error was added.
  bool is_case_known() {
    std::vector<std::string> labels;
    for (const CaseAnalysis& one : analysis_.cases) {
      labels.push_back(one.which.label);
    }
    if (labels.empty()) {
      found_.error("E0101",
                   {},
                   "the file has no cases, and nothing says which drives are held",
                   plan_ ? "write --along, to hold those of the motion, or add a case: help cases"
                         : "add a case with a motion: help cases");
      return false;
    }
    if (!choice_.case_label.empty() &&
        std::ranges::find(labels, choice_.case_label) == labels.end()) {
      refuse_case(choice_.case_label, labels, found_);
      return false;
    }
    return true;
  }

  // Of a figure of a motion, such as 'd.vx/range', where to find it.
  static std::string name_hint(const std::string& name, const std::vector<std::string>& names) {
    const std::string of = name.substr(0, name.find('/'));
    const bool is_figure = of != name && std::ranges::find(names, of) != names.end();
    return is_figure ? fmt::format(
                           "write '{0}'; how its range over a motion varies is a sweep with "
                           "'report: [{0}.position.range]': help sweeps",
                           of)
                     : guess_before(name, names, "write one of " + plain_list(names));
  }

  void check_positions() {
    for (const std::string& name : choice_.positions) {
      if (watched_positions(mechanism_, points(), name).empty()) {
        const std::vector<std::string> names = watched_names(mechanism_, points());
        found_.error("E0101",
                     {},
                     fmt::format("--of '{}': there is no such freedom, actuator, point or body",
                                 printable(name)),
                     name_hint(name, names));
      }
    }
  }

  // The drives are held where the velocities follow from theirs.
  void check_answered(const std::vector<CaseTolerance>& cases) {
    if (cases.empty()) {
      found_.error("E0101",
                   {},
                   "no case has velocities that follow from its drives",
                   mechanism_.topology.actuators.empty()
                       ? "give a case 'motion: {}', in which nothing moves"
                       : "give the motion of the drives that are held: help cases");
    }
  }

  std::vector<WatchedPosition> watched_of(const Case& which) const {
    if (choice_.positions.empty()) {
      return usual_positions(mechanism_, points(), which);
    }
    std::vector<WatchedPosition> result;
    for (const std::string& name : choice_.positions) {
      std::ranges::move(watched_positions(mechanism_, points(), name), std::back_inserter(result));
    }
    return result;
  }

  CaseTolerance tolerance_of(const Mechanism& mechanism,
                             const Case& which,
                             std::span<const WatchedPosition> watched,
                             const PartTolerances& tolerances) const {
    const std::vector<Deviation> deviations = part_deviations(mechanism);
    const Influences influences = find_influences(mechanism, which, deviations, watched);
    CaseTolerance result;
    result.label = which.label;
    for (const Primary& held : which.motions) {
      result.held.push_back(held.given);
    }
    result.positions =
        stack_tolerances(mechanism, which, deviations, watched, influences, tolerances);
    for (std::size_t w = 0; w < watched.size(); ++w) {
      if (!influences.of[w]) {
        result.loose.push_back(watched[w].name);
      }
    }
    for (std::size_t d = 0; d < deviations.size(); ++d) {
      if (!influences.fits[d]) {
        result.not_fitting.push_back(mechanism_.topology.action_name(deviations[d].action));
      }
    }
    result.has_tolerances = std::ranges::any_of(result.positions, [](const ToleranceStack& stack) {
      return std::ranges::any_of(stack.shares,
                                 [](const ToleranceShare& share) { return share.tolerance > 0.0; });
    });
    return result;
  }

  const Analysis& analysis_;
  const Mechanism& mechanism_;
  const ToleranceChoice& choice_;
  Diagnostics& found_;
  int errors_before_ = 0;
  std::optional<MotionPlan> plan_;
};

}  // namespace

std::optional<FoundTolerance> find_tolerance(const Analysis& analysis,
                                             const ToleranceChoice& choice,
                                             Diagnostics& found) {
  return ToleranceJob(analysis, choice, found).run();
}

}  // namespace kinestat
