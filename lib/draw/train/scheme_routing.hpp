// The shafts of one axis of a section: which way each body's line goes, and where elements stand.
#pragma once

#include <map>
#include <vector>

#include "draw/train/scheme_axes.hpp"
#include "draw/train/scheme_grid.hpp"
#include "draw/train/scheme_router.hpp"

namespace kinestat {

/// In which order bodies get their shafts.
enum class RouteOrder { small_first, large_first, as_in_file, reversed };

/// Nets from here on are parts of the housing, others bodies.
inline constexpr int kHousingNet = 1'000'000;

inline int body_of_net(int net) {
  return net < kHousingNet ? net : 0;
}

/// What of a developed section stands in the way of other axes.
struct SchemeObstacle {
  int axis = 0;  ///< whose it is
  int left = 0;  ///< tracks
  int right = 0;
  double low = 0.0;  ///< heights above the main axis [px]
  double high = 0.0;
  bool may_be_crossed = false;  ///< by lines along the axis
};

/// What a developed section has beside the axis; nothing of a half section.
struct SchemeSurroundings {
  std::vector<SchemeObstacle> obstacles;
  std::map<int, SchemeExtent> extents;        ///< of bodies
  std::vector<std::pair<int, int>> bearings;  ///< find_bearing_pairs
};

/// Where a planet's pin is.
struct RoutedPin {
  int planet = 0;
  int left = 0;
  int right = 0;
  int row = 0;
};

/// Where an element is.
struct RoutedSymbol {
  int element = -1;  ///< index into SchemeTrain::elements; -1: a body that is fixed to the housing
  int body = 0;
  GridCell at;
  GridCell beyond;
};

/// All must outlive it.
class SchemeRouting {
 public:
  SchemeRouting(const SchemeTrain& train,
                const SchemeGrid& grid,
                RouteOrder order,
                const SchemeSurroundings& around);

  void run();

  double price() const {
    constexpr double kMissing = 1000.0;
    return router_.price() + kMissing * missing_;
  }

  /// Connections that found no way.
  int missing() const { return missing_; }

  const SchemeRouter& router() const { return router_; }

  const std::vector<RoutedPin>& pins() const { return pins_; }

  const std::vector<RoutedSymbol>& symbols() const { return symbols_; }

  /// Of a whole wheel, the row at which its disc begins.
  int hub(int wheel) const { return hubs_.at(wheel); }

 private:
  using Group = std::vector<GridCell>;

  const SchemeWheel& wheel(int i) const { return train_.wheels[static_cast<std::size_t>(i)]; }

  // The net of a body; each part of the housing is one by itself.
  int net_of(int body) { return body > 0 ? body : kHousingNet + housing_parts_++; }

  int top_row() const { return router_.rows() - 1; }

  bool is_free(int column, int row) const { return router_.is_free_within({column, row}); }

  void block_obstacles();
  void place_wheels();
  void block_planet(int w);
  void place_pin(int planet);
  void place_main(int w);
  void place_whole(int w);
  void place_bearer(int w, int hub);
  int level_of(int body) const;
  std::vector<int> nets_in_order() const;
  double extent(int net) const;
  void start(const Group& group);
  void route_net(int net);
  void begin_at_end(int net, bool is_left);
  void add_port(int element);
  void add_clutch(int element);
  void join_clutch(int element, GridCell left, bool is_turned);
  void add_brake(int element, int net);

  const SchemeTrain& train_;
  RouteOrder order_;
  const SchemeGrid& grid_;
  const SchemeSurroundings& around_;
  SchemeRouter router_;
  std::map<int, std::vector<Group>> groups_;  // of each net: what is to be joined
  std::vector<RoutedPin> pins_;
  std::vector<RoutedSymbol> symbols_;
  std::map<int, int> hubs_;
  int housing_parts_ = 0;
  int missing_ = 0;
};

/// Of some orders the one with the fewest crossings; the same in every run.
SchemeRouting best_routing(const SchemeTrain& train,
                           const SchemeGrid& grid,
                           const SchemeSurroundings& around);

}  // namespace kinestat
