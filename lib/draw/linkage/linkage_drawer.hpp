// What planar and spatial drawings of a mechanism ask and do alike.
#pragma once

#include <optional>
#include <vector>

#include "draw/linkage/linkage_canvas.hpp"

namespace kinestat {

/// Base of the classes that fill a canvas. All references must outlive it.
class LinkageDrawer {
 public:
  LinkageDrawer(const Analysis& analysis,
                const LinkageOptions& options,
                const LinkageParts& parts,
                LinkageCanvas& canvas)
      : analysis_(analysis),
        topology_(analysis.mechanism.topology),
        geometry_(analysis.mechanism.geometry),
        options_(options),
        parts_(parts),
        canvas_(canvas),
        svg_(canvas.svg()) {}

 protected:
  const std::vector<BodyPoint>& points(BodyId body) const {
    return parts_.points[static_cast<std::size_t>(body.value)];
  }

  bool is_virtual(BodyId body) const {
    return parts_.is_virtual[static_cast<std::size_t>(body.value)];
  }

  /// Whether it has no symbol: between virtual links of cables.
  bool is_hidden(const CouplingTopology& coupling) const {
    return is_virtual(coupling.tail) || is_virtual(coupling.head);
  }

  /// The body that moves with the symbol of a coupling: its head unless that is the ground.
  static BodyId carrier(const CouplingTopology& coupling) {
    return coupling.head.value == 0 ? coupling.tail : coupling.head;
  }

  /// All that are drawn but the ground.
  std::vector<BodyId> moving_bodies() const;

  /// Cables are named in the middle of their straight parts.
  void place_cables();

  /// Those that are lines.
  void draw_springs();

  /// Those about a freedom, which turn with the body of their coupling.
  void draw_spirals();

  void name_springs();

  /// Adds a place unless the list has it already.
  static void add_place(PixelPoint place, std::vector<PixelPoint>& places);

  /// Adds where the ground may be named that stands below a place.
  static void add_feet(PixelPoint place, std::vector<PixelPoint>& places);

  /// Adds those of the body's points whose path is shown.
  void add_traced(BodyId body, std::vector<PixelPoint>& places) const;

  /// A dot at each of them, which moves with the body along its path.
  void draw_traced(BodyId body);

  /// The coupling about whose axis a spring turns; empty for one that is a line.
  std::optional<CouplingId> hinge_of(const Spring& spring) const;

  const Analysis& analysis_;
  const Topology& topology_;
  const Geometry& geometry_;
  const LinkageOptions& options_;
  const LinkageParts& parts_;
  LinkageCanvas& canvas_;
  Svg& svg_;
};

/// Fills the canvas, whose view looks along -z with y upwards.
void draw_planar(const Analysis& analysis,
                 const LinkageOptions& options,
                 const LinkageParts& parts,
                 LinkageCanvas& canvas);

/// The moving bodies, cables and couplings alone.
void draw_planar_bodies(const Analysis& analysis,
                        const LinkageOptions& options,
                        const LinkageParts& parts,
                        LinkageCanvas& canvas);

/// From above, z upwards; of some directions around z the one from which couplings stand apart
/// best. `points` are what the picture must hold.
LinkageView best_view(const Analysis& analysis, const std::vector<Vec3>& points);

/// Fills the canvas.
void draw_spatial(const Analysis& analysis,
                  const LinkageOptions& options,
                  const LinkageParts& parts,
                  LinkageCanvas& canvas);

/// The mechanism alone, without names, arrows and axes.
void draw_spatial_bodies(const Analysis& analysis,
                         const LinkageOptions& options,
                         const LinkageParts& parts,
                         LinkageCanvas& canvas);

}  // namespace kinestat
