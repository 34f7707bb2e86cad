#include "mechanism/motion_plan.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/check/report_name_check.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

struct ReportWord {
  std::string_view word;
  bool MotionReport::*member;
};

constexpr ReportWord kReportWords[] = {
    {"position", &MotionReport::position},
    {"velocity", &MotionReport::velocity},
    {"acceleration", &MotionReport::acceleration},
    {"action", &MotionReport::action},
    {"reaction", &MotionReport::reaction},
    {"power", &MotionReport::power},
    {"efficiency", &MotionReport::efficiency},
    {"ratio", &MotionReport::ratio},
    {"transmission_angle", &MotionReport::transmission_angle},
    {"mechanical_advantage", &MotionReport::mechanical_advantage},
    {"dynamics", &MotionReport::dynamics}};

// How far a slide may be from one limit to the other [m]. In a circuit without other slides the two
// points that were drawn in one place are apart by what its other bodies bridge, at most the
// greatest distance between two of the couplings of each, to either side.
double longest_slide(const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  double bridged = 0.0;
  for (int body = 0; body < static_cast<int>(topology.bodies.size()); ++body) {
    std::vector<Vec3> points;
    for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology.couplings[e];
      if (coupling.tail.value == body || coupling.head.value == body) {
        points.push_back(mechanism.geometry.points[e]);
      }
    }
    double widest = 0.0;
    for (const Vec3& a : points) {
      for (const Vec3& b : points) {
        widest = std::max(widest, (a - b).norm());
      }
    }
    bridged += widest;
  }
  return 2.0 * std::max(bridged, mechanism.geometry.length);
}

class MotionBinder {
 public:
  MotionBinder(const MechanismDescription& description, const Mechanism& mechanism)
      : description_(description),
        motion_(*description.motion),
        mechanism_(mechanism),
        evaluator_(make_evaluator(description, ignored_)) {
    evaluator_.measure_from(mechanism.geometry.origin);
  }

  MotionPlan run(std::optional<int> which) {
    for (const DriveRange& range : motion_.drives) {
      add_drive(range);
    }
    const auto steps = motion_.steps
                           ? evaluator_.number(*motion_.steps, QuantityKind::dimensionless)
                           : std::nullopt;
    plan_.steps = static_cast<int>(std::lround(steps.value_or(kUsualSteps)));
    plan_.which = which ? *which : motion_.label ? case_of(*motion_.label) : -1;
    plan_schedule();
    for (std::size_t i = 0; i < motion_.trace.size(); ++i) {
      const TracePoint& point = motion_.trace[i];
      const auto body =
          std::ranges::find(mechanism_.topology.bodies, point.body.text, &BodyTopology::name);
      plan_.trace.push_back({.name = name_of_trace(motion_.trace, i),
                             .body = {static_cast<int>(body - mechanism_.topology.bodies.begin())},
                             .at = evaluator_.point(point.at).value_or(Vec3::Zero())});
    }
    plan_.report.is_default = motion_.report.empty();
    plan_.report.works =
        plan_.report.is_default && this->which() != nullptr && this->which()->asks_actions;
    for (const Name& name : motion_.report) {
      add_report(name);
    }
    plan_.where = motion_.where;
    KINESTAT_EXPECTS(!ignored_.has_errors());
    return std::move(plan_);
  }

 private:
  int case_of(const Name& label) const {
    const auto at = std::ranges::find(mechanism_.cases, label.text, &Case::label);
    KINESTAT_EXPECTS(at != mechanism_.cases.end());
    return static_cast<int>(at - mechanism_.cases.begin());
  }

  const Case* which() const {
    return plan_.which < 0 ? nullptr : &mechanism_.cases[static_cast<std::size_t>(plan_.which)];
  }

  static double value_of(const std::vector<Primary>& list, int freedom) {
    const auto at = std::ranges::find(list, freedom, &Primary::index);
    return at == list.end() ? 0.0 : at->value;
  }

  bool knows_speed(const PlannedDrive& drive) const {
    return which() != nullptr &&
           std::ranges::find(which()->motions, drive.freedom, &Primary::index) !=
               which()->motions.end();
  }

  void complain(TimeProblem problem, std::size_t drive) {
    plan_.time_problem = problem;
    plan_.problem_drive = drive;
  }

  std::optional<double> duration() {
    return motion_.time ? evaluator_.number(*motion_.time, QuantityKind::time) : std::nullopt;
  }

