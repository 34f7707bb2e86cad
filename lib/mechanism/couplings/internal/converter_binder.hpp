// The characteristic of a torque converter in numbers.
#pragma once

#include <optional>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/couplings/torque_converter.hpp"

namespace kinestat {

/// Without bodies. The coupling must be a torque converter; empty iff an error was added. `Scalar`
/// is double or Dual.
template <class Scalar>
std::optional<ConverterLawOf<Scalar>> bind_converter(const CouplingDescription& coupling,
                                                     EvaluatorOf<Scalar>& evaluator,
                                                     Diagnostics& found);

}  // namespace kinestat
