#include "draw/train/developed_layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <set>

#include "core/index.hpp"
#include "draw/train/scheme_placer.hpp"

namespace kinestat {

namespace {

constexpr double kDevelopedHeight = 400.0;
constexpr double kDevelopedMost = 620.0;
constexpr double kLeastWheel = 22.0;
constexpr double kShaftRoom = 9.0;  // on both sides of the line of an axis

class DevelopedBuilder {
 public:
  explicit DevelopedBuilder(const SchemeTrain& train) : train_(train) {
    order_ = find_axis_order(train_);
    part_meshes();
    radii_ = find_radii(train_, order_);
    columns_ = order_columns(train_, radii_, find_columns(train_, radii_));
    around_.extents = find_extents(train_, columns_);
    close_gaps();
    find_scale();
    plan_links();
    around_.bearings = find_bearing_pairs(train_);
    for (int axis = 0; axis < train_.axis_count; ++axis) {
      grids_.emplace_back(train_, radii_, columns_, SchemeAxisView{.axis = axis, .scale = scale_});
    }
  }

  SchemeLayout build() {
    add_wheel_obstacles();
    add_axis_obstacles();
    add_link_obstacles();
    routings_.resize(grids_.size());
    mirrored_.resize(grids_.size());
    for (const int axis : axes_by_need()) {
      routings_[at(axis)].emplace(best_routing(train_, grids_[at(axis)], around_));
      add_line_obstacles(axis);
    }
    return place();
  }

 private:
  struct PlannedLink {
    int mesh = 0;
    int lower = 0;  // wheels
    int upper = 0;
    int column = 0;  // of the lower wheel
    int link = -1;   // beside the column; -1: straight from rim to rim
    bool has_way = true;
  };

  const SchemeWheel& wheel(int i) const { return train_.wheels[at(i)]; }

  // Which meshes have axes between their wheels.
  void part_meshes() {
    const auto place = [this](int w) {
      return std::ranges::find(order_, wheel(w).axis) - order_.begin();
    };
    for (SchemeMesh& mesh : train_.meshes) {
      mesh.is_apart = std::abs(place(mesh.first) - place(mesh.second)) > 1;
    }
  }

  // Axes without a mesh between them come as near to each other as their wheels and shafts let
  // them.
  void close_gaps() {
    for (std::size_t i = 0; i + 1 < order_.size(); ++i) {
      const bool is_kept = std::ranges::any_of(train_.meshes, [&](const SchemeMesh& mesh) {
        const int a = wheel(mesh.first).axis;
        const int b = wheel(mesh.second).axis;
        return (a == order_[i] && b == order_[i + 1]) || (b == order_[i] && a == order_[i + 1]);
      });
      if (!is_kept) {
        const double shift = room_above(i);
        for (std::size_t above = i + 1; above < order_.size(); ++above) {
          radii_.axes[at(order_[above])] -= shift;
        }
      }
    }
    const double main = radii_.axes.front();
    for (double& axis : radii_.axes) {
      axis -= main;
    }
  }

  // By how much all axes from the next one on may come down.
  double room_above(std::size_t i) const {
    const auto is_below = [&](int axis) {
      return std::ranges::find(order_, axis) - order_.begin() <= static_cast<std::ptrdiff_t>(i);
    };
    double largest = 0.0;
    for (const double radius : radii_.wheels) {
      largest = std::max(largest, radius);
    }
    const double clear = 0.3 * largest;
    double room = radii_.axes[at(order_[i + 1])] - radii_.axes[at(order_[i])] - 2.0 * clear;
    const int count = static_cast<int>(train_.wheels.size());
    for (int a = 0; a < count; ++a) {
      const WheelSpan one = span_of(train_, radii_, a);
      for (int b = 0; is_below(wheel(a).axis) && b < count; ++b) {
        const bool meet = columns_.first[at(a)] <= columns_.last[at(b)] &&
                          columns_.first[at(b)] <= columns_.last[at(a)];
        if (!is_below(wheel(b).axis) && meet) {
          room = std::min(room, span_of(train_, radii_, b).low - one.high - clear);
        }
      }
      for (const auto& [body, extent] : around_.extents) {
        const double height = radii_.axes[at(extent.axis)];
        const bool is_over =
            columns_.last[at(a)] >= extent.low && columns_.first[at(a)] <= extent.high;
        if (is_over && is_below(wheel(a).axis) && !is_below(extent.axis)) {
          room = std::min(room, height - one.high - clear);
        } else if (is_over && !is_below(wheel(a).axis) && is_below(extent.axis)) {
          room = std::min(room, one.low - height - clear);
        }
      }
    }
    return std::max(room, 0.0);
  }

