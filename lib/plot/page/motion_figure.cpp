#include "plot/page/motion_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "plot/linkage_drawing.hpp"
#include "report/numbers.hpp"

namespace kinestat {

namespace {

// More positions than these look no smoother.
constexpr std::size_t kMostSteps = 720;

class MotionFigure {
 public:
  MotionFigure(const Analysis& analysis, const PageMotion& motion, const std::string& id)
      : mechanism_(analysis.mechanism), analysis_(analysis), motion_(motion), id_(id) {
    const std::size_t stride = (motion.poses.size() + kMostSteps - 1) / kMostSteps;
    for (std::size_t i = 0; i < motion.poses.size(); i += stride) {
      steps_.push_back(i);
    }
  }

  void add_to(int number, Html& html) const {
    const bool moves = mechanism_.space == Space::planar && steps_.size() > 1;
    if (moves) {
      html.open("figure",
                {{"class", "motion"},
                 {"data-picture", "motion"},
                 {"data-poses", id_ + "-poses"},
                 {"data-autoplay", ""}});
    } else {
      html.open("figure", {{"data-picture", "motion"}});
    }
    html.open("div", {{"class", "picture"}, {"tabindex", "0"}});
    html.markup(svg_element(drawing(), fmt::format("{}-figure-{}", id_, number)));
    html.close();
    if (moves) {
      add_controls(html);
    }
    html.open("figcaption");
    html.element("b", fmt::format("Figure {}. ", number));
    html.text(motion_.paths.empty() ? "The mechanism to scale"
                                    : "The mechanism to scale and the paths of its traced points");
    html.close();
    if (moves) {
      html.open("script", {{"type", "application/json"}, {"id", id_ + "-poses"}});
      html.markup(script_json(poses_json()));
      html.close();
    }
    html.close();
  }

 private:
  Picture drawing() const {
    LinkageOptions options;
    options.shows_forces = false;
    options.paths = motion_.paths;
    for (const std::size_t step : steps_) {
      add_places(motion_.poses[step], options.reach);
    }
    return draw_linkage(analysis_, options);
  }

  // Where couplings and reference points are with these poses.
  void add_places(const std::vector<BodyPose>& poses, std::vector<Vec3>& places) const {
    const Topology& topology = mechanism_.topology;
    for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
      const auto head = static_cast<std::size_t>(topology.couplings[e].head.value);
      places.push_back(poses[head].point(mechanism_.geometry.points[e]));
    }
    for (std::size_t b = 1; b < topology.bodies.size(); ++b) {
      places.push_back(poses[b].point(mechanism_.geometry.references[b]));
    }
  }

  void add_controls(Html& html) const {
    const std::string name = motion_.table.drives.empty() ? "drive" : drive_names();
    html.open("div", {{"class", "drive script"}, {"hidden", ""}});
    html.element("button", "Play", {{"type", "button"}});
    html.single("input",
                {{"type", "range"},
                 {"min", "0"},
                 {"max", fmt::format("{}", steps_.size() - 1)},
                 {"step", "1"},
                 {"value", "0"},
                 {"aria-label", name}});
    html.element("output", label(steps_.front()));
    html.close();
  }

  std::string drive_names() const {
    std::vector<std::string> names;
    for (const DriveTravel& drive : motion_.table.drives) {
      names.push_back(drive.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
  }

  // "motor 30 deg", the positions of the drives, which are the first columns.
  std::string label(std::size_t step) const {
    std::vector<std::string> parts;
    const std::vector<DriveTravel>& drives = motion_.table.drives;
    for (std::size_t d = 0; d < drives.size(); ++d) {
      const std::optional<double>& value = motion_.table.rows[step].values[d];
      parts.push_back(fmt::format(
          "{} {} {}", drives[d].name, value ? format_short(*value) : "?", drives[d].unit));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  // With the poses of the drawn position, names and the like may stand.
  int drawn_step() const {
    const bool is_first = motion_.table.corrections.empty() &&
                          std::ranges::all_of(motion_.table.drives, [](const DriveTravel& drive) {
                            return drive.from == 0.0;
                          });
    return is_first ? 0 : -1;
  }

  // Whether the motion comes back to where it began, so that it can go round.
  bool is_closed() const {
    const std::vector<BodyPose>& first = motion_.poses[steps_.front()];
    const std::vector<BodyPose>& last = motion_.poses[steps_.back()];
    for (std::size_t b = 0; b < first.size(); ++b) {
      const double turned = (first[b].rotation - last[b].rotation).norm();
      const double shifted = (first[b].shift - last[b].shift).norm();
      if (turned > kReportsAgree || shifted > kReportsAgree * mechanism_.geometry.length) {
        return false;
      }
    }
    return true;
  }

  // For each body its shift in the plane [m] and its angle.
  std::string poses_json() const {
    std::string poses;
    std::vector<std::string> labels;
    for (const std::size_t step : steps_) {
      std::vector<std::string> numbers;
      for (const BodyPose& pose : motion_.poses[step]) {
        const double angle = std::atan2(pose.rotation(1, 0), pose.rotation(0, 0));
        for (const double value : {pose.shift.x(), pose.shift.y(), angle}) {
          numbers.push_back(fmt::format("{:.9g}", value));
        }
      }
      poses += fmt::format("{}[{}]", poses.empty() ? "" : ",\n", fmt::join(numbers, ","));
      labels.push_back(script_string(label(step)));
    }
    std::vector<std::string> bodies;
    for (std::size_t b = 0; b < mechanism_.topology.bodies.size(); ++b) {
      bodies.push_back(script_string(fmt::format("{}-{}", mechanism_.topology.bodies[b].name, b)));
    }
    return fmt::format(R"({{"drawn":{},"closed":{},"bodies":[{}],"labels":[{}],"poses":[{}]}})",
                       drawn_step(),
                       is_closed(),
                       fmt::join(bodies, ","),
                       fmt::join(labels, ","),
                       poses);
  }

  const Mechanism& mechanism_;
  const Analysis& analysis_;
  const PageMotion& motion_;
  const std::string& id_;
  std::vector<std::size_t> steps_;
};

}  // namespace

void add_motion_figure(const Analysis& analysis,
                       const PageMotion& motion,
                       const std::string& id,
                       int& figures,
                       Html& html) {
  ++figures;
  MotionFigure(analysis, motion, id).add_to(figures, html);
}

Table position_table(const MotionTable& motion) {
  std::vector<std::string> head = {"Step"};
  for (const MotionColumn& column : motion.columns) {
    head.push_back(column.unit.empty() ? column.name()
                                       : fmt::format("{} [{}]", column.name(), column.unit));
  }
  head.emplace_back("status");
  Table table(std::move(head));
  for (const MotionRow& row : motion.rows) {
    std::vector<std::string> cells = {fmt::format("{}", row.step)};
    for (const std::optional<double>& value : row.values) {
      cells.push_back(value ? format_short(*value) : "-");
    }
    cells.push_back(row.status);
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace kinestat
