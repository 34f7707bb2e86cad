#include "mechanism/drive_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

constexpr double kPi = std::numbers::pi;

// Up to the eighth of the time, modified laws accelerate as c · sin(w u).
LawPoint first_eighth(double c, double u) {
  const double w = 4.0 * kPi;
  return {.share = c * (u / w - std::sin(w * u) / (w * w)),
          .slope = c * (1.0 - std::cos(w * u)) / w,
          .bend = c * std::sin(w * u)};
}

// The first half of a law that is odd about its middle. Accelerations that vanish in the middle are
// sines of what is left to it, so that they do so exactly.
LawPoint first_half(DriveLaw law, double ramp, double u) {
  switch (law) {
    case DriveLaw::constant_speed:
      return {.share = u, .slope = 1.0, .bend = 0.0};
    case DriveLaw::constant_acceleration:
      return {.share = 2.0 * u * u, .slope = 4.0 * u, .bend = 4.0};
    case DriveLaw::trapezoid: {
      const double bend = 1.0 / (ramp * (1.0 - ramp));
      return u < ramp
                 ? LawPoint{.share = 0.5 * bend * u * u, .slope = bend * u, .bend = bend}
                 : LawPoint{
                       .share = bend * ramp * (u - 0.5 * ramp), .slope = bend * ramp, .bend = 0.0};
    }
    case DriveLaw::polynomial_345:
      return {.share = u * u * u * (10.0 + u * (-15.0 + 6.0 * u)),
              .slope = 30.0 * u * u * (1.0 - u) * (1.0 - u),
              .bend = 60.0 * u * (1.0 - u) * (1.0 - 2.0 * u)};
    case DriveLaw::polynomial_4567:
      return {.share = u * u * u * u * (35.0 + u * (-84.0 + u * (70.0 - 20.0 * u))),
              .slope = 140.0 * std::pow(u * (1.0 - u), 3),
              .bend = 420.0 * u * u * (1.0 - u) * (1.0 - u) * (1.0 - 2.0 * u)};
    case DriveLaw::cycloidal:
      return {.share = u - std::sin(2.0 * kPi * u) / (2.0 * kPi),
              .slope = 1.0 - std::cos(2.0 * kPi * u),
              .bend = 2.0 * kPi * std::sin(2.0 * kPi * std::min(u, 0.5 - u))};
    case DriveLaw::harmonic:
      return {.share = std::pow(std::sin(0.5 * kPi * u), 2),
              .slope = 0.5 * kPi * std::sin(kPi * u),
              .bend = 0.5 * kPi * kPi * std::sin(kPi * (0.5 - u))};
    case DriveLaw::modified_trapezoid: {
      const double c = 8.0 * kPi / (kPi + 2.0);
      const double w = 4.0 * kPi;
      if (u < 0.125) {
        return first_eighth(c, u);
      }
      const double first = c * (0.125 / w - 1.0 / (w * w));
      if (u < 0.375) {
        const double v = u - 0.125;
        return {
            .share = first + c * v * (1.0 / w + 0.5 * v), .slope = c * (1.0 / w + v), .bend = c};
      }
      const double second = first + c * 0.25 * (1.0 / w + 0.125);
      const double v = u - 0.375;
      return {.share = second + c * ((1.0 / w + 0.25) * v + (1.0 - std::cos(w * v)) / (w * w)),
              .slope = c * (1.0 / w + 0.25 + std::sin(w * v) / w),
              .bend = c * std::sin(w * (0.5 - u))};
    }
    case DriveLaw::modified_sine: {
      const double c = 4.0 * kPi * kPi / (kPi + 4.0);
      const double w = 4.0 * kPi;
      if (u < 0.125) {
        return first_eighth(c, u);
      }
      const double first = c * (0.125 / w - 1.0 / (w * w));
      const double phase = w * u / 3.0 + kPi / 3.0;
      return {.share = first + c / w * ((u - 0.125) - 9.0 / w * (std::sin(phase) - 1.0)),
              .slope = c / w * (1.0 - 3.0 * std::cos(phase)),
              .bend = c * std::sin(w * (0.5 - u) / 3.0)};
    }
  }
  return {};
}

// In order, each once, for rounding parts what is the same.
std::vector<double> merged_times(std::vector<double> times) {
  std::ranges::sort(times);
  const auto is_same = [](double one, double next) { return next - one <= kSameValue; };
  times.erase(std::unique(times.begin(), times.end(), is_same), times.end());
  return times;
}

// Where a steady acceleration turns a drive round within the time.
bool turns_back(const DriveCourse& course, double duration) {
  const double end = course.speed + course.acceleration * duration;
  return course.speed * end < 0.0 &&
         std::min(std::abs(course.speed), std::abs(end)) >
             kSameValue * std::max(std::abs(course.speed), std::abs(end));
}

}  // namespace

