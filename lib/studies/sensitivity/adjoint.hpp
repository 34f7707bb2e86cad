// Derivatives of reported values towards parameters by the adjoint of the solved equations.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "mechanism/bind/derivatives.hpp"
#include "screw/coordinate_basis.hpp"
#include "studies/sensitivity/reported_value.hpp"

namespace kinestat {

class AdjointSide;
struct Sum;

/// The coordinates in which the equations of all cases are differentiated.
struct AdjointBases {
  CoordinateBasis motion;
  CoordinateBasis action;
};

/// Those in which the cases are solved, or all of the space where a parameter moves a screw or a
/// load out of these.
AdjointBases find_adjoint_bases(const Mechanism& mechanism,
                                const MechanismDerivatives& derivatives);

/// One case ready to be differentiated: the equations of each side factored once, when a value
/// first depends on them, with the right-hand sides that the parameters cause, and which parameters
/// would break the couplings apart.
class CaseAdjoint {
 public:
  /// Both must outlive the object.
  CaseAdjoint(const DualCase& values, const AdjointBases& bases);
  ~CaseAdjoint();

  /// dv/dp for each parameter in SI, for one more solution of the transposed equations on each side
  /// that takes part. Empty where there is no derivative: the value has a corner or a jump there,
  /// or the redundant couplings no longer fit when the parameter moves alone.
  std::vector<std::optional<double>> derivatives_of(const ReportedValue& value);

 private:
  AdjointSide& motion();
  AdjointSide& action();
  AdjointSide make_action();

  // Adds what a value moves by, from its slopes towards the magnitudes of one side.
  using AddPart = std::function<void(const std::vector<double>&, std::vector<std::optional<Sum>>&)>;
  static void leave_corners(std::vector<double>& slopes,
                            std::vector<std::optional<Sum>>& result,
                            const AddPart& add_part);

  void add_frictions(const std::vector<double>& slopes, std::vector<std::optional<Sum>>& result);

  const DualCase& values_;
  const AdjointBases& bases_;
  std::unique_ptr<AdjointSide> motion_;               ///< null until a value depends on a rate
  std::unique_ptr<AdjointSide> action_;               ///< null until a value depends on an action
  std::vector<std::vector<double>> friction_slopes_;  ///< by each parameter, once there are actions
};

}  // namespace kinestat
