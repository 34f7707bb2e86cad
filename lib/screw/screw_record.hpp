// What reports say of twists, wrenches and their axes.
#pragma once

#include "record/record.hpp"
#include "screw/bounded_screw.hpp"

namespace kinestat {

/// An axis that was found about `origin`.
struct AxisView {
  ScrewAxis axis;
  LocalOrigin origin;
};

const Record<AxisView>& axis_record();

/// For the key of the axis in the record of what moves or bears; empty where there is none.
std::optional<AxisView> view_of(const std::optional<ScrewAxis>& axis, const LocalOrigin& origin);

/// Angular velocity, then velocity, about the world origin.
Sixfold sixfold_of(const Twist& twist);

/// Moment about the world origin, then force.
Sixfold sixfold_of(const Wrench& wrench);

}  // namespace kinestat
