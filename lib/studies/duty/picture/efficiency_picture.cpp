#include "studies/duty/picture/efficiency_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/chart_frame.hpp"
#include "draw/picture_title.hpp"
#include "draw/shades.hpp"
#include "draw/text_styles.hpp"
#include "expression/file_units.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

// Whole pixels, whose coordinates are short.
constexpr double kCell = 10.0;
constexpr double kWidth = kCell * static_cast<double>(kMapColumns);
constexpr double kHeight = kCell * static_cast<double>(kMapRows);
constexpr double kGutter = 62.0;  // of numbers and words on the left
constexpr double kGapBelow = 66.0;
constexpr double kHead = 20.0;
constexpr double kGap = 22.0;
constexpr double kDot = 7.0;           // radius of the longest point
constexpr double kLeastDot = 1.5;      // of any
constexpr double kMostCovered = 0.06;  // of a panel by its points
constexpr double kHatch = 5.0;
constexpr std::size_t kMostLevels = 7;
constexpr std::size_t kLeastLevels = 4;
constexpr int kLevelDigits = 8;  // of levels that lie close together; zeros at the end are left out

// Panels beside each other: few on half a page, more across all of it.
std::size_t columns_for(std::size_t panels) {
  constexpr std::size_t kFew = 4;
  return panels == 1 ? 1 : panels <= kFew ? 2 : 3;
}

// Points that no eye tells apart are one, for as long as they are together.
std::vector<MapPoint> merged(const EfficiencyMap& map) {
  constexpr double kParts = 2.0;  // of a cell
  const auto part = [](double value, const MapRange& range, std::size_t count) {
    const double share = (value - range.low) / (range.high - range.low);
    return std::lround(share * kParts * static_cast<double>(count));
  };
  std::map<std::pair<long, long>, MapPoint> sums;
  for (const MapPoint& point : map.points) {
    MapPoint& sum =
        sums[{part(point.speed, map.speeds, kMapColumns), part(point.load, map.loads, kMapRows)}];
    const double duration = sum.duration + point.duration;
    const double share = duration > 0.0 ? point.duration / duration : 0.0;
    sum = {.speed = sum.speed + share * (point.speed - sum.speed),
           .load = sum.load + share * (point.load - sum.load),
           .duration = duration};
  }
  std::vector<MapPoint> result;
  for (const auto& [place, sum] : sums) {
    if (sum.duration > 0.0) {
      result.push_back(sum);
    }
  }
  // The short ones over the long ones.
  std::ranges::stable_sort(result, std::greater(), &MapPoint::duration);
  return result;
}

class MapDrawing {
 public:
  MapDrawing(const Analysis& analysis, std::span<const EfficiencyMap> maps)
      : mechanism_(analysis.mechanism), units_(analysis.description.units), maps_(maps) {
    double low = 1.0;
    double high = 0.0;
    for (const EfficiencyMap& map : maps_) {
      is_number_.push_back(map.constant().has_value());
      points_.push_back(is_number_.back() ? std::vector<MapPoint>() : merged(map));
      for (const MapPoint& point : points_.back()) {
        longest_ = std::max(longest_, point.duration);
      }
      for (const std::optional<double>& cell : map.cells) {
        has_blank_ = has_blank_ || !cell;
        if (cell && !is_number_.back()) {
          has_shades_ = true;
          low = std::min(low, *cell);
          high = std::max(high, *cell);
        }
      }
    }
    if (has_shades_) {
      levels_ = efficiency_levels(low, high);
    }
    for (const std::vector<MapPoint>& points : points_) {
      double covered = 0.0;
      for (const MapPoint& point : points) {
        const double radius = radius_of(point.duration);
        covered += std::numbers::pi * radius * radius / (kWidth * kHeight);
      }
      size_ = std::min(size_, std::sqrt(kMostCovered / std::max(covered, kMostCovered)));
    }
  }

