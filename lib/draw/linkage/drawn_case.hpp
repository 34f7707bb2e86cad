// What of a case its drawing shows: forces, couples, drives and velocities, without rounding.
#pragma once

#include <string>
#include <vector>

#include "draw/linkage/linkage_drawing.hpp"

namespace kinestat {

enum class ArrowKind {
  reaction,  ///< of tail on head, in a coupling
  load,      ///< from outside
  actuator,  ///< that of an actuator
  drive,     ///< the motion of an input
  velocity   ///< of the point of a body
};

/// A vector at a point; or an axial vector: a couple, a turning.
struct DrawnArrow {
  ArrowKind kind = ArrowKind::reaction;
  Vec3 at = Vec3::Zero();      ///< [m], world frame
  Vec3 vector = Vec3::Zero();  ///< [N], [m/s], or about it [N·m], [rad/s]
  bool is_axial = false;
  std::string name;  ///< of the load, the actuator, the drive; else empty
  std::string text;  ///< "250 N"; with that name before it
};

/// The arrows of the case that the options choose; none without one. What is rounding is left out.
std::vector<DrawnArrow> find_arrows(const Analysis& analysis, const LinkageOptions& options);

/// Loads and, where they are known, actions of actuators in a solved case of the mechanism, which
/// may be moved; also those that are rounding beside others.
std::vector<DrawnArrow> find_outer_actions(const MechanismDescription& description,
                                           const Mechanism& mechanism,
                                           const CaseAnalysis& one);

}  // namespace kinestat
