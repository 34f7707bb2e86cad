// What a linkage of a synthesis must keep to, as the file says.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// The corners of a polygon, or two opposite ones of a rectangle along the axes.
struct AreaDescription {
  std::vector<PointDescription> corners;
  SourceRange where;
};

enum class GrashofClass {
  crank_rocker,   ///< the shortest link is a crank
  double_crank,   ///< the shortest link is the ground (drag link)
  double_rocker,  ///< the shortest link is the coupler, which turns fully
  triple_rocker,  ///< not Grashof: no link turns fully
  change_point    ///< shortest and longest equal the other two: a position with all in line
};

/// The word in files and reports.
std::string_view word_of(GrashofClass which);

/// In which circuit a linkage is assembled: all poses that it can reach without being taken apart.
/// Two circuits are mirror images of each other. Whether links cross is no property of a circuit,
/// as it changes within each. What Norton calls open and crossed is how the links next to the
/// shortest one lie where the crank is a little counterclockwise of the line of centres, and that
/// tells circuits apart.
enum class LinkageCircuit {
  open,     ///< with a crank: the circle point of the output lies left of the line from that of the
            ///< crank to the output's centre; with a slider or inverted slider: ahead of the crank
  crossed,  ///< its mirror image
  left,     ///< of a double rocker: both circle points left of the line from input to output
  right,    ///< its mirror image
  single    ///< all poses are connected
};

/// The word in files and reports.
std::string_view word_of(LinkageCircuit which);

struct SynthesisLimits {
  std::optional<Value> transmission_angle;       ///< least, from the first to the last position
  std::optional<Value> full_transmission_angle;  ///< least, wherever the input goes
  std::optional<Value> link_ratio;               ///< largest: longest by shortest link
  std::optional<Value> size;                     ///< largest length
  std::vector<GrashofClass> classes;             ///< of a four-bar; empty: any
  std::vector<LinkageCircuit> circuits;          ///< empty: any
  bool turns_fully = false;                      ///< the input
  std::optional<AreaDescription> circle_points;
  std::optional<AreaDescription> centre_points;
};

}  // namespace kinestat
