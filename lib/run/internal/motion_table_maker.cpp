#include "run/internal/motion_table_maker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "run/internal/motion_columns.hpp"
#include "run/internal/motion_events.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kKinds = static_cast<std::size_t>(MotionKind::number) + 1;

MotionEnd end_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::completed:
      return MotionEnd::complete;
    case MotionStatus::limit:
      return MotionEnd::limited;
    case MotionStatus::locked:
      return MotionEnd::locked;
    case MotionStatus::not_assembled:
      return MotionEnd::not_assembled;
    case MotionStatus::singular:
    case MotionStatus::lost_branch:
    case MotionStatus::undetermined:
    case MotionStatus::not_movable:
      return MotionEnd::lost;
  }
  return MotionEnd::lost;
}

class TableMaker {
 public:
  TableMaker(const MechanismDescription& description,
             const Mechanism& mechanism,
             const FoundMotion& motion)
      : description_(description),
        units_(description.units),
        mechanism_(mechanism),
        topology_(mechanism.topology),
        motion_(motion),
        solution_(motion.solution),
        plan_(motion.plan) {}

  MotionTable run() {
    table_.end = end_of(solution_.status);
    table_.label =
        plan_.which < 0 ? "" : mechanism_.cases[static_cast<std::size_t>(plan_.which)].label;
    table_.steps = plan_.steps;
    table_.length_unit = units_.text(QuantityKind::length);
    table_.angle_unit = units_.text(QuantityKind::angle);
    add_drives();
    add_rows();
    add_events();
    add_assembly();
    return std::move(table_);
  }

 private:
  MotionKind kind_of(const PlannedDrive& drive) const {
    const auto f = static_cast<std::size_t>(drive.freedom);
    return topology_.freedoms[f].is_rotation ? MotionKind::angle : MotionKind::length;
  }

  double in_unit(MotionKind kind, double value) const {
    const double result = in_file_unit(units_, kind, value);
    return result == 0.0 ? 0.0 : result;
  }

