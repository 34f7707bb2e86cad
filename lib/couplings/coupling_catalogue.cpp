#include "couplings/coupling_catalogue.hpp"

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/kinds.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

template <class Scalar>
CouplingScrewsOf<Scalar> coupling_screws(CouplingType type,
                                         Space space,
                                         const CouplingGeometryOf<Scalar>& geometry) {
  CatalogueRow<Scalar> row(space);
  kind_of(type).mechanics->screws.template of<Scalar>()(geometry, row);
  return row.take();
}

template <class Scalar>
NamedWrenchOf<Scalar> internal_action(const NamedTwistOf<Scalar>& freedom,
                                      const Vec3In<Scalar>& at) {
  return {.name = freedom.name,
          .is_couple = freedom.is_rotation,
          .screw = freedom.is_rotation ? unit_couple<Scalar>(freedom.screw.angular)
                                       : unit_force<Scalar>(freedom.screw.linear, at)};
}

template CouplingScrewsOf<double> coupling_screws(CouplingType, Space, const CouplingGeometry&);
template CouplingScrewsOf<Dual> coupling_screws(CouplingType,
                                                Space,
                                                const CouplingGeometryOf<Dual>&);
template NamedWrenchOf<double> internal_action(const NamedTwistOf<double>&, const Vec3In<double>&);
template NamedWrenchOf<Dual> internal_action(const NamedTwistOf<Dual>&, const Vec3In<Dual>&);
template CouplingScrewsOf<ExactInput> coupling_screws(CouplingType,
                                                      Space,
                                                      const CouplingGeometryOf<ExactInput>&);
template NamedWrenchOf<ExactInput> internal_action(const NamedTwistOf<ExactInput>&,
                                                   const Vec3In<ExactInput>&);

}  // namespace kinestat
