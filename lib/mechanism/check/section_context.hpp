// What the checks of the sections work with: names, numbers and their bounds.
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

/// What a number may be, and how that is said.
struct NumberRule {
  QuantityKind kind = QuantityKind::dimensionless;
  NumberRange range;
  std::string_view allowed;  ///< "a whole number from 1 to 10000"
};

inline constexpr NumberRule kAnyLength = {
    .kind = QuantityKind::length, .range = kAnyNumber, .allowed = "a length"};

inline constexpr NumberRule kAnyAngle = {
    .kind = QuantityKind::angle, .range = kAnyNumber, .allowed = "an angle"};

inline constexpr NumberRule kAboveZeroLength = {
    .kind = QuantityKind::length, .range = kAboveZero, .allowed = "a length above zero"};

/// A number of a description, and what it may be.
struct CheckedNumber {
  Value value;
  NumberRule rule;
};

/// One description on its way through the checks.
struct SectionContext {
  const MechanismDescription& description;
  const DeclaredNames& names;
  Evaluator& evaluator;
  Diagnostics& found;
  std::vector<CheckedNumber>* checked = nullptr;  ///< where not null, what is looked at is noted:
                                                  ///< nothing else decides on these numbers

  /// The value in SI; empty if it is absent or an error was added. `what` begins the message:
  /// "'teeth' of gear member 'sun'".
  std::optional<double> number(const std::optional<Value>& value,
                               const NumberRule& rule,
                               std::string_view what) const;

  /// The components of a vector in SI; z is 0 in the plane. Empty if an error was added.
  std::optional<Vec3> vector(const std::vector<Value>& components, QuantityKind kind) const;

  /// Where a point is that decides nothing else, from the origin of the evaluator.
  std::optional<Vec3> place(const PointDescription& point) const;

  /// Evaluates the components of a vector.
  void components(const std::vector<Value>& values, QuantityKind kind) const;

  void point(const std::optional<PointDescription>& point) const;

  /// Complains of a name that stands in a list twice; answers whether any does.
  bool repeats(const std::vector<Name>& list, std::string_view what) const;

 private:
  std::optional<double> look_at(const Value& value, const NumberRule& rule) const;
};

}  // namespace kinestat