  Picture run(std::string title) {
    const std::size_t columns = columns_for(maps_.size());
    for (std::size_t i = 0; i < maps_.size(); ++i) {
      const double left = static_cast<double>(i % columns) * (kWidth + kGutter + kGap);
      const double top = static_cast<double>(i / columns) * (kHead + kHeight + kGapBelow);
      draw_panel(i,
                 {.left = left + kGutter,
                  .top = top + kHead,
                  .right = left + kGutter + kWidth,
                  .bottom = top + kHead + kHeight});
    }
    const std::size_t rows = (maps_.size() + columns - 1) / columns;
    draw_legend(static_cast<double>(rows) * (kHead + kHeight + kGapBelow));
    return make_picture("efficiency-map", std::move(title), description_, svg_);
  }

 private:
  const std::string& label_of(const EfficiencyMap& map) const {
    return mechanism_.cases[map.which].label;
  }

  QuantityKind speed_kind(const EfficiencyMap& map) const {
    const auto freedom = mechanism_.topology.actuators[static_cast<std::size_t>(map.input)].freedom;
    return kind_of(mechanism_.topology.freedoms[static_cast<std::size_t>(freedom)]);
  }

  QuantityKind load_kind(const EfficiencyMap& map) const {
    const auto action = mechanism_.topology.actuators[static_cast<std::size_t>(map.input)].action;
    return kind_of(mechanism_.topology.actions[static_cast<std::size_t>(action)]);
  }

  void draw_panel(std::size_t index, const PixelBox& box) {
    const EfficiencyMap& map = maps_[index];
    const std::string words = words_of(map);
    description_ += fmt::format("{}{}: {}.", index == 0 ? "" : " ", label_of(map), words);
    svg_.open_group(fmt::format("{}: {}", label_of(map), words));
    const double room = kWidth - text_width(words, kSmall.size) - 10.0;
    svg_.text({.x = box.left, .y = box.top - 7.0},
              fitting_text(label_of(map), kTextSize, std::max(room, kWidth / 3), Weight::bold),
              {.size = kTextSize, .weight = Weight::bold});
    if (is_number_[index]) {
      draw_number(map, box);
    } else {
      TextStyle style = kSmall;
      style.anchor = Anchor::end;
      svg_.text({.x = box.right, .y = box.top - 7.0}, words, style);
      draw_cells(map, box);
      draw_points(points_[index], draw_frame(map, box));
    }
    svg_.close_group();
  }

  std::string words_of(const EfficiencyMap& map) const {
    if (const std::optional<double> same = map.constant()) {
      return fmt::format("{} at every speed and {}", label_number(*same), load_word(map));
    }
    std::vector<double> values;
    for (const std::optional<double>& cell : map.cells) {
      if (cell) {
        values.push_back(*cell);
      }
    }
    if (values.empty()) {
      return "no efficiency anywhere";
    }
    const auto [low, high] = std::ranges::minmax(values);
    return fmt::format("{} to {}", label_number(low), label_number(high));
  }

  std::string_view load_word(const EfficiencyMap& map) const {
    return load_kind(map) == QuantityKind::moment ? "torque" : "force";
  }

  void draw_number(const EfficiencyMap& map, const PixelBox& box) {
    constexpr double kLarge = 26.0;
    svg_.rectangle(box, {.stroke = Ink::grid, .width = 1.0});
    svg_.text({.x = box.centre().x, .y = box.centre().y},
              label_number(*map.constant()),
              {.size = kLarge, .anchor = Anchor::middle});
    TextStyle style = kSmall;
    style.anchor = Anchor::middle;
    svg_.text({.x = box.centre().x, .y = box.centre().y + 22.0},
              fmt::format("at every speed and {}", load_word(map)),
              style);
  }

  // The shade of a value, from 0; that of no value.
  static constexpr std::size_t kBlank = kMostLevels + 1;

  std::size_t shade_of(const std::optional<double>& value) const {
    return value ? static_cast<std::size_t>(std::ranges::upper_bound(levels_, *value) -
                                            levels_.begin())
                 : kBlank;
  }

