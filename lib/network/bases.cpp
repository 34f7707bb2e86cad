#include "network/bases.hpp"

namespace kinestat {

namespace {

template <class Screw>
CoordinateBasis basis_of(const std::vector<Screw>& screws,
                         ScrewKind kind,
                         OrderChoice order,
                         double length) {
  if (order == OrderChoice::planar) {
    return planar_basis(kind, length);
  }
  if (order == OrderChoice::spatial) {
    return spatial_basis(kind, length);
  }
  Mat6X columns(6, static_cast<Eigen::Index>(screws.size()));
  for (std::size_t i = 0; i < screws.size(); ++i) {
    columns.col(static_cast<Eigen::Index>(i)) = screws[i].coordinates();
  }
  return find_minimal_basis(columns, kind, length);
}

}  // namespace

CoordinateBasis motion_basis(const Geometry& geometry, OrderChoice order) {
  return basis_of(geometry.motions, ScrewKind::twist, order, geometry.length);
}

CoordinateBasis action_basis(const Geometry& geometry, OrderChoice order) {
  return basis_of(geometry.actions, ScrewKind::wrench, order, geometry.length);
}

}  // namespace kinestat