  WheelSpan drawn_span(int w) const {
    const WheelSpan of = span_of(train_, radii_, w);
    return {.low = scale_ * of.low, .high = scale_ * of.high};
  }

  bool is_placed(int w) const { return columns_.last[at(w)] >= 0; }

  void find_scale() {
    double low = 0.0;
    double high = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
      low = std::min(low, span_of(train_, radii_, w).low);
      high = std::max(high, span_of(train_, radii_, w).high);
      if (is_whole(train_, w)) {
        least = std::min(least, radii_.wheels[at(w)]);
      }
    }
    const double height = high - low;
    scale_ =
        std::min(std::max(kDevelopedHeight / height, kLeastWheel / least), kDevelopedMost / height);
  }

  bool is_in_column(int w, int column) const {
    return columns_.first[at(w)] <= column && column <= columns_.last[at(w)];
  }

  // Whether a wheel of the column reaches into heights between.
  bool has_wheel_between(int column, double low, double high) const {
    for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
      const WheelSpan of = drawn_span(w);
      if (is_in_column(w, column) && of.low < high - 1.0 && of.high > low + 1.0) {
        return true;
      }
    }
    return false;
  }

  void plan_links() {
    for (std::size_t m = 0; m < train_.meshes.size(); ++m) {
      const SchemeMesh& mesh = train_.meshes[m];
      if (!mesh.is_apart || !is_placed(mesh.first) || !is_placed(mesh.second)) {
        continue;
      }
      const auto height = [this](int w) { return radii_.axes[at(wheel(w).axis)]; };
      PlannedLink link{.mesh = static_cast<int>(m), .lower = mesh.first, .upper = mesh.second};
      if (height(link.lower) > height(link.upper)) {
        std::swap(link.lower, link.upper);
      }
      link.column = std::clamp(columns_.first[at(link.upper)],
                               columns_.first[at(link.lower)],
                               columns_.last[at(link.lower)]);
      const double from = drawn_span(link.lower).high;
      const double to = drawn_span(link.upper).low;
      const bool is_one = is_in_column(link.upper, link.column);
      if (!is_one || has_wheel_between(link.column, from, to)) {
        link.link = columns_.links[at(link.column)]++;
      }
      const int other = columns_.first[at(link.upper)];
      for (int column = std::min(link.column, other) + 1;
           !is_one && column < std::max(link.column, other);
           ++column) {
        link.has_way = link.has_way && !has_wheel_between(column, to - 5.0, to + 5.0);
      }
      links_.push_back(link);
    }
  }

