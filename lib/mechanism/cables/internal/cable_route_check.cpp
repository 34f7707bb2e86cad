#include <algorithm>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "description/cable_expansion.hpp"
#include "mechanism/cables/internal/cable_check.hpp"
#include "mechanism/cables/internal/cable_station_binder.hpp"

namespace kinestat {

namespace {

// A segment of the cable with what it joins, in numbers.
struct Stretch {
  const CablePart* part = nullptr;
  std::string name;
  CableStationGeometry from;
  CableStationGeometry to;
  CableSpan span;
};

std::string title(const CableStation& station) {
  return fmt::format("{} '{}'", station.is_pulley ? "pulley" : "the point of", station.body.text);
}

class RouteCheck {
  struct Place {
    const CableStation* station = nullptr;
    const CableStationGeometry* geometry = nullptr;
  };

 public:
  RouteCheck(const CableDescription& cable, const FileUnits& units, Diagnostics& found)
      : cable_(cable), units_(units), found_(found) {}

  void run(std::vector<Stretch>& stretches) {
    const int errors_before = found_.error_count();
    for (Stretch& stretch : stretches) {
      check_tangent(stretch);
      const bool is_belt_on_two = cable_.closed && stretches.size() == 2;
      if (is_belt_on_two && found_.error_count() > errors_before) {
        return;  // the other segment joins the same pulleys
      }
    }
    if (found_.error_count() > errors_before) {
      return;
    }
    std::vector<Place> places;
    for (const Stretch& stretch : stretches) {
      places.push_back({.station = &stretch.part->from, .geometry = &stretch.from});
    }
    places.push_back({.station = &stretches.back().part->to, .geometry = &stretches.back().to});
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      check_points(stretches[i]);
      check_passing(stretches[i], i, places);
    }
    if (found_.error_count() > errors_before) {
      return;
    }
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      if (i + 1 < stretches.size() || cable_.closed) {
        const Stretch& leaves = stretches[(i + 1) % stretches.size()];
        check_contact({.cable = &cable_,
                       .station = &leaves.part->from,
                       .pulley = leaves.from,
                       .arrives = stretches[i].span,
                       .leaves = leaves.span},
                      units_,
                      found_);
      }
    }
  }

 private:
  void refuse(const CableStation& station, std::string message, std::string hint) {
    found_.error("E0317", station.where, std::move(message), std::move(hint));
  }

  std::string length(double metres) const {
    return fmt::format("{:.6g} {}",
                       units_.from_si(QuantityKind::length, metres),
                       units_.text(QuantityKind::length));
  }

  void check_tangent(Stretch& stretch) {
    const SpanFault fault = find_fault(stretch.from, stretch.to);
    switch (fault) {
      case SpanFault::none:
        stretch.span = tangent_span<double>(stretch.from, stretch.to);
        return;
      case SpanFault::same_point:
        return refuse(stretch.part->to,
                      fmt::format("segment '{}' begins and ends at the same point", stretch.name),
                      "a cable needs a direction: move one of its ends");
      case SpanFault::point_inside:
        return refuse_point(stretch);
      case SpanFault::circle_inside:
      case SpanFault::overlap:
        return refuse_circles(stretch, fault);
      case SpanFault::out_of_plane:
        return refuse(stretch.part->to,
                      fmt::format("{} and {} of cable '{}' do not lie in one plane across the axis",
                                  title(stretch.part->from),
                                  title(stretch.part->to),
                                  cable_.name.text),
                      "correct 'at' or 'axis', or give the pulley 'points: [MEETS, LEAVES]', where "
                      "the cable touches it");
    }
  }

  void refuse_point(const Stretch& stretch) {
    const bool is_from = !stretch.part->from.is_pulley || stretch.from.leaves;
    const CableStation& point = is_from ? stretch.part->from : stretch.part->to;
    const CableStation& pulley = is_from ? stretch.part->to : stretch.part->from;
    const Vec3 at = is_from ? stretch.from.leaves.value_or(stretch.from.centre)
                            : stretch.to.meets.value_or(stretch.to.centre);
    const CableStationGeometry& circle = is_from ? stretch.to : stretch.from;
    refuse(point,
           fmt::format("segment '{}' ends within pulley '{}': {} from its centre, and the radius "
                       "is {}",
                       stretch.name,
                       pulley.body.text,
                       length((at - circle.centre).norm()),
                       length(std::abs(circle.radius))),
           "a cable touches a pulley from outside: move the point, or correct the radius");
  }

