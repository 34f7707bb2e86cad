// The drawing of a spatial mechanism in parallel projection.
#pragma once

#include "draw/linkage/linkage_canvas.hpp"

namespace kinestat {

/// From above, z upwards; of some directions around z the one from which couplings stand apart
/// best. `points` are what the picture must hold.
LinkageView best_view(const Analysis& analysis, const std::vector<Vec3>& points);

/// Fills the canvas.
void draw_spatial(const Analysis& analysis,
                  const LinkageOptions& options,
                  const LinkageParts& parts,
                  LinkageCanvas& canvas);

}  // namespace kinestat
