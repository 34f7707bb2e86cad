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

// Bodies and couplings that are drawn anew for positions, all together: each is about 500 bytes.
constexpr std::size_t kMostParts = 1000;

std::size_t most_positions(const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  const std::size_t parts = topology.bodies.size() + topology.couplings.size();
  return mechanism.space == Space::planar ? kMostSteps
                                          : std::max<std::size_t>(kMostParts / parts, 2);
}

class MotionFigure {
 public:
  MotionFigure(const Analysis& analysis, const PageMotion& motion, const std::string& id)
      : mechanism_(analysis.mechanism), analysis_(analysis), motion_(motion), id_(id) {}

  void add_to(int number, Html& html) const {
    const bool moves = motion_.positions.size() > 1;
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

  bool has_cables() const {
    return std::ranges::any_of(mechanism_.topology.couplings, [](const CouplingTopology& one) {
      return one.type == CouplingType::cable;
    });
  }

  std::string caption() const {
    const std::string paths = motion_.paths.empty() ? "" : " and the paths of its traced points";
    const std::size_t shown = motion_.positions.size();
    const std::size_t all = motion_.table.rows.size();
    const std::string some =
        shown < all ? fmt::format(", at {} of the {} positions of the motion", shown, all) : "";
    return fmt::format("The mechanism to scale{}{}", paths, some);
  }

  Picture drawing() const {
    LinkageOptions options;
    options.shows_forces = false;
    options.paths = motion_.paths;
    const bool needs_frames = !is_planar() || has_cables();
    for (const LinkagePosition& position : motion_.positions) {
      add_places(position.poses, options);
    }
    if (needs_frames && motion_.positions.size() > 1) {
      options.frames = motion_.positions;
    }
    return draw_linkage(analysis_, options);
  }

  // Where couplings and reference points are with these poses.
  void add_places(const std::vector<BodyPose>& poses, LinkageOptions& options) const {
    const Topology& topology = mechanism_.topology;
    options.travel.resize(topology.couplings.size());
    for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology.couplings[e];
      const BodyId moving = coupling.head.value == 0 ? coupling.tail : coupling.head;
      const BodyPose& pose = poses[static_cast<std::size_t>(moving.value)];
      options.travel[e].push_back(pose.point(mechanism_.geometry.points[e]));
      options.reach.push_back(options.travel[e].back());
    }
    for (std::size_t b = 1; b < topology.bodies.size(); ++b) {
      options.reach.push_back(poses[b].point(mechanism_.geometry.references[b]));
    }
  }

  void add_controls(Html& html) const {
    const std::string name = motion_.table.drives.empty() ? "drive" : drive_names();
    html.open("div", {{"class", "drive script"}, {"hidden", ""}});
    html.element("button", "Play", {{"type", "button"}});
    html.single("input",
                {{"type", "range"},
                 {"min", "0"},
                 {"max", fmt::format("{}", motion_.positions.size() - 1)},
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
    for (std::size_t i = 0; i < motion_.positions.size(); ++i) {
      if (is_drawn(motion_.positions[i].poses)) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  // In space it is enough that couplings are in their places: how a rod spins is not seen.
  bool is_drawn(const std::vector<BodyPose>& poses) const {
    if (is_planar()) {
      return are_same(poses, std::vector<BodyPose>(poses.size()));
    }
    LinkageOptions moved;
    LinkageOptions still;
    add_places(poses, moved);
    add_places(std::vector<BodyPose>(poses.size()), still);
    return std::ranges::equal(moved.reach, still.reach, [this](const Vec3& a, const Vec3& b) {
      return (a - b).norm() <= kReportsAgree * mechanism_.geometry.length;
    });
  }

  bool are_same(const std::vector<BodyPose>& some, const std::vector<BodyPose>& others) const {
    for (std::size_t b = 0; b < some.size(); ++b) {
      const double turned = (some[b].rotation - others[b].rotation).norm();
      const double shifted = (some[b].shift - others[b].shift).norm();
      if (turned > kReportsAgree || shifted > kReportsAgree * mechanism_.geometry.length) {
        return false;
      }
    }
    return true;
  }

  // Whether the motion comes back to where it began, so that it can go round.
  bool is_closed() const {
    return are_same(motion_.positions.front().poses, motion_.positions.back().poses);
  }

  // For each body of a planar mechanism its shift in the plane [m] and its angle.
  std::string poses_json() const {
    std::string poses;
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < motion_.positions.size(); ++i) {
      std::vector<std::string> numbers;
      for (const BodyPose& pose : motion_.positions[i].poses) {
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
                       is_closed(),
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
  const std::size_t most = most_positions(mechanism);
  const std::size_t stride = (count + most - 1) / most;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < count; i += stride) {
    shown.push_back(i);
  }
  if (!shown.empty() && shown.back() + 1 < count) {
    shown.push_back(count - 1);
  }
  return shown;
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
