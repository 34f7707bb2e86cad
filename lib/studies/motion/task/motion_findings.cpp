#include "studies/motion/task/motion_findings.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/motion_tolerance.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "expression/file_units.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// Messages name so many couplings or bodies; the report has them all.
constexpr std::size_t kMostNamed = 4;

// Of a drive, in radians or sizes of the mechanism: a minute or some.
constexpr double kLongestRange = 1e6;

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? format_short(value) : fmt::format("{} {}", format_short(value), unit);
}

class Findings {
 public:
  Findings(const FoundMotion& motion,
           const FileUnits& units,
           const Mechanism& mechanism,
           EndOfMotion end,
           Diagnostics& found)
      : motion_(motion),
        table_(motion.table),
        topology_(mechanism.topology),
        mechanism_(mechanism),
        units_(units),
        end_(end),
        found_(found) {}

  void add_all() {
    add_correction();
    add_singularities();
    add_missing_dead_points();
    add_closure_error();
    switch (motion_.solution.status) {
      case MotionStatus::completed:
        return add_missing_limit();
      case MotionStatus::not_movable:
        return;
      case MotionStatus::not_assembled:
        return add_not_assembled();
      case MotionStatus::limit:
        return add_limit();
      case MotionStatus::lift_off:
        return add_lift_off();
      case MotionStatus::drives_locked:
        return add_locked();
      case MotionStatus::undetermined:
        return add_open_freedoms();
      case MotionStatus::singular:
      case MotionStatus::lost_branch:
        return add_lost();
    }
  }

 private:
  SourceRange place_of_drive() const { return motion_.plan.drives.front().where; }

  SourceRange place_of(const std::string& coupling) const {
    const auto at = std::ranges::find(topology_.couplings, coupling, &CouplingTopology::name);
    return at == topology_.couplings.end() ? motion_.plan.where : at->where;
  }

  // "'c' by 0.02 mm, 'd' by 0.1 deg"
  std::string gaps_text(std::vector<CouplingGap> gaps) const {
    std::ranges::stable_sort(gaps, std::ranges::greater{}, &CouplingGap::distance);
    std::string text;
    const std::size_t count = std::min(gaps.size(), kMostNamed);
    for (std::size_t i = 0; i < count; ++i) {
      const CouplingGap& gap = gaps[i];
      text += fmt::format("{}'{}' by ", i == 0 ? "" : ", ", gap.coupling);
      text += gap.distance > 0.0 ? with_unit(gap.distance, table_.length_unit) : "";
      text += gap.distance > 0.0 && gap.angle > 0.0 ? " and " : "";
      text += gap.angle > 0.0 ? with_unit(gap.angle, table_.angle_unit) : "";
    }
    return text + (count < gaps.size() ? fmt::format(" and {} more", gaps.size() - count) : "");
  }

  std::string drives_text(const std::vector<double>& positions) const {
    std::string text;
    for (std::size_t d = 0; d < positions.size(); ++d) {
      text += fmt::format("{}{} = {}",
                          d == 0 ? "" : ", ",
                          table_.drives[d].name,
                          with_unit(positions[d], table_.drives[d].unit));
    }
    return text;
  }

  std::string reached_text() const {
    std::vector<double> positions;
    for (const DriveTravel& drive : table_.drives) {
      if (drive.reached) {
        positions.push_back(*drive.reached);
      }
    }
    return positions.empty() ? "before its first step" : "at " + drives_text(positions);
  }

  // "0.01 mm and 0.1 deg"; what is zero is left out.
  std::string correction_text(const BodyCorrection& one) const {
    const double shift = one.shift.norm();
    return fmt::format("{}{}{}",
                       shift > 0.0 ? with_unit(shift, table_.length_unit) : "",
                       shift > 0.0 && one.angle > 0.0 ? " and " : "",
                       one.angle > 0.0 ? with_unit(one.angle, table_.angle_unit) : "");
  }

