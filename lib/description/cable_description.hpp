// A rope, belt or chain as the user wrote it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// The sense of turning about +z, or about the axis given, of someone who follows the rope in the
/// order of its list.
enum class Wrap { clockwise, counterclockwise };

/// A point on a body where the rope ends or is fixed, or a pulley that it wraps.
struct CableStation {
  bool is_pulley = false;
  Name body;                           ///< the body, or the body of the pulley
  std::optional<PointDescription> at;  ///< of a pulley: default its body's first revolute coupling
  std::optional<Value> radius;         ///< the rest is of a pulley
  std::optional<Wrap> wrap;
  std::optional<AxisDescription> axis;
  bool slip = false;  ///< false: a drum or toothed wheel
  std::optional<Value> friction;
  std::optional<Value> eta;              ///< efficiency of a sheave
  std::vector<PointDescription> points;  ///< none, or where the rope meets and leaves the pulley
  SourceRange where;
};

struct CableDescription {
  Name name;
  std::vector<CableStation> over;
  bool closed = false;  ///< joins the last station to the first
  SourceRange where;
};

/// How many straight segments it has, each a coupling of type cable.
int segment_count(const CableDescription& cable);

/// The name of a segment, counted from 1: "rope_1".
std::string segment_name(const CableDescription& cable, int segment);

/// The name of the virtual link at a slipping pulley, and of the revolute coupling that it turns
/// on: "rope_wheel"; where the rope slips over the same wheel again, "rope_wheel_2".
std::string virtual_link_name(const CableDescription& cable, std::size_t station);

}  // namespace kinestat
