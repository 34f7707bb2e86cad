#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "mechanism/cables/internal/cable_check.hpp"

namespace kinestat {

namespace {

// How far from the axis the cable runs, seen along the axis; signed as the radius.
double lever_of(const CableSpan& span, const CableStationGeometry& pulley) {
  const Vec3 along = span.to - span.from;
  const Vec3 across = along - along.dot(pulley.axis) * pulley.axis;
  return (span.from - pulley.centre).cross(across).dot(pulley.axis) / across.norm();
}

// Of points without a radius; empty if there are two.
std::optional<double> find_lever(const DrawnContact& contact,
                                 const FileUnits& units,
                                 Diagnostics& found) {
  const double before = lever_of(contact.arrives, contact.pulley);
  const double after = lever_of(contact.leaves, contact.pulley);
  const double largest = std::max(std::abs(before), std::abs(after));
  const bool runs_along_axis = !std::isfinite(before) || !std::isfinite(after);
  if (runs_along_axis || std::abs(before - after) <= kDrawnContact * largest) {
    return before;
  }
  const auto length = [&](double metres) {
    return fmt::format("{:.6g} {}",
                       units.from_si(QuantityKind::length, std::abs(metres)),
                       units.text(QuantityKind::length));
  };
  const std::string& pulley = contact.station->body.text;
  found.warning(
      "W0308",
      contact.station->where,
      before * after < 0.0
          ? fmt::format("the cable meets pulley '{}' in one sense of turning and leaves it "
                        "in the other",
                        pulley)
          : fmt::format("the cable passes the centre of pulley '{}' at {} before its "
                        "'points' and at {} behind them",
                        pulley,
                        length(before),
                        length(after)),
      "a round pulley has one lever: correct 'points', [MEETS, LEAVES], or give 'radius' "
      "and 'wrap' instead; as they are, the tensions of the two sides differ");
  return std::nullopt;
}

std::string short_way(const CableStation& station, double radius) {
  const std::string wrap = radius > 0.0 ? "clockwise" : "counterclockwise";
  if (station.points.empty()) {
    return fmt::format("write 'wrap: {}'", wrap);
  }
  return station.wrap ? fmt::format("write 'wrap: {}' and exchange the points", wrap)
                      : "exchange the two points";
}

}  // namespace

void check_contact(const DrawnContact& contact, const FileUnits& units, Diagnostics& found) {
  const CableStation& station = *contact.station;
  if (!station.is_pulley || !station.at) {
    return;
  }
  CableStationGeometry pulley = contact.pulley;
  if (pulley.radius == 0.0) {
    const std::optional<double> lever = find_lever(contact, units, found);
    if (!lever) {
      return;
    }
    pulley.radius = *lever;
  }
  const double wrap = wrap_angle<double>(pulley, contact.arrives, contact.leaves);
  const bool is_on_purpose = station.turns || contact.cable->over.size() == 2;
  const double shorter = std::min((contact.arrives.to - contact.arrives.from).norm(),
                                  (contact.leaves.to - contact.leaves.from).norm());
  if (is_on_purpose || !crosses_itself(pulley.radius, wrap, shorter)) {
    return;
  }
  found.warning("W0308",
                station.where,
                fmt::format("cable '{}' turns by {:.6g} deg about pulley '{}' and crosses itself",
                            contact.cable->name.text,
                            wrap * 180.0 / std::numbers::pi,
                            station.body.text),
                fmt::format("{} for the short way, or write 'turns: 0' if it is meant",
                            short_way(station, pulley.radius)));
}

}  // namespace kinestat
