#include "studies/motion/picture/placed_mechanism.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cases/chosen_case.hpp"
#include "cases/findings/case_findings.hpp"
#include "core/utf8.hpp"
#include "draw/axes.hpp"
#include "draw/linkage/drawn_motion.hpp"
#include "draw/picture_title.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/label_kind.hpp"
#include "studies/motion/picture/drawn_motion_maker.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/motion/task/motion_findings.hpp"
#include "studies/motion/task/motion_position.hpp"
#include "studies/motion/task/motion_table_maker.hpp"

namespace kinestat {

namespace {

class Placer {
 public:
  Placer(std::string file,
         const MechanismDescription& description,
         const Mechanism& mechanism,
         Diagnostics& found)
      : description_(description),
        mechanism_(mechanism),
        found_(found),
        plan_(*bind_motion(description, mechanism)) {
    placed_.drawn.file = std::move(file);
    placed_.drawn.description = description;
    placed_.drawn.mechanism = mechanism;
  }

  std::optional<PlacedMechanism> run(const PlaceChoice& choice) {
    const int errors_before = found_.error_count();
    const int which = case_of(choice.case_label);
    bool is_good = found_.error_count() == errors_before;
    for (const std::string& text : choice.at) {
      const std::optional<double> at = position_of(text);
      is_good = at && place(*at, placed_.positions.empty() ? which : -1) && is_good;
    }
    return is_good ? std::optional(std::move(placed_)) : std::nullopt;
  }

 private:
  const PlannedDrive& drive() const { return plan_.drives.front(); }

  bool turns() const {
    return mechanism_.topology.freedoms[static_cast<std::size_t>(drive().freedom)].is_rotation;
  }

  int case_of(const std::string& label) {
    if (label.empty()) {
      return plan_.which;
    }
    const Case* const one = choose_case(mechanism_.cases, label, found_);
    return one == nullptr ? -1 : static_cast<int>(one - mechanism_.cases.data());
  }

  // [rad or m]
  std::optional<double> position_of(const std::string& text) {
    auto parsed = parse_expression(text);
    if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
      found_.error(
          "E0101", {}, fmt::format("--at '{}': {}", printable(text), error->message), error->hint);
      return std::nullopt;
    }
    const Value value{.expression = std::get<Expression>(std::move(parsed)), .where = {}};
    return make_evaluator(description_, found_).number(value, position_kind(turns()));
  }

  // When a motion in time first has the first drive there, as share of its time.
  std::optional<double> time_at(double at) const {
    constexpr int kLooks = 1000;
    const auto beyond = [&](double time) { return plan_.schedule->at(0, time).position - at; };
    for (int k = 0; plan_.schedule && k < kLooks; ++k) {
      double low = static_cast<double>(k) / kLooks;
      double high = static_cast<double>(k + 1) / kLooks;
      const bool was_beyond = beyond(low) > 0.0;
      if (beyond(low) == 0.0) {
        return low;
      }
      if ((beyond(high) > 0.0) == was_beyond && beyond(high) != 0.0) {
        continue;
      }
      for (double middle = 0.5 * (low + high); low < middle && middle < high;
           middle = 0.5 * (low + high)) {
        ((beyond(middle) > 0.0) == was_beyond && beyond(middle) != 0.0 ? low : high) = middle;
      }
      return high;
    }
    return std::nullopt;
  }

  // From where the motion begins to where the first drive is there; others that move go with it.
  MotionPlan way_to(double at) const {
    MotionPlan plan = plan_;
    plan.steps = 1;
    plan.which = -1;
    plan.report = {};
    plan.schedule.reset();
    plan.time_problem = TimeProblem::none;
    PlannedDrive& first = plan.drives.front();
    // Where the first drive comes back to its beginning, nothing tells where others are.
    const double share = first.to == first.from ? 0.0 : (at - first.from) / (first.to - first.from);
    const std::optional<double> time = time_at(at);
    for (std::size_t d = 0; d < plan.drives.size(); ++d) {
      PlannedDrive& one = plan.drives[d];
      one.to =
          time ? plan_.schedule->at(d, *time).position : one.from + share * (one.to - one.from);
      one.until_limit = false;
    }
    first.to = at;
    return plan;
  }

