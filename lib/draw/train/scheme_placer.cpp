#include "draw/train/scheme_placer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/index.hpp"

namespace kinestat {

namespace {

// How far the plates of a clutch reach inwards and outwards from its line, where that is a shaft
// round another.
constexpr double kPlateIn = 3.0;
constexpr double kPlateOut = 14.0;

}  // namespace

void SchemePlacer::mark_used(std::vector<bool>& is_used, std::vector<bool>& is_used_row) const {
  for (const SchemeRouter::Step& step : routing_.router().steps()) {
    if (step.from.column == step.to.column) {
      is_used[at(step.from.column)] = true;
    } else {
      is_used_row[at(step.from.row)] = true;
    }
  }
  for (const RoutedSymbol& symbol : routing_.symbols()) {
    for (const GridCell& cell : {symbol.at, symbol.beyond}) {
      const int column = std::clamp(cell.column, 0, grid_.track_count() - 1);
      is_used[at(column)] = true;
      is_used_row[at(std::min(cell.row, (grid_.row_count() - 1)))] = true;
    }
    const bool is_clutch = std::abs(symbol.at.column - symbol.beyond.column) == 3;
    for (int i = 1; is_clutch && i < 3; ++i) {
      is_used[at(std::min(symbol.at.column, symbol.beyond.column) + i)] = true;
    }
  }
  for (const RoutedPin& pin : routing_.pins()) {
    is_used[at(pin.left)] = true;
    is_used[at(pin.right)] = true;
  }
}

void SchemePlacer::add_to(SchemeLayout& layout) const {
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    if (grid_.is_placed(w)) {
      layout.wheels.push_back(drawn(w));
    }
  }
  add_shafts(layout);
  for (const RoutedPin& pin : routing_.pins()) {
    layout.pins.push_back(drawn(pin));
  }
  for (const RoutedSymbol& symbol : routing_.symbols()) {
    DrawnElement drawn{.element = symbol.element,
                       .body = symbol.body,
                       .at = grid_.place(symbol.at),
                       .beyond = grid_.place(symbol.beyond),
                       .axis = -grid_.base()};
    if (grid_.is_developed() && symbol.at.row > 0) {
      drawn.inwards = kPlateIn;
      drawn.outwards = kPlateOut;
    }
    drawn.is_mirrored = symbol.at.row > 0 && mirrored_.contains(symbol.body) &&
                        grid_.height(symbol.at.row) <= kMirrorReach && !goes_outwards(symbol.at) &&
                        !goes_outwards(symbol.beyond);
    layout.elements.push_back(drawn);
  }
  layout.crossings += routing_.router().crossings();
}

DrawnWheel SchemePlacer::drawn(int w) const {
  DrawnWheel result{.wheel = w,
                    .left = grid_.x(grid_.left_face(w)),
                    .right = grid_.x(grid_.right_face(w)),
                    .discs = {},
                    .low = wheel(w).planet < 0 ? 0.0 : grid_.low(w),
                    .high = grid_.high(w)};
  if (grid_.is_developed()) {
    result.axis = grid_.base();
    result.high += grid_.base();
    result.low = wheel(w).planet < 0 ? result.axis : grid_.low(w) + grid_.base();
    result.is_whole = is_whole(train_, w);
    result.hub = result.is_whole ? hub_height(w) : 0.0;
    result.is_fixed = result.is_whole && is_fixed(w);
  }
  const SchemeColumns& columns = grid_.columns();
  for (int column = columns.first[at(w)]; column <= columns.last[at(w)]; ++column) {
    result.discs.push_back(grid_.x(grid_.centre(column)));
    if (wheel(w).planet < 0) {
      break;
    }
  }
  return result;
}

double SchemePlacer::hub_height(int w) const {
  const int hub = routing_.hub(w);
  const int disc = grid_.left_face(w) + 1;
  const bool has_shaft_within =
      std::ranges::any_of(routing_.router().steps(), [&](const SchemeRouter::Step& step) {
        const auto [from, to] = std::minmax(step.from.column, step.to.column);
        return step.from.row == step.to.row && step.from.row < hub && from <= disc && disc <= to;
      });
  return has_shaft_within ? grid_.height(hub) : 0.0;
}

