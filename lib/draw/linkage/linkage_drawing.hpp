// The drawing of a mechanism to scale: links, couplings, wheels, cables; paths, forces and drives.
//
// How a script moves a planar drawing. The picture has one group with `data-scale` k [px/m],
// `data-x0` X and `data-y0` Y [px]: the world point (x, y) [m] is drawn at (X + k x, Y - k y). What
// moves with a body stands in one or more groups `<g data-body="NAME-INDEX">`, INDEX counted from 0
// as in Topology::bodies, the ground's too. A body that has turned by θ and then moved by (u, v)
// [m] from where it is drawn, so that x' = R(θ) x + (u, v), gets the attribute
//   transform="matrix(c -s s c  X(1-c)-Ys+ku  Y(1-c)+Xs-kv)",   c = cos θ, s = sin θ
// on all its groups. Guides and slots stand in the groups of the bodies that have them. A cable is
// in groups `<g data-cable="COUPLING">` for a straight part and `<g data-wrap="NAME-INDEX">` for
// the part on a pulley, a spring in `<g data-spring="NAME">`, which a script hides or draws anew.
// Names, forces and drives of the drawn position stand in `<g data-layer="names">`, `"forces"`,
// `"drives"`, `"velocities"`; paths in `"paths"`, their points in the groups of their bodies; these
// are to be hidden or left as they are.
//
// What no such matrix moves, a spatial mechanism and the cables and springs of a planar one, is
// drawn anew for every position of LinkageOptions::frames, in a group `<g data-frame="K"
// display="none">`; shown, it stands for the `"still"` layers of a spatial mechanism, or for all
// cables and springs.
//
// That group of a spatial mechanism has the unit vectors to the right and upwards, `data-right="X Y
// Z"` and `data-up`: the world point p is drawn at (X + k right·p, Y - k up·p).
//
// With LinkageOptions::cycle no script is needed: the same groups move, and the frames take turns,
// by themselves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "draw/picture.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// The path of a point. World frame [m].
struct TracedPath {
  std::string name;  ///< "coupler.1"; written at its begin
  std::vector<Vec3> points;
  std::optional<BodyId> body;  ///< to which the point belongs
  Vec3 drawn = Vec3::Zero();   ///< the point in the drawn position, to which its link reaches
};

/// A position of a finite motion.
struct LinkagePosition {
  std::vector<BodyPose> poses;  ///< of each body
  std::vector<double> turns;    ///< in the plane: of each body about +z [rad], full turns counted
  Geometry geometry;            ///< moved to the poses
};

/// How a body of a planar mechanism goes through a cycle: a point of it, and its turn about that.
struct BodyTrack {
  Vec3 point = Vec3::Zero();  ///< as drawn [m]
  std::vector<Vec3> places;   ///< of the point, at each time of the cycle [m]
  std::vector<double> turns;  ///< since it was drawn, likewise [rad]
};

/// Positions through which a drawing goes over and over.
struct LinkageCycle {
  Cycle pace;
  std::vector<BodyTrack> tracks;    ///< of each body; empty in space
  std::vector<std::size_t> frames;  ///< at each time, index into LinkageOptions::frames
};

/// How wide the places of a mechanism are drawn at most [px].
inline constexpr double kDrawingWidth = 620.0;

/// What a drawing shows beside the mechanism.
struct LinkageOptions {
  std::optional<std::size_t> which;  ///< index into Analysis::cases: its forces and drives
  bool shows_forces = true;          ///< of the case, if it has actions
  bool shows_velocities = false;     ///< of the case, if it has motions
  bool shows_names = true;           ///< of bodies and couplings
  std::vector<TracedPath> paths;
  std::vector<Vec3> reach;  ///< points that the picture holds, such as all places in a motion [m]
  std::vector<std::vector<Vec3>> travel;  ///< of each coupling, where it comes [m]; or empty
  std::vector<LinkagePosition> stands;    ///< where it stands, and faintly in all but the first; or
                                          ///< empty: as drawn
  std::string remark;                     ///< beside the scale; or empty
  double width = kDrawingWidth;           ///< of the places of the mechanism, at most [px]
  std::vector<LinkagePosition> frames;
  std::optional<LinkageCycle> cycle;  ///< empty: the drawing stands still

  bool is_as_drawn() const { return stands.empty() && frames.empty(); }
};

/// To scale, planar mechanisms as they are, spatial ones in parallel projection with z upwards, in
/// the view from which their couplings stand apart best. Every mechanism has one.
Picture draw_linkage(const Analysis& analysis, const LinkageOptions& options = {});

}  // namespace kinestat
