#include "draw/train/scheme_routing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/index.hpp"

namespace kinestat {

SchemeRouting::SchemeRouting(const SchemeTrain& train,
                             const SchemeGrid& grid,
                             RouteOrder order,
                             const SchemeSurroundings& around)
    : train_(train),
      order_(order),
      grid_(grid),
      around_(around),
      router_(grid.track_count(), grid.row_count()) {}

void SchemeRouting::run() {
  block_obstacles();
  place_wheels();
  for (const int net : nets_in_order()) {
    route_net(net);
  }
  const auto for_each = [this](auto is_of_kind, auto add) {
    for (std::size_t i = 0; i < train_.elements.size(); ++i) {
      if (train_.elements[i].axis == grid_.axis() && is_of_kind(train_.elements[i].kind)) {
        add(static_cast<int>(i));
      }
    }
  };
  using enum SchemeElementKind;
  for_each([](SchemeElementKind kind) { return kind == input || kind == output; },
           [this](int i) { add_port(i); });
  std::vector<int> clutches;
  for_each([](SchemeElementKind kind) { return kind == clutch; },
           [&](int i) { clutches.push_back(i); });
  // What is within first.
  std::ranges::stable_sort(clutches, {}, [this](int i) {
    return level_of(train_.elements[at(i)].body) + level_of(train_.elements[at(i)].other);
  });
  for (const int i : clutches) {
    add_clutch(i);
  }
  for_each([](SchemeElementKind kind) { return kind == brake; },
           [this](int i) { add_brake(i, train_.elements[at(i)].body); });
  for (const auto& [net, groups] : groups_) {
    if (net >= kHousingNet) {
      add_brake(-1, net);
    }
  }
}

// Gears of other axes, and lines that have been led there.
void SchemeRouting::block_obstacles() {
  constexpr double kMargin = 5.0;
  for (const SchemeObstacle& one : around_.obstacles) {
    if (one.axis == grid_.axis()) {
      continue;
    }
    for (int row = 0; row < grid_.row_count(); ++row) {
      const double height = grid_.base() + grid_.height(row);
      if (height < one.low - kMargin || height > one.high + kMargin) {
        continue;
      }
      for (int column = one.left; column <= one.right; ++column) {
        if (one.may_be_crossed) {
          router_.keep_aside({column, row});
        } else {
          router_.block({column, row});
        }
      }
    }
  }
}

void SchemeRouting::place_wheels() {
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    if (grid_.is_placed(w) && wheel(w).planet >= 0) {
      block_planet(w);
    }
  }
  for (int p = 0; p < static_cast<int>(train_.planets.size()); ++p) {
    place_pin(p);
  }
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    if (grid_.is_placed(w) && wheel(w).planet < 0) {
      place_main(w);
    }
  }
}

void SchemeRouting::block_planet(int w) {
  for (int column = grid_.left_face(w); column <= grid_.right_face(w); ++column) {
    for (int row = grid_.row_at(grid_.low(w)); row <= grid_.row_at(grid_.high(w)); ++row) {
      router_.block({column, row});
    }
  }
}

void SchemeRouting::place_pin(int planet) {
  int left = std::numeric_limits<int>::max();
  int right = -1;
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    if (wheel(w).planet == planet && grid_.is_placed(w)) {
      left = std::min(left, grid_.left_face(w) - 1);
      right = std::max(right, grid_.right_face(w) + 1);
    }
  }
  if (right < 0) {
    return;
  }
  const int row = grid_.row_at(grid_.pin(planet));
  const int net = net_of(train_.planets[at(planet)].carrier);
  for (int column = left + 1; column < right; ++column) {
    router_.keep_along({column, row}, net);
  }
  router_.keep({left, row}, net);
  router_.keep({right, row}, net);
  groups_[net].push_back({{left, row}, {right, row}});
  pins_.push_back({.planet = planet, .left = left, .right = right, .row = row});
}

// Its disc reaches down to the shaft of its body, within which others may run.
void SchemeRouting::place_whole(int w) {
  constexpr double kRim = 5.0;
  const double rim = grid_.high(w);
  const int net = net_of(wheel(w).body);
  const int level = level_of(wheel(w).body);
  const int disc = grid_.left_face(w) + 1;
  int hub = 0;
  for (int row = 0; row < grid_.row_count() && grid_.height(row) < rim + kRim; ++row) {
    if (row <= level && grid_.height(row) < rim - kRim) {
      hub = row;
    } else {
      router_.block({disc, row});
    }
    if (grid_.height(row) > rim - kRim) {
      for (int column = grid_.left_face(w); column <= grid_.right_face(w); ++column) {
        router_.block({column, row});
      }
    }
  }
  router_.keep({disc, hub}, net);
  groups_[net].push_back({{disc, hub}});
  hubs_[w] = hub;
  place_bearer(w, hub);
}