  void plan_schedule() {
    const bool speeds_up = which() != nullptr && which()->has_inertia();
    const bool has_courses = std::ranges::any_of(motion_.drives, &DriveRange::has_course);
    const auto to_limit = std::ranges::find_if(plan_.drives, &PlannedDrive::until_limit);
    if (to_limit != plan_.drives.end()) {
      // At a steady speed of one drive all rows are alike in time.
      const bool changes_speed =
          speeds_up && (plan_.drives.size() > 1 ||
                        std::ranges::any_of(*which()->accelerations,
                                            [](const Primary& one) { return one.value != 0.0; }));
      if (motion_.law || motion_.time || has_courses || changes_speed) {
        complain(TimeProblem::to_limit, static_cast<std::size_t>(to_limit - plan_.drives.begin()));
      }
      return;
    }
    if (has_courses) {
      plan_own_courses();
    } else if (motion_.law) {
      plan_law();
    } else if (motion_.time || speeds_up) {
      plan_steady_courses();
    }
  }

  double ramp_of(const std::optional<Value>& ramp) {
    return ramp ? evaluator_.number(*ramp, QuantityKind::dimensionless).value_or(kUsualRamp)
                : kUsualRamp;
  }

  // False iff the case gives the drive a speed, too.
  bool check_speed(std::size_t d, TimeProblem problem) {
    const PlannedDrive& drive = plan_.drives[d];
    if (knows_speed(drive) && value_of(which()->motions, drive.freedom) != 0.0) {
      complain(problem, d);
      return false;
    }
    return true;
  }

  DriveCourse course_by_law(const PlannedDrive& drive) {
    return {.from = drive.from,
            .to = drive.to,
            .parts = {{.from = drive.from,
                       .to = drive.to,
                       .law = *motion_.law,
                       .ramp = ramp_of(motion_.ramp)}}};
  }

