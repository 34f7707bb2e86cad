#include "studies/motion/task/motion_table_maker.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/tolerance.hpp"
#include "mechanism/label_kind.hpp"
#include "studies/motion/followed_configurations.hpp"
#include "studies/motion/task/assembly_table.hpp"
#include "studies/motion/task/columns/column_detail.hpp"
#include "studies/motion/task/columns/motion_column_choice.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"
#include "studies/motion/task/drive_counts.hpp"
#include "studies/motion/task/figures/approach_limits.hpp"
#include "studies/motion/task/figures/finer_rows.hpp"
#include "studies/motion/task/figures/motion_corners.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"
#include "studies/motion/task/figures/overall_efficiency.hpp"
#include "studies/motion/task/figures/poles.hpp"
#include "studies/motion/task/figures/reversal_events.hpp"
#include "studies/motion/task/figures/unbounded_quotients.hpp"
#include "studies/motion/task/figures/values_between.hpp"
#include "studies/motion/task/friction_watch.hpp"
#include "studies/motion/task/idle_rates.hpp"
#include "studies/motion/task/motion_events.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

namespace {

// Of more columns extremes are those of the steps: to look between them takes several positions
// each.
constexpr std::size_t kMostClimbed = 400;

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

class TableMaker {
 public:
  TableMaker(const MechanismDescription& description,
             const Mechanism& mechanism,
             const FoundMotion& motion,
             const MotionScope& scope,
             PositionFindings& found)
      : description_(description),
        units_(description.units),
        mechanism_(mechanism),
        topology_(mechanism.topology),
        motion_(motion),
        solution_(motion.solution),
        plan_(motion.plan),
        scope_(scope),
        found_(found),
        counts_(drive_counts(description, topology_, plan_)),
        friction_(description, mechanism, motion) {}

  MotionTable run() {
    table_.end = end_of(solution_.status);
    table_.label =
        plan_.which < 0 ? "" : mechanism_.cases[static_cast<std::size_t>(plan_.which)].label;
    table_.steps = plan_.steps;
    table_.until_limit = std::ranges::any_of(plan_.drives, &PlannedDrive::until_limit);
    if (plan_.schedule) {
      table_.duration = units_.from_si(QuantityKind::time, plan_.schedule->duration());
      table_.time_unit = units_.text(QuantityKind::time);
    }
    table_.length_unit = units_.text(QuantityKind::length);
    table_.angle_unit = units_.text(QuantityKind::angle);
    add_drives();
    add_rows();
    add_events();
    add_column_figures();
    quotients_.leave_out_unbounded(readings_, table_.drives.size(), steps_, table_);
    if (overall_) {
      overall_->finish(table_);
    }
    add_assembly(solution_.assembly, mechanism_, units_, table_);
    return std::move(table_);
  }

 private:
  QuantityKind kind_of(const PlannedDrive& drive) const {
    const auto f = static_cast<std::size_t>(drive.freedom);
    return position_kind(topology_.freedoms[f].is_rotation);
  }

  double in_unit(QuantityKind kind, double value) const {
    return units_.from_si(kind, value) + 0.0;  // never -0
  }

  double drive_at(std::size_t d, int p) const {
    return shown_drive(description_, topology_, motion_, counts_[d], d, p);
  }

  void add_drives() {
    const int last = solution_.position_count() - 1;
    for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
      const PlannedDrive& drive = plan_.drives[d];
      const QuantityKind kind = kind_of(drive);
      const ActuatorTopology& actuator =
          topology_.actuators[static_cast<std::size_t>(drive.actuator)];
      table_.drives.push_back({.name = actuator.name,
                               .freedom = topology_.freedom_name(drive.freedom),
                               .unit = units_.text(kind),
                               .from = in_unit(kind, drive.from),
                               .to = in_unit(kind, drive.to),
                               .reached = !solution_.lost_at.empty()
                                              ? std::optional(in_unit(kind, solution_.lost_at[d]))
                                          : last < 0 ? std::nullopt
                                                     : std::optional(drive_at(d, last))});
      table_.columns.push_back({.element = actuator.name,
                                .quantity = std::string(kDriveColumn),
                                .unit = units_.text(kind)});
      tell_named(table_.columns.back());
    }
  }

  // Of columns that every table has.
  void tell_named(MotionColumn& column) const {
    column.is_named = plan_.report.chosen && is_among(plan_.report.chosen->named, column.name());
  }