// What bears the body of a wheel runs through it.
void SchemeRouting::place_bearer(int w, int hub) {
  for (const auto& [inner, outer] : around_.bearings) {
    const int row = level_of(inner);
    if (outer == wheel(w).body && row < hub) {
      const GridCell cell = {grid_.left_face(w) + 1, row};
      router_.keep(cell, inner);
      groups_[inner].push_back({cell});
    }
  }
}

int SchemeRouting::level_of(int body) const {
  const auto extent = around_.extents.find(body);
  return extent == around_.extents.end() ? 0 : extent->second.level;
}

void SchemeRouting::place_main(int w) {
  if (grid_.is_developed() && is_whole(train_, w)) {
    place_whole(w);
    return;
  }
  const int row = grid_.row_at(grid_.high(w));
  for (int column = grid_.left_face(w); column <= grid_.right_face(w); ++column) {
    router_.block({column, row});
  }
  const int net = net_of(wheel(w).body);
  const GridCell disc = {grid_.left_face(w) + 1, row};
  router_.keep(disc, net);
  groups_[net].push_back({disc});
}

std::vector<int> SchemeRouting::nets_in_order() const {
  std::vector<int> nets;
  for (const auto& [net, groups] : groups_) {
    nets.push_back(net);
  }
  if (order_ == RouteOrder::reversed) {
    std::ranges::reverse(nets);
  } else if (order_ != RouteOrder::as_in_file) {
    const double sign = order_ == RouteOrder::small_first ? 1.0 : -1.0;
    std::ranges::stable_sort(nets,
                             [&](int a, int b) { return sign * extent(a) < sign * extent(b); });
  }
  return nets;
}

double SchemeRouting::extent(int net) const {
  int least = std::numeric_limits<int>::max();
  int most = 0;
  for (const Group& group : groups_.at(net)) {
    for (const GridCell& cell : group) {
      least = std::min(least, cell.column);
      most = std::max(most, cell.column);
    }
  }
  return most - least;
}

void SchemeRouting::start(const Group& group) {
  for (const GridCell& cell : group) {
    router_.start(cell);
  }
}

void SchemeRouting::route_net(int net) {
  std::vector<Group> waiting = groups_.at(net);
  start(waiting.front());
  waiting.erase(waiting.begin());
  while (!waiting.empty()) {
    std::vector<SchemeRouter::End> ends;
    for (const Group& group : waiting) {
      for (const GridCell& cell : group) {
        ends.push_back({.cell = cell, .price = 0.0});
      }
    }
    if (!router_.connect(net, ends)) {
      missing_ += static_cast<int>(waiting.size());
      return;
    }
    std::erase_if(waiting, [this](const Group& group) {
      const bool is_reached = std::ranges::any_of(
          group, [this](const GridCell& cell) { return router_.is_reached(cell); });
      if (is_reached) {
        start(group);
      }
      return is_reached;
    });
  }
}

// A body without wheels begins at the end where its port is.
void SchemeRouting::begin_at_end(int net, bool is_left) {
  const int column = is_left ? 1 : router_.columns() - 2;
  for (int row = 0; row < router_.rows(); ++row) {
    const GridCell cell = {column, row};
    if (router_.is_free(cell)) {
      router_.keep(cell, net);
      router_.start(cell);
      groups_[net].push_back({cell});
      return;
    }
  }
}

// Inputs at the left, outputs at the right, near the axis; at the other end if that is easier.
void SchemeRouting::add_port(int element) {
  constexpr double kRowPrice = 0.5;
  constexpr double kWrongEnd = 30.0;
  const SchemeElement& port = train_.elements[at(element)];
  const bool is_left = port.kind == SchemeElementKind::input;
  if (!groups_.contains(port.body)) {
    begin_at_end(port.body, is_left);
  }
  std::vector<SchemeRouter::End> ends;
  for (int row = 0; row < grid_.inner_row_count(); ++row) {
    for (const bool at_left : {true, false}) {
      const GridCell cell = {at_left ? 0 : router_.columns() - 1, row};
      if (router_.is_free(cell)) {
        ends.push_back(
            {.cell = cell, .price = kRowPrice * row + (at_left == is_left ? 0.0 : kWrongEnd)});
      }
    }
  }
  if (const auto end = router_.connect(port.body, ends)) {
    router_.keep(*end, port.body);
    const int out = end->column == 0 ? -1 : 1;
    symbols_.push_back({.element = element,
                        .body = port.body,
                        .at = *end,
                        .beyond = {end->column + out, end->row}});
  } else {
    ++missing_;
  }
}

