#include "mechanism/bind/rounding_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Calls visit(slope, p) for each derivative of the vector towards a parameter p.
template <class Visit>
void visit_slopes(Vec3Of<Dual>& vector, const Visit& visit) {
  for (Dual& coordinate : vector) {
    for (std::size_t p = 0; p < coordinate.derivatives.size(); ++p) {
      visit(coordinate.derivatives[p], p);
    }
  }
}

// Calls visit(vector, its unit) for the halves of all screws.
template <class Visit>
void visit_halves(GeometryOf<Dual>& geometry, const Visit& visit) {
  for (TwistOf<Dual>& motion : geometry.motions) {
    visit(motion.angular, 1.0);
    visit(motion.linear, geometry.length);
  }
  for (WrenchOf<Dual>& action : geometry.actions) {
    visit(action.moment, geometry.length);
    visit(action.force, 1.0);
  }
  for (OtherFlankOf<Dual>& flank : geometry.other_flanks) {
    visit(flank.screw.moment, geometry.length);
    visit(flank.screw.force, 1.0);
  }
}

std::vector<double> steepest_slopes(GeometryOf<Dual>& geometry, std::size_t parameter_count) {
  std::vector<double> steepest(parameter_count, 0.0);
  const auto compare = [&](Vec3Of<Dual>& vector, double unit) {
    visit_slopes(vector, [&](double slope, std::size_t p) {
      steepest[p] = std::max(steepest[p], std::abs(slope) / unit);
    });
  };
  visit_halves(geometry, compare);
  for (Vec3Of<Dual>& point : geometry.points) {
    compare(point, geometry.length);
  }
  return steepest;
}

}  // namespace

void drop_rounding(GeometryOf<Dual>& geometry, std::size_t parameter_count) {
  const std::vector<double> steepest = steepest_slopes(geometry, parameter_count);
  visit_halves(geometry, [&](Vec3Of<Dual>& half, double unit) {
    visit_slopes(half, [&](double& slope, std::size_t p) {
      if (std::abs(slope) / unit <= kCancellation * steepest[p]) {
        slope = 0.0;
      }
    });
  });
}

}  // namespace kinestat
