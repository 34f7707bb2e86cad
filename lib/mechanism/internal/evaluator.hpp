// Evaluates the numbers of a description, with complaints at their places.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "expression/parameters.hpp"
#include "mechanism/coupling_catalogue.hpp"

namespace kinestat {

/// Holds the values of the parameters. Answers are empty iff an error was added, here or for the
/// parameter that the number depends on.
class Evaluator {
 public:
  Evaluator(const MechanismDescription& description, Diagnostics& found);

  std::optional<double> number(const Value& value, QuantityKind kind);

  /// In SI, whatever it measures.
  std::optional<Quantity> quantity(const Value& value);

  /// [m], in the world frame; z is 0 in the plane.
  std::optional<Vec3> point(const PointDescription& point);

  /// A unit vector; a zero vector is an error.
  std::optional<Axis> axis(const AxisDescription& axis);

  /// Warns of parameters that nothing refers to.
  void warn_of_unused() const;

 private:
  void warn_of_degrees(const Value& value, double angle);
  std::span<const std::string> known_names() const;  // that a hint may suggest
  void report(const ParameterDescription& parameter, const ExpressionError& error);
  std::optional<Vec3> vector(const std::vector<Value>& components, QuantityKind kind);

  const MechanismDescription& description_;
  Diagnostics& found_;
  ParameterTable table_;
};

}  // namespace kinestat
