// What acts along a finite motion, as moving drawings of the mechanism show it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "draw/linkage/drawn_case.hpp"

namespace kinestat {

/// A force at a point, or a couple, in one position.
struct PlacedVector {
  Vec3 at = Vec3::Zero();      ///< [m], world frame
  Vec3 vector = Vec3::Zero();  ///< [N], or about it [N·m]
};

/// One force or couple along the motion.
struct ActingArrow {
  ArrowKind kind = ArrowKind::reaction;  ///< reaction, load or actuator
  std::string name;                      ///< of the coupling, the load, the actuator
  bool is_axial = false;
  std::vector<std::optional<PlacedVector>> at;  ///< of each position; empty: not known there
};

struct DrawnActions {
  std::vector<ActingArrow> arrows;  ///< none where nothing asks for actions
  std::vector<std::string> doubts;  ///< of each position: why nothing is known, or why it cannot be
                                    ///< so; empty where all is well
};

}  // namespace kinestat
