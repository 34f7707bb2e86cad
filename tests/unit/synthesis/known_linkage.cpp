#include "known_linkage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/angles.hpp"

namespace kinestat {

namespace {

// Where a dyad leaves the origin of the plane: |o - centre| = radius, or normal . o = offset.
struct Locus {
  bool is_line = false;
  Point centre;
  double radius = 0.0;
  Point normal;
  double offset = 0.0;
};

Locus locus_of(const Dyad& dyad, double angle) {
  const Point turn = unit_vector(angle);
  const Point centre = dyad.centre_point - turn * dyad.circle_point;
  if (dyad.kind == DyadKind::crank) {
    return {.centre = centre, .radius = dyad.length, .normal = {}};
  }
  const Point along = dyad.kind == DyadKind::slider ? dyad.direction : turn * dyad.direction;
  const Point normal = left_of(along);
  return {.is_line = true, .centre = {}, .normal = normal, .offset = dot(normal, centre)};
}

// Points of a line that lie on another locus.
std::vector<Point> on_line(const Locus& line, const Locus& other) {
  const Point foot = line.normal * line.offset;
  const Point along = left_of(line.normal);
  if (other.is_line) {
    const double slope = dot(other.normal, along);
    if (std::abs(slope) < 0.1) {
      return {};
    }
    return {foot + along * ((other.offset - dot(other.normal, foot)) / slope)};
  }
  const double middle = dot(other.centre - foot, along);
  const double away = dot(other.centre - foot, line.normal);
  const double square = other.radius * other.radius - away * away;
  if (square < 0.0) {
    return {};
  }
  return {foot + along * (middle + std::sqrt(square)), foot + along * (middle - std::sqrt(square))};
}

// Two circles share the points of one of them on their common chord.
std::vector<Point> shared_points(const Locus& one, const Locus& other) {
  if (one.is_line || other.is_line) {
    return one.is_line ? on_line(one, other) : on_line(other, one);
  }
  const Point between = other.centre - one.centre;
  const double distance = std::abs(between);
  const double along =
      (distance * distance + one.radius * one.radius - other.radius * other.radius) /
      (2.0 * distance);
  const Point normal = between / distance;
  const Locus chord{
      .is_line = true, .centre = {}, .normal = normal, .offset = dot(normal, one.centre) + along};
  return on_line(chord, one);
}

double binomial(std::size_t n, std::size_t k) {
  return k == 0 ? 1.0 : binomial(n - 1, k - 1) * static_cast<double>(n) / static_cast<double>(k);
}

// Jets of e^{iγ} for γ given with its derivatives.
std::vector<Point> turns_of(const std::vector<double>& angle) {
  std::vector<Point> turns{unit_vector(angle[0])};
  for (std::size_t k = 1; k < angle.size(); ++k) {
    Point sum(0.0, 0.0);
    for (std::size_t i = 0; i < k; ++i) {
      sum += binomial(k - 1, i) * Point(0.0, angle[k - i]) * turns[i];
    }
    turns.push_back(sum);
  }
  return turns;
}

// normal . o(k) = value makes derivative k of what the dyad keeps vanish.
struct Condition {
  Point normal;
  double value = 0.0;
};

Condition condition_of(const Dyad& dyad,
                       const std::vector<Point>& turns,
                       const std::vector<Point>& origins,
                       std::size_t k) {
  std::vector<Point> arm;  // derivatives of the arm, the last one without o(k)
  for (std::size_t i = 0; i <= k; ++i) {
    arm.push_back(turns[i] * dyad.circle_point + (i < k ? origins[i] : Point(0.0, 0.0)));
  }
  arm[0] -= dyad.centre_point;
  double rest = 0.0;
  if (dyad.kind == DyadKind::slider) {
    return {.normal = left_of(dyad.direction), .value = -dot(left_of(dyad.direction), arm[k])};
  }
  const bool is_crank = dyad.kind == DyadKind::crank;
  const Point line = left_of(dyad.direction);
  for (std::size_t i = 0; i <= k; ++i) {
    const Point other = is_crank ? arm[i] : turns[i] * line;
    rest += (is_crank ? 0.5 : 1.0) * binomial(k, i) * dot(other, arm[k - i]);
  }
  return {.normal = is_crank ? arm[0] : turns[0] * line, .value = -rest};
}

Point random_point(Random& random, double size) {
  const double x = random.between(-size, size);
  const double y = random.between(-size, size);
  return {x, y};
}

Dyad random_dyad(Random& random, DyadKind kind, const Point& at, double angle) {
  Dyad dyad{.kind = kind, .circle_point = random_point(random, 2.0)};
  const Point place = at + unit_vector(angle) * dyad.circle_point;
  dyad.direction = unit_vector(random.between(-kPi / 2, kPi / 2));
  if (kind == DyadKind::crank) {
    dyad.length = random.between(0.5, 3.0);
    dyad.centre_point = place + dyad.length * unit_vector(random.between(-kPi, kPi));
  } else if (kind == DyadKind::slider) {
    dyad.centre_point = place;
  } else {
    dyad.circle_point -= dyad.direction * dot(dyad.circle_point, dyad.direction);
    dyad.centre_point =
        at + unit_vector(angle) * (dyad.circle_point + random.between(-2.0, 2.0) * dyad.direction);
  }
  return dyad;
}

}  // namespace

std::vector<Point> KnownLinkage::origins(double angle) const {
  return shared_points(locus_of(one, angle), locus_of(other, angle));
}

std::optional<PositionJets> KnownLinkage::jets(const Point& at,
                                               const std::vector<double>& angle) const {
  const std::vector<Point> turns = turns_of(angle);
  std::vector<Point> origins{at};
  PositionJets result{.x = {at.real()}, .y = {at.imag()}, .angle = angle};
  for (std::size_t k = 1; k < angle.size(); ++k) {
    const Condition a = condition_of(one, turns, origins, k);
    const Condition b = condition_of(other, turns, origins, k);
    const double determinant = cross(a.normal, b.normal);
    if (std::abs(determinant) < 0.1 * std::abs(a.normal) * std::abs(b.normal)) {
      return std::nullopt;
    }
    origins.emplace_back((a.value * b.normal.imag() - b.value * a.normal.imag()) / determinant,
                         (b.value * a.normal.real() - a.value * b.normal.real()) / determinant);
    result.x.push_back(origins[k].real());
    result.y.push_back(origins[k].imag());
  }
  return result;
}

KnownLinkage random_linkage(Random& random, DyadKind one, DyadKind other) {
  const Point at = random_point(random, 1.0);
  const double angle = random.between(-std::numbers::pi, std::numbers::pi);
  return {.one = random_dyad(random, one, at, angle),
          .other = random_dyad(random, other, at, angle)};
}

std::vector<PositionJets> random_positions(Random& random,
                                           const KnownLinkage& linkage,
                                           const std::vector<int>& orders) {
  constexpr int kTries = 200;
  std::vector<PositionJets> positions;
  std::vector<double> used;
  const bool by_angle = random.chance(0.5);
  for (int i = 0; i < kTries && positions.size() < orders.size(); ++i) {
    std::vector<double> angle{random.between(-kPi, kPi)};
    const std::vector<Point> poses = linkage.origins(angle[0]);
    const bool is_near = std::ranges::any_of(
        used, [&](double other) { return std::abs(std::sin((other - angle[0]) / 2)) < 0.1; });
    if (poses.empty() || is_near) {
      continue;
    }
    for (int k = 1; k < orders[positions.size()]; ++k) {
      angle.push_back(by_angle ? (k == 1 ? 1.0 : 0.0)
                               : (k == 1 ? random.magnitude() : random.between(-1.0, 1.0)));
    }
    if (const auto jets = linkage.jets(random.one_of(poses), angle)) {
      positions.push_back(*jets);
      used.push_back(angle[0]);
    }
  }
  return positions.size() == orders.size() ? positions : std::vector<PositionJets>{};
}

}  // namespace kinestat
