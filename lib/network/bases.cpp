#include "network/bases.hpp"

#include <algorithm>

namespace kinestat {

namespace {

template <class Screw>
Mat6X columns_of(const std::vector<Screw>& screws) {
  Mat6X columns(6, static_cast<Eigen::Index>(screws.size()));
  for (std::size_t i = 0; i < screws.size(); ++i) {
    columns.col(static_cast<Eigen::Index>(i)) = screws[i].coordinates();
  }
  return columns;
}

CoordinateBasis basis_of(const Mat6X& screws, ScrewKind kind, OrderChoice order, double length) {
  switch (order) {
    case OrderChoice::planar:
      return planar_basis(kind, length);
    case OrderChoice::spatial:
      return spatial_basis(kind, length);
    case OrderChoice::minimal:
      break;
  }
  return find_minimal_basis(screws, kind, length);
}

bool holds(const CoordinateBasis& basis, std::span<const BodyWrench> loads) {
  return std::ranges::all_of(
      loads, [&](const BodyWrench& load) { return basis.holds(load.wrench.coordinates()); });
}

bool is_planar(const Mat6X& wrenches) {
  return wrenches.topRows<2>().isZero(0.0) && wrenches.bottomRows<1>().isZero(0.0);
}

}  // namespace

CoordinateBasis motion_basis(const Geometry& geometry, OrderChoice order) {
  return basis_of(columns_of(geometry.motions), ScrewKind::twist, order, geometry.length);
}

CoordinateBasis action_basis(const Geometry& geometry,
                             OrderChoice order,
                             std::span<const BodyWrench> loads) {
  return action_basis(
      basis_of(columns_of(geometry.actions), ScrewKind::wrench, order, geometry.length),
      geometry,
      loads);
}

CoordinateBasis action_basis(CoordinateBasis of_actions,
                             const Geometry& geometry,
                             std::span<const BodyWrench> loads) {
  if (holds(of_actions, loads)) {
    return of_actions;
  }
  CoordinateBasis planar = planar_basis(ScrewKind::wrench, geometry.length);
  return is_planar(columns_of(geometry.actions)) && holds(planar, loads)
             ? planar
             : spatial_basis(ScrewKind::wrench, geometry.length);
}

}  // namespace kinestat