void SchemeRouting::add_clutch(int element) {
  const SchemeElement& clutch = train_.elements[at(element)];
  for (const int body : {clutch.body, clutch.other}) {
    if (!groups_.contains(body)) {
      begin_at_end(body, body == clutch.body);
    }
  }
  if (const auto gap = find_gap(router_, clutch.body, clutch.other, grid_.is_developed())) {
    join_clutch(element, gap->left, gap->is_turned);
  } else {
    ++missing_;
  }
}

void SchemeRouting::join_clutch(int element, GridCell left, bool is_turned) {
  const SchemeElement& clutch = train_.elements[at(element)];
  const GridCell right = {left.column + 3, left.row};
  const GridCell at = is_turned ? right : left;
  const GridCell beyond = is_turned ? left : right;
  const int below = grid_.is_developed() ? 0 : 1;
  for (int row = left.row - below; row <= left.row + 1; ++row) {
    for (const int column : {left.column + 1, left.column + 2}) {
      if (is_free(column, row)) {
        router_.block({column, row});
      }
    }
  }
  router_.keep(at, clutch.body);
  router_.keep(beyond, clutch.other);
  const bool is_good = router_.connect(clutch.body, {{.cell = at, .price = 0.0}}) &&
                       router_.connect(clutch.other, {{.cell = beyond, .price = 0.0}});
  missing_ += is_good ? 0 : 1;
  symbols_.push_back({.element = element, .body = clutch.body, .at = at, .beyond = beyond});
}

// The housing is above everything, and at the ends for what is fixed.
void SchemeRouting::add_brake(int element, int net) {
  std::vector<SchemeRouter::End> ends;
  for (int column = 1; column + 1 < router_.columns(); ++column) {
    const int row = top_row();
    if (is_free(column, row) && is_free(column - 1, row) && is_free(column + 1, row)) {
      ends.push_back({.cell = {column, row}, .price = 0.0});
    }
  }
  // In a developed section also wherever there is room for it.
  for (int row = 1; grid_.is_developed() && row + 2 < top_row(); ++row) {
    for (int column = 1; column + 1 < router_.columns(); ++column) {
      bool has_room = is_free(column, row);
      for (const int beside : {-1, 0, 1}) {
        for (const int above : {0, 1, 2}) {
          has_room = has_room && is_free(column + beside, row + above);
        }
      }
      if (has_room) {
        ends.push_back({.cell = {column, row}, .price = 0.0});
      }
    }
  }
  for (int row = 1; element < 0 && row < grid_.inner_row_count(); ++row) {
    for (const int column : {0, router_.columns() - 1}) {
      if (is_free(column, row) && is_free(column, row - 1) && is_free(column, row + 1)) {
        ends.push_back({.cell = {column, row}, .price = 0.0});
      }
    }
  }
  if (!groups_.contains(net)) {
    ++missing_;
    return;
  }
  const auto end = router_.connect(net, ends);
  if (!end) {
    ++missing_;
    return;
  }
  router_.keep(*end, net);
  const bool is_above =
      end->row == top_row() || (end->column > 0 && end->column < router_.columns() - 1);
  const GridCell beyond = {is_above ? end->column : end->column + (end->column == 0 ? -1 : 1),
                           is_above ? end->row + 1 : end->row};
  for (const int side : {-1, 1}) {
    const GridCell beside = {end->column + (is_above ? side : 0), end->row + (is_above ? 0 : side)};
    router_.block(beside);
    if (grid_.is_developed() && is_above && end->row < top_row()) {
      router_.block({beside.column, beside.row + 1});
      router_.block({end->column, beside.row + 1});
    }
  }
  symbols_.push_back({.element = element, .body = body_of_net(net), .at = *end, .beyond = beyond});
}

SchemeRouting best_routing(const SchemeTrain& train,
                           const SchemeGrid& grid,
                           const SchemeSurroundings& around) {
  std::optional<SchemeRouting> best;
  for (const RouteOrder order : {RouteOrder::small_first,
                                 RouteOrder::as_in_file,
                                 RouteOrder::large_first,
                                 RouteOrder::reversed}) {
    SchemeRouting routing(train, grid, order, around);
    routing.run();
    if (!best || routing.price() < best->price()) {
      best.emplace(std::move(routing));
    }
    if (grid.is_developed() && best->missing() == 0 && best->router().crossings() == 0) {
      break;
    }
  }
  return std::move(*best);
}

}  // namespace kinestat
