#include "draw/train/scheme_layout.hpp"

#include "draw/train/developed_layout.hpp"
#include "draw/train/scheme_placer.hpp"

namespace kinestat {

SchemeLayout lay_out_scheme(const SchemeTrain& train) {
  if (train.axis_count > 1) {
    return lay_out_developed(train);
  }
  const SchemeRadii radii = find_radii(train);
  const SchemeColumns columns = find_columns(train, radii);
  SchemeGrid grid(train, radii, columns);
  const SchemeSurroundings alone;
  const SchemeRouting routing = best_routing(train, grid, alone);
  const SchemePlacer placer(train, grid, routing);
  std::vector<bool> is_used(static_cast<std::size_t>(grid.track_count()), false);
  std::vector<bool> is_used_row(static_cast<std::size_t>(grid.row_count()), false);
  placer.mark_used(is_used, is_used_row);
  grid.close_up(is_used, is_used_row);
  SchemeLayout layout;
  placer.add_to(layout);
  layout.box = {.left = grid.x(0),
                .top = -grid.height(grid.row_count() - 1),
                .right = grid.x(grid.track_count() - 1),
                .bottom = 0.0};
  return layout;
}

}  // namespace kinestat
