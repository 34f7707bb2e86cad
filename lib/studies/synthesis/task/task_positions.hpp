// The positions of a synthesis task, in doubles or with a hundred digits.
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "expression/parameters.hpp"
#include "math/numbers/exact_input.hpp"
#include "studies/synthesis/dyads/precise_point.hpp"
#include "studies/synthesis/positions/position_jets.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// Positions of a description that is right by itself (check). `Number` is double, or ExactInput
/// for values as typed.
template <class Number>
class TaskPositions {
 public:
  using Scalar = std::conditional_t<std::is_same_v<Number, double>, double, BigFloat>;
  using Positions = std::vector<PositionJetsOf<Scalar>>;

  explicit TaskPositions(const MechanismDescription& description);

  /// How many tasks: one for every choice of the angles that are lists.
  std::size_t count() const;

  /// One of them, by the angle of the last position first. `choice` stands for what the curvature
  /// of a position leaves to the ranges; it has doubles only. Empty iff an error was added: E0801
  /// for a position that contradicts itself or at which nothing moves, E0316 for a value that only
  /// rounding of doubles gives.
  std::optional<Positions> of_task(std::size_t task,
                                   const SynthesisChoice& choice,
                                   Diagnostics& found) const;

  /// All of them. Empty iff an error was added.
  std::optional<std::vector<Positions>> of_tasks(const SynthesisChoice& choice,
                                                 Diagnostics& found) const;

  /// A value in SI.
  Scalar number(const Value& value, QuantityKind kind, Diagnostics& found) const;

 private:
  using Point = PointOf<Scalar>;

  Point point(const PointDescription& point, Diagnostics& found) const;
  PositionJetsOf<Scalar> with_derivatives(const PositionDescription& position,
                                          const Scalar& angle,
                                          Diagnostics& found) const;
  std::optional<PositionJetsOf<Scalar>> position(std::size_t index,
                                                 const Scalar& angle,
                                                 const SynthesisChoice& choice,
                                                 Diagnostics& found) const;

  const MechanismDescription& description_;
  const SynthesisDescription& task_;
  BasicParameterTable<Number> table_;
};

/// How many decimals the positions are written with: of places and of angles the number with the
/// most: short ones may have lost zeros at
/// their end. Whole numbers, formulas and parameters count as exact. The description is right by
/// itself (check).
LastDecimal last_decimal_of(const MechanismDescription& description);

/// How far a point may be off if the last decimals of its coordinates are rounded; zero where they
/// count as exact [length].
double rounding_of(const PointDescription& point, const MechanismDescription& description);

}  // namespace kinestat
