#include "pages/motion_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "draw/linkage/linkage_drawing.hpp"
#include "pages/figures.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// More positions than these look no smoother.
constexpr std::size_t kMostSteps = 720;

class MotionFigure {
 public:
  MotionFigure(const Analysis& analysis, const PageMotion& motion, const std::string& id)
      : mechanism_(analysis.mechanism), analysis_(analysis), motion_(motion), id_(id) {}

  void add_to(int number, Html& html) const {
    const bool moves = positions().size() > 1;
    if (moves) {
      html.open("figure",
                {{"class", "motion"},
                 {"data-picture", "motion"},
                 {"data-poses", id_ + "-poses"},
                 {"data-autoplay", ""}});
    } else {
      html.open("figure", {{"data-picture", "motion"}});
    }
    add_picture(drawing(), fmt::format("{}-figure-{}", id_, number), html);
    if (moves) {
      add_controls(html);
    }
    html.open("figcaption");
    html.element("b", fmt::format("Figure {}. ", number));
    html.text(caption());
    html.close();
    if (moves) {
      html.open("script", {{"type", "application/json"}, {"id", id_ + "-poses"}});
      html.markup(script_json(poses_json()));
      html.close();
    }
    html.close();
  }

 private:
  bool is_planar() const { return mechanism_.space == Space::planar; }

  const std::vector<LinkagePosition>& positions() const { return motion_.drawn.positions; }

  std::string caption() const {
    const std::string paths =
        motion_.drawn.paths.empty() ? "" : " and the paths of its traced points";
    const std::size_t shown = positions().size();
    const std::size_t all = motion_.table.rows.size();
    const std::string some =
        shown < all ? fmt::format(", at {} of the {} positions of the motion", shown, all) : "";
    return fmt::format("The mechanism to scale{}{}", paths, some);
  }

  Picture drawing() const {
    return draw_linkage(analysis_, motion_options(mechanism_, motion_.drawn));
  }

  void add_controls(Html& html) const {
    const std::string name = motion_.table.drives.empty() ? "drive" : drive_names();
    html.open("div", {{"class", "drive script"}, {"hidden", ""}});
    html.element("button", "Play", {{"type", "button"}});
    html.single("input",
                {{"type", "range"},
                 {"min", "0"},
                 {"max", fmt::format("{}", positions().size() - 1)},
                 {"step", "1"},
                 {"value", fmt::format("{}", std::max(drawn_step(), 0))},
                 {"aria-label", name}});
    html.element("output", label(static_cast<std::size_t>(std::max(drawn_step(), 0))));
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
  std::string label(std::size_t position) const {
    std::vector<std::string> parts;
    const std::vector<DriveTravel>& drives = motion_.table.drives;
    for (std::size_t d = 0; d < drives.size(); ++d) {
      const std::optional<double>& value = motion_.table.rows[motion_.shown[position]].values[d];
      parts.push_back(fmt::format(
          "{} {} {}", drives[d].name, value ? format_short(*value) : "?", drives[d].unit));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  // Of the steps the one with the poses of the drawn position, where names and the like may stand;
  // -1 if there is none.
  int drawn_step() const {
    for (std::size_t i = 0; i < positions().size(); ++i) {
      if (is_drawn(positions()[i].poses)) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  // In space it is enough that couplings are in their places: how a rod spins is not seen.
  bool is_drawn(const std::vector<BodyPose>& poses) const {
    if (is_planar()) {
      return are_same(mechanism_, poses, std::vector<BodyPose>(poses.size()));
    }
    LinkageOptions moved;
    LinkageOptions still;
    add_places(mechanism_, poses, moved);
    add_places(mechanism_, std::vector<BodyPose>(poses.size()), still);
    return std::ranges::equal(moved.reach, still.reach, [this](const Vec3& a, const Vec3& b) {
      return (a - b).norm() <= kReportsAgree * mechanism_.geometry.length;
    });
  }

  // For each body of a planar mechanism its shift in the plane [m] and its angle.
  std::string poses_json() const {
    std::string poses;
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < positions().size(); ++i) {
      std::vector<std::string> numbers;
      for (const BodyPose& pose : positions()[i].poses) {
        if (!is_planar()) {
          break;
        }
        const double angle = std::atan2(pose.rotation(1, 0), pose.rotation(0, 0));
        for (const double value : {pose.shift.x(), pose.shift.y(), angle}) {
          numbers.push_back(fmt::format("{:.9g}", value));
        }
      }
      poses += fmt::format("{}[{}]", poses.empty() ? "" : ",\n", fmt::join(numbers, ","));
      labels.push_back(script_string(label(i)));
    }
    std::vector<std::string> bodies;
    for (std::size_t b = 0; is_planar() && b < mechanism_.topology.bodies.size(); ++b) {
      bodies.push_back(script_string(fmt::format("{}-{}", mechanism_.topology.bodies[b].name, b)));
    }
    return fmt::format(R"({{"drawn":{},"closed":{},"bodies":[{}],"labels":[{}],"poses":[{}]}})",
                       drawn_step(),
                       is_closed(mechanism_, motion_.drawn),
                       fmt::join(bodies, ","),
                       fmt::join(labels, ","),
                       poses);
  }

  const Mechanism& mechanism_;
  const Analysis& analysis_;
  const PageMotion& motion_;
  const std::string& id_;
};

}  // namespace

std::vector<std::size_t> shown_positions(const Mechanism& mechanism, std::size_t count) {
  return spread_positions(count,
                          mechanism.space == Space::planar ? kMostSteps : most_frames(mechanism));
}

void add_motion_figure(const Analysis& analysis,
                       const PageMotion& motion,
                       const std::string& id,
                       int& figures,
                       Html& html) {
  ++figures;
  MotionFigure(analysis, motion, id).add_to(figures, html);
}

}  // namespace kinestat
