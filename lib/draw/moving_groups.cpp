// The groups of an Svg that move: animations of SMIL, which play wherever a picture is shown.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/markup.hpp"
#include "draw/svg.hpp"

namespace kinestat {

namespace {

// Values of one kind of transformation at the key frames, as they are written.
struct Transformation {
  std::string_view type;
  std::vector<std::string> values;
  std::string none;  ///< the value with which nothing is transformed

  bool changes() const {
    return std::ranges::adjacent_find(values, std::not_equal_to()) != values.end();
  }

  bool begins_with_none() const { return values.front() == none; }

  bool is_none() const { return begins_with_none() && !changes(); }
};

std::string place_text(PixelPoint place) {
  return fmt::format("{} {}", format_coordinate(place.x), format_coordinate(place.y));
}

Transformation shift_of(const GroupMotion& motion) {
  std::vector<std::string> values;
  for (const PixelPoint& shift : motion.shifts) {
    values.push_back(place_text(shift));
  }
  return {.type = "translate", .values = std::move(values), .none = place_text({})};
}

// Faster than a turn from key frame to key frame nobody can see: what is left of the turn looks the
// same.
Transformation turn_of(const GroupMotion& motion) {
  constexpr double kTurn = 360.0;  // [degrees]
  const std::string pivot = place_text(motion.pivot);
  std::vector<std::string> values;
  double before = 0.0;
  double shown = 0.0;
  for (const double turn : motion.turns) {
    const double step = turn - before;
    shown += std::abs(step) > kTurn ? std::remainder(step, kTurn) : step;
    before = turn;
    values.push_back(fmt::format("{} {}", format_coordinate(shown), pivot));
  }
  return {.type = "rotate", .values = std::move(values), .none = fmt::format("0 {}", pivot)};
}

std::string time_text(double time) {
  std::string text = fmt::format("{:.5f}", time);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text;
}

std::string pace(const Cycle& cycle) {
  return fmt::format(" dur=\"{}s\" repeatCount=\"indefinite\"", time_text(cycle.seconds));
}

std::string key_times(const std::vector<double>& times) {
  std::string text;
  for (const double time : times) {
    text += (text.empty() ? "" : ";") + time_text(time);
  }
  return fmt::format(" keyTimes=\"{}\"", text);
}

// As they are where nothing is said of them.
bool are_even(const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double even = static_cast<double>(i) / static_cast<double>(times.size() - 1);
    if (time_text(times[i]) != time_text(even)) {
      return false;
    }
  }
  return true;
}

// The first one replaces what stands in the group, the second one comes on top of it. Stepwise each
// value stays until the next, and the last one, at the end, is never seen.
std::string element_of(const Transformation& one, bool is_second, const Cycle& cycle) {
  const std::ptrdiff_t unseen = cycle.is_stepwise ? 1 : 0;
  const std::vector<double> times(cycle.times.begin(), cycle.times.end() - unseen);
  return fmt::format(
      "<animateTransform attributeName=\"transform\" type=\"{}\"{}{}{}{} values=\"{}\"/>\n",
      one.type,
      is_second ? " additive=\"sum\"" : "",
      cycle.is_stepwise ? " calcMode=\"discrete\"" : "",
      pace(cycle),
      are_even(cycle.times) ? "" : key_times(times),
      fmt::join(one.values.begin(), one.values.end() - unseen, ";"));
}

PixelPoint moved(PixelPoint point, const GroupMotion& motion, std::size_t i) {
  const double angle = motion.turns[i] * std::numbers::pi / 180;
  const double x = point.x - motion.pivot.x;
  const double y = point.y - motion.pivot.y;
  return {.x = motion.pivot.x + motion.shifts[i].x + std::cos(angle) * x - std::sin(angle) * y,
          .y = motion.pivot.y + motion.shifts[i].y + std::sin(angle) * x + std::cos(angle) * y};
}

}  // namespace

void Svg::open_moving_group(std::string_view title,
                            std::span<const Attribute> attributes,
                            const GroupMotion& motion,
                            const Cycle& cycle) {
  KINESTAT_EXPECTS(!moving_ && cycle.times.size() > 1 &&
                   motion.shifts.size() == cycle.times.size() &&
                   motion.turns.size() == cycle.times.size());
  std::vector<Transformation> parts = {shift_of(motion), turn_of(motion)};
  std::erase_if(parts, [](const Transformation& one) { return one.is_none(); });

  std::vector<std::string> first;
  for (const Transformation& one : parts) {
    if (!one.begins_with_none()) {
      first.push_back(fmt::format("{}({})", one.type, one.values.front()));
    }
  }
  std::vector<Attribute> all(attributes.begin(), attributes.end());
  if (!first.empty()) {
    all.emplace_back("transform", fmt::format("{}", fmt::join(first, " ")));
  }
  open_group(title, all);
  moving_ = {.motion = motion, .depth = open_groups_, .reach = {}};
  if (std::ranges::any_of(parts, &Transformation::changes)) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      elements_ += element_of(parts[i], i > 0, cycle);
    }
  }
}

void Svg::include_moved(const MovingGroup& group) {
  for (const auto& [point, margin] : group.reach) {
    for (std::size_t i = 0; i < group.motion.shifts.size(); ++i) {
      include(moved(point, group.motion, i), margin);
    }
  }
}

void Svg::open_passing_group(std::span<const Attribute> attributes,
                             const std::vector<bool>& is_seen,
                             const Cycle& cycle) {
  KINESTAT_EXPECTS(cycle.times.size() > 1 && is_seen.size() == cycle.times.size());
  const auto word = [&](std::size_t i) { return is_seen[i] ? "inline" : "none"; };
  std::vector<Attribute> all(attributes.begin(), attributes.end());
  if (!is_seen.front()) {
    all.emplace_back("display", "none");
  }
  open_group({}, all);
  // Until the last key frame, which is the first again.
  std::vector<double> times;
  std::string values;
  for (std::size_t i = 0; i + 1 < is_seen.size(); ++i) {
    if (i == 0 || is_seen[i] != is_seen[i - 1]) {
      times.push_back(cycle.times[i]);
      values += fmt::format("{}{}", values.empty() ? "" : ";", word(i));
    }
  }
  if (times.size() > 1) {
    elements_ += fmt::format(
        "<animate attributeName=\"display\" calcMode=\"discrete\"{}{} values=\"{}\"/>\n",
        pace(cycle),
        key_times(times),
        values);
  }
}

}  // namespace kinestat