  void plan_law() {
    std::vector<DriveCourse> courses;
    for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
      courses.push_back(course_by_law(plan_.drives[d]));
      (void)check_speed(d, TimeProblem::two_speeds);
    }
    plan_.schedule.emplace(duration().value_or(1.0), std::move(courses));
  }

  // Some drives have a profile or a curve; the others run by the law of all, or as the case says.
  void plan_own_courses() {
    std::vector<DriveCourse> courses(plan_.drives.size());
    double longest = 0.0;  // [s]
    for (std::size_t d = 0; d < courses.size(); ++d) {
      const DriveRange& range = motion_.drives[d];
      if (!range.profile.empty()) {
        longest = std::max(longest, bind_profile(d, courses[d]));
      } else if (range.curve) {
        const Curve& curve = bind_curve(d, courses[d]);
        longest = std::max(longest, curve.period ? 0.0 : curve.at.back());
      }
      if (range.has_course() && !check_speed(d, TimeProblem::two_courses)) {
        return;
      }
    }
    const double whole = duration().value_or(longest);
    for (std::size_t d = 0; d < courses.size(); ++d) {
      if (!finish_course(d, whole, courses[d])) {
        return;
      }
    }
    plan_.schedule.emplace(whole, std::move(courses));
  }

  // Parts in seconds as yet; answers how long all of them take.
  double bind_profile(std::size_t d, DriveCourse& course) {
    PlannedDrive& drive = plan_.drives[d];
    const QuantityKind kind = drive_kind(drive);
    double place = drive.from;
    double time = 0.0;
    const auto seconds = [&](const std::optional<Value>& value) {
      return value ? evaluator_.number(*value, QuantityKind::time).value_or(0.0) : 0.0;
    };
    for (const ProfilePart& part : motion_.drives[d].profile) {
      CoursePart next{.begin = time, .end = time, .from = place, .to = place};
      if (part.dwell) {
        next.end += seconds(part.dwell);
      } else {
        next.end += seconds(part.time);
        next.to = part.to ? evaluator_.number(*part.to, kind).value_or(place) : place;
        next.law = part.law.value_or(next.law);
        next.ramp = ramp_of(part.ramp);
      }
      place = next.to;
      time = next.end;
      course.parts.push_back(next);
    }
    drive.to = place;
    course.from = drive.from;
    course.to = place;
    return time;
  }

  // Bare values count in the unit of the file.
  const Curve& bind_curve(std::size_t d, DriveCourse& course) {
    const auto at =
        std::ranges::find(mechanism_.curves, motion_.drives[d].curve->text, &Curve::name);
    KINESTAT_EXPECTS(at != mechanism_.curves.end());
    Curve curve = *at;
    if (is_bare(curve.dimension)) {
      const double unit = description_.units.factor(drive_kind(plan_.drives[d]));
      for (auto* list : {&curve.values, &curve.slopes}) {
        for (double& number : *list) {
          number *= unit;
        }
      }
    }
    course.curve = std::make_shared<const Curve>(std::move(curve));
    return *course.curve;
  }

  QuantityKind drive_kind(const PlannedDrive& drive) const {
    const auto f = static_cast<std::size_t>(drive.freedom);
    return position_kind(mechanism_.topology.freedoms[f].is_rotation);
  }

  // False iff a problem was found.
  bool finish_course(std::size_t d, double whole, DriveCourse& course) {
    PlannedDrive& drive = plan_.drives[d];
    if (course.curve != nullptr) {
      if (whole == 0.0) {
        complain(TimeProblem::no_duration, d);
        return false;
      }
      const std::optional<CurvePoint> begin = course.curve->point(0.0);
      const std::optional<CurvePoint> end = course.curve->point(whole);
      if (!begin || !end) {
        complain(TimeProblem::beyond_curve, d);
        return false;
      }
      course.from = drive.from = begin->value;
      course.to = drive.to = end->value;
      return true;
    }
    if (!course.parts.empty()) {
      if (course.parts.back().end > whole * (1.0 + kSameValue)) {
        complain(TimeProblem::too_long, d);
        return false;
      }
      for (CoursePart& part : course.parts) {
        part.begin /= whole;
        part.end = std::abs(part.end - whole) <= kSameValue * whole ? 1.0 : part.end / whole;
      }
      return true;
    }
    if (motion_.law) {
      course = course_by_law(drive);
      return check_speed(d, TimeProblem::two_speeds);
    }
    const bool holds_still = motion_.drives[d].to.has_value() && drive.from == drive.to;
    if (!knows_speed(drive) && !holds_still) {
      complain(TimeProblem::no_speed, d);
      return false;
    }
    course = steady_course(drive);
    return end_steady_course(d, whole, course);
  }

  DriveCourse steady_course(const PlannedDrive& drive) const {
    const bool is_known = knows_speed(drive);
    return {.from = drive.from,
            .to = drive.to,
            .speed = is_known ? value_of(which()->motions, drive.freedom) : 0.0,
            .acceleration = is_known ? acceleration_of(*which(), drive.freedom) : 0.0};
  }

  // False iff it ends elsewhere than its range does.
  bool end_steady_course(std::size_t d, double time, DriveCourse& course) {
    const double end = course.from + time * (course.speed + 0.5 * course.acceleration * time);
    const bool is_given = motion_.drives[d].to.has_value();
    const double size = std::abs(end) + std::abs(course.to) + std::abs(course.from);
    if (is_given && std::abs(end - course.to) > kSameEnd * size) {
      complain(motion_.time ? TimeProblem::other_end : TimeProblem::other_time, d);
      return false;
    }
    course.to = is_given ? course.to : end;
    plan_.drives[d].to = course.to;
    return true;
  }

  // By the speeds and accelerations of the case, from `from` on.
  void plan_steady_courses() {
    std::vector<DriveCourse> courses;
    for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
      if (!knows_speed(plan_.drives[d])) {
        if (motion_.time) {
          complain(TimeProblem::no_speed, d);
        }
        return;  // then the case tells the speeds in each position
      }
      courses.push_back(steady_course(plan_.drives[d]));
    }
    std::optional<double> time = duration();
    for (std::size_t d = 0; d < courses.size() && !time; ++d) {
      time = time_to_end(courses[d]);
      if (!time && (courses[d].speed != 0.0 || courses[d].acceleration != 0.0)) {
        complain(TimeProblem::never, d);
        return;
      }
    }
    if (!time) {
      return;  // at rest, in every position
    }
    for (std::size_t d = 0; d < courses.size(); ++d) {
      if (!end_steady_course(d, *time, courses[d])) {
        return;
      }
    }
    plan_.schedule.emplace(*time, std::move(courses));
  }

  // When a drive with a steady acceleration is at the end of its range for the first time.
  static std::optional<double> time_to_end(const DriveCourse& course) {
    const double way = course.to - course.from;
    const double half = 0.5 * course.acceleration;
    const double root = course.speed * course.speed + 4.0 * half * way;
    if (way == 0.0 || root < 0.0) {
      return std::nullopt;
    }
    // way / (v + a t / 2), from the citardauq form, which loses no digits.
    const double sense = way > 0.0 ? 1.0 : -1.0;
    const double divisor = course.speed + sense * std::sqrt(root);
    const double time = divisor == 0.0 ? -1.0 : 2.0 * way / divisor;
    return time > 0.0 && std::isfinite(time) ? std::optional(time) : std::nullopt;
  }

  void add_drive(const DriveRange& range) {
    const Topology& topology = mechanism_.topology;
    const auto at =
        std::ranges::find(topology.actuators, range.actuator.text, &ActuatorTopology::name);
    KINESTAT_EXPECTS(at != topology.actuators.end());
    const bool turns = topology.freedoms[static_cast<std::size_t>(at->freedom)].is_rotation;
    const QuantityKind kind = position_kind(turns);
    const auto value = [&](const std::optional<Value>& text) {
      return text ? evaluator_.number(*text, kind).value_or(0.0) : 0.0;
    };
    const double from = value(range.from);
    const int sense = limit_sense(range.to, description_);
    plan_.drives.push_back({.actuator = static_cast<int>(at - topology.actuators.begin()),
                            .freedom = at->freedom,
                            .from = from,
                            .to = sense == 0 ? value(range.to)
                                             : from + sense * (turns ? 2.0 * std::numbers::pi
                                                                     : longest_slide(mechanism_)),
                            .until_limit = sense != 0,
                            .where = range.actuator.where});
  }

  bool names_element(const std::string& name) const {
    std::vector<std::string> bodies;
    for (const BodyTopology& body : mechanism_.topology.bodies) {
      bodies.push_back(body.name);
    }
    const std::vector<std::string> elements = elements_of_motion(description_, bodies);
    return std::ranges::find(elements, name) != elements.end();
  }

  // A word, an actuator, a freedom or an action of a coupling, or a coupling for all its actions;
  // any other is that of columns.
  void add_report(const Name& typed) {
    const std::string& name = typed.text;
    if (bool* const word = find_report_word(name, plan_.report)) {
      *word = true;
      return;
    }
    const Topology& topology = mechanism_.topology;
    for (int i = 0; i < static_cast<int>(topology.actuators.size()); ++i) {
      if (topology.actuators[static_cast<std::size_t>(i)].name == name) {
        plan_.report.actuators.push_back(i);
        return;
      }
    }
    for (int f = 0; f < topology.freedom_count(); ++f) {
      if (topology.freedom_name(f) == name) {
        plan_.report.freedoms.push_back(f);
        return;
      }
    }
    for (int a = 0; a < topology.action_count(); ++a) {
      if (topology.action_name(a) == name) {
        plan_.report.actions.push_back(a);
        return;
      }
    }
    const auto coupling = std::ranges::find(topology.couplings, name, &CouplingTopology::name);
    if (coupling == topology.couplings.end() || names_element(name)) {
      plan_.report.columns.push_back(typed);
      return;
    }
    for (int a = 0; a < coupling->action_count; ++a) {
      plan_.report.actions.push_back(coupling->first_action + a);
    }
  }

  const MechanismDescription& description_;
  const MotionDescription& motion_;
  const Mechanism& mechanism_;
  Diagnostics ignored_;
  Evaluator evaluator_;
  MotionPlan plan_;
};

}  // namespace

bool* find_report_word(std::string_view word, MotionReport& report) {
  const auto* const at = std::ranges::find(kReportWords, word, &ReportWord::word);
  return at == std::end(kReportWords) ? nullptr : &(report.*at->member);
}

std::span<const std::string> motion_report_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> result;
    for (const ReportWord& one : kReportWords) {
      result.emplace_back(one.word);
    }
    return result;
  }();
  return words;
}

std::string name_of_trace(const std::vector<TracePoint>& trace, std::size_t i) {
  const TracePoint& point = trace[i];
  return point.name ? point.name->text : fmt::format("{}.{}", point.body.text, i + 1);
}

std::optional<MotionPlan> bind_motion(const MechanismDescription& description,
                                      const Mechanism& mechanism,
                                      std::optional<int> which) {
  return description.motion ? std::optional(MotionBinder(description, mechanism).run(which))
                            : std::nullopt;
}

bool runs_by_case(const MotionDescription& motion) {
  return !motion.law && !std::ranges::all_of(motion.drives, &DriveRange::has_course);
}

}  // namespace kinestat
