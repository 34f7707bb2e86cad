#include "draw/linkage/linkage_frames.hpp"

#include <fmt/format.h>

namespace kinestat {

namespace {

// The mechanism alone, which a position moves.
Analysis without_solutions(const Analysis& analysis) {
  return {.file = analysis.file,
          .description = analysis.description,
          .mechanism = analysis.mechanism,
          .mobility = {},
          .cases = {},
          .shift = {},
          .affine = {}};
}

// The traced points as they stand with these poses.
LinkageOptions options_at(const LinkagePosition& position, const LinkageOptions& options) {
  LinkageOptions moved;
  moved.shows_forces = false;
  for (const TracedPath& path : options.paths) {
    if (path.body) {
      const BodyPose& pose = position.poses[static_cast<std::size_t>(path.body->value)];
      moved.paths.push_back({.name = path.name, .points = {}, .body = path.body});
      moved.paths.back().drawn = pose.point(path.drawn);
    }
  }
  return moved;
}

// When the cycle is at the frame.
std::vector<bool> times_of(std::size_t frame, const LinkageCycle& cycle) {
  std::vector<bool> times;
  for (const std::size_t one : cycle.frames) {
    times.push_back(one == frame);
  }
  return times;
}

void open_frame(std::size_t frame, const LinkageOptions& options, Svg& svg) {
  std::vector<Attribute> marks = {{"data-frame", fmt::format("{}", frame)}};
  if (options.cycle) {
    svg.open_passing_group(marks, times_of(frame, *options.cycle), options.cycle->pace);
    return;
  }
  marks.emplace_back("display", "none");
  svg.open_group({}, marks);
}

}  // namespace

void draw_linkage_frames(const Analysis& analysis,
                         const LinkageOptions& options,
                         LinkageCanvas& canvas,
                         FrameWriter write) {
  if (options.frames.empty()) {
    return;
  }
  Analysis moved = without_solutions(analysis);
  for (std::size_t i = 0; i < options.frames.size(); ++i) {
    const LinkagePosition& position = options.frames[i];
    const LinkageParts parts =
        find_linkage_parts(analysis.description, analysis.mechanism, position.poses);
    moved.mechanism.geometry = position.geometry;
    const LinkageOptions at_position = options_at(position, options);
    LinkageCanvas frame(moved, at_position, canvas.view());
    write(moved, at_position, parts, frame);
    open_frame(i, options, canvas.svg());
    canvas.svg().add(frame.svg());
    canvas.svg().close_group();
  }
}

void draw_faint_positions(const Analysis& drawn,
                          const LinkageOptions& options,
                          LinkageCanvas& canvas,
                          FrameWriter write) {
  if (options.stands.size() < 2) {
    return;
  }
  const std::vector<Attribute> faint = {{"opacity", "0.35"}};
  Analysis moved = without_solutions(drawn);
  for (std::size_t i = options.stands.size() - 1; i > 0; --i) {
    const LinkagePosition& position = options.stands[i];
    const LinkageParts parts =
        find_linkage_parts(drawn.description, drawn.mechanism, position.poses);
    moved.mechanism.geometry = position.geometry;
    const LinkageOptions at_position = options_at(position, options);
    LinkageCanvas frame(moved, at_position, canvas.view());
    write(moved, at_position, parts, frame);
    canvas.svg().open_group({}, faint);
    canvas.svg().add(frame.svg());
    canvas.svg().close_group();
  }
}

}  // namespace kinestat