  Paint paint_of(std::size_t shade) const {
    const int steps = static_cast<int>(levels_.size()) + 1;
    return {.stroke = Ink::none,
            .fill = Ink::blue,
            .opacity = shade_opacity(static_cast<int>(shade), steps)};
  }

  // Neighbours of a row with one shade are one rectangle, and all of a shade one path, so that no
  // seam shows between them.
  void draw_cells(const EfficiencyMap& map, const PixelBox& box) {
    std::array<std::string, kBlank> paths;
    for (std::size_t row = 0; row < kMapRows; ++row) {
      const double bottom = box.bottom - kCell * static_cast<double>(row);
      std::size_t first = 0;
      for (std::size_t column = 1; column <= kMapColumns; ++column) {
        const std::size_t shade = shade_of(map.cells[row * kMapColumns + first]);
        if (column < kMapColumns && shade_of(map.cells[row * kMapColumns + column]) == shade) {
          continue;
        }
        const PixelBox cells = {.left = box.left + kCell * static_cast<double>(first),
                                .top = bottom - kCell,
                                .right = box.left + kCell * static_cast<double>(column),
                                .bottom = bottom};
        if (shade == kBlank) {
          svg_.hatch(cells, Ink::soft, kHatch);
        } else {
          paths.at(shade) += fmt::format(
              "M{},{}H{}V{}H{}Z", cells.left, cells.top, cells.right, cells.bottom, cells.left);
        }
        first = column;
      }
    }
    for (std::size_t shade = 0; shade < paths.size(); ++shade) {
      if (!paths.at(shade).empty()) {
        svg_.path(paths.at(shade), box, paint_of(shade));
      }
    }
  }

  AxisRange range_of(const MapRange& range, QuantityKind kind, int ticks) const {
    return tight_axis({.low = units_.from_si(kind, range.low),
                       .high = units_.from_si(kind, range.high),
                       .tick_count = ticks});
  }

  // In SI, so that points have their places in it.
  ChartFrame draw_frame(const EfficiencyMap& map, const PixelBox& box) {
    constexpr int kAcross = 4;
    constexpr int kUp = 4;
    const QuantityKind speed = speed_kind(map);
    const QuantityKind load = load_kind(map);
    const Chart chart = {
        .x = {.label = "input speed", .unit = units_.text(speed)},
        .y = {.label = fmt::format("input {}", load_word(map)), .unit = units_.text(load)},
        .series = {}};
    const ChartFrame frame = {
        .box = box, .x = range_of(map.speeds, speed, kAcross), .y = range_of(map.loads, load, kUp)};
    draw_axes(chart, frame, svg_);
    const Paint line = {.stroke = Ink::soft, .width = 1.0};
    svg_.rectangle(box, line);
    const PixelPoint zero = frame.place(0.0, 0.0);
    if (map.loads.low < 0.0 && map.loads.high > 0.0) {
      svg_.line({.x = box.left, .y = zero.y}, {.x = box.right, .y = zero.y}, line);
    }
    if (map.speeds.low < 0.0 && map.speeds.high > 0.0) {
      svg_.line({.x = zero.x, .y = box.top}, {.x = zero.x, .y = box.bottom}, line);
    }
    ChartFrame places = frame;
    places.x.low = map.speeds.low;
    places.x.high = map.speeds.high;
    places.y.low = map.loads.low;
    places.y.high = map.loads.high;
    return places;
  }

  void draw_points(const std::vector<MapPoint>& points, const ChartFrame& frame) {
    for (const MapPoint& point : points) {
      draw_dot(frame.place(point.speed, point.load), point.duration);
    }
  }

  // Areas are as durations.
  void draw_dot(PixelPoint at, double duration) {
    svg_.circle(at,
                size_ * radius_of(duration),
                {.stroke = Ink::paper, .fill = Ink::vermilion, .width = size_});
  }

  // Where points do not cover much of a panel.
  double radius_of(double duration) const {
    return std::max(kDot * std::sqrt(duration / longest_), kLeastDot);
  }

