#include "draw/linkage/linkage_drawing.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "draw/linkage/linkage_canvas.hpp"
#include "draw/linkage/linkage_drawer.hpp"
#include "draw/linkage/linkage_frames.hpp"
#include "draw/picture_title.hpp"
#include "report/report_parts.hpp"

namespace kinestat {

namespace {

// "Mechanism with the forces of case 1".
std::string drawn_words(const Analysis& analysis, const LinkageOptions& options) {
  const bool has_forces =
      options.shows_forces && options.which && *options.which < analysis.cases.size();
  return has_forces
             ? fmt::format("Mechanism with the forces of case {}{}",
                           analysis.cases[*options.which].which.label,
                           options.is_as_drawn() ? in_drawn_position(analysis.description) : "")
             : "Mechanism";
}

Analysis standing_at(const LinkagePosition& position, const Analysis& analysis) {
  Analysis moved = analysis;
  moved.mechanism.geometry = position.geometry;
  return moved;
}

std::string vector_text(const Vec3& v) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", v.x(), v.y(), v.z());
}

std::string describe(const Topology& topology) {
  return fmt::format("Drawing to scale of {} bodies and {} couplings.",
                     topology.body_count(),
                     topology.coupling_count());
}

}  // namespace

Picture draw_linkage(const Analysis& drawn, const LinkageOptions& options) {
  const std::optional<Analysis> moved =
      options.stands.empty() ? std::nullopt
                             : std::optional(standing_at(options.stands.front(), drawn));
  const Analysis& analysis = moved ? *moved : drawn;
  const LinkageParts parts =
      find_linkage_parts(drawn.description,
                         drawn.mechanism,
                         moved ? std::span(options.stands.front().poses) : std::span<BodyPose>());
  const std::vector<Vec3> points = extent_points(parts, analysis, options);
  const bool is_planar = analysis.mechanism.space == Space::planar;
  const LinkageView view =
      fit_view(is_planar ? LinkageView{} : best_view(analysis, points), points, options.width);
  LinkageCanvas canvas(analysis, options, view);
  std::vector<Attribute> marks = {
      {"data-scale", fmt::format("{}", view.scale)},
      {"data-x0", fmt::format("{}", view.x0)},
      {"data-y0", fmt::format("{}", view.y0)},
  };
  if (!is_planar) {
    marks.emplace_back("data-right", vector_text(view.right));
    marks.emplace_back("data-up", vector_text(view.up));
  }
  canvas.svg().open_group({}, marks);
  draw_faint_positions(
      drawn, options, canvas, is_planar ? draw_planar_bodies : draw_spatial_bodies);
  if (is_planar) {
    draw_planar(analysis, options, parts, canvas);
  } else {
    draw_spatial(analysis, options, parts, canvas);
  }
  canvas.svg().close_group();
  Picture picture = make_picture("linkage",
                                 picture_title(drawn_words(analysis, options), analysis),
                                 describe(analysis.mechanism.topology),
                                 canvas.svg());
  const PixelBox bounds = canvas.bounds();
  picture.view.add(PixelBox{.left = std::floor(bounds.left),
                            .top = std::floor(bounds.top),
                            .right = std::ceil(bounds.right),
                            .bottom = std::ceil(bounds.bottom)});
  return picture;
}

}  // namespace kinestat
