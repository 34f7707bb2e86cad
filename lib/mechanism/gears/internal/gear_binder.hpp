// The section `gears` in numbers.
#pragma once

#include <optional>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/gear_layout.hpp"

namespace kinestat {

/// The numbers of a train; empty iff an error was added. `Scalar` is double or Dual.
template <class Scalar>
std::optional<GearNumbersOf<Scalar>> bind_gear_numbers(const GearsDescription& gears,
                                                       const GearTrain& train,
                                                       EvaluatorOf<Scalar>& evaluator);

/// What couplings need of the section: where its gears stand, and what it says of their teeth. The
/// description must outlive it.
template <class Scalar>
struct GearFrameOf {
  const GearsDescription* gears = nullptr;
  GearLayoutOf<Scalar> layout;
};

using GearFrame = GearFrameOf<double>;

/// Empty if the file has no gears, or if their meshes have not become couplings, because they are
/// wrong (check_gears).
template <class Scalar>
std::optional<GearFrameOf<Scalar>> bind_gear_frame(const MechanismDescription& description,
                                                   EvaluatorOf<Scalar>& evaluator);

/// What `gears` finds of a mesh.
template <class Scalar>
struct MeshTeethOf {
  Vec3Of<Scalar> tangent = Vec3Of<Scalar>::UnitX();
  double hand = 1.0;   ///< 1: a positive helix angle pushes the head along the axis, otherwise -1
  double flank = 1.0;  ///< 1: a positive force pushes the head away from the tail, otherwise -1
};

/// A helix angle is that of the first gear, whose hand alternates along the train where it is the
/// angle of the section; in a ring a gear touches the side of its teeth that looks inwards. On the
/// loaded flank a positive force pushes gears apart, and a planet inwards from its ring.
template <class Scalar>
MeshTeethOf<Scalar> teeth_of(const GearFrameOf<Scalar>& frame, const CouplingDescription& coupling);

}  // namespace kinestat
