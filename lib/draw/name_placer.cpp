#include "draw/name_placer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "draw/symbols.hpp"

namespace kinestat {

namespace {

// What it costs to cover a pixel of a label, of something else, or of a line. Labels are never
// covered as long as there is any other place.
constexpr double kLabelCost = 1e6;
constexpr double kBoxCost = 3.0;
constexpr double kLineCost = 14.0;

// Likewise of a line to a label that goes through another.
constexpr double kCrossedLabelCost = 40.0;

// Likewise for each line that it crosses, and at most for all: as much as to lead so much farther
// [px]. With the farthest place that is less than to cover anything.
constexpr double kCrossedLine = 25.0;
constexpr double kMostCrossed = 150.0;

// Letters may be so much wider than they were measured [px].
constexpr double kSlack = 1.0;

// What is nearer to a label than this seems to touch it, which costs less than to cover it.
constexpr double kAir = 2.0;
constexpr double kNearCost = 1.0;

// What a pixel of distance from the anchor costs.
constexpr double kFarCost = 4.0;

// By how much a label is rather put farther away than upon anything that is drawn [px].
constexpr double kDetour = 600.0;

// What an anchor costs that is the next of several [px].
constexpr double kNextAnchor = 3.0;

// From there on a line leads to the label [px].
constexpr double kNearEnough = 14.0;

constexpr int kDirections = 16;

// How far from the nearest place [px].
constexpr std::array kFarther = {
    0.0, 6.0, kNearEnough, 26.0, 42.0, 64.0, 92.0, 126.0, 168.0, 220.0, 280.0, 350.0};

// The share of the height that lies above the base line.
constexpr double kAscentShare = 0.76;

double overlap(const PixelBox& a, const PixelBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

// Cuts the part [from, to] of a line to where start + t * step <= bound.
void clip(double start, double step, double bound, double& from, double& to) {
  if (step == 0.0) {
    to = start <= bound ? to : -1.0;
  } else if (step > 0.0) {
    to = std::min(to, (bound - start) / step);
  } else {
    from = std::max(from, (bound - start) / step);
  }
}

double length_within(const PixelBox& box, PixelPoint a, PixelPoint b) {
  // Most lines are far away.
  if (std::max(a.x, b.x) < box.left || std::min(a.x, b.x) > box.right ||
      std::max(a.y, b.y) < box.top || std::min(a.y, b.y) > box.bottom) {
    return 0.0;
  }
  double from = 0.0;
  double to = 1.0;
  clip(a.x, b.x - a.x, box.right, from, to);
  clip(-a.x, a.x - b.x, -box.left, from, to);
  clip(a.y, b.y - a.y, box.bottom, from, to);
  clip(-a.y, a.y - b.y, -box.top, from, to);
  return to > from ? (to - from) * length_of(b - a) : 0.0;
}

PixelBox box_around(PixelPoint middle, double width, double height) {
  return {.left = middle.x - width / 2,
          .top = middle.y - height / 2,
          .right = middle.x + width / 2,
          .bottom = middle.y + height / 2};
}

// The middle of a box that touches the circle around the anchor in that direction.
PixelPoint middle_at(PixelPoint anchor, double angle, double distance, PixelPoint half) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {.x = anchor.x + c * (distance + half.x), .y = anchor.y - s * (distance + half.y)};
}

PixelPoint nearest_point(const PixelBox& box, PixelPoint to) {
  return {.x = std::clamp(to.x, box.left, box.right), .y = std::clamp(to.y, box.top, box.bottom)};
}

}  // namespace

void NamePlacer::keep_off(PixelPoint from, PixelPoint to) {
  lines_.add(from, to);
}

void NamePlacer::keep_off(std::span<const PixelLine> lines) {
  for (const PixelLine& line : lines) {
    lines_.add(line.from, line.to);
  }
}

double NamePlacer::cost(const PixelBox& box, double price, double limit) const {
  double sum = price;
  double covering = kFarCost * kDetour;  // until something is covered
  const auto add = [&](double cost) {
    if (cost > 0.0) {
      sum += cost + std::exchange(covering, 0.0);
    }
  };
  for (const PixelBox& label : labels_) {
    sum += kLabelCost * overlap(box, label);
  }
  if (area_) {
    sum += kLabelCost * (box.width() * box.height() - overlap(box, *area_));
  }
  const PixelBox letters = box.grown(kSlack);
  const PixelBox around = box.grown(kAir);
  for (const PixelBox& other : boxes_) {
    add(kBoxCost * overlap(box, other));
  }
  if (sum < limit) {
    lines_.visit(around, [&](PixelPoint from, PixelPoint to) {
      const double near = sum < limit ? length_within(around, from, to) : 0.0;
      if (near > 0.0) {
        sum += kNearCost * near;
        add(kLineCost * length_within(letters, from, to));
      }
    });
  }
  return sum;
}

double NamePlacer::line_cost(PixelPoint from, PixelPoint to) const {
  double sum = 0.0;
  for (const PixelBox& label : labels_) {
    const double crossed = length_within(label, from, to);
    sum += crossed > 0.0 ? kCrossedLabelCost * crossed + kFarCost * kDetour : 0.0;
  }
  if (!prices_crossings_) {
    return sum;
  }
  PixelBox around;
  around.add(from);
  around.add(to);
  double crossed = 0.0;
  lines_.visit(around, [&](PixelPoint a, PixelPoint b) {
    crossed += do_cross(from, to, a, b) ? kCrossedLine : 0.0;
  });
  sum += kFarCost * std::min(crossed, kMostCrossed);
  return sum;
}

PlacedName NamePlacer::take(const PixelBox& box, double cost, const TextStyle& style) {
  labels_.push_back(with_word_gap(box));
  const double base = box.top + kAscentShare * box.height();
  const double x = style.anchor == Anchor::start    ? box.left
                   : style.anchor == Anchor::middle ? box.centre().x
                                                    : box.right;
  return {.place = {.x = x, .y = base},
          .box = box,
          .is_free = cost < kFarCost * kDetour,
          .needs_line = false,
          .anchor = {},
          .line_end = {}};
}

NamePlacer::Found NamePlacer::find_around(PixelPoint anchor,
                                          std::string_view text,
                                          const TextStyle& style,
                                          double distance,
                                          const Found& best_so_far) const {
  const double width = text_width(text, style.size, style.weight);
  const PixelPoint half = {.x = width / 2, .y = style.size / 2};
  Found best = best_so_far;
  for (const double more : kFarther) {
    if (kFarCost * more >= best.cost) {
      break;
    }
    for (int i = 0; i < kDirections; ++i) {
      // From the upper right on, which readers expect first.
      const double angle = std::numbers::pi / 4 + 2 * std::numbers::pi * i / kDirections;
      const PixelPoint middle = middle_at(anchor, angle, distance + more, half);
      const PixelBox box = box_around(middle, width, style.size);
      double total = cost(box, kFarCost * more, best.cost);
      if (total < best.cost && more > kNearEnough) {
        total += line_cost(anchor, nearest_point(box, anchor));
      }
      if (total < best.cost) {
        best = {.anchor = anchor, .box = box, .cost = total, .farther = more};
      }
    }
  }
  return best;
}

PlacedName NamePlacer::take(const Found& found, const TextStyle& style) {
  PlacedName result = take(found.box, found.cost, style);
  result.needs_line = found.farther > kNearEnough;
  result.anchor = found.anchor;
  result.line_end = nearest_point(found.box, found.anchor);
  if (result.needs_line) {
    keep_off(result.anchor, result.line_end);
  }
  return result;
}

PlacedName NamePlacer::place(PixelPoint anchor,
                             std::string_view text,
                             const TextStyle& style,
                             double distance) {
  return take(find_around(anchor, text, style, distance, {}), style);
}

PlacedName NamePlacer::place(std::span<const PixelPoint> anchors,
                             std::string_view text,
                             const TextStyle& style,
                             double distance) {
  return take(find_around(anchors, text, style, distance, {}), style);
}

NamePlacer::Found NamePlacer::find_around(std::span<const PixelPoint> anchors,
                                          std::string_view text,
                                          const TextStyle& style,
                                          double distance,
                                          Found best) const {
  for (const PixelPoint& anchor : anchors) {
    best = find_around(anchor, text, style, distance, best);
    best.cost -= kFarCost * kNextAnchor;  // what the next one must save
  }
  return best;
}

PlacedName NamePlacer::place_at(const std::vector<PixelPoint>& middles,
                                std::span<const PixelPoint> anchors,
                                std::string_view text,
                                const TextStyle& style) {
  const double width = text_width(text, style.size, style.weight);
  Found best;
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const PixelBox box = box_around(middles[i], width, style.size);
    const double total = cost(box, static_cast<double>(i), best.cost);
    if (total < best.cost) {
      best = {.anchor = anchors.front(), .box = box, .cost = total, .farther = 0.0};
    }
  }
  if (best.cost >= kFarCost * kDetour) {
    best = find_around(anchors, text, style, 4.0, best);
  }
  return take(best, style);
}

PixelBox with_word_gap(const PixelBox& text) {
  constexpr double kWordGap = 4.0;
  PixelBox box = text.grown(1.0);
  box.left = text.left - kWordGap;
  box.right = text.right + kWordGap;
  return box;
}

void write_label(Svg& svg, const PlacedName& label, std::string_view text, TextStyle style) {
  if (label.needs_line) {
    constexpr double kBefore = 2.0;  // leaning letters reach beyond their box
    const PixelPoint end = label.line_end + kBefore * unit_of(label.anchor - label.line_end);
    svg.line(label.anchor, end, {.stroke = Ink::soft, .width = 0.7});
  }
  svg.text(label.place, text, style);
}

}  // namespace kinestat
