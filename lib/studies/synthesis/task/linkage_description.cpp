#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "studies/synthesis/report/linkage_text.hpp"
#include "studies/synthesis/task/linkage_files.hpp"

namespace kinestat {

namespace {

Value value_of(const std::string& text) {
  auto parsed = parse_expression(text);
  KINESTAT_EXPECTS(std::holds_alternative<Expression>(parsed));
  return {.expression = std::get<Expression>(std::move(parsed)), .where = {}, .text_column = 0};
}

Name name_of(std::string_view text) {
  return {.text = std::string(text), .where = {}};
}

AxisDescription axis_of(const Point& direction) {
  AxisDescription axis;
  for (const double component : {direction.real(), direction.imag()}) {
    axis.components.push_back(value_of(format_exact(component)));
  }
  return axis;
}

CouplingDescription coupling_of(std::string_view name,
                                std::string_view tail,
                                std::string_view head) {
  CouplingDescription coupling;
  coupling.name = name_of(name);
  coupling.tail = name_of(tail);
  coupling.head = name_of(head);
  return coupling;
}

// The couplings of one link of the linkage, drawn in a pose of the moving plane.
class LinkDrawing {
 public:
  LinkDrawing(const Dyad& dyad, const Pose& pose, const FileUnits& units)
      : dyad_(dyad), pose_(pose), in_(units) {}

  // Between frame and link.
  CouplingDescription outer(std::string_view name, std::string_view link) const {
    CouplingDescription coupling = coupling_of(name, "frame", link);
    place(coupling, dyad_.kind == DyadKind::slider ? moving_place() : dyad_.centre_point);
    if (dyad_.kind == DyadKind::slider) {
      make_prismatic(coupling, dyad_.direction);
    }
    return coupling;
  }

  // Between link and coupler, in the order in which they are given.
  CouplingDescription inner(std::string_view name,
                            std::string_view tail,
                            std::string_view head) const {
    CouplingDescription coupling = coupling_of(name, tail, head);
    const bool is_guide = dyad_.kind == DyadKind::inverted_slider;
    place(coupling, is_guide ? dyad_.centre_point : moving_place());
    if (is_guide) {
      const BoundedPoint along = BoundedPoint::within(dyad_.direction, dyad_.direction_bound);
      make_prismatic(coupling, (turn() * along).zeroed());
    }
    return coupling;
  }

  PointDescription point(const Point& p) const {
    PointDescription result;
    for (const double coordinate : {p.real(), p.imag()}) {
      result.coordinates.push_back(value_of(format_exact(in_.length(coordinate))));
    }
    return result;
  }

 private:
  BoundedPoint turn() const { return bounded_unit_vector(pose_.angle); }

  Point moving_place() const {
    return pose_.bounded_place(turn(), dyad_.bounded_circle_point()).zeroed();
  }

  void place(CouplingDescription& coupling, const Point& at) const {
    coupling.at = CouplingPoint{.point = point(at), .of_bodies = {}, .along_axis = {}, .where = {}};
  }

  static void make_prismatic(CouplingDescription& coupling, const Point& direction) {
    coupling.type = CouplingType::prismatic;
    coupling.axis = axis_of(direction);
  }