  void add_wheel_obstacles() {
    const SchemeGrid& grid = grids_.front();
    for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
      if (is_placed(w)) {
        const WheelSpan of = drawn_span(w);
        around_.obstacles.push_back({.axis = wheel(w).axis,
                                     .left = grid.left_face(w),
                                     .right = grid.right_face(w),
                                     .low = of.low,
                                     .high = of.high});
      }
    }
  }

  // The lines of other axes, along their wheels and to their ports.
  void add_axis_obstacles() {
    constexpr int kBeside = 7;
    const SchemeGrid& grid = grids_.front();
    for (int axis = 0; axis < train_.axis_count; ++axis) {
      int left = grid.track_count();
      int right = -1;
      for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
        if (wheel(w).axis == axis && is_placed(w)) {
          left = std::min(left, grid.left_face(w) - kBeside);
          right = std::max(right, grid.right_face(w) + kBeside);
        }
      }
      for (const SchemeElement& element : train_.elements) {
        if (element.axis == axis && element.kind == SchemeElementKind::input) {
          left = 0;
        } else if (element.axis == axis && element.kind == SchemeElementKind::output) {
          right = grid.track_count() - 1;
        }
      }
      const double height = scale_ * radii_.axes[at(axis)];
      around_.obstacles.push_back({.axis = axis,
                                   .left = std::max(left, 0),
                                   .right = std::min(right, grid.track_count() - 1),
                                   .low = height - kShaftRoom,
                                   .high = height + kShaftRoom});
    }
  }

  int track_of(const PlannedLink& link) const {
    const SchemeGrid& grid = grids_.front();
    return link.link < 0 ? grid.centre(link.column) : grid.link_track(link.column, link.link);
  }

  void add_link_obstacles() {
    for (const PlannedLink& link : links_) {
      around_.obstacles.push_back({.axis = -1,
                                   .left = track_of(link),
                                   .right = track_of(link),
                                   .low = drawn_span(link.lower).high,
                                   .high = drawn_span(link.upper).low,
                                   .may_be_crossed = true});
    }
  }

  // What has most to find room for first: planets, then the most elements.
  std::vector<int> axes_by_need() const {
    std::vector<int> axes;
    for (int axis = 0; axis < train_.axis_count; ++axis) {
      axes.push_back(axis);
    }
    const auto has_planet = [this](int axis) {
      return std::ranges::any_of(train_.planets,
                                 [axis](const SchemePlanet& one) { return one.axis == axis; });
    };
    std::stable_partition(axes.begin(), axes.end(), has_planet);
    return axes;
  }

  void add_line_obstacles(int axis) {
    const SchemeGrid& grid = grids_[at(axis)];
    const SchemeRouting& routing = *routings_[at(axis)];
    const std::vector<SchemeObstacle> lines = lines_of(axis);
    around_.obstacles.insert(around_.obstacles.end(), lines.begin(), lines.end());
    mirrored_[at(axis)] = find_mirrored(axis);
    for (const SchemeRouter::Step& step : routing.router().steps()) {
      if (mirrored_[at(axis)].contains(step.net) && is_near(grid, step)) {
        around_.obstacles.push_back(mirrored(box_of(grid, step), grid));
      }
    }
  }

  static SchemeObstacle box_of(const SchemeGrid& grid, const SchemeRouter::Step& step) {
    const auto [low, high] = std::minmax(step.from.row, step.to.row);
    const auto [left, right] = std::minmax(step.from.column, step.to.column);
    return {.axis = grid.axis(),
            .left = left,
            .right = right,
            .low = grid.base() + grid.height(low),
            .high = grid.base() + grid.height(high)};
  }

  static SchemeObstacle mirrored(SchemeObstacle box, const SchemeGrid& grid) {
    const double low = 2.0 * grid.base() - box.high;
    box.high = 2.0 * grid.base() - box.low;
    box.low = low;
    return box;
  }

  std::vector<SchemeObstacle> lines_of(int axis) const {
    const SchemeGrid& grid = grids_[at(axis)];
    std::vector<SchemeObstacle> lines;
    for (const SchemeRouter::Step& step : routings_[at(axis)]->router().steps()) {
      lines.push_back(box_of(grid, step));
    }
    for (const RoutedSymbol& symbol : routings_[at(axis)]->symbols()) {
      constexpr double kSymbol = 15.0;
      const auto [left, right] = std::minmax(symbol.at.column, symbol.beyond.column);
      const double height = grid.base() + grid.height(symbol.at.row);
      lines.push_back({.axis = axis,
                       .left = std::max(left - 1, 0),
                       .right = std::min(right + 1, grid.track_count() - 1),
                       .low = height,
                       .high = height + kSymbol});
    }
    return lines;
  }

  bool is_near(const SchemeGrid& grid, const SchemeRouter::Step& step) const {
    const int row = std::max(step.from.row, step.to.row);
    return row > 0 && grid.height(row) <= kMirrorReach;
  }

  // Bodies of whole wheels, and what clutches join to these, that have room on the other side of
  // the axis.
  std::set<int> find_mirrored(int axis) const {
    const SchemeGrid& grid = grids_[at(axis)];
    const SchemeRouting& routing = *routings_[at(axis)];
    std::set<int> nets;
    for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
      if (wheel(w).axis == axis && is_whole(train_, w)) {
        nets.insert(wheel(w).body);
      }
    }
    const std::set<int> begin = nets;
    for (const SchemeElement& element : train_.elements) {
      if (element.kind == SchemeElementKind::clutch &&
          (begin.contains(element.body) || begin.contains(element.other))) {
        nets.insert({element.body, element.other});
      }
    }
    std::set<int> others;
    for (const SchemeRouter::Step& step : routing.router().steps()) {
      if (is_near(grid, step) && !has_room(mirrored(box_of(grid, step), grid))) {
        others.insert(step.net);
      }
    }
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (const RoutedSymbol& symbol : routing.symbols()) {
        if (symbol.element < 0 || kind(symbol) != SchemeElementKind::clutch || symbol.at.row == 0) {
          continue;
        }
        const SchemeElement& clutch = train_.elements[at(symbol.element)];
        const auto is_other = [&](int net) { return others.contains(net) || !nets.contains(net); };
        if (is_other(clutch.body) != is_other(clutch.other)) {
          others.insert({clutch.body, clutch.other});
          goes_on = true;
        }
      }
    }
    for (const int other : others) {
      nets.erase(other);
    }
    return nets;
  }

  SchemeElementKind kind(const RoutedSymbol& symbol) const {
    return train_.elements[at(symbol.element)].kind;
  }

  // Of others, beside it.
  bool has_room(const SchemeObstacle& box) const {
    constexpr double kMargin = 4.0;
    return std::ranges::none_of(around_.obstacles, [&](const SchemeObstacle& one) {
      return one.axis != box.axis && !one.may_be_crossed && one.left <= box.right &&
             box.left <= one.right && one.low - kMargin <= box.high &&
             box.low <= one.high + kMargin;
    });
  }

  SchemeLayout place() {
    std::vector<bool> is_used(at(grids_.front().track_count()), false);
    std::vector<SchemePlacer> placers;
    for (std::size_t axis = 0; axis < grids_.size(); ++axis) {
      placers.emplace_back(train_, grids_[axis], *routings_[axis], mirrored_[axis]);
      std::vector<bool> rows(at(grids_[axis].row_count()), false);
      placers.back().mark_used(is_used, rows);
    }
    // Names stand beside what is driven and drives.
    constexpr int kPortTracks = 4;
    for (int track = 0; track < kPortTracks; ++track) {
      is_used[at(track)] = true;
      is_used[is_used.size() - at(track) - 1] = true;
    }
    SchemeLayout layout;
    for (std::size_t axis = 0; axis < grids_.size(); ++axis) {
      grids_[axis].close_up(is_used, {});
      placers[axis].add_to(layout);
      layout.is_complete = layout.is_complete && routings_[axis]->missing() == 0;
    }
    add_links(layout);
    add_axes(layout);
    find_box(layout);
    return layout;
  }

  void add_links(SchemeLayout& layout) const {
    const SchemeGrid& grid = grids_.front();
    for (const PlannedLink& link : links_) {
      layout.is_complete = layout.is_complete && link.has_way;
      const double from = -drawn_span(link.lower).high;
      const double to = -drawn_span(link.upper).low;
      const double x = grid.x(track_of(link));
      DrawnLink drawn{.mesh = link.mesh, .points = {{.x = x, .y = from}, {.x = x, .y = to}}};
      if (link.link >= 0) {
        const double left = grid.x(grid.left_face(link.upper));
        const double right = grid.x(grid.right_face(link.upper));
        drawn.points.insert(drawn.points.begin(),
                            {.x = grid.x(grid.right_face(link.lower)), .y = from});
        drawn.points.push_back({.x = x > left ? right : left, .y = to});
      }
      layout.links.push_back(std::move(drawn));
    }
  }

  void add_axes(SchemeLayout& layout) const {
    constexpr double kBeyond = 16.0;
    for (const SchemeGrid& grid : grids_) {
      DrawnAxis axis{.left = std::numeric_limits<double>::infinity(),
                     .right = -std::numeric_limits<double>::infinity(),
                     .height = grid.base()};
      const auto reach = [&](double from, double to) {
        axis.left = std::min(axis.left, from - kBeyond);
        axis.right = std::max(axis.right, to + kBeyond);
      };
      for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
        if (grid.is_placed(w)) {
          reach(grid.x(grid.left_face(w)), grid.x(grid.right_face(w)));
        }
      }
      for (const SchemeRouter::Step& step : routings_[at(grid.axis())]->router().steps()) {
        reach(grid.x(std::min(step.from.column, step.to.column)),
              grid.x(std::max(step.from.column, step.to.column)));
      }
      if (axis.left < axis.right) {
        layout.axes.push_back(axis);
      }
    }
  }

  void find_box(SchemeLayout& layout) const {
    const SchemeGrid& grid = grids_.front();
    layout.box = {
        .left = grid.x(0), .top = 0.0, .right = grid.x(grid.track_count() - 1), .bottom = 0.0};
    for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
      layout.box.top = std::min(layout.box.top, -drawn_span(w).high);
      layout.box.bottom = std::max(layout.box.bottom, -drawn_span(w).low);
    }
  }

  SchemeTrain train_;
  std::vector<int> order_;  // axes, the lowest first
  SchemeRadii radii_;
  SchemeColumns columns_;
  double scale_ = 1.0;
  std::vector<PlannedLink> links_;
  std::vector<SchemeGrid> grids_;                       // of each axis
  std::vector<std::optional<SchemeRouting>> routings_;  // likewise
  std::vector<std::set<int>> mirrored_;                 // likewise
  SchemeSurroundings around_;
};

}  // namespace

SchemeLayout lay_out_developed(const SchemeTrain& train) {
  return DevelopedBuilder(train).build();
}

}  // namespace kinestat
