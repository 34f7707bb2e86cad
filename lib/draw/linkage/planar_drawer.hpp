// What drawings of planar links and of their couplings ask alike.
#pragma once

#include "draw/linkage/linkage_drawer.hpp"

namespace kinestat {

inline constexpr double kSlotHalf = 24.0;  ///< half the length of a slot [px]

class PlanarDrawer : protected LinkageDrawer {
 public:
  using LinkageDrawer::LinkageDrawer;

 protected:
  PixelPoint at(CouplingId id) const {
    return canvas_.view().at(geometry_.points[static_cast<std::size_t>(id.value)]);
  }

  /// Of the sliding freedom of a coupling.
  PixelPoint sliding_direction(const CouplingTopology& coupling) const;

  /// Of the force in a contact, which pushes the head.
  PixelPoint normal(const CouplingTopology& coupling) const;

  /// What fixes the body that is held, of a prismatic coupling the one that has the guide.
  static BodyId guide_body(const CouplingTopology& coupling) {
    return coupling.head.value == 0 ? coupling.head : coupling.tail;
  }

  /// Whether the body slides as a rack, and so needs no block.
  bool has_rack(BodyId body) const;
};

/// Blocks, slots, racks, contacts and, on top of them, pins.
void draw_planar_couplings(const Analysis& analysis,
                           const LinkageOptions& options,
                           const LinkageParts& parts,
                           LinkageCanvas& canvas);

}  // namespace kinestat