  const Dyad& dyad_;
  Pose pose_;
  InUnits in_;
};

bool is_linear(const Dyad& dyad) {
  return dyad.kind == DyadKind::slider;
}

bool is_function(const LinkageCandidate& candidate) {
  return !candidate.positions.empty();
}

// The actuator of the driver.
Name drive_of(const LinkageCandidate& candidate) {
  return name_of(is_function(candidate) ? "input" : "drive");
}

// Drives the linkage at one unit of its speed towards the other positions.
CaseDescription case_of(const LinkageCandidate& candidate, const FileUnits& units) {
  const bool is_linear_input = is_linear(input_of(candidate.linkage, candidate.best_drive));
  const QuantityKind kind =
      is_linear_input ? QuantityKind::velocity : QuantityKind::angular_velocity;
  const bool is_backwards = candidate.best().passage == Passage::decreasing;
  CaseDescription result;
  result.label = name_of("first position");
  result.asks_motions = true;
  const std::string speed = fmt::format("{}1 {}", is_backwards ? "-" : "", units.text(kind));
  result.motions.push_back({.target = drive_of(candidate), .value = value_of(speed)});
  result.inputs = {drive_of(candidate)};
  result.outputs = {name_of("output")};
  return result;
}

ActuatorDescription actuator_of(std::string_view name, std::string_view coupling) {
  return {.name = name_of(name), .coupling = name_of(coupling), .freedom = std::nullopt};
}

// Through all positions, with the path of the origin of the moving frame, or with output and
// transmission angle of a function; only where they are passed one after the other.
std::optional<MotionDescription> motion_of(const LinkageCandidate& candidate,
                                           const std::optional<PointDescription>& traced,
                                           const FileUnits& units) {
  if (candidate.best().passage == Passage::none) {
    return std::nullopt;
  }
  constexpr const char* kSteps = "60";
  const bool is_length = is_linear(input_of(candidate.linkage, candidate.best_drive));
  const InUnits in(units);
  const double arc = drive_travel(candidate).back();
  const double to = is_length ? in.length(arc) : in.angle(arc);
  if (to == 0.0) {
    return std::nullopt;
  }
  MotionDescription motion;
  motion.drives.push_back(
      {.actuator = drive_of(candidate), .from = {}, .to = value_of(format_exact(to))});
  motion.steps = value_of(kSteps);
  motion.label = name_of("first position");
  if (traced) {
    motion.trace.push_back({.body = name_of("coupler"), .at = *traced});
  } else {
    motion.report = {name_of("B0.wz/position"), name_of("transmission_angle")};
  }
  return motion;
}

std::string title_of(const SynthesisAnalysis& analysis) {
  return analysis.description.name.empty() ? analysis.file : analysis.description.name;
}

std::string_view link_of(const Dyad& dyad) {
  switch (dyad.kind) {
    case DyadKind::crank:
      return "pivoted link";
    case DyadKind::slider:
      return "slider";
    case DyadKind::inverted_slider:
      return "guide, in which the coupler slides";
  }
  return "";
}

// What the comment says in numbers.
class CommentNumbers {
 public:
  explicit CommentNumbers(const FileUnits& units) : in_(units) {}

  std::string length(double value) const {
    return fmt::format(
        "{} {}", format_short(in_.length(value)), in_.units().text(QuantityKind::length));
  }

  std::string angle(double value) const {
    return fmt::format(
        "{} {}", format_short(in_.angle(value)), in_.units().text(QuantityKind::angle));
  }

  std::string pose(const PositionJets& position) const {
    const Point at = origin(position);
    return fmt::format("({}, {}), {}",
                       format_short(in_.length(at.real())),
                       format_short(in_.length(at.imag())),
                       angle(position.angle[0]));
  }

 private:
  InUnits in_;
};

void add_passage(const SynthesisTask& task,
                 const LinkageCandidate& candidate,
                 const LinkageLimits& limits,
                 const CommentNumbers& in,
                 std::vector<std::string>& lines) {
  if (candidate.best().passage == Passage::none) {
    lines.emplace_back("The linkage does not pass the positions of the task in their order.");
    return;
  }
  lines.push_back("From the drawn position the drive moves to the positions of the task by");
  const bool is_length = is_linear(input_of(candidate.linkage, candidate.best_drive));
  const std::vector<double> moved = drive_travel(candidate);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    lines.push_back(fmt::format("  {:<12} {}",
                                is_length ? in.length(moved[i]) : in.angle(moved[i]),
                                limits.function ? "output " + in.angle(limits.function->output[i])
                                                : "E at " + in.pose(task.positions[i])));
  }
}

}  // namespace