LawPoint law_at(DriveLaw law, double ramp, double time) {
  // What rounding leaves before a jump is behind it.
  if (law == DriveLaw::trapezoid && std::abs(time - ramp) <= kSameValue) {
    time = std::max(time, ramp);
  }
  if (time < 0.5 - kSameValue) {
    return first_half(law, ramp, time);
  }
  double rest = std::min(1.0 - time, 0.5);
  if (law == DriveLaw::trapezoid && std::abs(rest - ramp) <= kSameValue) {
    rest = std::min(rest, std::nextafter(ramp, 0.0));
  }
  const LawPoint mirrored = first_half(law, ramp, rest);
  return {.share = 1.0 - mirrored.share, .slope = mirrored.slope, .bend = -mirrored.bend};
}

namespace {

// Where its acceleration jumps, with the ends between a way and a rest.
std::vector<double> breaks_of(DriveLaw law, double ramp) {
  switch (law) {
    case DriveLaw::constant_speed:
    case DriveLaw::harmonic:
      return {0.0, 1.0};
    case DriveLaw::constant_acceleration:
      return {0.0, 0.5, 1.0};
    case DriveLaw::trapezoid:
      return {0.0, ramp, 1.0 - ramp, 1.0};
    case DriveLaw::polynomial_345:
    case DriveLaw::polynomial_4567:
    case DriveLaw::cycloidal:
    case DriveLaw::modified_trapezoid:
    case DriveLaw::modified_sine:
      break;
  }
  return {};
}

// Where its acceleration turns sharply within it.
std::vector<double> kinks_of(DriveLaw law) {
  switch (law) {
    case DriveLaw::modified_trapezoid:
      return {0.125, 0.375, 0.625, 0.875};
    case DriveLaw::modified_sine:
      return {0.125, 0.875};
    case DriveLaw::constant_speed:
    case DriveLaw::constant_acceleration:
    case DriveLaw::trapezoid:
    case DriveLaw::polynomial_345:
    case DriveLaw::polynomial_4567:
    case DriveLaw::cycloidal:
    case DriveLaw::harmonic:
      break;
  }
  return {};
}

// Within the whole time.
void add_breaks(const Curve& curve, double duration, std::vector<double>& breaks) {
  const double period = curve.period.value_or(0.0);
  for (const double point : curve.at) {
    const double first = period > 0.0 ? point - period * std::floor(point / period) : point;
    double time = first;
    for (double turn = 1.0; time < duration; ++turn) {
      breaks.push_back(time / duration);
      if (!(period > 0.0)) {
        break;
      }
      time = first + turn * period;
    }
  }
}

// The drives run in proportion if all do so by the same law, from the beginning to the end.
bool runs_by_one_law(const std::vector<DriveCourse>& courses) {
  return std::ranges::all_of(courses, [&](const DriveCourse& one) {
    const std::vector<CoursePart>& first = courses.front().parts;
    return one.parts.size() == 1 && first.size() == 1 && one.parts[0].begin == 0.0 &&
           one.parts[0].end == 1.0 && one.parts[0].law == first[0].law &&
           one.parts[0].ramp == first[0].ramp;
  });
}

bool runs_straight(double duration, const std::vector<DriveCourse>& courses) {
  if (!std::ranges::all_of(courses, &DriveCourse::is_steady)) {
    return runs_by_one_law(courses);
  }
  const auto ways = [&](const DriveCourse& one) {
    return std::pair(one.speed * duration, one.acceleration * duration * duration);
  };
  const auto [speed, bend] = ways(courses.front());
  const double first = speed + 0.5 * bend;
  bool is_straight = true;
  for (const DriveCourse& one : courses) {
    const auto [other_speed, other_bend] = ways(one);
    const double way = other_speed + 0.5 * other_bend;
    const double size =
        (std::abs(speed) + std::abs(bend)) * (std::abs(other_speed) + std::abs(other_bend));
    is_straight = is_straight && !turns_back(one, duration) && first != 0.0 &&
                  std::abs(other_speed * first - speed * way) <= kSameValue * size &&
                  std::abs(other_bend * first - bend * way) <= kSameValue * size;
  }
  return is_straight;
}

// Behind the last part a drive rests.
DriveInstant instant_of(const std::vector<CoursePart>& parts, double time, double duration) {
  const auto part = std::ranges::find_if(
      parts, [&](const CoursePart& one) { return time < one.end - kSameValue; });
  const CoursePart& one = part != parts.end() ? *part : parts.back();
  const bool is_over = time >= one.end - kSameValue;
  if (one.from == one.to || (is_over && one.end < 1.0)) {
    return {.position = one.to, .speed = 0.0, .acceleration = 0.0};
  }
  const double share = one.end - one.begin;
  const double u = is_over ? 1.0 : std::max(time - one.begin, 0.0) / share;
  const LawPoint point = law_at(one.law, one.ramp, u);
  const double way = one.to - one.from;
  const double length = share * duration;
  return {.position = is_over ? one.to : one.from + point.share * way,
          .speed = point.slope * way / length,
          .acceleration = point.bend * way / (length * length)};
}

}  // namespace

DriveSchedule::DriveSchedule(double duration, std::vector<DriveCourse> courses)
    : duration_(duration),
      courses_(std::move(courses)),
      is_straight_(runs_straight(duration_, courses_)) {}