// An idler has no other wheel and runs on a shaft; anything else is one with its shaft.
bool SchemePlacer::is_fixed(int w) const {
  const auto wheels = std::ranges::count(train_.wheels, wheel(w).body, &SchemeWheel::body);
  return routing_.hub(w) == 0 || wheels > 1;
}

// A pin ends behind its bearing where nothing holds it.
DrawnPin SchemePlacer::drawn(const RoutedPin& pin) const {
  constexpr double kBeyond = 11.0;
  const auto is_held = [this](GridCell end) {
    return std::ranges::any_of(routing_.router().steps(), [end](const SchemeRouter::Step& step) {
      return step.from == end || step.to == end;
    });
  };
  double first = std::numeric_limits<double>::infinity();
  double last = 0.0;
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    if (wheel(w).planet == pin.planet && grid_.is_placed(w)) {
      const double middle = (grid_.x(grid_.left_face(w)) + grid_.x(grid_.right_face(w))) / 2;
      first = std::min(first, middle);
      last = std::max(last, middle);
    }
  }
  return {.planet = pin.planet,
          .left = is_held({pin.left, pin.row}) ? grid_.x(pin.left) : first - kBeyond,
          .right = is_held({pin.right, pin.row}) ? grid_.x(pin.right) : last + kBeyond,
          .height = grid_.base() + grid_.height(pin.row)};
}

bool SchemePlacer::goes_outwards(GridCell end) const {
  return std::ranges::any_of(routing_.router().steps(), [&](const SchemeRouter::Step& step) {
    return step.from.column == end.column && step.to.column == end.column &&
           std::min(step.from.row, step.to.row) == end.row;
  });
}

bool SchemePlacer::is_of_brake(GridCell end) const {
  return std::ranges::any_of(routing_.symbols(), [&](const RoutedSymbol& symbol) {
    return symbol.at == end && symbol.at.column == symbol.beyond.column;
  });
}

// Where the disc of a wheel stands that is drawn in half.
bool SchemePlacer::is_of_half_wheel(int track) const {
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    if (grid_.is_placed(w) && !is_whole(train_, w) && grid_.left_face(w) + 1 == track) {
      return true;
    }
  }
  return false;
}

// Steps of one line become one.
void SchemePlacer::add_shafts(SchemeLayout& layout) const {
  std::map<std::tuple<int, bool, int>, std::set<int>> runs;
  for (const SchemeRouter::Step& step : routing_.router().steps()) {
    const bool is_along = step.from.row == step.to.row;
    const int where = is_along ? step.from.row : step.from.column;
    const int from = is_along ? std::min(step.from.column, step.to.column)
                              : std::min(step.from.row, step.to.row);
    runs[{step.net, is_along, where}].insert(from);
  }
  for (const auto& [line, begins] : runs) {
    const auto& [net, is_along, where] = line;
    for (auto begin = begins.begin(); begin != begins.end();) {
      const int from = *begin;
      int to = from + 1;
      ++begin;
      while (begin != begins.end() && *begin == to) {
        ++to;
        ++begin;
      }
      const DrawnShaft shaft = {
          .body = body_of_net(net),
          .from = grid_.place(is_along ? GridCell{from, where} : GridCell{where, from}),
          .to = grid_.place(is_along ? GridCell{to, where} : GridCell{where, to})};
      layout.shafts.push_back(shaft);
      const bool is_near = grid_.height(is_along ? where : to) <= kMirrorReach;
      const bool is_mirrored =
          mirrored_.contains(net) && is_near &&
          (is_along ? where > 0 : !is_of_half_wheel(where) && !is_of_brake({where, to}));
      if (is_mirrored) {
        layout.shafts.push_back(
            {.body = shaft.body, .from = mirror(shaft.from), .to = mirror(shaft.to)});
      }
    }
  }
}

}  // namespace kinestat
