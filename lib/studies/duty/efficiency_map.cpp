#include "studies/duty/efficiency_map.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Where the speed and the load of the input are among what a case knows.
struct MapAxes {
  int input = 0;
  std::size_t speed = 0;
  std::size_t load = 0;
};

// Empty for a case that has not one input with both.
std::optional<MapAxes> axes_of(const Mechanism& mechanism, std::size_t which) {
  const std::vector<int>& inputs = mechanism.cases[which].inputs;
  if (inputs.size() != 1) {
    return std::nullopt;
  }
  const int input = inputs.front();
  const auto actuator = static_cast<std::size_t>(input);
  const auto speed = find_known(mechanism, which, actuator, DutySide::motion);
  const auto load = find_known(mechanism, which, actuator, DutySide::action);
  return speed && load ? std::optional(MapAxes{.input = input, .speed = *speed, .load = *load})
                       : std::nullopt;
}

void widen(double value, MapRange& range) {
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

double middle(const MapRange& range, std::size_t cell, std::size_t count) {
  const double share = (static_cast<double>(cell) + 0.5) / static_cast<double>(count);
  return range.low + share * (range.high - range.low);
}

// In the order of the cases.
class MapMaker {
 public:
  explicit MapMaker(const Mechanism& mechanism) : mechanism_(mechanism) {}

  // Empty for a case of which there is no map.
  std::optional<MapAxes> axes(std::size_t which) const { return axes_of(mechanism_, which); }

  // The map of a case that has axes, wide enough for the point.
  EfficiencyMap& map_with(std::size_t which, const MapPoint& point) {
    EfficiencyMap& map = maps_[which];
    map.which = which;
    widen(point.speed, map.speeds);
    widen(point.load, map.loads);
    return map;
  }

  std::vector<EfficiencyMap> run() && {
    std::vector<EfficiencyMap> result;
    DutyPlan plan;
    for (auto& [which, map] : maps_) {
      // Nothing to be seen over a speed or load that is zero throughout.
      if (map.speeds.low < map.speeds.high && map.loads.low < map.loads.high) {
        map.input = axes(which)->input;
        add_cells(map, plan);
        result.push_back(std::move(map));
      }
    }
    const std::vector<DutyPointState> states = solve_duty(mechanism_, plan).points;
    std::size_t i = 0;
    for (EfficiencyMap& map : result) {
      for (std::size_t cell = 0; cell < kMapRows * kMapColumns; ++cell) {
        map.cells.push_back(efficiency_of(states[i++]));
      }
    }
    return result;
  }

 private:
  void add_cells(const EfficiencyMap& map, DutyPlan& plan) const {
    const MapAxes axis = *axes(map.which);
    DutyPoint point = point_of(mechanism_, map.which);
    point.duration = 1.0;
    for (std::size_t row = 0; row < kMapRows; ++row) {
      point.actions[axis.load] = middle(map.loads, row, kMapRows);
      for (std::size_t column = 0; column < kMapColumns; ++column) {
        point.motions[axis.speed] = middle(map.speeds, column, kMapColumns);
        plan.points.push_back(point);
      }
    }
  }

  static std::optional<double> efficiency_of(const DutyPointState& state) {
    const std::optional<double> efficiency =
        state.status == DutyStatus::solved ? state.energy.efficiency() : std::nullopt;
    return efficiency && *efficiency > 0.0 ? efficiency : std::nullopt;
  }

  const Mechanism& mechanism_;
  std::map<std::size_t, EfficiencyMap> maps_;
};

}  // namespace

std::optional<double> EfficiencyMap::constant() const {
  if (cells.empty() ||
      !std::ranges::all_of(cells, [](const auto& one) { return one.has_value(); })) {
    return std::nullopt;
  }
  const auto [low, high] = std::ranges::minmax(cells);
  return *high - *low <= kSameValue * *high ? high : std::nullopt;
}

std::vector<EfficiencyMap> map_duty(const Mechanism& mechanism, const DutyPlan& plan) {
  MapMaker maker(mechanism);
  for (const DutyPoint& point : plan.points) {
    if (const std::optional<MapAxes> axes = maker.axes(point.which)) {
      const MapPoint one{.speed = point.motions[axes->speed],
                         .load = point.actions[axes->load],
                         .duration = point.duration};
      EfficiencyMap& map = maker.map_with(point.which, one);
      // What rests has no efficiency.
      if (one.speed != 0.0) {
        map.points.push_back(one);
      }
    }
  }
  return std::move(maker).run();
}

std::vector<EfficiencyMap> map_cases(const Mechanism& mechanism,
                                     std::span<const std::size_t> cases) {
  constexpr double kBeyond = 1.25;
  MapMaker maker(mechanism);
  for (const std::size_t which : cases) {
    if (const std::optional<MapAxes> axes = maker.axes(which)) {
      const Case& one = mechanism.cases[which];
      maker.map_with(which,
                     {.speed = kBeyond * one.motions[axes->speed].value,
                      .load = kBeyond * one.actions[axes->load].value});
    }
  }
  return std::move(maker).run();
}

}  // namespace kinestat
