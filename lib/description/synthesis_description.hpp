// The section `synthesis`: linkages from multiply separated positions of a plane, or transmissions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/synthesis_limits_description.hpp"
#include "description/transmission_description.hpp"
#include "description/value.hpp"

namespace kinestat {

enum class LinkageKind { any, four_bar, slider_crank, inverted_slider_crank };

/// One derivative of a pose by the parameter of the motion. Without `angle` (then in all of them)
/// the parameter is the angle itself, in radians; with it, angles per unit of the parameter.
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

/// Points of a dyad that the user gives: one where three or four positions leave the other no
/// choice, both where two leave it a line.
struct DyadDescription {
  std::optional<PointDescription> circle_point;  ///< moving frame
  std::optional<PointDescription> centre_point;  ///< fixed frame
  SourceRange where;
};

/// A link of a function generator, which turns about its centre point.
struct FunctionLink {
  PointDescription centre_point;                 ///< fixed frame
  std::vector<Value> angles;                     ///< one a precision point
  std::optional<PointDescription> circle_point;  ///< given; fixed frame, in the first position
  SourceRange where;
};

/// Angles that two links must have together.
struct FunctionDescription {
  FunctionLink input;
  FunctionLink output;
  SourceRange where;
};

/// What `vary` may leave free. `s`, `tau` and `tau_2` are the effective freedom of what curvature,
/// stationary curvature and a Burmester point leave open, in the place of free point and m; circle
/// points, or centre points in their place, are free with three and four positions.
enum class FreeNumber { m, free_point, s, tau, tau_2, circle_points, centre_points };

/// The key, and the word in messages.
std::string_view word_of(FreeNumber which);

/// What it is measured in: of a point its coordinates.
QuantityKind kind_of(FreeNumber which);

/// Whether it has two coordinates.
bool is_point(FreeNumber which);

/// Whether it chooses the dyads of three and four positions.
bool chooses_dyads(FreeNumber which);

/// A line for a file that lets vary what a position of such an order leaves open, by conditions on
/// the path of `at` alone: "vary: {s: {from: -20, to: 20}, tau: {from: -1, to: 1}}". `radius` is
/// the distance of the pole, in the file's unit of length.
std::string example_of_ranges(int order, double radius);

/// A free parameter of the task: a number or a point, from … to.
struct SynthesisRange {
  FreeNumber which = FreeNumber::m;
  SourceRange name_where;
  std::vector<Value> from;  ///< one number, or the coordinates of a point
  std::vector<Value> to;
  SourceRange where;
};

/// Where the file does not say how many.
inline constexpr int kUsualSamples = 4000;
inline constexpr int kUsualCurvePoints = 200;

struct SynthesisDescription {
  LinkageKind linkage = LinkageKind::four_bar;
  std::vector<PositionDescription> positions;
  std::optional<FunctionDescription> function;  ///< instead of positions and dyads
  std::vector<DyadDescription> dyads;           ///< given, two at most
  SynthesisLimits limits;
  std::vector<SynthesisRange> vary;
  std::optional<Value> samples;      ///< of a selection, about; kUsualSamples
  std::optional<Value> curve_count;  ///< points of each curve; kUsualCurvePoints
  std::optional<Value> digits;       ///< decimal digits of the positions, more than a double has
  std::shared_ptr<const TransmissionDescription> transmission;  ///< instead of all these
  SourceRange where;
};

}  // namespace kinestat
