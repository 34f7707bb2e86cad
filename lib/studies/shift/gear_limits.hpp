// What a gear takes of the limits of the section `shift`.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "studies/shift/solved_gear.hpp"

namespace kinestat {

/// An element, a shaft or a planet that has a limit.
struct LimitedPart {
  ShiftLimit limit;  ///< whose index names it
  BodyId seen_from;  ///< of speeds: the ground, or the carrier of a planet
};

/// What a gear takes of one limit.
struct LimitUse {
  LimitedPart part;
  std::optional<double> size;  ///< [N·m or rad/s]; empty where the case does not tell it
  bool is_open = false;        ///< as it is a speed that the gear leaves open: it uses nothing
  bool has_losses = false;     ///< it is a torque that losses of meshes make larger

  /// Above 1 the limit is exceeded.
  std::optional<double> use() const;

  /// By more than rounding.
  bool is_exceeded() const;
};

/// Whose limits count, those for all part by part. A limit of planets that names what is none has
/// no part.
std::vector<LimitedPart> find_limited_parts(const Mechanism& mechanism, const ShiftPlan& plan);

/// In the order of the file.
std::vector<LimitUse> find_limit_uses(const SolvedGear& gear);

/// The largest; of equal ones the first. Null where a value is missing that is not open, or there
/// are none.
const LimitUse* find_largest_use(std::span<const LimitUse> uses);

/// "torque.C1", "planet_speed.planet".
std::string name_of(const LimitedPart& part, const ShiftPlan& plan, const Topology& topology);

/// "C1"
const std::string& owner_of(const LimitedPart& part,
                            const ShiftPlan& plan,
                            const Topology& topology);

}  // namespace kinestat
