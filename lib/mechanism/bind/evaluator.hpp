// Evaluates the numbers of a description, with complaints at their places.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostic.hpp"
#include "couplings/coupling_geometry.hpp"
#include "description/mechanism_description.hpp"
#include "expression/parameters.hpp"

namespace kinestat {

/// Holds the values of the parameters. Answers are empty iff an error was added, here or for the
/// parameter that the number depends on. `Scalar` is double or Dual.
template <class Scalar>
class EvaluatorOf {
 public:
  EvaluatorOf(const MechanismDescription& description,
              BasicParameterTable<Scalar> table,
              Diagnostics& found)
      : description_(description), found_(found), table_(std::move(table)) {}

  std::optional<Scalar> number(const Value& value, QuantityKind kind);

  /// In SI, whatever it measures.
  std::optional<BasicQuantity<Scalar>> quantity(const Value& value);

  /// Up to three components.
  std::optional<Vec3Of<Scalar>> vector(const std::vector<Value>& components, QuantityKind kind);

  /// [m], in the world frame; z is 0 in the plane.
  std::optional<Vec3Of<Scalar>> point(const PointDescription& point);

  /// A unit vector; a zero vector is an error.
  std::optional<AxisOf<Scalar>> axis(const AxisDescription& axis);

  /// Warns of parameters that nothing refers to.
  void warn_of_unused() const;

 private:
  void warn_of_degrees(const Value& value, double angle);
  std::span<const std::string> known_names() const;  // that a hint may suggest

  const MechanismDescription& description_;
  Diagnostics& found_;
  BasicParameterTable<Scalar> table_;
};

using Evaluator = EvaluatorOf<double>;

/// Evaluates the parameters; complains of those that have no value.
Evaluator make_evaluator(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
