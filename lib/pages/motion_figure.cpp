#include "pages/motion_figure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "draw/linkage/file_numbers.hpp"
#include "draw/linkage/linkage_drawing.hpp"
#include "draw/linkage/page_linkage.hpp"
#include "pages/acting_arrows.hpp"
#include "pages/figures.hpp"
#include "pages/moving_figure.hpp"
#include "pages/spatial_scene.hpp"
#include "report/number_format.hpp"
#include "studies/motion/picture/motion_abscissa.hpp"

namespace kinestat {

namespace {

// More positions than these look no smoother.
constexpr std::size_t kMostSteps = 720;

class MotionFigure {
 public:
  MotionFigure(const Analysis& analysis, const PageMotion& motion, const MovingDrawingName& as)
      : mechanism_(analysis.mechanism),
        analysis_(analysis),
        motion_(motion),
        name_(as.name),
        id_(as.section),
        over_(usual_abscissa(motion.table)) {}

  void add_to(int number, Html& html) const {
    MovingFigure figure{.name = name_,
                        .section = id_,
                        .number = number,
                        .caption = caption(),
                        .what = drive_names(),
                        .drawn = drawn_step(),
                        .is_closed = goes_on_in_time() || is_closed(mechanism_, motion_.drawn),
                        .bodies = {},
                        .labels = {},
                        .rows = motion_.shown,
                        .acting = acting_json(motion_.acting, analysis_),
                        .steps = {}};
    for (std::size_t i = 0; i < positions().size(); ++i) {
      figure.labels.push_back(label(i));
      figure.steps.push_back(poses_in_plane(positions()[i].poses));
    }
    for (std::size_t b = 0; is_planar() && b < mechanism_.topology.bodies.size(); ++b) {
      figure.bodies.push_back(fmt::format("{}-{}", mechanism_.topology.bodies[b].name, b));
    }
    open_moving_figure(drawing(), figure, html);
    if (!is_planar()) {
      add_spatial_scene(analysis_,
                        positions(),
                        motion_.drawn.paths,
                        fmt::format("{}-{}-scene", id_, name_),
                        html);
    }
    html.close();
  }

 private:
  bool goes_on_in_time() const { return name_ == "simulation"; }

  bool is_planar() const { return mechanism_.space == Space::planar; }

  const std::vector<LinkagePosition>& positions() const { return motion_.drawn.positions; }

  std::string caption() const {
    const std::string paths =
        motion_.drawn.paths.empty() ? "" : " and the paths of its traced points";
    const std::size_t shown = positions().size();
    const std::size_t all = motion_.table.rows.size();
    const std::string some =
        shown < all ? fmt::format(", at {} of the {} positions of the {}", shown, all, name_) : "";
    return fmt::format("The mechanism to scale{}{}", paths, some);
  }

  Picture drawing() const {
    LinkageOptions options = motion_options(mechanism_, motion_.drawn);
    if (is_planar()) {
      add_lobes(options);
    }
    return draw_page_linkage(analysis_, options);
  }

  // Where round cams come, so that the picture holds them.
  void add_lobes(LinkageOptions& options) const {
    const FileNumbers numbers(analysis_.description);
    for (std::size_t e = 0; e < mechanism_.topology.couplings.size(); ++e) {
      const CouplingTopology& coupling = mechanism_.topology.couplings[e];
      const auto& radii = analysis_.description.couplings[e].radii;
      const auto radius = radii.empty() || !radii[0]
                              ? std::nullopt
                              : numbers.number(*radii[0], QuantityKind::length);
      if (!radius || coupling.action_count == 0) {
        continue;
      }
      const Vec3 normal =
          mechanism_.geometry.actions[static_cast<std::size_t>(coupling.first_action)].force;
      const Vec3 centre = mechanism_.geometry.points[e] - *radius * normal;
      for (const LinkagePosition& position : positions()) {
        const Vec3 at = position.poses[static_cast<std::size_t>(coupling.tail.value)].point(centre);
        for (const double side : {-*radius, *radius}) {
          options.reach.push_back(at + side * Vec3::UnitX());
          options.reach.push_back(at + side * Vec3::UnitY());
        }
      }
    }
  }

  std::string drive_names() const {
    if (motion_.table.drives.empty()) {
      return "drive";
    }
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
    if (over_ >= drives.size()) {  // where a drive rests its place alone does not tell the step
      const std::optional<double>& time = motion_.table.rows[motion_.shown[position]].values[over_];
      parts.push_back(
          fmt::format("time {} {}", format_short(time.value_or(0.0)), motion_.table.time_unit));
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

  // Of each body of a planar mechanism.
  std::vector<DrawnPose> poses_in_plane(const std::vector<BodyPose>& poses) const {
    std::vector<DrawnPose> result;
    for (const BodyPose& pose : poses) {
      if (is_planar()) {
        const double angle = std::atan2(pose.rotation(1, 0), pose.rotation(0, 0));
        result.push_back({pose.shift.x(), pose.shift.y(), angle});
      }
    }
    return result;
  }

  const Mechanism& mechanism_;
  const Analysis& analysis_;
  const PageMotion& motion_;
  const std::string& name_;
  const std::string& id_;
  std::size_t over_;  // the column over which charts stand
};

}  // namespace

std::vector<std::size_t> shown_positions(const Mechanism& mechanism, std::size_t count) {
  return spread_positions(count,
                          mechanism.space == Space::planar ? kMostSteps : most_frames(mechanism));
}

void add_motion_figure(const Analysis& analysis,
                       const PageMotion& motion,
                       const MovingDrawingName& as,
                       int& figures,
                       Html& html) {
  ++figures;
  MotionFigure(analysis, motion, as).add_to(figures, html);
}

}  // namespace kinestat