  void add_rows() {
    if (solution_.position_count() == 0) {
      return;
    }
    detail_ = detail_of(plan_, mechanism_);
    detail_.closure_error = worst_closure_error(solution_);
    MotionPositions positions(mechanism_, plan_, motion_.network, motion_.drawn, detail_);
    const MotionPosition first_position = positions.at(solution_.configuration_at(0), 0.0);
    readings_ = motion_readings(description_, mechanism_, plan_, first_position);
    leave_out_idle_motions(motion_, mechanism_, readings_);
    if (scope_.columns) {
      keep_readings([&](const MotionColumn& one) { return is_among(*scope_.columns, one.name()); },
                    readings_);
    }
    if (scope_.overall_efficiency && first_position.solved) {
      overall_.emplace(mechanism_, plan_);
      overall_->add_readings(*first_position.solved, readings_);
    }
    for (const MotionReading& reading : readings_) {
      table_.columns.push_back(reading.column);
      const auto drive =
          std::ranges::find(table_.drives, reading.column.element, &DriveTravel::freedom);
      const bool is_driven = drive != table_.drives.end() && reading.column.quantity == "position";
      driven_.push_back(is_driven ? static_cast<int>(drive - table_.drives.begin()) : -1);
    }
    for (int p = 0; p < solution_.position_count(); ++p) {
      const Configuration configuration = solution_.configuration_at(p);
      const auto row = static_cast<std::size_t>(p);
      const MotionPosition position =
          positions.at(configuration, solution_.shares[row], time_of_row(motion_, row));
      said_.push_back(judge_position(description_,
                                     plan_,
                                     position,
                                     positions.moved(),
                                     said_.empty() ? nullptr : &said_.back()));
      add_crossing_cables(
          description_, mechanism_, motion_, configuration, position.state.poses, said_.back());
      add_row(p, position);
      table_.rows.back().status = status_of(p, position, positions.moved());
    }
    friction_.look_between(said_, positions);
    friction_.find_turns(positions, table_);
    friction_.tell(said_, table_, found_);
    table_.columns.push_back(
        {.element = "", .quantity = std::string(kClosureErrorColumn), .unit = ""});
    tell_named(table_.columns.back());
    for (std::size_t r = 0; r < table_.rows.size(); ++r) {
      const double closure = solution_.closure_errors[r];
      table_.rows[r].values.emplace_back(closure);
      if (closure > table_.worst_closure) {
        table_.worst_closure = closure;
        table_.worst_step = table_.rows[r].step;
      }
    }
  }