  void add_drives() {
    const int last = solution_.position_count() - 1;
    for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
      const PlannedDrive& drive = plan_.drives[d];
      const MotionKind kind = kind_of(drive);
      const ActuatorTopology& actuator =
          topology_.actuators[static_cast<std::size_t>(drive.actuator)];
      table_.drives.push_back(
          {.name = actuator.name,
           .freedom = topology_.freedom_name(drive.freedom),
           .unit = unit_text(units_, kind),
           .from = in_unit(kind, drive.from),
           .to = in_unit(kind, drive.to),
           .reached = !solution_.lost_at.empty()
                          ? std::optional(in_unit(kind, solution_.lost_at[d]))
                      : last < 0 ? std::nullopt
                                 : std::optional(in_unit(kind, solution_.drive_value(d, last)))});
      table_.columns.push_back(
          {.element = actuator.name, .quantity = "drive", .unit = unit_text(units_, kind)});
    }
  }

  void add_rows() {
    if (solution_.position_count() == 0) {
      return;
    }
    MotionDetail detail = detail_of(plan_, mechanism_);
    detail.misclosure = worst_misclosure(solution_);
    MotionPositions positions(mechanism_, plan_, motion_.network, motion_.drawn, detail);
    const std::vector<MotionReading> readings = motion_readings(
        description_, mechanism_, plan_, positions.at(solution_.configuration_at(0)));
    for (const MotionReading& reading : readings) {
      table_.columns.push_back(reading.column);
    }
    for (int p = 0; p < solution_.position_count(); ++p) {
      add_row(p, positions.at(solution_.configuration_at(p)), readings);
    }
    table_.columns.push_back({.element = "", .quantity = "misclosure", .unit = ""});
    write_in_units(readings);
    for (std::size_t r = 0; r < table_.rows.size(); ++r) {
      const double closure = solution_.misclosures[r];
      table_.rows[r].values.emplace_back(closure);
      if (closure > table_.worst_closure) {
        table_.worst_closure = closure;
        table_.worst_step = table_.rows[r].step;
      }
    }
  }

  // Values in SI until the largest of each kind is known.
  void add_row(int p, const MotionPosition& position, const std::vector<MotionReading>& readings) {
    MotionRow row{.step = p, .values = {}, .status = status_of(p, position)};
    for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
      row.values.emplace_back(in_unit(kind_of(plan_.drives[d]), solution_.drive_value(d, p)));
    }
    for (const MotionReading& reading : readings) {
      std::optional<double> value = reading.value(position);
      value = value && std::isfinite(*value) ? value : std::nullopt;
      row.values.push_back(value);
      double& largest = largest_[static_cast<std::size_t>(reading.kind)];
      largest = std::max(largest, std::abs(value.value_or(0.0)));
    }
    table_.rows.push_back(std::move(row));
  }

  std::string status_of(int p, const MotionPosition& position) const {
    const bool is_last = p + 1 == solution_.position_count();
    if (is_last && solution_.status == MotionStatus::limit) {
      return "limit";
    }
    if (position.state.is_singular) {
      return "singular";
    }
    if (position.solved && position.solved->action) {
      return std::string(word_of(position.solved->action->status));
    }
    return "solved";
  }

  double& largest(MotionKind kind) { return largest_[static_cast<std::size_t>(kind)]; }

  // What turns fast moves points fast, and turning steadily accelerates them: a motion in which all
  // points rest has no velocities but rounding.
  void compare_turns_with_speeds() {
    using enum MotionKind;
    const double size = mechanism_.geometry.length;
    const double turns = std::max(largest(angular_velocity), largest(velocity) / size);
    const double bends =
        std::max({largest(angular_acceleration), largest(acceleration) / size, turns * turns});
    largest(angular_velocity) = turns;
    largest(velocity) = turns * size;
    largest(angular_acceleration) = bends;
    largest(acceleration) = bends * size;
  }

  void write_in_units(const std::vector<MotionReading>& readings) {
    compare_turns_with_speeds();
    const std::size_t first = plan_.drives.size();
    for (MotionRow& row : table_.rows) {
      for (std::size_t c = 0; c < readings.size(); ++c) {
        std::optional<double>& value = row.values[first + c];
        if (!value) {
          continue;
        }
        const MotionKind kind = readings[c].kind;
        const double least = kReportsAgreeInZero * largest_[static_cast<std::size_t>(kind)];
        value = std::abs(*value) <= least ? 0.0 : in_unit(kind, *value);
      }
    }
  }

  std::vector<double> drives_at(double share) const {
    std::vector<double> values;
    for (const PlannedDrive& drive : plan_.drives) {
      values.push_back(in_unit(kind_of(drive), drive.from + share * (drive.to - drive.from)));
    }
    return values;
  }

  // How uncertain the position of the first drive is there. Shares of the way to the start, before
  // the first step, are of that way.
  double uncertainty(double share, int step) const {
    const PlannedDrive& drive = plan_.drives.front();
    const double way = step < 0 ? drive.from : drive.to - drive.from;
    return in_unit(kind_of(drive), std::abs(share * way));
  }

  void add_events() {
    struct Placed {
      double share = 0.0;
      MotionEvent event;
    };

    std::vector<Placed> placed;
    for (const DeadPoint& point : find_dead_points(mechanism_, motion_)) {
      placed.push_back({.share = point.share,
                        .event = {.kind = "dead_point",
                                  .element = topology_.freedom_name(point.freedom),
                                  .step = point.step,
                                  .drive = drives_at(point.share),
                                  .uncertainty = uncertainty(point.uncertainty, point.step)}});
    }
    for (const SpecialPosition& special : solution_.special) {
      const bool is_limit = special.kind == SpecialKind::limit;
      std::vector<double> drive;
      for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
        drive.push_back(in_unit(kind_of(plan_.drives[d]), special.drive_values[d]));
      }
      placed.push_back({.share = special.share,
                        .event = {.kind = is_limit ? "limit" : "singular",
                                  .element = is_limit ? table_.drives.front().name : "",
                                  .step = special.step,
                                  .drive = std::move(drive),
                                  .uncertainty = uncertainty(special.uncertainty, special.step)}});
    }
    std::ranges::stable_sort(
        placed, {}, [](const Placed& one) { return std::pair(one.event.step >= 0, one.share); });
    for (Placed& one : placed) {
      table_.events.push_back(std::move(one.event));
    }
  }

  std::vector<CouplingGap> gaps(const std::vector<CouplingMiss>& misses) const {
    std::vector<CouplingGap> result;
    for (const CouplingMiss& miss : misses) {
      result.push_back({.coupling = topology_.coupling(miss.coupling).name,
                        .distance = in_unit(MotionKind::length, miss.distance),
                        .angle = in_unit(MotionKind::angle, miss.angle)});
    }
    return result;
  }

  void add_assembly() {
    const Assembly& assembly = solution_.assembly;
    table_.drawn_gaps = gaps(assembly.drawn_misses);
    table_.nearest_gaps = gaps(assembly.nearest_misses);
    for (std::size_t b = 1; b < assembly.corrections.size(); ++b) {
      const BodyPose& pose = assembly.corrections[b];
      const Vec3& reference = mechanism_.geometry.references[b];
      const Vec3 shift = pose.point(reference) - reference;
      table_.corrections.push_back(
          {.body = topology_.bodies[b].name,
           .shift = shift.unaryExpr([this](double x) { return in_unit(MotionKind::length, x); }),
           .angle =
               in_unit(MotionKind::angle, std::abs(Eigen::AngleAxisd(pose.rotation).angle()))});
    }
  }

  const MechanismDescription& description_;
  const FileUnits& units_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  const FoundMotion& motion_;
  const MotionSolution& solution_;
  const MotionPlan& plan_;
  std::array<double, kKinds> largest_ = {};  ///< of each kind [SI]
  MotionTable table_;
};

}  // namespace

MotionTable make_motion_table(const MechanismDescription& description,
                              const Mechanism& mechanism,
                              const FoundMotion& motion) {
  return TableMaker(description, mechanism, motion).run();
}

}  // namespace kinestat
