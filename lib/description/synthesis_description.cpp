#include "description/synthesis_description.hpp"

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

int PositionDescription::order() const {
  if (!derivatives.empty()) {
    return 1 + static_cast<int>(derivatives.size());
  }
  return 1 + (pole ? 1 : 0) + (curvature ? 1 : 0) + (stationary ? 1 : 0) + (burmester ? 1 : 0);
}

}  // namespace kinestat