  void refuse_circles(const Stretch& stretch, SpanFault fault) {
    const std::string numbers =
        fmt::format("centres {} apart, radii {} and {}",
                    length((stretch.to.centre - stretch.from.centre).norm()),
                    length(std::abs(stretch.from.radius)),
                    length(std::abs(stretch.to.radius)));
    if (fault == SpanFault::overlap) {
      refuse(
          stretch.part->to,
          fmt::format("segment '{}' crosses over between pulleys '{}' and '{}', which overlap: {}",
                      stretch.name,
                      stretch.part->from.body.text,
                      stretch.part->to.body.text,
                      numbers),
          "move the pulleys apart, or wrap both in the same sense for an open belt");
    } else {
      refuse(stretch.part->to,
             fmt::format("segment '{}' has no tangent, as one of pulleys '{}' and '{}' lies within "
                         "the other: {}",
                         stretch.name,
                         stretch.part->from.body.text,
                         stretch.part->to.body.text,
                         numbers),
             "correct 'at' or 'radius' of one of the two");
    }
  }

  // Pulleys on one axle stand side by side, not in one plane.
  static bool is_coaxial(const CableStationGeometry& a, const CableStationGeometry& b) {
    const double radius = std::max(std::abs(a.radius), std::abs(b.radius));
    return (a.centre - b.centre).norm() <= kGrazing * radius;
  }

  // Points that the file gives agree with the radius and the sense that it gives too; one complaint
  // a cable.
  void check_points(const Stretch& stretch) {
    const int errors_before = found_.error_count();
    const Vec3 along = stretch.span.to - stretch.span.from;
    if (stretch.from.leaves && !has_wrong_points_) {
      check_point(stretch.part->from, stretch.from, *stretch.from.leaves, along);
    }
    if (stretch.to.meets && !has_wrong_points_) {
      check_point(stretch.part->to, stretch.to, *stretch.to.meets, along);
    }
    has_wrong_points_ = has_wrong_points_ || found_.error_count() > errors_before;
  }

  void check_point(const CableStation& station,
                   const CableStationGeometry& pulley,
                   const Vec3& point,
                   const Vec3& along) {
    if (!station.is_pulley || !station.at || pulley.radius == 0.0) {
      return;
    }
    const Vec3 arm = point - pulley.centre;
    const double distance = arm.cross(pulley.axis).norm();
    const double radius = std::abs(pulley.radius);
    if (distance > (1.0 + kDrawnContact) * radius) {
      refuse(station,
             fmt::format("the cable touches pulley '{}' {} from its centre, and the radius is {}",
                         station.body.text,
                         length(distance),
                         length(radius)),
             "correct 'points', which lie on the rim, or 'radius' or 'at'");
    } else if (arm.cross(along).dot(pulley.axis) * pulley.radius < 0.0) {
      refuse(
          station,
          fmt::format("at its 'points' the cable turns about pulley '{}' in the other sense than "
                      "'wrap' says",
                      station.body.text),
          "correct 'wrap', or exchange the two points");
    }
  }

  // The segment goes from place i to the next. Computed ends touch their own pulleys; where the
  // file gives rounded points, they may cut in.
  void check_passing(const Stretch& stretch, std::size_t i, const std::vector<Place>& places) {
    for (std::size_t j = 0; j < places.size(); ++j) {
      const auto& [station, pulley] = places[j];
      const bool is_own = j == i || j == i + 1;
      const bool may_cut =
          is_own ? pulley->meets.has_value()
                 : !is_coaxial(*pulley, stretch.from) && !is_coaxial(*pulley, stretch.to);
      if (may_cut && station->is_pulley && station->at &&
          passes_through(stretch.span, *pulley, is_own ? kDrawnContact : kGrazing)) {
        refuse(*station,
               fmt::format(
                   "segment '{}' passes through pulley '{}'", stretch.name, station->body.text),
               is_own ? "correct its 'points', which lie on its rim, or its 'at'"
                      : "lead the cable over this pulley where it meets it, change the 'wrap' of a "
                        "neighbour, or move it");
      }
    }
  }

  const CableDescription& cable_;
  const FileUnits& units_;
  Diagnostics& found_;
  bool has_wrong_points_ = false;
};

}  // namespace

bool check_routes(const SectionContext& context) {
  const MechanismDescription& description = context.description;
  if (!is_expanded(description)) {
    return false;
  }
  Diagnostics said_elsewhere;  // of centres, by the couplings that have them
  Evaluator evaluator = make_evaluator(description, said_elsewhere);
  std::vector<std::vector<Stretch>> routes(description.cables.size());
  for (const CouplingDescription& coupling : description.couplings) {
    if (!coupling.is_segment()) {
      continue;
    }
    const CablePart& part = *coupling.part;
    const auto from = bind_station<double>(part.from, evaluator);
    const auto to = bind_station<double>(part.to, evaluator);
    if (!from || !to) {
      return false;
    }
    routes[static_cast<std::size_t>(part.cable)].push_back(
        {.part = &part, .name = coupling.name.text, .from = *from, .to = *to, .span = {}});
  }
  const int errors_before = context.found.error_count();
  for (std::size_t i = 0; i < routes.size(); ++i) {
    RouteCheck(description.cables[i], description.units, context.found).run(routes[i]);
  }
  return context.found.error_count() == errors_before;
}

}  // namespace kinestat
