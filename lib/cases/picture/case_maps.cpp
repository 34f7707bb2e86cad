#include "cases/picture/case_maps.hpp"

#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/axis_name.hpp"
#include "draw/picture_title.hpp"
#include "kinematics/bounded_motion.hpp"
#include "report/in_units.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

// The vector of an element in a case, in the units of the file; empty where it is not known.
using VectorOf = std::function<std::optional<Vec3>(
    const CaseAnalysis& one, std::size_t element, const InUnits&)>;

// A quantity with three components.
struct VectorQuantity {
  std::string words;
  std::string symbol;
  std::string unit;
  bool is_turning = false;
  VectorOf value;
};

bool has_motion(const CaseAnalysis& one) {
  return one.motion && one.motion->status == SolveStatus::solved;
}

bool has_action(const CaseAnalysis& one) {
  return one.action && !one.action->wrenches.empty();
}

class MapBuilder {
 public:
  MapBuilder(const Analysis& analysis, bool (*counts)(const CaseAnalysis&)) : analysis_(analysis) {
    for (const CaseAnalysis& one : analysis.cases) {
      if (counts(one)) {
        cases_.push_back(&one);
        map_.columns.push_back(one.which.label);
      }
    }
  }

  void add(const VectorQuantity& quantity, const std::vector<std::string>& names) {
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
      BarBlock block = {
          .title = fmt::format("{} {}{}{}",
                               quantity.words,
                               quantity.symbol,
                               kAxisNames[axis],
                               quantity.unit.empty() ? "" : " [" + quantity.unit + "]"),
          .rows = {}};
      bool is_zero = true;
      for (std::size_t i = 0; i < names.size(); ++i) {
        block.rows.push_back(row(names[i], i, static_cast<int>(axis), quantity, is_zero));
      }
      // In the plane nothing else is possible.
      const bool is_out_of_plane =
          analysis_.mechanism.space == Space::planar && quantity.is_turning == (axis < 2);
      if (is_zero && is_out_of_plane) {
        continue;
      }
      if (is_zero) {
        zeros_.push_back(quantity.symbol + kAxisNames[axis]);
      } else {
        map_.blocks.push_back(std::move(block));
      }
    }
  }

  BarMap finish(std::string name, std::string_view title, std::string description) {
    map_.name = std::move(name);
    map_.title = words_of_cases(title, analysis_);
    map_.mechanism = shown_name(analysis_.file, analysis_.description);
    map_.description = std::move(description);
    if (!zeros_.empty()) {
      map_.remarks.push_back(fmt::format("Zero throughout: {}", fmt::join(zeros_, ", ")));
    }
    return std::move(map_);
  }

 private:
  BarRow row(const std::string& name,
             std::size_t element,
             int axis,
             const VectorQuantity& quantity,
             bool& is_zero) const {
    BarRow row = {.name = name, .values = {}};
    for (const CaseAnalysis* one : cases_) {
      const InUnits in(analysis_.description.units);
      const std::optional<Vec3> vector = quantity.value(*one, element, in);
      is_zero = is_zero && vector && (*vector)[axis] == 0.0;
      row.values.push_back(vector ? std::optional((*vector)[axis]) : std::nullopt);
    }
    return row;
  }

  const Analysis& analysis_;
  std::vector<const CaseAnalysis*> cases_;
  BarMap map_;
  std::vector<std::string> zeros_;
};

std::string unit_text(const Analysis& analysis, QuantityKind kind) {
  return analysis.description.units.text(kind);
}

// Of all bodies but the ground; empty where the case does not determine it.
std::optional<BoundedTwist> body(const CaseAnalysis& one, std::size_t i) {
  const BodyId id{static_cast<int>(i) + 1};
  return one.motion->knows_body(id) ? std::optional(bounded_body(*one.motion, id)) : std::nullopt;
}

// All but the ground, which rests.
std::vector<std::string> moving_bodies(const Analysis& analysis) {
  std::vector<std::string> names;
  for (std::size_t b = 1; b < analysis.mechanism.topology.bodies.size(); ++b) {
    names.push_back(analysis.mechanism.topology.bodies[b].name);
  }
  return names;
}

std::vector<std::string> couplings(const Analysis& analysis) {
  std::vector<std::string> names;
  for (const CouplingTopology& coupling : analysis.mechanism.topology.couplings) {
    names.push_back(coupling.name);
  }
  return names;
}

}  // namespace

BarMap speed_map(const Analysis& analysis) {
  const Geometry& geometry = analysis.mechanism.geometry;
  MapBuilder builder(analysis, has_motion);
  builder.add({.words = "angular velocity",
               .symbol = "ω",
               .unit = unit_text(analysis, QuantityKind::angular_velocity),
               .is_turning = true,
               .value =
                   [](const CaseAnalysis& one, std::size_t i, const InUnits& in) {
                     const std::optional<BoundedTwist> twist = body(one, i);
                     return twist ? std::optional<Vec3>(in.angular(twist->angular.zeroed()))
                                  : std::nullopt;
                   }},
              moving_bodies(analysis));
  builder.add({.words = "velocity",
               .symbol = "v",
               .unit = unit_text(analysis, QuantityKind::velocity),
               .value =
                   [&geometry](const CaseAnalysis& one, std::size_t i, const InUnits& in) {
                     const std::optional<BoundedTwist> twist = body(one, i);
                     const Vec3 at = geometry.references[i + 1];
                     return twist ? std::optional<Vec3>(in.linear(velocity_at(*twist, at).zeroed()))
                                  : std::nullopt;
                   }},
              moving_bodies(analysis));
  return builder.finish(
      "speeds",
      "Velocities of the bodies",
      "Bars of the angular velocity of each body and of the velocity of its reference point, "
      "relative to the ground, for each case on one scale.");
}

BarMap torque_map(const Analysis& analysis) {
  const Geometry& geometry = analysis.mechanism.geometry;
  MapBuilder builder(analysis, has_action);
  builder.add({.words = "moment",
               .symbol = "T",
               .unit = unit_text(analysis, QuantityKind::moment),
               .is_turning = true,
               .value =
                   [&geometry](const CaseAnalysis& one, std::size_t e, const InUnits& in) {
                     const auto wrench =
                         bounded_wrench(*one.action, CouplingId{static_cast<int>(e)});
                     const Vec3 at = geometry.points[e];
                     return wrench ? std::optional<Vec3>(in.moment(moment_at(*wrench, at).zeroed()))
                                   : std::nullopt;
                   }},
              couplings(analysis));
  return builder.finish("torques",
                        "Moments in the couplings",
                        "Bars of the moment that each coupling bears about its own point, of tail "
                        "on head, for each case on one scale.");
}

BarMap force_map(const Analysis& analysis) {
  MapBuilder builder(analysis, has_action);
  builder.add(
      {.words = "force",
       .symbol = "F",
       .unit = unit_text(analysis, QuantityKind::force),
       .value =
           [](const CaseAnalysis& one, std::size_t e, const InUnits& in) {
             const auto wrench = bounded_wrench(*one.action, CouplingId{static_cast<int>(e)});
             return wrench ? std::optional<Vec3>(in.force(wrench->force.zeroed())) : std::nullopt;
           }},
      couplings(analysis));
  return builder.finish("forces",
                        "Forces in the couplings",
                        "Bars of the force that each coupling bears, of tail on head, for each "
                        "case on one scale.");
}

}  // namespace kinestat
