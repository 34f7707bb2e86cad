// A cable, belt or chain as the user wrote it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// The sense of turning about +z, or about the axis given, of someone who follows the cable in the
/// order of its list.
enum class Wrap { clockwise, counterclockwise };

/// A point on a body where the cable ends or is fixed, or a pulley that it wraps.
struct CableStation {
  bool is_pulley = false;
  Name body;                           ///< the body, or the body of the pulley
  std::optional<PointDescription> at;  ///< of a pulley: default its body's first revolute coupling
  std::optional<Value> radius;         ///< the rest is of a pulley
  std::optional<Wrap> wrap;
  std::optional<AxisDescription> axis;
  bool slip = false;           ///< false: a drum or toothed wheel
  std::optional<Value> turns;  ///< whole ones that the cable makes beside the arc that is drawn
  std::optional<Value> friction;
  std::optional<Value> eta;              ///< efficiency of a sheave
  std::vector<PointDescription> points;  ///< none, or where the cable meets and leaves the pulley
  SourceRange where;
};

/// A cable, belt or chain through its stations.
struct CableDescription {
  Name name;
  std::vector<CableStation> over;
  bool closed = false;  ///< joins the last station to the first
  SourceRange where;
};

/// What the section `cables` adds to the couplings: the segment from `from` to `to`, or the
/// revolute coupling of the virtual link at the pulley `from`. Pulleys have their centre and axis
/// filled in from the revolute coupling of their body where the file leaves them out.
struct CablePart {
  int cable = 0;      ///< index in the section
  int segment = 0;    ///< counted from 1; 0: a virtual link
  int station = 0;    ///< index of `from`
  CableStation from;  ///< its centre is known unless it has points
  CableStation to;    ///< of a segment
};

/// How many straight segments it has, each a coupling of type cable.
int segment_count(const CableDescription& cable);

/// The name of a segment, counted from 1: "rope_1".
std::string segment_name(const CableDescription& cable, int segment);

/// The station at which a segment ends, counted from 1; it begins at station `segment` - 1.
std::size_t end_station(const CableDescription& cable, int segment);

/// Whether a segment between the two would join a body to itself. A slipping pulley has a virtual
/// link for each segment to end on, so that only what does not slip can be the same body.
bool is_same_end(const CableStation& a, const CableStation& b);

/// The virtual link at a slipping pulley.
struct VirtualLink {
  std::size_t station = 0;
  std::string name;  ///< of the link, and of the revolute coupling that it turns on
};

/// One for each slipping pulley, in the order of the cable: "rope_wheel"; where the cable slips
/// over the same wheel again, "rope_wheel_2".
std::vector<VirtualLink> virtual_links(const CableDescription& cable);

}  // namespace kinestat