  void draw_legend(double top) {
    const double left = kGutter;
    double y = top;
    if (has_shades_) {
      draw_bar(left, y);
      y += 52.0;
    }
    if (has_blank_) {
      const PixelBox box = {.left = left, .top = y, .right = left + 26.0, .bottom = y + 14.0};
      svg_.hatch(box, Ink::soft, kHatch);
      svg_.rectangle(box, {.stroke = Ink::soft, .width = 1.0});
      svg_.text({.x = left + 34.0, .y = y + 11.0},
                "losses exceed the power of the input, or there is no answer",
                kSmall);
      y += 24.0;
    }
    if (longest_ > 0.0) {
      draw_dot({.x = left + 13.0, .y = y + 7.0}, longest_);
      svg_.text({.x = left + 34.0, .y = y + 11.0},
                fmt::format("points of the duty, area by duration; this one {} {}",
                            label_number(units_.from_si(QuantityKind::time, longest_)),
                            units_.text(QuantityKind::time)),
                kSmall);
    }
  }

  // The shades beside each other, and between them where they change.
  void draw_bar(double left, double top) {
    constexpr double kStep = 44.0;
    constexpr double kBarHeight = 14.0;
    svg_.text({.x = left, .y = top + 11.0}, "efficiency", {.size = kTextSize});
    const double y = top + 18.0;
    for (std::size_t shade = 0; shade <= levels_.size(); ++shade) {
      const double x = left + kStep * static_cast<double>(shade);
      svg_.rectangle({.left = x, .top = y, .right = x + kStep, .bottom = y + kBarHeight},
                     paint_of(shade));
      if (shade < levels_.size()) {
        svg_.text({.x = x + kStep, .y = y + kBarHeight + 13.0},
                  label_number(levels_[shade], kLevelDigits),
                  {.ink = Ink::soft, .size = kTickText, .anchor = Anchor::middle});
      }
    }
    svg_.rectangle({.left = left,
                    .top = y,
                    .right = left + kStep * static_cast<double>(levels_.size() + 1),
                    .bottom = y + kBarHeight},
                   {.stroke = Ink::soft, .width = 1.0});
  }

  const Mechanism& mechanism_;
  const FileUnits& units_;
  std::span<const EfficiencyMap> maps_;
  std::vector<bool> is_number_;
  std::vector<std::vector<MapPoint>> points_;
  std::vector<double> levels_;
  double longest_ = 0.0;
  double size_ = 1.0;  // of points, smaller where they are many
  bool has_blank_ = false;
  bool has_shades_ = false;
  std::string description_;
  Svg svg_;
};

}  // namespace

std::vector<double> efficiency_levels(double low, double high) {
  constexpr std::array<double, 3> kLosses = {5.0, 2.0, 1.0};
  constexpr int kDecades = 4;
  std::vector<double> levels;
  double decade = 10.0;
  for (int i = 0; i < kDecades; ++i) {
    for (const double loss : kLosses) {
      if (const double level = 1.0 - loss / decade; level > low && level < high) {
        levels.push_back(level);
      }
    }
    decade *= 10.0;
  }
  if (levels.size() < kLeastLevels) {
    levels.clear();
    const int count = static_cast<int>(kMostLevels);
    for (const Tick& tick : tight_axis({.low = low, .high = high, .tick_count = count}).ticks) {
      if (tick.value > low && tick.value < high) {
        levels.push_back(tick.value);
      }
    }
  }
  if (levels.size() > kMostLevels) {
    levels.erase(levels.begin(), levels.end() - static_cast<std::ptrdiff_t>(kMostLevels));
  }
  return levels;
}

Picture draw_efficiency_maps(const Analysis& analysis, std::span<const EfficiencyMap> maps) {
  KINESTAT_EXPECTS(!maps.empty());
  return MapDrawing(analysis, maps).run(picture_title("Efficiency map", analysis));
}

}  // namespace kinestat
