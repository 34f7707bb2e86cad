// Mechanisms from the text of a file, through the reader and the binder.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "mechanism/bind/bind.hpp"

namespace kinestat {

/// A complaint of reader or binder is a failed test and an empty mechanism.
inline Mechanism mechanism_of(const std::string& text) {
  const SourceFile source{.path = "test", .text = "kinestat: 1\n" + text};
  Diagnostics found;
  const std::optional<YamlNode> tree = read_yaml(source, {}, found);
  std::optional<MechanismDescription> description;
  if (tree) {
    description = read_mechanism(*tree, found);
  }
  std::optional<Mechanism> mechanism;
  if (description) {
    mechanism = bind(*description, found);
  }
  for (const Diagnostic& item : found.items()) {
    ADD_FAILURE() << item.code << " in line " << item.where.line << ": " << item.message;
  }
  return mechanism.value_or(Mechanism{});
}

/// The number of "a.wz"; a failed test and -1 if there is none.
inline int freedom_index(const Mechanism& mechanism, std::string_view name) {
  for (int f = 0; f < mechanism.topology.freedom_count(); ++f) {
    if (mechanism.topology.freedom_name(f) == name) {
      return f;
    }
  }
  ADD_FAILURE() << "no freedom " << name;
  return -1;
}

/// The number of "a.Rx" or of an actuator's action.
inline int action_index(const Mechanism& mechanism, std::string_view name) {
  for (int a = 0; a < mechanism.topology.action_count(); ++a) {
    if (mechanism.topology.action_name(a) == name) {
      return a;
    }
  }
  ADD_FAILURE() << "no action " << name;
  return -1;
}

inline Primary known_motion(const Mechanism& mechanism, std::string_view name, double value) {
  Primary primary;
  primary.index = freedom_index(mechanism, name);
  primary.value = value;
  return primary;
}

inline Primary known_action(const Mechanism& mechanism, std::string_view name, double value) {
  Primary primary;
  primary.index = action_index(mechanism, name);
  primary.value = value;
  return primary;
}

/// Crank pin at (9, 12), slider pin at (14, 0): crank 15, rod 13, all in m.
inline const std::string kSliderCrank =
    "space: planar\n"
    "ground: frame\n"
    "bodies: [crank, rod, slider]\n"
    "couplings:\n"
    "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
    "  b: {type: revolute, bodies: [crank, rod], at: [9, 12]}\n"
    "  c: {type: revolute, bodies: [rod, slider], at: [14, 0]}\n"
    "  d: {type: prismatic, bodies: [frame, slider], at: [14, 0], axis: x}\n"
    "actuators:\n"
    "  Tin: {coupling: a}\n"
    "  Fout: {coupling: d}\n";

/// A lever on a fulcrum at the origin between two sliders that push it along y at x = -2 and x = 3.
/// The sliders touch it by a pin that slides along x on the lever.
inline const std::string kLever =
    "space: planar\n"
    "ground: frame\n"
    "bodies: [lever, left, pin, right, peg]\n"
    "couplings:\n"
    "  fulcrum: {type: revolute, bodies: [frame, lever], at: [0, 0]}\n"
    "  l: {type: prismatic, bodies: [frame, left], at: [-2, 0], axis: y}\n"
    "  lp: {type: revolute, bodies: [left, pin], at: [-2, 0]}\n"
    "  ls: {type: prismatic, bodies: [pin, lever], at: [-2, 0], axis: x}\n"
    "  r: {type: prismatic, bodies: [frame, right], at: [3, 0], axis: y}\n"
    "  rp: {type: revolute, bodies: [right, peg], at: [3, 0]}\n"
    "  rs: {type: prismatic, bodies: [peg, lever], at: [3, 0], axis: x}\n"
    "actuators:\n"
    "  push: {coupling: l}\n"
    "  load: {coupling: r}\n";

}  // namespace kinestat