  // False iff an error was added: it does not come so far.
  bool place(double at, int which) {
    std::optional<FoundMotion> motion = follow_motion(description_, mechanism_, way_to(at), found_);
    if (!motion) {
      return false;
    }
    PositionFindings of_positions;
    motion->table = make_motion_table(description_,
                                      mechanism_,
                                      *motion,
                                      {.columns = std::vector<std::string>(),
                                       .dead_points = false,
                                       .extremes = std::vector<std::string>()},
                                      of_positions);
    const int errors_before = found_.error_count();
    add_motion_findings(*motion, description_, mechanism_, found_, EndOfMotion::must_be_reached);
    if (found_.error_count() > errors_before || motion->solution.position_count() == 0) {
      return false;
    }
    const auto last = static_cast<std::size_t>(motion->solution.position_count()) - 1;
    DrawnMotion drawn = make_drawn_motion(*motion, motion->solution, {last}, mechanism_);
    placed_.positions.push_back(std::move(drawn.positions.front()));
    placed_.words.push_back(words_of(at));
    if (which >= 0) {
      add_case(*motion, which, time_at(at));
    }
    return true;
  }

  // With the speeds and the time that the motion has there, if it is of that case.
  void add_case(const FoundMotion& motion, int which, std::optional<double> time) {
    MotionPlan plan = motion.plan;
    plan.which = which;
    if (time && which == plan_.which) {
      plan.schedule = plan_.schedule;
    }
    const MotionDetail detail{
        .velocity =
            plan.schedule || !mechanism_.cases[static_cast<std::size_t>(which)].motions.empty(),
        .acceleration = mechanism_.cases[static_cast<std::size_t>(which)].has_inertia(),
        .statics = true,
        .transmission_angle = false,
        .closure_error = worst_closure_error(motion.solution)};
    MotionPositions positions(mechanism_, plan, motion.network, motion.drawn, detail);
    const MotionPosition position =
        positions.at(motion.solution.configuration_at(motion.solution.position_count() - 1),
                     motion.solution.shares.back(),
                     plan.schedule ? time : std::nullopt);
    if (!position.solved) {
      found_.warning(
          "W0503",
          plan.drives.front().where,
          fmt::format("{} is a singular position: case '{}' has no answer there",
                      placed_.words.front(),
                      printable(mechanism_.cases[static_cast<std::size_t>(which)].label)),
          "the drawing is without forces; a position close to it has some");
      return;
    }
    const std::optional<ShiftAnalysis> no_shift;
    const CaseFindings findings = find_case_findings(
        {.description = description_, .mechanism = positions.moved(), .shift = no_shift},
        *position.solved);
    for (const CaseFinding& one : findings.items()) {
      add(one, found_);
    }
    placed_.drawn.cases.push_back(*position.solved);
  }

  std::string words_of(double at) const {
    const QuantityKind kind = position_kind(turns());
    const std::string unit = description_.units.text(kind);
    return fmt::format(
        "{} = {}{}{}",
        mechanism_.topology.actuators[static_cast<std::size_t>(drive().actuator)].name,
        label_number(description_.units.from_si(kind, at), 6),
        unit.empty() ? "" : " ",
        unit);
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  Diagnostics& found_;
  MotionPlan plan_;
  PlacedMechanism placed_;
};

}  // namespace

std::optional<PlacedMechanism> place_mechanism(std::string file,
                                               const MechanismDescription& description,
                                               const Mechanism& mechanism,
                                               const PlaceChoice& choice,
                                               Diagnostics& found) {
  return Placer(std::move(file), description, mechanism, found).run(choice);
}

Picture draw_placed(const PlacedMechanism& placed) {
  LinkageOptions options;
  if (!placed.drawn.cases.empty()) {
    options.which = 0;
  }
  options.stands = placed.positions;
  for (const LinkagePosition& position : placed.positions) {
    add_places(placed.drawn.mechanism, position.poses, options);
  }
  options.remark = placed.words.front();
  if (placed.words.size() > 1) {
    const std::vector<std::string> others(placed.words.begin() + 1, placed.words.end());
    options.remark += fmt::format("; faint: {}", fmt::join(others, ", "));
  }
  Picture picture = draw_linkage(placed.drawn, options);
  picture.description += fmt::format(" {}.", options.remark);
  return picture;
}

}  // namespace kinestat
