// What planar and spatial drawings of mechanisms have in common: scale, arrows, names, paths.
#pragma once

#include <string>
#include <vector>

#include "draw/linkage/drawn_case.hpp"
#include "draw/linkage/linkage_drawing.hpp"
#include "draw/linkage/linkage_view.hpp"
#include "draw/name_placer.hpp"

namespace kinestat {

/// "crank-1", the value of data-body.
std::string body_mark(const Topology& topology, BodyId body);

/// The ink of a body: of the ground that of text, of the others in turn.
Ink body_ink(BodyId body);

/// The ink of the path of a point, by its place in LinkageOptions::paths.
Ink path_ink(std::size_t path);

/// Writes one drawing, layer by layer.
class LinkageCanvas {
 public:
  LinkageCanvas(const Analysis& analysis, const LinkageOptions& options, const LinkageView& view);

  Svg& svg() { return svg_; }

  const LinkageView& view() const { return view_; }

  /// A group of what moves with the body.
  void open_body(BodyId body);

  void open_layer(const std::string& name);

  /// Of what is drawn, and of what the options say that a motion reaches.
  PixelBox bounds() const;

  /// The name of a body or of couplings, written with all others when everything is drawn.
  void name(std::string text, PixelPoint anchor, double distance, Ink ink);

  /// Likewise at any of several places, the first rather than the last.
  void name(std::string text, std::vector<PixelPoint> anchors, double distance, Ink ink);

  /// Where the symbol of a coupling stands: at its point, a cable in the middle, or beside another
  /// coupling that has the point already [m].
  const Vec3& place(CouplingId coupling) const {
    return places_[static_cast<std::size_t>(coupling.value)];
  }

  void set_place(CouplingId coupling, const Vec3& place) {
    places_[static_cast<std::size_t>(coupling.value)] = place;
  }

  /// One name for all couplings of one place.
  void name_couplings();

  void draw_paths();

  /// Forces, couples, drives and velocities of the case.
  void draw_arrows();

  void draw_names();

  /// The scale of lengths, what arrows mean, and the case, below everything else.
  void draw_legend();

 private:
  struct WaitingName {
    std::string text;
    std::string title = {};           ///< shown under the pointer, where there is one
    std::vector<PixelPoint> anchors;  ///< any of them, the first rather than the last
    double distance = 0.0;
    TextStyle style;
  };

  const BodyTrack* track_of(BodyId body) const;
  GroupMotion on_picture(const BodyTrack& track) const;

  // Where it ends at the right. None where places are no more than examples.
  double draw_scale(PixelPoint from);
  void draw_arrow(const DrawnArrow& arrow, double factor);
  void draw_axial(const DrawnArrow& arrow);

  const Analysis& analysis_;
  const LinkageOptions& options_;
  LinkageView view_;
  std::vector<DrawnArrow> arrows_;
  std::vector<Vec3> places_;    // of each coupling [m]
  double largest_force_ = 0.0;  // [N]
  Svg svg_;
  std::vector<WaitingName> names_;
  std::vector<PixelPoint> turnings_;  // where turning arrows stand
};

}  // namespace kinestat
