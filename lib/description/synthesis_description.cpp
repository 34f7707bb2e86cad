#include "description/synthesis_description.hpp"

#include <fmt/format.h>

#include "core/one_digit.hpp"

namespace kinestat {

std::string_view word_of(FreeNumber which) {
  switch (which) {
    case FreeNumber::m:
      return "m";
    case FreeNumber::free_point:
      return "free_point";
    case FreeNumber::s:
      return "s";
    case FreeNumber::tau:
      return "tau";
    case FreeNumber::tau_2:
      return "tau_2";
    case FreeNumber::circle_points:
      return "circle_points";
    case FreeNumber::centre_points:
      return "centre_points";
  }
  return "";
}

std::string_view word_of(GrashofClass which) {
  switch (which) {
    case GrashofClass::crank_rocker:
      return "crank_rocker";
    case GrashofClass::double_crank:
      return "double_crank";
    case GrashofClass::double_rocker:
      return "double_rocker";
    case GrashofClass::triple_rocker:
      return "triple_rocker";
    case GrashofClass::change_point:
      return "change_point";
  }
  return "";
}

std::string_view word_of(LinkageCircuit which) {
  switch (which) {
    case LinkageCircuit::open:
      return "open";
    case LinkageCircuit::crossed:
      return "crossed";
    case LinkageCircuit::left:
      return "left";
    case LinkageCircuit::right:
      return "right";
    case LinkageCircuit::single:
      return "single";
  }
  return "";
}

QuantityKind kind_of(FreeNumber which) {
  const bool is_length = is_point(which) || which == FreeNumber::s;
  return is_length ? QuantityKind::length : QuantityKind::dimensionless;
}

bool is_point(FreeNumber which) {
  return which == FreeNumber::free_point || chooses_dyads(which);
}

bool chooses_dyads(FreeNumber which) {
  return which == FreeNumber::circle_points || which == FreeNumber::centre_points;
}

std::string example_of_ranges(int order, double radius) {
  const double end = radius > 0.0 ? round_up_to_one_digit(2.0 * radius) : 1.0;
  std::string text = fmt::format("vary: {{s: {{from: -{0:.15g}, to: {0:.15g}}}", end);
  for (const FreeNumber which : {FreeNumber::tau, FreeNumber::tau_2}) {
    const int from = which == FreeNumber::tau ? 4 : 5;
    text += order >= from ? fmt::format(", {}: {{from: -1, to: 1}}", word_of(which)) : "";
  }
  return text + "}";
}

int PositionDescription::order() const {
  if (!derivatives.empty()) {
    return 1 + static_cast<int>(derivatives.size());
  }
  return 1 + (pole ? 1 : 0) + (curvature ? 1 : 0) + (stationary ? 1 : 0) + (burmester ? 1 : 0);
}

}  // namespace kinestat
