// The stations of a cable in numbers.
#pragma once

#include <optional>

#include "couplings/cable_geometry.hpp"
#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

/// A station as a CablePart has it, whose centre and axis are filled in. Empty iff an error was
/// added, or if the centre of a pulley without points is not known. Without `wrap` the radius is 0,
/// as the sense of turning is not known. `Scalar` is double or Dual.
template <class Scalar>
std::optional<CableStationGeometryOf<Scalar>> bind_station(const CableStation& station,
                                                           EvaluatorOf<Scalar>& evaluator);

}  // namespace kinestat
