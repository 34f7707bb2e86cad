// Teeth that touch: the line of action of a gear, bevel gear, worm or rack, and how they move.
#pragma once

#include "mechanism/bind/direction_binder.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

/// Unit force of tail on head. Of a gear either given or, with tangent t, axis a, pressure angle α
/// and helix angle β (positive: the tail is right-handed), n = cos αn cos β t + sin αn (a x t) +
/// cos αn sin β a with tan αn = tan α cos β. Of the other types always given. Empty iff an error
/// was added; x for a coupling that is only counted.
template <class Scalar>
std::optional<Vec3Of<Scalar>> bind_line_of_action(const CouplingDescription& coupling,
                                                  Space space,
                                                  const AxisOf<Scalar>& axis,
                                                  EvaluatorOf<Scalar>& evaluator,
                                                  Diagnostics& found);

/// Whether the file writes teeth as a coupling that turn to their other flank under load.
bool turns_flank(const CouplingDescription& coupling);

/// That of the other flank, whose normal is mirrored at the tangent: with -αn. Empty of a line that
/// is given, which does not say where the tangent is. The other line must have been bound.
template <class Scalar>
std::optional<Vec3Of<Scalar>> bind_other_line_of_action(const CouplingDescription& coupling,
                                                        Space space,
                                                        const AxisOf<Scalar>& axis,
                                                        EvaluatorOf<Scalar>& evaluator,
                                                        Diagnostics& found);

/// Likewise of a mesh of `gears`, whose axis is z and whose tangent follows from the train.
template <class Scalar>
std::optional<Vec3Of<Scalar>> bind_mesh_line_of_action(const CouplingDescription& coupling,
                                                       Space space,
                                                       const MeshTeethOf<Scalar>& teeth,
                                                       EvaluatorOf<Scalar>& evaluator,
                                                       Diagnostics& found);

}  // namespace kinestat