MechanismDescription describe_linkage(const SynthesisAnalysis& analysis,
                                      const SynthesisTask& task,
                                      const LinkageCandidate& candidate) {
  const FileUnits& units = analysis.description.units;
  const Pose pose = pose_of(task.positions_of(candidate)[0]);
  const Drive drive = candidate.best_drive;
  const LinkDrawing driver(input_of(candidate.linkage, drive), pose, units);
  const LinkDrawing follower(output_of(candidate.linkage, drive), pose, units);

  MechanismDescription result;
  result.name = title_of(analysis) + ", linkage";
  result.source = analysis.description.source;
  result.space = Space::planar;
  result.units = units;
  result.ground = name_of("frame");
  result.bodies.resize(3);
  result.bodies[0].name = name_of("driver");
  result.bodies[1].name = name_of("coupler");
  if (!is_function(candidate)) {
    result.bodies[1].reference = driver.point(pose.origin);
  }
  result.bodies[2].name = name_of("follower");
  result.couplings = {driver.outer("A0", "driver"),
                      driver.inner("A", "driver", "coupler"),
                      follower.inner("B", "coupler", "follower"),
                      follower.outer("B0", "follower")};
  result.actuators = {actuator_of(drive_of(candidate).text, "A0"), actuator_of("output", "B0")};
  result.cases = {case_of(candidate, units)};
  result.motion = motion_of(candidate, result.bodies[1].reference, units);
  return result;
}

std::vector<double> drive_travel(const LinkageCandidate& candidate) {
  const DriveVerdict& verdict = candidate.best();
  const double sign = verdict.passage == Passage::decreasing ? -1.0 : 1.0;
  const bool is_cyclic = !is_linear(input_of(candidate.linkage, candidate.best_drive));
  std::vector<double> moved(1, 0.0);
  for (std::size_t i = 1; i < verdict.coordinates.size(); ++i) {
    double step = verdict.coordinates[i] - verdict.coordinates[i - 1];
    if (is_cyclic && sign * step < 0.0) {
      step += sign * 2.0 * std::numbers::pi;
    }
    moved.push_back(moved.back() + step);
  }
  return moved;
}

std::vector<std::string> linkage_comment(const SynthesisAnalysis& analysis,
                                         const SynthesisTask& task,
                                         std::size_t number) {
  const LinkageCandidate& candidate = task.linkages[number];
  const CommentNumbers in(analysis.description.units);
  const Drive drive = candidate.best_drive;
  const std::size_t driven = candidate.dyads[drive == Drive::one ? 0 : 1];
  const std::size_t other = candidate.dyads[drive == Drive::one ? 1 : 0];
  const bool guides = !is_function(candidate);
  std::vector<std::string> lines = {
      fmt::format("Linkage {} of '{}', a {} of the form {}: {}.",
                  number,
                  title_of(analysis),
                  guides ? "task" : "function",
                  analysis.form,
                  word_of(candidate.linkage.type())),
      "",
      fmt::format("       A o---- coupler ----o B{}",
                  guides ? "            E, the reference point of the coupler," : ""),
      fmt::format("driver  /                   \\  follower{}",
                  guides ? "   is the origin of the moving frame" : ""),
      "    A0 o- - - - frame - - - -o B0",
      "",
      fmt::format("The driver is dyad {}, a {}; the follower is dyad {}, a {}.",
                  driven,
                  link_of(input_of(candidate.linkage, drive)),
                  other,
                  link_of(output_of(candidate.linkage, drive)))};
  if (!candidate.is_usable()) {
    lines.push_back(fmt::format("It is not usable: {}.", phrase_of(candidate.defects)));
  }
  if (candidate.best().working_arc) {
    lines.push_back(fmt::format("The transmission angle stays {} from the dead points on its way.",
                                in.angle(candidate.margin())));
  }
  lines.push_back("It is drawn in the first position.");
  add_passage(task, candidate, analysis.limits, in, lines);
  return lines;
}

}  // namespace kinestat
