// Evaluates the numbers of a description, with complaints at their places.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostic.hpp"
#include "couplings/coupling_geometry.hpp"
#include "description/mechanism_description.hpp"
#include "expression/number_law.hpp"
#include "expression/parameters.hpp"
#include "screw/local_origin.hpp"

namespace kinestat {

struct ExactInput;

/// Holds the values of the parameters. Answers are empty iff an error was added, here or for the
/// parameter that the number depends on. `Scalar` is double or Dual.
template <class Scalar>
class EvaluatorOf {
 public:
  EvaluatorOf(const MechanismDescription& description,
              BasicParameterTable<Scalar> table,
              Diagnostics& found)
      : description_(description), found_(found), table_(std::move(table)) {}

  /// The same numbers, with complaints elsewhere.
  EvaluatorOf complaining_to(Diagnostics& found) const;

  /// From now on points are measured from there: differences of the numbers as typed, so that
  /// rounding to double takes nothing from what lies between the points.
  void measure_from(const LocalOrigin& origin);

  std::optional<Scalar> number(const Value& value, QuantityKind kind);

  /// A number that may name these quantities beside the parameters: their values here are samples,
  /// at which its dimension is checked.
  std::optional<NumberLaw<Scalar>> law(const Value& value,
                                       QuantityKind kind,
                                       std::span<const LawVariable<Scalar>> variables);

  /// In SI, whatever it measures.
  std::optional<BasicQuantity<Scalar>> quantity(const Value& value);

  /// Up to three components.
  std::optional<Vec3Of<Scalar>> vector(const std::vector<Value>& components, QuantityKind kind);

  /// [m], from the origin; z is 0 in the plane.
  std::optional<Vec3Of<Scalar>> point(const PointDescription& point);

  /// Of a point whose coordinates in the world are known [m].
  Vec3Of<Scalar> from_origin(const Vec3Of<Scalar>& in_world) const;

  /// From now on the numbers that it is asked for are noted there, until it is given null. Answers
  /// where they were noted before.
  std::vector<const Value*>* note_numbers(std::vector<const Value*>* list) {
    return std::exchange(noted_, list);
  }

  /// A unit vector; a zero vector is an error.
  std::optional<AxisOf<Scalar>> axis(const AxisDescription& axis);

  /// Warns of parameters that nothing refers to.
  void warn_of_unused() const;

  /// E0316 for each number so far that has a value by rounding alone: only ExactInput sees any.
  void refuse_values_by_rounding() const;

 private:
  void complain(const Value& value, const ExpressionError& error);
  void warn_of_degrees(const Value& value, double angle);
  void mark_used(const Value& value);
  std::optional<double> from_origin(const Value& coordinate, double origin) const;
  std::span<const std::string> known_names() const;  // that a hint may suggest

  const MechanismDescription& description_;
  Diagnostics& found_;
  BasicParameterTable<Scalar> table_;
  LocalOrigin origin_;
  std::vector<const Value*>* noted_ = nullptr;
  std::vector<const Value*> by_rounding_;  ///< of which ExactInput knows no digits
  std::shared_ptr<const BasicParameterTable<ExactInput>>
      exact_input_;  ///< where the origin is not the world's
};

using Evaluator = EvaluatorOf<double>;

/// Evaluates the parameters; complains of those that have no value.
Evaluator make_evaluator(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
