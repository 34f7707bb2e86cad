// What values of a motion come to towards a place where they end: a limit, or without bound.
#pragma once

#include <array>
#include <functional>
#include <optional>

namespace kinestat {

/// Where values grow without bound, or fall.
struct Growth {
  bool falls = false;
  bool grows = false;

  bool has_any() const { return falls || grows; }
};

/// A value where that share of the way from a position that has it to one that has none is left;
/// empty where there is none.
using ValueLeft = std::function<std::optional<double>(double left)>;

/// What values look like before a position that has none.
struct ValueEnd {
  Growth growth = {};
  double left = 0.0;                 ///< of the way, where the values end
  std::optional<double> value = {};  ///< what they come to there; empty where they grow or fall
};

/// Of values with half of the way left each, the last the nearest: each adds more than the last.
Growth growth_of(const std::array<double, 3>& values);

/// Looks as near to the end as there are values, of which `size` is the largest. Where they end
/// before is found by bisection; where they are only lost there, as `is_lost` says of so much that
/// is left of the way, they come to what they are at the end of the way.
ValueEnd find_value_end(const ValueLeft& value,
                        double size,
                        const std::function<bool(double left)>& is_lost);

}  // namespace kinestat
