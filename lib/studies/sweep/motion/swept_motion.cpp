#include "studies/sweep/motion/swept_motion.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "mechanism/check/report_name_check.hpp"
#include "mechanism/column_path.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/task/columns/motion_column_offers.hpp"
#include "studies/motion/task/motion_events.hpp"
#include "studies/motion/task/motion_findings.hpp"

namespace kinestat {

namespace {

// Places follow from the drives alone.
bool needs_case(MotionReport report) {
  report.position = false;
  return !report.actions.empty() ||
         std::ranges::any_of(motion_report_words(), [&](const std::string& word) {
           return *find_report_word(word, report);
         });
}

// Actions are called as in a single position, and what is of the whole needs no element.
std::string brief_name(const MotionColumn& column) {
  const std::string& quantity = column.quantity;
  const bool is_of_whole =
      quantity == "ratio" || quantity == "transmission_angle" || quantity == "mechanical_advantage";
  return quantity == kActionColumn ? column.element : is_of_whole ? quantity : std::string();
}

template <class Candidates>
auto find_column(const Candidates& all, const std::string& column) {
  return std::ranges::find_if(all, [&](const auto& one) {
    return one.dotted == column || one.brief == column ||
           std::ranges::count(one.others, column) > 0;
  });
}

}  // namespace

MotionColumnSearch::MotionColumnSearch(const MechanismDescription& description,
                                       const Mechanism& mechanism,
                                       std::vector<int> cases,
                                       Diagnostics& found)
    : description_(description), mechanism_(mechanism), found_(found) {
  std::vector<int> driven;
  for (const PlannedDrive& drive : plan_of(-1).drives) {
    driven.push_back(drive.freedom);
  }
  const MotionNetwork network =
      make_motion_network(mechanism, bind_drawn_couplings(description, mechanism), driven);
  positions_ = freedom_positions(network, mechanism, drawn_configuration(network));
  watched_ = watched_freedoms(mechanism, network);
  asked_.scope = {.columns = std::vector<std::string>(),
                  .dead_points = false,
                  .extremes = std::vector<std::string>()};
  asked_.cases = std::move(cases);
  for (const int which : asked_.cases) {
    candidates_.push_back(candidates_of(which));
    const MotionPlan plan = plan_of(which);
    is_in_time_ = is_in_time_ || plan.schedule || plan.time_problem != TimeProblem::none;
  }
  // Then positions are those at other times.
  asked_.is_of_case = is_in_time_ && runs_by_case(*description.motion) && asked_.cases.front() >= 0;
}

MotionPlan MotionColumnSearch::plan_of(int which) const {
  MotionPlan plan =
      *bind_motion(description_, mechanism_, which < 0 ? std::nullopt : std::optional(which));
  plan.which = which;
  return plan;
}

std::vector<MotionColumnSearch::Candidate> MotionColumnSearch::candidates_of(int which) const {
  const MotionPlan plan = plan_of(which);
  std::vector<Candidate> all;
  for (MotionColumnOffer& one : motion_column_offers(description_, mechanism_, plan, positions_)) {
    std::string name = one.column.name();
    std::vector<std::string> others;
    for (const auto& [element, quantity] : names_of(one.column, mechanism_.topology)) {
      others.push_back(element + "." + quantity);
    }
    all.push_back({.name = name,
                   .dotted = dotted(name),
                   .others = std::move(others),
                   .brief = brief_name(one.column),
                   .unit = one.column.unit,
                   .needs = std::move(one.needs)});
  }
  all.push_back({.name = std::string(kClosureErrorColumn),
                 .dotted = std::string(kClosureErrorColumn),
                 .others = {},
                 .brief = {},
                 .unit = {},
                 .needs = {}});
  return all;
}

std::optional<SweepColumn> MotionColumnSearch::find(const Name& name) {
  MotionFigureName asked = *motion_figure_of(name.text);
  asked.column = dotted(asked.column);
  if (asked.figure == MotionFigure::dead_points) {
    return find_dead_points(name, asked);
  }
  if (asked.figure == MotionFigure::overall_efficiency) {
    return find_efficiency_of_whole(name);
  }
  const Candidate* column = nullptr;
  for (const std::vector<Candidate>& of_case : candidates_) {
    const auto at = find_column(of_case, asked.column);
    if (at == of_case.end()) {
      continue;
    }
    if (column != nullptr && (column->unit != at->unit || column->name != at->name)) {
      found_.error("E0305",
                   name.where,
                   fmt::format("'{}' is {} in '{}' in one case and {} in '{}' in another",
                               name.text,
                               column->name,
                               column->unit,
                               at->name,
                               at->unit),
                   "name cases under 'cases:' of 'sweep' whose inputs and outputs are alike");
      return std::nullopt;
    }
    column = &*at;
  }
  if (column == nullptr) {
    if (!lacks_case(asked.column)) {
      refuse_column(name, asked.column);
    }
    return std::nullopt;
  }
  if (asked.figure == MotionFigure::rms && !is_in_time_) {
    found_.error("E0305",
                 name.where,
                 fmt::format("'{}' is a mean in time, and the motion has none", name.text),
                 "add 'time' to 'motion', or ask for the mean or the peak");
    return std::nullopt;
  }
  unite(asked_.report, column->needs);
  asked_.is_of_case = asked_.is_of_case || needs_case(column->needs);
  // Positions are extreme where a freedom turns back.
  const bool is_extreme = asked.figure != MotionFigure::mean && asked.figure != MotionFigure::rms;
  asked_.scope.dead_points = asked_.scope.dead_points || (is_extreme && !needs_case(column->needs));
  asked_.scope.columns->push_back(column->name);
  if (is_extreme) {
    asked_.scope.extremes->push_back(column->name);
  }
  return add(name, {.column = column->name, .figure = asked.figure}, column->unit);
}

// The powers of what the case names as ends.
std::optional<SweepColumn> MotionColumnSearch::find_efficiency_of_whole(const Name& name) {
  MotionReport needs = report_of_word("velocity");
  unite(needs, report_of_word("efficiency"));
  if (!can_report(needs)) {
    return std::nullopt;
  }
  unite(asked_.report, report_of_word("power"));  // statuses of positions are those of powers
  asked_.is_of_case = true;
  asked_.scope.overall_efficiency = true;
  return add(name, {.column = {}, .figure = MotionFigure::overall_efficiency}, "");
}

std::optional<SweepColumn> MotionColumnSearch::find_dead_points(const Name& name,
                                                                const MotionFigureName& asked) {
  std::vector<std::string> names;
  for (const int freedom : watched_) {
    names.push_back(mechanism_.topology.freedom_name(freedom));
  }
  std::string column = asked.column;
  for (const ActuatorTopology& actuator : mechanism_.topology.actuators) {
    if (actuator.name == asked.column) {
      column = mechanism_.topology.freedom_name(actuator.freedom);
    }
  }
  if (!column.empty() && std::ranges::find(names, column) == names.end()) {
    found_.error(
        "E0313",
        name.where,
        fmt::format("dead points of '{}' are not looked for", asked.column),
        names.empty()
            ? "freedoms at the ground and of actuators have them, if they are not driven; make it "
              "one of an actuator, or ask for its extremes: COLUMN.least"
            : guess_before(
                  asked.column,
                  names,
                  "those of freedoms at the ground and of actuators are: " + plain_list(names)));
    return std::nullopt;
  }
  asked_.scope.dead_points = true;
  return add(name, {.column = std::move(column), .figure = asked.figure}, "");
}

// Of a freedom alone, whose name would be a rate, those that it has.
void MotionColumnSearch::refuse_column(const Name& name, const std::string& column) {
  std::vector<std::string> all;
  std::vector<std::string> longer;
  std::vector<std::string> of_part;
  const std::string part = column.substr(0, column.find('.')) + ".";
  const auto has = [](const Candidate& one, const std::string& begin) {
    return std::ranges::any_of(
        one.others, [&begin](const std::string& other) { return other.starts_with(begin); });
  };
  for (const Candidate& one : candidates_.front()) {
    all.push_back(one.dotted);
    if (has(one, column + ".")) {
      longer.push_back(one.dotted);
    } else if (has(one, part)) {
      of_part.push_back(one.dotted);
    }
  }
  const std::vector<std::string>& near = of_part.empty() ? all : of_part;
  found_.error("E0313",
               name.where,
               fmt::format("the motion has no column '{}'", column),
               longer.empty() ? guess_before(column, near, "it has " + plain_list(near))
                              : "it has " + plain_list(longer));
}

// Where a case does not say what a word of the report needs, that is the matter.
bool MotionColumnSearch::lacks_case(const std::string& column) {
  return needs_case_of_its_own(column) ||
         std::ranges::any_of(motion_report_words(), [&](const std::string& word) {
           const bool is_of_word = column == word || column.ends_with("." + word);
           return is_of_word && !can_report(report_of_word(word));
         });
}

// A motion with one of the cases has the column, and this one is without any.
bool MotionColumnSearch::needs_case_of_its_own(const std::string& column) {
  if (std::ranges::find(asked_.cases, -1) == asked_.cases.end()) {
    return false;
  }
  for (std::size_t c = 0; c < mechanism_.cases.size(); ++c) {
    const std::vector<Candidate> all = candidates_of(static_cast<int>(c));
    const auto at = find_column(all, column);
    if (at != all.end()) {
      return !can_report(at->needs);
    }
  }
  return false;
}

bool MotionColumnSearch::can_report(const MotionReport& report) {
  Diagnostics found;
  const bool can = std::ranges::all_of(asked_.cases, [&](int which) {
    MotionPlan plan = plan_of(which);
    plan.report = report;
    return check_report(plan, mechanism_, found, CasePlace::sweep);
  });
  // Once for all columns.
  for (const Diagnostic& one : found.items()) {
    if (std::ranges::find(found_.items(), one.message, &Diagnostic::message) ==
        found_.items().end()) {
      found_.error(one.code, one.where, one.message, one.hint);
    }
  }
  return can;
}

std::optional<SweptMotion> MotionColumnSearch::take() {
  if (!can_report(asked_.report)) {
    return std::nullopt;
  }
  return std::move(asked_);
}

SweepColumn MotionColumnSearch::add(const Name& name, SweptFigure figure, std::string unit) {
  asked_.figures.push_back(std::move(figure));
  return {.kind = SweepColumnKind::motion,
          .index = static_cast<int>(asked_.figures.size()) - 1,
          .name = name.text,
          .unit = std::move(unit)};
}

}  // namespace kinestat
