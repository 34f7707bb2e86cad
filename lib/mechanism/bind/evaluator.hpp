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

/// Evaluates numbers with the values of the parameters, which it holds. Results are empty iff an
/// error was added, for the number itself or for a parameter on which it depends. `Scalar` is
/// double or Dual.
template <class Scalar>
class EvaluatorOf {
 public:
  EvaluatorOf(const MechanismDescription& description,
              BasicParameterTable<Scalar> table,
              Diagnostics& found)
      : description_(description), found_(found), table_(std::move(table)) {}

  /// The same evaluator, with its messages in another list.
  EvaluatorOf complaining_to(Diagnostics& found) const;

  /// From now on points are measured from this origin. They are differences of the numbers as
  /// typed, so that rounding to double does not change the distances between points.
  void measure_from(const LocalOrigin& origin);

  std::optional<Scalar> number(const Value& value, QuantityKind kind);

  /// A number that may depend on these variables besides the parameters. The values of the
  /// variables are samples, at which its dimension is checked.
  std::optional<NumberLaw<Scalar>> law(const Value& value,
                                       QuantityKind kind,
                                       std::span<const LawVariable<Scalar>> variables);

  /// A number of any dimension, in SI.
  std::optional<BasicQuantity<Scalar>> quantity(const Value& value);

  /// A vector of up to three components, in SI.
  std::optional<Vec3Of<Scalar>> vector(const std::vector<Value>& components, QuantityKind kind);

  /// A point, measured from the origin [m]; z is 0 in the plane.
  std::optional<Vec3Of<Scalar>> point(const PointDescription& point);

  /// A point that is given by its coordinates in the world, measured from the origin [m].
  Vec3Of<Scalar> from_origin(const Vec3Of<Scalar>& in_world) const;

  /// From now on adds every number that it evaluates to `list`, until it is given null. Returns the
  /// list used before.
  std::vector<const Value*>* note_numbers(std::vector<const Value*>* list) {
    return std::exchange(noted_, list);
  }

  /// A unit vector; a zero vector is an error. Its components are of any one dimension, such as the
  /// differences of the coordinates of two points.
  std::optional<AxisOf<Scalar>> axis(const AxisDescription& axis);

  /// Warns of parameters that nothing refers to.
  void warn_of_unused() const;

  /// Adds E0316 for each number so far that has a value only by rounding. Only an evaluator of
  /// ExactInput finds such numbers.
  void refuse_values_by_rounding() const;

 private:
  std::optional<Vec3Of<Scalar>> direction(const std::vector<Value>& components);
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
  std::vector<const Value*> by_rounding_;  ///< numbers of which ExactInput knows no digits
  std::shared_ptr<const BasicParameterTable<ExactInput>>
      exact_input_;  ///< where the origin is not the world's
};

using Evaluator = EvaluatorOf<double>;

/// Makes an evaluator: evaluates the parameters, and adds an error for each that has no value.
Evaluator make_evaluator(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
