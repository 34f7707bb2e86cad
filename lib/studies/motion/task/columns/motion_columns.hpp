// The columns of a finite motion: what each is, and its value in a position.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "expression/file_units.hpp"
#include "studies/motion/peak_search.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// A column and how its value is read [SI]: at each position the components of a vector one after
/// the other, the first of a list first.
/// What a quotient is made of at a position, with signs.
struct QuotientParts {
  double dividend = 0.0;
  double divisor = 0.0;
};

struct MotionReading {
  MotionColumn column;
  QuantityKind kind = QuantityKind::dimensionless;
  std::function<std::optional<double>(const MotionPosition&)> value;
  std::optional<MotionDetail> needs = {};  ///< what must be worked out for it alone; empty: all
  std::optional<ValueFolds> folds = {};
  bool is_idle = false;         ///< without values, as nothing determines it
  bool is_size = false;         ///< without its sign
  bool is_of_friction = false;  ///< open where friction has no direction, whatever acts without it
  bool is_bounded = false;    ///< nothing makes it grow without bound, but it may end between steps
  bool is_of_motion = false;  ///< whatever acts
  bool is_checked = false;    ///< its mean by half of the steps, too
  std::function<std::optional<QuotientParts>(const MotionPosition&)> parts = {};  ///< of a quotient
  std::function<std::optional<double>(const MotionPosition&)> alone =
      {};  ///< of a component: reads
           ///< it before the others
};

/// Of freedoms, bodies and points.
constexpr bool is_rate(QuantityKind kind) {
  return kind == QuantityKind::angular_velocity || kind == QuantityKind::velocity;
}

constexpr bool is_rate_of_rate(QuantityKind kind) {
  return kind == QuantityKind::angular_acceleration || kind == QuantityKind::acceleration;
}

/// Of where freedoms, bodies and points are.
inline bool is_place(const MotionColumn& column) {
  return column.quantity == "position" || column.quantity.starts_with("at/") ||
         column.quantity.starts_with("rotation/");
}

/// All columns but those of the drives. `first` is the first position: freedoms without a position
/// there have no column for it.
std::vector<MotionReading> motion_readings(const MechanismDescription& description,
                                           const Mechanism& mechanism,
                                           const MotionPlan& plan,
                                           const MotionPosition& first);

}  // namespace kinestat
