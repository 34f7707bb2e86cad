// Derivatives of reported values towards parameters by the adjoint of the solved equations.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sensitivity/reported_value.hpp"

namespace kinestat {

/// One case ready to be differentiated: the equations factored once, the right-hand sides that the
/// parameters cause, and which parameters would break the couplings apart.
class CaseAdjoint {
 public:
  /// `derivatives` are those of the mechanism, `primaries` those of the case of `values`. The
  /// equations are written in all coordinates of the space.
  CaseAdjoint(const DualCase& values,
              const MechanismDerivatives& derivatives,
              const CaseDerivatives& primaries);
  ~CaseAdjoint();

  /// dv/dp for each parameter in SI, for one more solution of the transposed equations on each side
  /// that takes part. Empty where there is no derivative: the value has a corner or a jump there,
  /// or the redundant couplings no longer fit when the parameter moves alone.
  std::vector<std::optional<double>> derivatives_of(const ReportedValue& value) const;

 private:
  class Side;

  const DualCase& values_;
  std::unique_ptr<Side> motion_;  ///< null if the case has no velocities
  std::unique_ptr<Side> action_;  ///< null if the case has no actions
};

}  // namespace kinestat
