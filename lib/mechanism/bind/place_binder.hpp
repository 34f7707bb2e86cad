// Where a coupling is: its point, or the ends of a cable.
#pragma once

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

/// Fills `at`, `from` and `to` of the geometry, with errors where the file is wrong; the origin
/// where it gives no point, which leaves it to counts. A mesh stands at its pitch point, a coupling
/// on the axis of a gear there. `gears` is null if the file has none or if they are wrong; then
/// there must be no meshes. `Scalar` is double or Dual.
template <class Scalar>
void bind_place(const CouplingDescription& coupling,
                const GearFrameOf<Scalar>* gears,
                EvaluatorOf<Scalar>& evaluator,
                Diagnostics& found,
                CouplingGeometryOf<Scalar>& geometry);

}  // namespace kinestat
