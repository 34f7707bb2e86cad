#include "mechanism/internal/coupling_binder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "mechanism/internal/geometry_check.hpp"

namespace kinestat {

namespace {

bool has_axis(CouplingType type) {
  return is_in_catalogue(type) && type != CouplingType::rigid;
}

std::string title(const CouplingDescription& coupling) {
  return fmt::format("{} '{}'", word_of(coupling.type), coupling.name.text);
}

void lacks(const CouplingDescription& coupling,
           std::string_view key,
           std::string hint,
           Diagnostics& found) {
  found.error("E0314",
              coupling.name.where,
              fmt::format("{} lacks the key '{}'", title(coupling), key),
              std::move(hint));
}

// The points as drawn on the two bodies; the tail's counts.
std::optional<Vec3> bind_points_of_bodies(const CouplingDescription& coupling,
                                          Evaluator& evaluator,
                                          Diagnostics& found) {
  std::optional<Vec3> result;
  bool is_good = true;
  for (const auto& [body, point] : coupling.at->of_bodies) {
    const std::optional<Vec3> drawn = evaluator.point(point);
    is_good = is_good && drawn.has_value();
    if (body.text == coupling.tail.text) {
      result = drawn;
    } else if (body.text != coupling.head.text) {
      is_good = false;
      found.error("E0313",
                  body.where,
                  fmt::format("'{}' is not a body of {}", body.text, title(coupling)),
                  fmt::format("its bodies are {} and {}", coupling.tail.text, coupling.head.text));
    }
  }
  return is_good ? result : std::nullopt;
}

// The origin where the file gives no point, which leaves it to counts or to `gears`.
std::optional<Vec3> bind_point(const CouplingDescription& coupling,
                               Evaluator& evaluator,
                               Diagnostics& found) {
  if (!coupling.at) {
    return Vec3::Zero();
  }
  if (coupling.at->point) {
    return evaluator.point(*coupling.at->point);
  }
  if (!coupling.at->of_bodies.empty()) {
    return bind_points_of_bodies(coupling, evaluator, found);
  }
  const auto z = evaluator.number(*coupling.at->along_axis, QuantityKind::length);
  return z ? std::optional(Vec3(0.0, 0.0, *z)) : std::nullopt;
}

// In the plane a rotation is about z and a translation lies in the plane.
bool check_in_plane(const CouplingDescription& coupling, const Axis& axis, Diagnostics& found) {
  const bool is_rotation = coupling.type != CouplingType::prismatic;
  const double out_of_place =
      is_rotation ? axis.direction.head<2>().norm() : std::abs(axis.direction.z());
  if (out_of_place <= kZeroAxis) {
    return true;
  }
  found.error("E0314",
              coupling.axis->where,
              is_rotation
                  ? fmt::format("{} of a planar mechanism turns about z", title(coupling))
                  : fmt::format("{} of a planar mechanism slides in the plane", title(coupling)),
              is_rotation ? "remove 'axis', or write 'space: spatial' at the top of the file"
                          : "write axis: x, axis: y or axis: [x, y]");
  return false;
}

std::optional<Axis> bind_axis(const CouplingDescription& coupling,
                              Space space,
                              Evaluator& evaluator,
                              Diagnostics& found) {
  if (!has_axis(coupling.type)) {
    return Axis{};
  }
  if (!coupling.axis) {
    const bool is_about_z = space == Space::planar && coupling.type != CouplingType::prismatic;
    if (is_about_z || is_counted_only(coupling)) {
      return Axis{};
    }
    lacks(coupling, "axis", "add axis: x, y, z, -x, … or a vector", found);
    return std::nullopt;
  }
  const std::optional<Axis> axis = evaluator.axis(*coupling.axis);
  if (axis && space == Space::planar && !check_in_plane(coupling, *axis, found)) {
    return std::nullopt;
  }
  return axis;
}

// n = cos α t + sin α (axis x t): the force of tail on head along the line of action of spur teeth.
std::optional<Vec3> force_from_tangent(const CouplingDescription& coupling,
                                       const Axis& axis,
                                       Evaluator& evaluator,
                                       Diagnostics& found) {
  const std::optional<Axis> tangent = evaluator.axis(*coupling.tangent);
  const std::optional<double> angle =
      evaluator.number(*coupling.pressure_angle, QuantityKind::angle);
  if (!tangent || !angle) {
    return std::nullopt;
  }
  if (std::abs(tangent->direction.dot(axis.direction)) > kCancellation) {
    found.error("E0314",
                coupling.tangent->where,
                fmt::format("the tangent of {} is not perpendicular to its axis", title(coupling)),
                "the tangent touches both pitch circles at the pitch point");
    return std::nullopt;
  }
  if (std::abs(*angle) >= std::numbers::pi / 2) {
    found.error("E0314",
                coupling.pressure_angle->where,
                "a pressure angle lies between -90 and 90 degrees",
                "write for example pressure_angle: 20 deg");
    return std::nullopt;
  }
  return std::cos(*angle) * tangent->direction +
         std::sin(*angle) * axis.direction.cross(tangent->direction);
}

std::optional<Vec3> bind_line_of_action(const CouplingDescription& coupling,
                                        const Axis& axis,
                                        Evaluator& evaluator,
                                        Diagnostics& found) {
  if (coupling.line_of_action) {
    if (coupling.tangent || coupling.pressure_angle) {
      found.error("E0314",
                  coupling.line_of_action->where,
                  fmt::format("{} has both a line of action and a tangent or pressure angle",
                              title(coupling)),
                  "keep 'line_of_action', or 'tangent' with 'pressure_angle'");
      return std::nullopt;
    }
    const std::optional<Axis> line = evaluator.axis(*coupling.line_of_action);
    return line ? std::optional(line->direction) : std::nullopt;
  }
  if (is_counted_only(coupling)) {
    return Vec3::UnitX();
  }
  if (!coupling.tangent || !coupling.pressure_angle) {
    lacks(coupling,
          coupling.tangent ? "pressure_angle" : "tangent",
          "add tangent: x (or a vector) and pressure_angle: 20 deg, or line_of_action: a vector",
          found);
    return std::nullopt;
  }
  return force_from_tangent(coupling, axis, evaluator, found);
}

}  // namespace

std::optional<CouplingGeometry> bind_geometry(const CouplingDescription& coupling,
                                              Space space,
                                              Evaluator& evaluator,
                                              Diagnostics& found) {
  const bool is_good = check_geometry(coupling, space, evaluator, found);
  const std::optional<Vec3> at = bind_point(coupling, evaluator, found);
  const std::optional<Axis> axis = bind_axis(coupling, space, evaluator, found);
  std::optional<Vec3> line = Vec3::UnitX();
  if (coupling.type == CouplingType::gear && axis) {
    line = bind_line_of_action(coupling, *axis, evaluator, found);
  }
  if (!is_good || !at || !axis || !line) {
    return std::nullopt;
  }
  return CouplingGeometry{.at = *at, .axis = *axis, .line_of_action = *line};
}

void keep_passive(const CouplingDescription& coupling, CouplingScrews& screws, Diagnostics& found) {
  if (!coupling.passive) {
    return;
  }
  std::vector<std::string> available;
  for (const NamedWrench& constraint : screws.constraints) {
    available.push_back(constraint.name);
  }
  std::vector<std::string> kept;
  for (const Name& name : *coupling.passive) {
    if (std::ranges::find(kept, name.text) != kept.end()) {
      found.error("E0307",
                  name.where,
                  fmt::format("'passive' of {} names '{}' twice", title(coupling), name.text),
                  "remove one of the two");
    }
    kept.push_back(name.text);
    if (std::ranges::find(available, name.text) == available.end()) {
      const std::string guess = did_you_mean(name.text, available);
      found.error("E0313",
                  name.where,
                  fmt::format("{} has no constraint '{}'", title(coupling), name.text),
                  available.empty() ? "it has no passive constraints; remove 'passive'"
                                    : fmt::format("{}{}its constraints are {}",
                                                  guess,
                                                  guess.empty() ? "" : " ",
                                                  plain_list(available)));
    }
  }
  std::erase_if(screws.constraints, [&](const NamedWrench& constraint) {
    return std::ranges::find(kept, constraint.name) == kept.end();
  });
}

}  // namespace kinestat