  void add_correction() const {
    if (table_.drawn_gaps.empty() || !motion_.solution.assembly.closes) {
      return;
    }
    std::vector<std::string> moved;
    for (const BodyCorrection& one : table_.corrections) {
      if (one.shift.norm() > 0.0 || one.angle > 0.0) {
        moved.push_back(fmt::format("'{}' by {}", one.body, correction_text(one)));
      }
    }
    const std::size_t count = moved.size();
    moved.resize(std::min(count, kMostNamed));
    found_.warning("W0504",
                   place_of(table_.drawn_gaps.front().coupling),
                   fmt::format("the drawn position does not close: it misses {}; closing it moves "
                               "{}{}",
                               gaps_text(table_.drawn_gaps),
                               fmt::join(moved, ", "),
                               count > kMostNamed ? fmt::format(" and {} more", count - kMostNamed)
                                                  : std::string()),
                   closed_points_hint());
  }

  // Where points alone were drawn wrong, those that close; axes would have to be turned too.
  std::string closed_points_hint() const {
    const Assembly& assembly = motion_.solution.assembly;
    std::string text;
    std::size_t count = 0;
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology_.couplings[e];
      const Vec3& drawn = motion_.drawn[e].geometry.at;
      const auto tail = static_cast<std::size_t>(coupling.tail.value);
      const Vec3 closed = assembly.corrections[tail].point(drawn);
      if (!motion_.drawn[e].at_head &&
          (closed - drawn).norm() <= kSilentCorrection * mechanism_.geometry.length) {
        continue;
      }
      const bool is_point = coupling.type == CouplingType::spherical ||
                            (is_planar() && coupling.type == CouplingType::revolute);
      if (!is_point || ++count > kMostNamed) {
        return "the motion begins at the closed position; draw the points where both bodies meet "
               "if that is not what was meant";
      }
      text +=
          fmt::format("{}{}: at: {}", count == 1 ? "" : ", ", coupling.name, point_text(closed));
    }
    return "the motion begins at the closed position; other analyses accept the file if it is "
           "drawn so: " +
           text + ", and what else lies on the bodies that move with them";
  }

  bool is_planar() const { return mechanism_.space == Space::planar; }

  std::string point_text(const Vec3& point) const {
    const Vec3 in_world = mechanism_.geometry.origin.in_world(point);
    std::vector<std::string> coordinates;
    for (int i = 0; i < (is_planar() ? 2 : 3); ++i) {
      coordinates.push_back(format_exact(units_.from_si(QuantityKind::length, in_world[i])));
    }
    return fmt::format("[{}]", fmt::join(coordinates, ", "));
  }

  void add_singularities() const {
    std::vector<const MotionEvent*> passed;
    for (const MotionEvent& event : table_.events) {
      if (event.kind == kSingularEvent) {
        passed.push_back(&event);
      }
    }
    if (passed.empty()) {
      return;
    }
    found_.warning(
        "W0503",
        place_of_drive(),
        fmt::format("the motion passes a singular position at {}{}",
                    drives_text(passed.front()->drive),
                    passed.size() == 1 ? "" : fmt::format(" and {} more", passed.size() - 1)),
        "more than one motion is possible from there; the report follows the one it was on");
  }

  void add_missing_dead_points() const {
    const bool has_own_laws = motion_.solution.path && table_.drives.size() > 1;
    if (table_.may_lack_dead_points) {
      found_.warning(
          "W0509",
          place_of_drive(),
          fmt::format("dead points may be missing from the events: {}",
                      has_own_laws ? "drives run by different laws at the same time"
                                   : "the motion has too many turns to look at all of it"),
          fmt::format("let {}; rows and singular positions are complete",
                      has_own_laws ? "one law drive all, or one after the other"
                                   : "it run through a shorter range"));
    }
  }

  // Of what has more equations than unknowns and was drawn with few figures.
  void add_closure_error() const {
    const double share = table_.worst_closure;
    if (!motion_.solution.closes_by_least_squares) {
      return;
    }
    const auto worst = static_cast<std::size_t>(table_.worst_step);
    std::vector<double> positions;
    for (std::size_t d = 0; d < table_.drives.size(); ++d) {
      positions.push_back(table_.rows[worst].values[d].value_or(0.0));
    }
    const double length = units_.from_si(QuantityKind::length, share * mechanism_.geometry.length);
    found_.warning(
        "W0510",
        place_of_drive(),
        fmt::format("the positions do not close: at {} they miss up to {}, {} of the size. As "
                    "typed, the mechanism is overconstrained and has no such motion",
                    drives_text(positions),
                    with_unit(length, table_.length_unit),
                    format_short(share)),
        "every position is the least-squares fit, so forces and velocities are those of a "
        "mechanism that differs by so much; type more figures, or expressions such as 50*sqrt(3), "
        "if it is to move");
  }

  void add_not_assembled() const {
    const std::vector<CouplingGap>& gaps = table_.nearest_gaps;
    found_.error("E0504",
                 gaps.empty() ? motion_.plan.where : place_of(gaps.front().coupling),
                 fmt::format("the mechanism cannot be assembled: the nearest position misses {}",
                             gaps_text(gaps)),
                 "change the lengths of the links by about that much; a four-bar needs its longest "
                 "link shorter than the other three together");
  }

  // Whoever types a limit that a report gave asks for it.
  bool ends_where_asked() const {
    return std::ranges::all_of(table_.drives, [](const DriveTravel& drive) {
      return drive.reached &&
             std::abs(drive.to - *drive.reached) <= kAskedLimit * std::abs(drive.to - drive.from);
    });
  }

  void add_missing_limit() const {
    if (!table_.until_limit) {
      return;
    }
    const auto at = std::ranges::find(motion_.plan.drives, true, &PlannedDrive::until_limit);
    const DriveTravel& drive =
        table_.drives[static_cast<std::size_t>(at - motion_.plan.drives.begin())];
    const bool turns = topology_.freedoms[static_cast<std::size_t>(at->freedom)].is_rotation;
    found_.warning(
        "W0511",
        at->where,
        fmt::format("drive '{}' reaches no limit {} {}",
                    drive.name,
                    turns ? "within a full turn, to" : "up to",
                    with_unit(drive.to, drive.unit)),
        turns
            ? "it turns fully, unless a limit lies in a later turn: give 'to' the number of turns, "
              "as 720 deg; the report has this one"
            : "links between it and the ground would not reach so far: something else slides or "
              "rolls with it; the report goes up to there");
  }

  void add_limit() const {
    if (!table_.rows.empty() && (table_.until_limit || ends_where_asked())) {
      return;
    }
    const DriveTravel& drive = table_.drives.front();
    const bool has_way_to_start =
        std::ranges::any_of(table_.drives, [](const DriveTravel& one) { return one.from != 0.0; });
    const bool has_begun = !table_.rows.empty() || table_.events.empty() || !has_way_to_start;
    if (table_.until_limit && has_begun) {
      found_.error("E0505",
                   place_of_drive(),
                   fmt::format("the drawn position is a limit of '{}' itself", drive.name),
                   "the direction from there is not determined: draw another position, or drive "
                   "another coupling");
      return;
    }
    std::string message =
        fmt::format("the motion reaches its limit {}, before {} = {}",
                    has_begun ? reached_text()
                              : fmt::format("at {}, on the way to where it begins",
                                            drives_text(table_.events.back().drive)),
                    drive.name,
                    with_unit(has_begun ? drive.to : drive.from, drive.unit));
    if (end_ == EndOfMotion::may_be_a_limit && table_.rows.size() > 1) {
      const bool takes_limit = table_.drives.size() == 1 && !table_.duration;
      found_.warning(
          kEndsAtLimit,
          place_of_drive(),
          std::move(message),
          fmt::format("the report goes up to there{}; otherwise end the motion earlier, or drive "
                      "another coupling",
                      !takes_limit            ? ""
                      : drive.to < drive.from ? ": if that is meant, write 'to: -limit'"
                                              : ": if that is meant, write 'to: limit'"));
      return;
    }
    found_.error("E0505",
                 place_of_drive(),
                 std::move(message),
                 end_ == EndOfMotion::must_be_reached
                     ? "ask for a position before that, or drive another coupling"
                     : "let the motion begin and end before that, or drive another coupling");
  }

  void add_lift_off() const {
    const int contact = motion_.solution.special.back().contact;
    const CableContact& cable = mechanism_.contacts[static_cast<std::size_t>(contact)];
    const CouplingTopology& leaves = topology_.coupling(cable.leaves);
    found_.error("E0510",
                 cable.where,
                 fmt::format("the cable lifts off '{}' at {}: there its arc is zero",
                             topology_.body(leaves.tail).name,
                             drives_text(table_.events.back().drive)),
                 "the report goes up to there; end the motion earlier, or draw the cable beyond "
                 "without this pulley");
  }

  void add_locked() const {
    if (table_.drives.size() > 1) {
      std::vector<std::string> names;
      for (const DriveTravel& drive : table_.drives) {
        names.push_back(fmt::format("'{}'", drive.name));
      }
      found_.error(
          "E0505",
          place_of_drive(),
          fmt::format("the drives {} cannot run through their ranges together", plain_list(names)),
          "'kinestat mobility' says how many freedoms there are: drive no more than these");
      return;
    }
    found_.error(
        "E0505",
        place_of_drive(),
        fmt::format("drive '{}' cannot move the mechanism at all", table_.drives.front().name),
        "'kinestat mobility' says what is free; a limit may lie in the drawn position");
  }

  void add_open_freedoms() const {
    std::vector<std::string> names;
    for (const int freedom : motion_.solution.open_freedoms) {
      names.push_back(topology_.freedom_name(freedom));
    }
    found_.error("E0508",
                 motion_.plan.where,
                 fmt::format("the drives of 'motion' do not determine {}", plain_list(names)),
                 "drive one of them too: drives: [{drive: …, to: …}, …]");
  }

  void add_lost() const {
    const bool is_singular = motion_.solution.status == MotionStatus::singular;
    found_.error(
        "E0506",
        place_of_drive(),
        is_singular
            ? std::string("the motion cannot leave the drawn position")
            : fmt::format("the motion cannot be followed beyond {}", reached_text().substr(3)),
        is_singular
            ? "several motions begin there, or none; start from another position, "
              "or take more drives"
            : "another assembly branch comes too close there, or a point moves far away: end the "
              "motion before that or start beyond it, or take another path with more drives");
  }

  const FoundMotion& motion_;
  const MotionTable& table_;
  const Topology& topology_;
  const Mechanism& mechanism_;
  const FileUnits& units_;
  EndOfMotion end_;
  Diagnostics& found_;
};

}  // namespace

