// The section `synthesis`: linkages from multiply separated positions of a plane.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

enum class LinkageKind { any, four_bar, slider_crank, inverted_slider_crank };

/// One derivative of a pose by the parameter of the motion. Without `angle` (then in all of them)
/// the parameter is the angle itself; with it, radians per unit of the parameter.
struct PoseDerivative {
  PointDescription at;
  std::optional<Value> angle;
};

/// Curvature of the path of E = `at` (centre O_E) and of a free point F with its ratio m: together
/// they fix the second order of the motion (do Valle 1983). F or m may be absent if `vary` has it.
struct CurvatureDescription {
  PointDescription centre;
  std::optional<PointDescription> free_point;
  std::optional<Value> m;
  SourceRange where;
};

/// One position of the moving plane; each order of contact needs the one before.
struct PositionDescription {
  PointDescription at;
  std::vector<Value> angles;  ///< usually one; a list makes a task of each
  std::optional<PointDescription> pole;
  std::optional<CurvatureDescription> curvature;
  bool stationary = false;
  bool burmester = false;
  std::vector<PoseDerivative> derivatives;  ///< instead of pole, curvature, …
  SourceRange where;

  /// How many coincident positions it stands for: 1 for P, 2 for PP, … 5 for PPPPP.
  int order() const;
};

/// A free parameter of the task: a number m or a point, from … to.
struct SynthesisRange {
  Name name;
  std::vector<Value> from;  ///< one number, or the coordinates of a point
  std::vector<Value> to;
  SourceRange where;
};

struct SynthesisLimits {
  std::optional<Value> transmission_angle;  ///< least
  std::optional<Value> link_ratio;          ///< largest: longest by shortest link
  std::optional<Value> size;                ///< largest length
};

struct SynthesisDescription {
  LinkageKind linkage = LinkageKind::four_bar;
  std::vector<PositionDescription> positions;
  SynthesisLimits limits;
  std::vector<SynthesisRange> vary;
  std::optional<Value> curve_count;  ///< points of each curve
  SourceRange where;
};

}  // namespace kinestat
