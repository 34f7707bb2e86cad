// Plans of sweeps from the text of a file.
#pragma once

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "mechanism/bind/bind.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace kinestat {

/// A complaint is a failed test. The file has the parameters p, q = 2 p, length and angle.
inline SweepPlan plan_of(const std::string& sweep, const std::string& head = "") {
  const std::string text =
      "kinestat: 1\n" + head +
      "space: planar\n"
      "parameters: {p: 1, q: 2*p, r: 1, length: 1 mm, angle: 1 deg}\n"
      "ground: frame\n"
      "bodies: [crank]\n"
      "couplings: {a: {type: revolute, bodies: [frame, crank], at: [p*q*r*length, length*angle/"
      "(1 rad)]}}\n"
      "cases: {turn: {motion: {a.wz: 1}}}\n"
      "sweep: " +
      sweep + "\n";
  Diagnostics found;
  const auto tree = read_yaml({.path = "test", .text = text}, {}, found);
  const auto description = tree ? read_mechanism(*tree, found) : std::nullopt;
  const bool is_right = description && bind(*description, found);
  for (const Diagnostic& item : found.items()) {
    ADD_FAILURE() << item.code << ": " << item.message;
  }
  if (!is_right) {
    throw std::runtime_error("the file is wrong");
  }
  return SweepPlan(*description);
}

}  // namespace kinestat
