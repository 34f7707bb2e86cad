// Where something that is positive becomes negative.
#pragma once

#include <functional>
#include <optional>

namespace kinestat {

/// Two places between which it becomes negative: it is at the second, and not yet at the first.
struct SignChange {
  double before = 0.0;
  double behind = 0.0;
};

/// Empty where there is none.
using ValueAt = std::function<std::optional<double>(double place)>;

/// The first on the way from a place at which it is not negative. It is looked at in so many parts,
/// and at the bottom of each dip between them, where it may become negative and positive again;
/// dips that are no deeper than rounding are none, and those within a 64th of a part of an end are
/// not seen.
std::optional<SignChange> find_crossing(const ValueAt& value, double from, double to, int parts);

}  // namespace kinestat
