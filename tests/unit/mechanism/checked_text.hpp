// What the checks of the sections say about the text of a mechanism.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "mechanism/cables/internal/cable_check.hpp"
#include "mechanism/cases/load_binder.hpp"
#include "mechanism/check/section_checks.hpp"
#include "mechanism/curves/curve_binder.hpp"
#include "mechanism/gears/internal/gear_check.hpp"
#include "mechanism/inertia/mass_binder.hpp"
#include "support/read_text.hpp"

namespace kinestat {

/// A gear set on two shafts with a clutch and a brake, and a slider; sections follow from line 30.
inline std::string gear_set(const std::string& sections) {
  const std::string head =
      "kinestat: 1\n"
      "space: spatial\n"
      "units: {length: mm, angle: deg}\n"
      "parameters: {N1: 19, N2: 15, alpha: 20 deg, T: 100 N*m}\n"
      "ground: housing\n"
      "bodies: [sun, planet, ring, carrier, shaft, block]\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [housing, sun], at: [0, 0, 0], axis: z}\n"
      "  c: {type: revolute, bodies: [housing, carrier], at: [0, 0, 9], axis: z}\n"
      "  p: {type: revolute, bodies: [carrier, planet], at: 5, axis: z}\n"
      "  s: {type: revolute, bodies: [housing, shaft], at: [0, 0, -9], axis: z}\n"
      "  slide: {type: prismatic, bodies: [housing, block], axis: y}\n"
      "  C1: {type: clutch, bodies: [shaft, sun], at: [0, 0, -1], axis: z}\n"
      "  B1: {type: brake, bodies: [housing, ring], at: [0, 0, 4], axis: z}\n"
      "actuators: {in: {coupling: s}, out: {coupling: c}, lift: {coupling: slide}}\n"
      "cases: {low: {motion: {in: 1}}, high: {motion: {in: 2}}}\n";
  return head + std::string(13, '\n') + sections;
}

/// What bind does beside the structure and the cases.
inline void check_all_sections(const MechanismDescription& description,
                               Evaluator& evaluator,
                               Diagnostics& found) {
  const DeclaredNames names = declare_names(description, found);
  const SectionContext context = {
      .description = description, .names = names, .evaluator = evaluator, .found = found};
  (void)check_gears(context);
  (void)check_cables(context);
  check_sections(context);
  (void)bind_loads(context, bind_masses(context), bind_curves(context, nullptr));
}

/// Errors of the reader are a failed test.
inline Diagnostics check_of(const std::string& text) {
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, found);
  const auto description = root ? read_mechanism(*root, found) : std::nullopt;
  EXPECT_EQ(complaints_of(found), Complaints{});
  if (description) {
    Evaluator evaluator = make_evaluator(*description, found);
    check_all_sections(*description, evaluator, found);
  }
  return found;
}

/// What is wrong with sections that follow the gear set.
inline Complaints complaints_about(const std::string& sections) {
  return complaints_of(check_of(gear_set(sections)));
}

}  // namespace kinestat