  void add_row(int p, const MotionPosition& position) {
    MotionRow row{.step = p, .values = {}, .status = {}};
    row.lacks_velocities = detail_.velocity && !has_motion(position);
    row.lacks_accelerations =
        detail_.acceleration && has_motion(position) && position.state.twist_rates.empty();
    for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
      row.values.emplace_back(drive_at(d, p));
    }
    for (std::size_t r = 0; r < readings_.size(); ++r) {
      const MotionReading& reading = readings_[r];
      const std::optional<double> value = reading.value(position);
      row.values.push_back(value && std::isfinite(*value)
                               ? std::optional(value_in_unit(r, p, *value))
                               : std::nullopt);
      const bool is_left_out = !value && !reading.is_idle && has_motion(position);
      row.drops_velocities |= is_left_out && is_rate(reading.kind);
      row.drops_accelerations |=
          is_left_out && !row.lacks_accelerations && is_rate_of_rate(reading.kind);
    }
    row.at_rest = values_at_rest(position, solution_.shares[static_cast<std::size_t>(p)]);
    table_.rows.push_back(std::move(row));
    steps_.push_back(step_of_row(motion_, static_cast<std::size_t>(p)));
    quotients_.look(readings_, position, steps_.back(), has_drive_at_rest(plan_, position));
    rates_.push_back(position.state.rates);
    friction_.add_row(steps_.back(), sliding_at(mechanism_, plan_, position));
    coast_flanks_.push_back(position.solved ? std::optional(position.solved->coast_flanks)
                                            : std::nullopt);
    springs_.push_back(position.solved ? position.solved->springs : std::vector<SpringState>());
  }

  // A driven freedom stands where its drive does.
  double value_in_unit(std::size_t reading, int p, double value) const {
    const auto d = static_cast<std::size_t>(std::max(driven_[reading], 0));
    const double drive = solution_.drive_value(d, p);
    const bool is_drive =
        driven_[reading] >= 0 && std::abs(value - drive) <= kSameValue * std::abs(drive);
    return is_drive ? drive_at(d, p) : in_unit(readings_[reading].kind, value);
  }

  std::string status_of(int p, const MotionPosition& position, const Mechanism& moved) const {
    if (p + 1 == solution_.position_count() && solution_.status == MotionStatus::limit) {
      return std::string(kLimitEvent);
    }
    return status_of_position(plan_, position, moved);
  }

  std::vector<double> drives_at(double share) const {
    std::vector<double> all;
    for (const PlannedDrive& drive : plan_.drives) {
      all.push_back(in_unit(kind_of(drive), solution_.drive_at(all.size(), share)));
    }
    return all;
  }

  // How uncertain the position of the first drive is at a share that is uncertain by so much.
  // Shares of the way to the start, before the first step, are of that way.
  double uncertainty(double share, double by, int step) const {
    const PlannedDrive& drive = plan_.drives.front();
    const double nearer = share > by ? share - by : share + by;  // within the way
    const double reach = solution_.drive_at(0, nearer) - solution_.drive_at(0, share);
    return in_unit(kind_of(drive), std::abs(step < 0 ? by * drive.from : reach));
  }

  // The kind of the event, and the element that it is of.
  std::pair<std::string_view, std::string> event_of(const SpecialPosition& special) const {
    switch (special.kind) {
      case SpecialKind::limit:
        return {kLimitEvent, table_.drives.front().name};
      case SpecialKind::lift_off:
        return {kLiftOffEvent, mechanism_.contacts[static_cast<std::size_t>(special.contact)].name};
      case SpecialKind::change_point:
        return {kSingularEvent, ""};
    }
    return {};
  }

  // Of all columns, or of the drives and of places alone.
  std::vector<std::optional<double>> values_at(const MotionPosition& position,
                                               double share,
                                               bool of_places = false) const {
    const std::vector<double> drives = drives_at(share);
    std::vector<std::optional<double>> values(drives.begin(), drives.end());
    for (const MotionReading& reading : readings_) {
      const std::optional<double> value =
          of_places && !is_place(reading.column) ? std::nullopt : reading.value(position);
      values.push_back(value && std::isfinite(*value) ? std::optional(in_unit(reading.kind, *value))
                                                      : std::nullopt);
    }
    values.emplace_back();  // the closure error
    return values;
  }

  // What acts there without friction, if only its direction is open; not that friction itself.
  std::vector<std::optional<double>> values_at_rest(const MotionPosition& position,
                                                    double share) const {
    if (!position.without_friction) {
      return {};
    }
    auto values = values_at(position.or_without_friction(), share);
    for (std::size_t r = 0; r < readings_.size(); ++r) {
      if (readings_[r].is_of_friction) {
        values[table_.drives.size() + r] = read_column(readings_, r, position, units_);
      }
    }
    return values;
  }

  // Extremes of positions lie where a freedom turns back.
  std::vector<std::optional<double>> places_at(const DeadPoint& point,
                                               MotionPositions& positions) const {
    if (point.step < 0 || readings_.empty()) {
      return {};
    }
    return values_at(positions.at(point.configuration, point.share), point.share, true);
  }

  void add_events() {
    struct Placed {
      double share = 0.0;
      MotionEvent event;
    };

    std::vector<Placed> placed;
    const bool has_poles =
        (detail_.velocity || detail_.statics) && may_have_poles(plan_, mechanism_);
    const DeadPoints dead_points =
        scope_.dead_points || has_poles ? find_dead_points(mechanism_, motion_) : DeadPoints{};
    if (has_poles) {
      poles_at_ = find_poles(motion_, dead_points.points);
    }
    table_.may_lack_dead_points = scope_.dead_points && dead_points.may_lack_some;
    MotionPositions positions(mechanism_, plan_, motion_.network, motion_.drawn, {});
    for (const DeadPoint& point : dead_points.points) {
      placed.push_back(
          {.share = point.share,
           .event = {.kind = std::string(kDeadPointEvent),
                     .element = topology_.freedom_name(point.freedom),
                     .step = point.step,
                     .drive = drives_at(point.share),
                     .uncertainty = uncertainty(point.share, point.uncertainty, point.step),
                     .places = places_at(point, positions),
                     .reverses = point.reverses}});
    }
    for (const SpecialPosition& special : solution_.special) {
      std::vector<double> drive;
      for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
        drive.push_back(in_unit(kind_of(plan_.drives[d]), special.drive_values[d]));
      }
      const auto [kind, element] = event_of(special);
      placed.push_back(
          {.share = special.share,
           .event = {.kind = std::string(kind),
                     .element = element,
                     .step = special.step,
                     .drive = std::move(drive),
                     .uncertainty = uncertainty(special.share, special.uncertainty, special.step),
                     .places = {}}});
    }
    std::ranges::stable_sort(
        placed, {}, [](const Placed& one) { return std::pair(one.event.step >= 0, one.share); });
    for (Placed& one : placed) {
      one.event.row = one.event.step < 0 ? -1.0 : step_at_share(motion_, one.share);
      table_.events.push_back(std::move(one.event));
    }
  }

  void add_column_figures() {
    const auto where_at = [this](double share) {
      return FigureWhere{.drive = drives_at(share).front(), .step = step_at_share(motion_, share)};
    };
    const auto share_at = [this](double step) { return share_at_step(motion_, step); };
    if (readings_.empty()) {
      add_figures(solution_.shares, steps_, {}, {}, {}, where_at, share_at, table_);
      return;
    }
    const auto own = std::ranges::count_if(table_.columns, OverallEfficiency::is_own);
    table_.looks_between_steps =
        scope_.extremes || table_.columns.size() <= kMostClimbed + static_cast<std::size_t>(own);
    const std::vector<FigureColumn> columns =
        figure_columns(readings_, table_.drives.size(), units_, [this](const MotionColumn& one) {
          return !OverallEfficiency::is_own(one) &&
                 (scope_.extremes ? is_among(*scope_.extremes, one.name())
                                  : table_.looks_between_steps);
        });
    FollowedConfigurations configurations(mechanism_, motion_.network, solution_);
    ValuesBetween values(
        mechanism_, motion_, detail_, readings_, units_, configurations, quotients_);
    const std::size_t first = table_.drives.size();
    Corners corners = find_corners(
        mechanism_,
        motion_,
        detail_,
        {.sliding = friction_.places(),
         .turns = friction_.turns(),
         .springs = springs_,
         .coast_flanks = coast_flanks_,
         .poles = poles_at_,
         .rates = rates_},
        [this](const auto& position, double share) {
          quotients_.look(readings_,
                          position,
                          step_at_share(motion_, share),
                          has_drive_at_rest(plan_, position));
          return FigureValues{.values = values_at(position, share),
                              .at_rest = values_at_rest(position, share)};
        },
        configurations);
    table_.corners = std::move(corners.steps);
    table_.places = places_of_lines(corners.places, steps_);
    BetweenSteps between;
    if (table_.looks_between_steps) {
      between.value = [&](std::size_t column, double share, Look look) {
        return values.at(column - first, share, look);
      };
      between.is_jammed = [&](double share) { return values.is_jammed(share); };
    }
    add_figures(
        solution_.shares, steps_, corners.view(), columns, between, where_at, share_at, table_);
    add_reversals(
        motion_,
        corners.reversals,
        steps_,
        [this](double share) { return drives_at(share); },
        table_);
  }

  const MechanismDescription& description_;
  const FileUnits& units_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  const FoundMotion& motion_;
  const MotionSolution& solution_;
  const MotionPlan& plan_;
  const MotionScope& scope_;
  PositionFindings& found_;
  std::vector<std::optional<WholeRange>> counts_;  // of each drive
  MotionDetail detail_;
  std::optional<OverallEfficiency> overall_;
  std::vector<MotionReading> readings_;
  std::vector<int> driven_;  // of each reading the drive whose position it is, or -1
  FrictionWatch friction_;
  std::vector<FreedomRates> rates_;                            // of each row
  std::vector<std::vector<SpringState>> springs_;              // likewise
  std::vector<std::optional<std::vector<int>>> coast_flanks_;  // likewise
  std::vector<CaseFindings> said_;                             // likewise
  UnboundedQuotients quotients_;
  std::vector<double> steps_;     // at which the rows stand
  std::vector<double> poles_at_;  // in steps
  MotionTable table_;
};

}  // namespace

MotionTable make_motion_table(const MechanismDescription& description,
                              const Mechanism& mechanism,
                              const FoundMotion& motion,
                              const MotionScope& scope,
                              PositionFindings& found) {
  const bool has_figures = !scope.columns || !scope.columns->empty() || scope.overall_efficiency;
  const std::optional<FinerMotion> finer =
      has_figures ? divide_steps(mechanism, motion) : std::nullopt;
  found.keep(finer ? finer->rows : std::vector<std::size_t>());
  MotionTable table =
      TableMaker(description, mechanism, finer ? finer->motion : motion, scope, found).run();
  if (finer) {
    keep_rows(*finer, motion.plan.steps, table);
  }
  return table;
}

}  // namespace kinestat
