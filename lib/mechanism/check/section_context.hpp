// The data that the checks of sections share: names, numbers and their ranges.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "description/number_range.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/check/declared_names.hpp"

namespace kinestat {

/// The range that a number may have, and its words in messages.
struct NumberRule {
  QuantityKind kind = QuantityKind::dimensionless;
  NumberRange range;
  std::string_view allowed;  ///< "a whole number from 1 to 10000"
};

inline constexpr NumberRule kAnyLength = {
    .kind = QuantityKind::length, .range = kAnyNumber, .allowed = "a length"};

inline constexpr NumberRule kAnyAngle = {
    .kind = QuantityKind::angle, .range = kAnyNumber, .allowed = "an angle"};

inline constexpr NumberRule kDuration = {
    .kind = QuantityKind::time, .range = kAboveZero, .allowed = "a time above zero"};

inline constexpr NumberRule kStepCount = {.kind = QuantityKind::dimensionless,
                                          .range = kSteps,
                                          .allowed = "a whole number from 1 to 1000000"};

inline constexpr NumberRule kAboveZeroLength = {
    .kind = QuantityKind::length, .range = kAboveZero, .allowed = "a length above zero"};

/// A number of a description with its rule.
struct CheckedNumber {
  Value value;
  NumberRule rule;
};

/// A description during its checks.
struct SectionContext {
  const MechanismDescription& description;
  const DeclaredNames& names;
  Evaluator& evaluator;
  Diagnostics& found;
  std::vector<CheckedNumber>* checked = nullptr;  ///< if not null, receives the numbers that only
                                                  ///< their own rule decides on

  /// Evaluates a number [SI] and checks its rule. Empty if it is absent or an error was added.
  /// `what` begins the message: "'teeth' of gear member 'sun'".
  std::optional<double> number(const std::optional<Value>& value,
                               const NumberRule& rule,
                               std::string_view what) const;

  /// The components of a vector in SI; z is 0 in the plane. Empty if an error was added.
  std::optional<Vec3> vector(const std::vector<Value>& components, QuantityKind kind) const;

  /// Evaluates a point on which no other check depends [m], from the origin of the evaluator.
  std::optional<Vec3> place(const PointDescription& point) const;

  /// Evaluates the components of a vector.
  void components(const std::vector<Value>& values, QuantityKind kind) const;

  void point(const std::optional<PointDescription>& point) const;

  /// Whether a name occurs twice in a list; adds an error if so.
  bool repeats(const std::vector<Name>& list, std::string_view what) const;

 private:
  std::optional<double> look_at(const Value& value, const NumberRule& rule) const;
};

}  // namespace kinestat
