// Paths of the report below a case, and what stands at their end.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "studies/sensitivity/reported_value.hpp"

namespace kinestat {

/// A path at its slashes.
using PathParts = std::vector<std::string>;

/// Without its name.
inline std::optional<ReportedValue> as_value(QuantityKind kind, const std::optional<Dual>& value) {
  return value ? std::optional(
                     ReportedValue{.name = {}, .kind = kind, .per = std::nullopt, .value = *value})
               : std::nullopt;
}

/// Empty where the divisor is zero.
std::optional<ReportedValue> quotient(const Dual& a,
                                      QuantityKind of_a,
                                      const Dual& b,
                                      QuantityKind of_b);

/// One component of vectors that stand behind each other, by the last part of a path.
std::optional<ReportedValue> component(
    const PathParts& parts, const std::vector<std::pair<QuantityKind, Vec3Of<Dual>>>& vectors);

/// Which of `count` things has the name that name(i) gives.
template <class Name>
std::optional<std::size_t> index_where(std::size_t count, const std::string& text, Name name) {
  for (std::size_t i = 0; i < count; ++i) {
    if (name(static_cast<int>(i)) == text) {
      return i;
    }
  }
  return std::nullopt;
}

/// Which of the items has that name.
template <class Items>
std::optional<std::size_t> index_of(const Items& items, const std::string& name) {
  return index_where(items.size(), name, [&](int i) -> const std::string& {
    return items[static_cast<std::size_t>(i)].name;
  });
}

/// The formula at a path that begins with "kinematics", "statics" or "power", its name left out.
/// The case must have the motions, the actions or both.
std::optional<ReportedValue> find_kinematic_value(const DualCase& values, const PathParts& parts);
std::optional<ReportedValue> find_static_value(const DualCase& values, const PathParts& parts);
std::optional<ReportedValue> find_power_value(const DualCase& values, const PathParts& parts);

}  // namespace kinestat
