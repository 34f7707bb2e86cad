// The numbers of a mechanism, bound again with another type of number.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanism/couplings/internal/coupling_binder.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The known magnitudes and the loads of a case. Lists are parallel to those of the Case.
template <class Scalar>
struct CaseNumbersOf {
  std::vector<Scalar> motions;
  std::vector<Scalar> actions;
  std::vector<WrenchOf<Scalar>> loads;  ///< about the origin of the geometry
};

/// Binds again the description of which bind made `mechanism`. The origin and the size remain plain
/// numbers, and the evaluator measures from this origin. All arguments must outlive it. `Scalar` is
/// Dual or ExactInput.
template <class Scalar>
class NumberRebinder {
 public:
  NumberRebinder(const MechanismDescription& description,
                 const Mechanism& mechanism,
                 EvaluatorOf<Scalar>& evaluator,
                 Diagnostics& found)
      : description_(description),
        mechanism_(mechanism),
        evaluator_(evaluator),
        found_(found),
        gears_(bind_gear_frame<Scalar>(description, evaluator)) {
    evaluator.measure_from(mechanism.geometry.origin);
  }

  /// The geometry of a coupling as drawn.
  CouplingGeometryOf<Scalar> drawn(const CouplingDescription& coupling);

  /// Appends the point, the motions and the actions of the coupling with index `e` to `result`.
  /// Returns its freedoms and constraints in the space of the file.
  CouplingScrewsOf<Scalar> add_coupling(std::size_t e,
                                        CouplingGeometryOf<Scalar> geometry,
                                        GeometryOf<Scalar>& result) const;

  /// Completes a geometry to which all couplings were added.
  void complete(GeometryOf<Scalar>& result) const;

  CaseNumbersOf<Scalar> bind_case(const CaseDescription& description, const Case& bound);

 private:
  Scalar number(const Value& value, QuantityKind kind);

  Vec3Of<Scalar> vector(const std::vector<Value>& components, QuantityKind kind);

  WrenchOf<Scalar> force_at(const Vec3Of<Scalar>& point, const Vec3Of<Scalar>& force) const;

  WrenchOf<Scalar> bind_load(const Load& load, const CaseDescription& description);

  WrenchOf<Scalar> bind_load(const LoadDescription& load);

  Space flank_space() const;

  void add_action(int action,
                  const CouplingTopology& coupling,
                  const CouplingScrewsOf<Scalar>& screws,
                  const std::vector<NamedWrenchOf<Scalar>>& constraints,
                  const Vec3Of<Scalar>& at,
                  GeometryOf<Scalar>& result) const;

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  EvaluatorOf<Scalar>& evaluator_;
  Diagnostics& found_;
  std::optional<GearFrameOf<Scalar>> gears_;
};

}  // namespace kinestat
