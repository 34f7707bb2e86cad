// The geometry of one coupling in numbers: its points and directions, checked against each other.
#pragma once

#include <optional>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

/// Whether the file says where the coupling is: at, the ends of a cable, or a screw with a line.
bool has_place(const CouplingDescription& coupling);

/// The numbers of a coupling; empty iff an error was added. `gears` is null if the file has none or
/// if they are wrong; then there must be no meshes. `Scalar` is double or Dual.
template <class Scalar>
std::optional<CouplingGeometryOf<Scalar>> bind_geometry(const CouplingDescription& coupling,
                                                        Space space,
                                                        const GearFrameOf<Scalar>* gears,
                                                        EvaluatorOf<Scalar>& evaluator,
                                                        Diagnostics& found);

}  // namespace kinestat
