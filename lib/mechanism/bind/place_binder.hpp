// The place of a coupling: its point, or the ends of a cable.
#pragma once

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

/// Fills `at`, `from` and `to` of the geometry [m], and adds errors if the file is wrong. A
/// coupling without a point, which can only be counted, is put at the origin. A mesh is at its
/// pitch point, a coupling on the axis of a gear on this axis. `gears` is null if the file has no
/// gears or if they are wrong; there must then be no meshes. `Scalar` is double or Dual.
template <class Scalar>
void bind_place(const CouplingDescription& coupling,
                const GearFrameOf<Scalar>* gears,
                EvaluatorOf<Scalar>& evaluator,
                Diagnostics& found,
                CouplingGeometryOf<Scalar>& geometry);

}  // namespace kinestat
