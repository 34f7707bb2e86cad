// What springs do in a position.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "dynamics/load_state.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/springs/spring_numbers.hpp"

namespace kinestat {

struct SpringState {
  double position = 0.0;  ///< length, or position of the freedom [m or rad]
  double rate = 0.0;
  double force = 0.0;  ///< tension [N]; of a freedom the action of tail on head [N or N·m]
};

/// What a spring does that acts one way alone.
template <class Scalar>
Scalar cut_off(SpringSense acts, const Scalar& tension) {
  using std::max;
  using std::min;
  switch (acts) {
    case SpringSense::both:
      return tension;
    case SpringSense::push:
      return min(tension, Scalar(0.0));
    case SpringSense::pull:
      return max(tension, Scalar(0.0));
  }
  return tension;
}

/// Of a gas spring of that length.
template <class Scalar>
Scalar gas_tension(const GasNumbersOf<Scalar>& gas, const Scalar& length) {
  using std::pow;
  const Scalar left = Scalar(1.0) - gas.hold * (gas.length - length) / gas.stroke;
  return -gas.force * pow(left, -gas.exponent);
}

/// Of a spring between two points, by its length and how fast that grows; `hold` of a gas spring is
/// not looked at. Where one that acts one way alone would not act at rest, its ends are apart, and
/// its damper does nothing; a damper without a spring knows no such place.
template <class Scalar>
Scalar tension_of(const SpringNumbersOf<Scalar>& spring,
                  SpringSense acts,
                  const Scalar& length,
                  const Scalar& rate) {
  Scalar at_rest = spring.stiffness * (length - spring.free) - spring.force;
  if (spring.gas) {
    at_rest = at_rest + gas_tension(*spring.gas, length);
  }
  const bool has_left = cut_off(acts, value_of(at_rest)) != value_of(at_rest);
  return has_left ? Scalar(0.0) : cut_off(acts, Scalar(at_rest + spring.damping * rate));
}

/// Of tail on head, of a spring of a freedom.
template <class Scalar>
Scalar action_of(const SpringNumbersOf<Scalar>& spring,
                 const Scalar& position,
                 const Scalar& rate) {
  return spring.force - spring.stiffness * (position - spring.free) - spring.damping * rate;
}

/// A spring of which nothing can be said.
struct SpringObstacle {
  enum class Kind {
    no_length,    ///< its points meet, so that it has no direction
    past_stroke,  ///< a gas spring is shorter or longer than it can be
    no_position,  ///< of a freedom without a position
    no_speed      ///< of a damper whose ends have no speed
  };

  Kind kind = Kind::no_length;
  std::size_t spring = 0;
  double length = 0.0;  ///< the distance of its points, past the stroke [m]
};

/// Of each spring of a mechanism that stands there; `forces` are what each has beside stiffness and
/// damping (curve_numbers).
std::variant<std::vector<SpringState>, SpringObstacle> spring_states(
    const Mechanism& drawn, const LoadState& place, std::span<const double> forces);

/// What a spring does in a position of which no speeds are known, as of a SpringState.
struct PlacedSpring {
  std::optional<double> position;  ///< empty of a freedom without one
  std::optional<double> force;     ///< empty where it follows speeds or curves, or has none there
};

PlacedSpring placed_spring(const Spring& spring, const LoadState& place);

/// What the stiffness or the gas of a spring holds at that length or position [J]; none where they
/// act not.
double stored_energy(const Spring& spring, double position);

/// How that grows with the position: the tension without damping [N], or minus the action of a
/// freedom [N or N·m].
double elastic_tension(const Spring& spring, double position);

/// Their forces on the bodies they join, as loads spring.NAME, or spring.NAME.BODY where both move;
/// the names are `spring_load_names`, in that order.
/// `moved` has the screws of the position.
std::vector<Load> spring_loads(const Mechanism& moved,
                               const LoadState& place,
                               const std::vector<SpringState>& states);

std::vector<std::string> spring_load_names(const Mechanism& mechanism);

}  // namespace kinestat
