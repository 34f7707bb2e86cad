// Two dyads that guide the plane together: a linkage with one freedom.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "description/synthesis_description.hpp"
#include "studies/synthesis/dyads/bounded_point.hpp"
#include "studies/synthesis/dyads/dyad.hpp"

namespace kinestat {

enum class LinkageType {
  four_bar,
  slider_crank,           ///< crank and slider
  inverted_slider_crank,  ///< crank and inverted slider
  double_slider,          ///< two sliders: an elliptic trammel
  slider_inverted_slider,
  double_inverted_slider  ///< an Oldham coupling
};

/// The word in reports.
std::string_view word_of(LinkageType type);

/// The moving plane is the coupler; the order of the dyads means nothing by itself.
struct Linkage {
  Dyad one;
  Dyad other;

  LinkageType type() const;
};

/// Which dyad is driven: a crank by its angle, a slider by its displacement, an inverted slider by
/// the angle of its guide, which is that of the plane.
enum class Drive { one, other };

const Dyad& input_of(const Linkage& linkage, Drive drive);
const Dyad& output_of(const Linkage& linkage, Drive drive);

/// Where the moving plane stands: a point z of it lies at e^{iγ} z + origin.
struct Pose {
  Point origin;
  double angle = 0.0;

  Point place(const Point& moving) const;

  /// With what rounding does to the pose; `turn` is the unit vector at its angle.
  BoundedPoint bounded_place(const BoundedPoint& turn, const BoundedPoint& moving) const;
};

Pose pose_of(const PositionJets& position);

/// The frame in which such a point of a dyad is given, in the first position.
Pose frame_of(DyadPoint which, std::span<const PositionJets> positions);

/// The links of a four-bar [length].
struct FourBarLengths {
  double ground = 0.0;
  double crank_one = 0.0;
  double coupler = 0.0;
  double crank_other = 0.0;
  double bound = 0.0;  ///< by how much all four together may be off

  double longest() const;
  double shortest() const;
};

/// Empty unless both dyads are cranks.
std::optional<FourBarLengths> lengths_of(const Linkage& linkage);

enum class FourBarLink { ground, crank_one, coupler, crank_other };

std::string_view word_of(FourBarLink link);

struct Grashof {
  GrashofClass kind = GrashofClass::triple_rocker;
  FourBarLink which = FourBarLink::ground;  ///< the shortest link; of a triple rocker the longest
};

Grashof classify(const FourBarLengths& lengths);

}  // namespace kinestat