bool check_movable(const FoundMotion& motion, const Mechanism& mechanism, Diagnostics& found) {
  std::set<std::pair<int, MotionObstacle>> refused;
  for (const UnmovableCoupling& one : motion.network.obstacles) {
    if (!refused.insert({one.coupling.value, one.why}).second) {
      continue;
    }
    const CouplingTopology& coupling = mechanism.topology.coupling(one.coupling);
    found.error("E0507",
                coupling.where,
                fmt::format("coupling '{}' cannot be moved: {}", coupling.name, reason_of(one.why)),
                "its instantaneous motion is analysed all the same; 'kinestat help motion' says "
                "what each type needs to be moved");
  }
  return motion.network.is_movable();
}

bool check_ranges(const FoundMotion& motion, const Mechanism& mechanism, Diagnostics& found) {
  const Topology& topology = mechanism.topology;
  bool are_bounded = true;
  for (const PlannedDrive& drive : motion.plan.drives) {
    const bool turns = topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
    const double unit = turns ? 1.0 : mechanism.geometry.length;
    if (std::max(std::abs(drive.from), std::abs(drive.to)) <= kLongestRange * unit) {
      continue;
    }
    are_bounded = false;
    found.error(
        "E0305",
        drive.where,
        fmt::format("drive '{}' begins or ends more than a million {} from the drawn position",
                    topology.actuators[static_cast<std::size_t>(drive.actuator)].name,
                    turns ? "radians" : "sizes of the mechanism"),
        "it is followed in steps of a third of a radian or of the size; a full turn is to: "
        "360 deg");
  }
  return are_bounded;
}

void add_motion_findings(const FoundMotion& motion,
                         const MechanismDescription& description,
                         const Mechanism& mechanism,
                         Diagnostics& found,
                         EndOfMotion end) {
  Findings(motion, description.units, mechanism, end, found).add_all();
}

}  // namespace kinestat