DriveInstant DriveSchedule::at(std::size_t drive, double time) const {
  const DriveCourse& one = courses_[drive];
  const double t = time * duration_;
  if (one.curve != nullptr) {
    const std::optional<CurvePoint> point = one.curve->point(t);
    KINESTAT_EXPECTS(point.has_value());
    return {.position = point->value, .speed = point->slope, .acceleration = point->bend};
  }
  if (!one.parts.empty()) {
    return instant_of(one.parts, time, duration_);
  }
  return {
      .position = time == 1.0 ? one.to : one.from + t * (one.speed + 0.5 * one.acceleration * t),
      .speed = one.speed + one.acceleration * t,
      .acceleration = one.acceleration};
}

double DriveSchedule::share_at(double time) const {
  if (!is_straight_ || time <= 0.0 || time >= 1.0) {
    return time;
  }
  const DriveCourse& one = courses_.front();
  if (!one.parts.empty()) {
    return law_at(one.parts.front().law, one.parts.front().ramp, time).share;
  }
  return (at(0, time).position - one.from) / (one.to - one.from);
}

double DriveSchedule::time_of(double share) const {
  if (share <= 0.0 || share >= 1.0) {
    return std::clamp(share, 0.0, 1.0);
  }
  double low = 0.0;
  double high = 1.0;
  // With a steady speed the time is the share but for rounding.
  const double rounding = 8.0 * kEpsilon * share;
  if (share_at(share - rounding) < share && share_at(share + rounding) >= share) {
    low = share - rounding;
    high = share + rounding;
  }
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high)) {
    (share_at(middle) < share ? low : high) = middle;
  }
  return high;
}

std::vector<double> DriveSchedule::breaks() const {
  std::vector<double> result;
  for (const DriveCourse& course : courses_) {
    for (const CoursePart& part : course.parts) {
      if (part.from != part.to) {
        for (const double one : breaks_of(part.law, part.ramp)) {
          result.push_back(std::lerp(part.begin, part.end, one));
        }
      }
    }
    if (course.curve != nullptr) {
      add_breaks(*course.curve, duration_, result);
    }
  }
  std::erase_if(result, [](double time) {
    return time <= 2.0 * kSameValue || time >= 1.0 - 2.0 * kSameValue;
  });
  return merged_times(std::move(result));
}

// Parts and laws take what is nearer than kSameValue as behind.
double DriveSchedule::before(double jump) {
  constexpr double kBefore = 4.0;
  return jump - kBefore * kSameValue;
}

// Within what has one formula: its speed is at most a quadratic, or never changes its sign.
void DriveSchedule::add_turns(std::size_t drive,
                              double from,
                              double to,
                              std::vector<double>& turns) const {
  const double edge = std::min(2.0 * kSameValue, 0.25 * (to - from));
  const double first = from + edge;
  const double last = to - edge;
  const double bend = at(drive, first).acceleration;
  const double last_bend = at(drive, last).acceleration;
  const double fastest = bend * last_bend < 0.0 ? first + (last - first) * bend / (bend - last_bend)
                                                : 0.5 * (first + last);
  double low = first;
  for (const double end : {fastest, last}) {
    const double speed = at(drive, low).speed;
    double high = end;
    if (speed * at(drive, end).speed < 0.0) {
      for (double middle = 0.5 * (low + high); low < middle && middle < high;
           middle = 0.5 * (low + high)) {
        (at(drive, middle).speed * speed > 0.0 ? low : high) = middle;
      }
      turns.push_back(high);
    }
    low = end;
  }
}

// And breaks.
std::vector<double> DriveSchedule::ends_of_parts() const {
  std::vector<double> ends = breaks();
  for (const DriveCourse& course : courses_) {
    for (const CoursePart& part : course.parts) {
      ends.insert(ends.end(), {part.begin, part.end});
    }
  }
  std::erase_if(ends, [](double time) { return time <= 0.0 || time >= 1.0; });
  return merged_times(std::move(ends));
}

std::vector<double> DriveSchedule::corners() const {
  std::vector<double> corners = ends_of_parts();
  for (const DriveCourse& course : courses_) {
    for (const CoursePart& part : course.parts) {
      for (const double one : part.from == part.to ? std::vector<double>() : kinks_of(part.law)) {
        corners.push_back(std::lerp(part.begin, part.end, one));
      }
    }
  }
  return merged_times(std::move(corners));
}

std::vector<double> DriveSchedule::turns() const {
  std::vector<double> ends = ends_of_parts();
  std::vector<double> turns = ends;
  double from = 0.0;
  ends.push_back(1.0);
  for (const double to : ends) {
    for (std::size_t d = 0; d < courses_.size(); ++d) {
      add_turns(d, from, to, turns);
    }
    from = to;
  }
  return merged_times(std::move(turns));
}

std::vector<double> DriveSchedule::jumps() const {
  std::vector<double> result;
  for (const DriveCourse& course : courses_) {
    for (const CoursePart& part : course.parts) {
      if (part.law == DriveLaw::constant_speed && part.from != part.to) {
        result.push_back(part.begin);
        result.push_back(part.end);
      }
    }
  }
  return merged_times(std::move(result));
}

}  // namespace kinestat
