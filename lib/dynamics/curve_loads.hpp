// What loads and actions that follow curves are in a position.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "dynamics/load_state.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A curve, or a number made of curves, of which nothing can be said.
struct CurveObstacle {
  enum class Kind {
    outside,      ///< the place is beyond the points
    no_time,      ///< the motion is not in time
    no_position,  ///< of a freedom without a position
    no_speed,     ///< the case does not tell it
    no_value      ///< the expression has none there
  };

  Kind kind = Kind::outside;
  std::size_t curve = 0;    ///< index into Mechanism::curves; not of no_value
  std::string number = {};  ///< no_value: of which load or action
};

/// The numbers of a case that follow curves, where the mechanism stands.
struct CurveNumbers {
  std::vector<Load> loads;      ///< one a moving load of the case, in that order
  std::vector<double> actions;  ///< of each action that the case knows
  std::vector<double> springs;  ///< of each spring its `force`
};

/// The numbers that do not move stand among them. `which` has the points of its loads where they
/// are.
std::variant<CurveNumbers, CurveObstacle> curve_numbers(const Mechanism& mechanism,
                                                        const Case& which,
                                                        const LoadState& place);

}  // namespace kinestat
