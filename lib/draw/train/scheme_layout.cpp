#include "draw/train/scheme_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "core/index.hpp"
#include "draw/train/scheme_grid.hpp"

namespace kinestat {

namespace {

// Nets from here on are parts of the housing, others bodies.
constexpr int kHousing = 1'000'000;

int body_of(int net) {
  return net < kHousing ? net : 0;
}

// In which order bodies get their shafts.
enum class RouteOrder { small_first, large_first, as_in_file, reversed };

class SchemeBuilder {
 public:
  SchemeBuilder(const SchemeTrain& train,
                const SchemeRadii& radii,
                const SchemeColumns& columns,
                RouteOrder order)
      : train_(train),
        order_(order),
        grid_(train, radii, columns),
        router_(grid_.track_count(), grid_.row_count()) {}

  SchemeLayout build() {
    place_wheels();
    for (const int net : nets_in_order()) {
      route_net(net);
    }
    for (std::size_t i = 0; i < train_.elements.size(); ++i) {
      const SchemeElementKind kind = train_.elements[i].kind;
      if (kind == SchemeElementKind::input || kind == SchemeElementKind::output) {
        add_port(static_cast<int>(i));
      }
    }
    for (std::size_t i = 0; i < train_.elements.size(); ++i) {
      if (train_.elements[i].kind == SchemeElementKind::clutch) {
        add_clutch(static_cast<int>(i));
      }
    }
    for (std::size_t i = 0; i < train_.elements.size(); ++i) {
      if (train_.elements[i].kind == SchemeElementKind::brake) {
        add_brake(static_cast<int>(i), train_.elements[i].body);
      }
    }
    for (const auto& [net, groups] : groups_) {
      if (net >= kHousing) {
        add_brake(-1, net);
      }
    }
    return finish();
  }

  double price() const {
    constexpr double kMissing = 1000.0;
    return router_.price() + kMissing * missing_;
  }

 private:
  using Group = std::vector<GridCell>;

  struct Pin {
    int planet = 0;
    int left = 0;
    int right = 0;
    int row = 0;
  };

  struct Symbol {
    int element = -1;
    int body = 0;
    GridCell at;
    GridCell beyond;
  };

  const SchemeWheel& wheel(int i) const { return train_.wheels[at(i)]; }

  // The net of a body; each part of the housing is one by itself.
  int net_of(int body) { return body > 0 ? body : kHousing + housing_parts_++; }

  void place_wheels() {
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

  void block_planet(int w) {
    for (int column = grid_.left_face(w); column <= grid_.right_face(w); ++column) {
      for (int row = grid_.row_at(grid_.low(w)); row <= grid_.row_at(grid_.high(w)); ++row) {
        router_.block({column, row});
      }
    }
  }

  void place_pin(int planet) {
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

  void place_main(int w) {
    const int row = grid_.row_at(grid_.high(w));
    for (int column = grid_.left_face(w); column <= grid_.right_face(w); ++column) {
      router_.block({column, row});
    }
    const int net = net_of(wheel(w).body);
    const GridCell disc = {grid_.left_face(w) + 1, row};
    router_.keep(disc, net);
    groups_[net].push_back({disc});
  }

  std::vector<int> nets_in_order() const {
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

  double extent(int net) const {
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

  void start(const Group& group) {
    for (const GridCell& cell : group) {
      router_.start(cell);
    }
  }

  void route_net(int net) {
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

  int top_row() const { return router_.rows() - 1; }

  // A body without wheels begins at the end where its port is.
  void begin_at_end(int net, bool is_left) {
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
  void add_port(int element) {
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

  bool is_free(int column, int row) const { return router_.is_free_within({column, row}); }

  void add_clutch(int element) {
    const SchemeElement& clutch = train_.elements[at(element)];
    for (const int body : {clutch.body, clutch.other}) {
      if (!groups_.contains(body)) {
        begin_at_end(body, body == clutch.body);
      }
    }
    if (const auto gap = find_gap(router_, clutch.body, clutch.other)) {
      join_clutch(element, gap->left, gap->is_turned);
    } else {
      ++missing_;
    }
  }

  void join_clutch(int element, GridCell left, bool is_turned) {
    const SchemeElement& clutch = train_.elements[at(element)];
    const GridCell right = {left.column + 3, left.row};
    const GridCell at = is_turned ? right : left;
    const GridCell beyond = is_turned ? left : right;
    for (const int row : {left.row - 1, left.row, left.row + 1}) {
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
  void add_brake(int element, int net) {
    std::vector<SchemeRouter::End> ends;
    for (int column = 1; column + 1 < router_.columns(); ++column) {
      const int row = top_row();
      if (is_free(column, row) && is_free(column - 1, row) && is_free(column + 1, row)) {
        ends.push_back({.cell = {column, row}, .price = 0.0});
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
    const bool is_above = end->row == top_row();
    const GridCell beyond = {is_above ? end->column : end->column + (end->column == 0 ? -1 : 1),
                             is_above ? end->row + 1 : end->row};
    for (const int side : {-1, 1}) {
      const GridCell beside = {end->column + (is_above ? side : 0),
                               end->row + (is_above ? 0 : side)};
      router_.block(beside);
    }
    symbols_.push_back({.element = element, .body = body_of(net), .at = *end, .beyond = beyond});
  }

  // From here on places in pixels: tracks and outer rows in which nothing turns come together.

  void find_places() {
    std::vector<bool> is_used(at(grid_.track_count()), false);
    std::vector<bool> is_used_row(at(grid_.row_count()), false);
    for (const SchemeRouter::Step& step : router_.steps()) {
      if (step.from.column == step.to.column) {
        is_used[at(step.from.column)] = true;
      } else {
        is_used_row[at(step.from.row)] = true;
      }
    }
    for (const Symbol& symbol : symbols_) {
      for (const GridCell& cell : {symbol.at, symbol.beyond}) {
        const int column = std::clamp(cell.column, 0, grid_.track_count() - 1);
        is_used[at(column)] = true;
        is_used_row[at(std::min(cell.row, top_row()))] = true;
      }
      const bool is_clutch = std::abs(symbol.at.column - symbol.beyond.column) == 3;
      for (int i = 1; is_clutch && i < 3; ++i) {
        is_used[at(std::min(symbol.at.column, symbol.beyond.column) + i)] = true;
      }
    }
    for (const Pin& pin : pins_) {
      is_used[at(pin.left)] = true;
      is_used[at(pin.right)] = true;
    }
    grid_.close_up(is_used, is_used_row);
  }

  SchemeLayout finish() {
    find_places();
    SchemeLayout layout;
    for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
      if (grid_.is_placed(w)) {
        layout.wheels.push_back(drawn(w));
      }
    }
    add_shafts(layout);
    for (const Pin& pin : pins_) {
      layout.pins.push_back(drawn(pin));
    }
    for (const Symbol& symbol : symbols_) {
      layout.elements.push_back({.element = symbol.element,
                                 .body = symbol.body,
                                 .at = grid_.place(symbol.at),
                                 .beyond = grid_.place(symbol.beyond)});
    }
    layout.box = {.left = grid_.x(0),
                  .top = -grid_.height(top_row()),
                  .right = grid_.x(grid_.track_count() - 1),
                  .bottom = 0.0};
    layout.crossings = router_.crossings();
    return layout;
  }

  DrawnWheel drawn(int w) const {
    DrawnWheel result{.wheel = w,
                      .left = grid_.x(grid_.left_face(w)),
                      .right = grid_.x(grid_.right_face(w)),
                      .discs = {},
                      .low = wheel(w).planet < 0 ? 0.0 : grid_.low(w),
                      .high = grid_.high(w)};
    const SchemeColumns& columns = grid_.columns();
    for (int column = columns.first[at(w)]; column <= columns.last[at(w)]; ++column) {
      result.discs.push_back(grid_.x(grid_.centre(column)));
      if (wheel(w).planet < 0) {
        break;
      }
    }
    return result;
  }

  // A pin ends behind its bearing where nothing holds it.
  DrawnPin drawn(const Pin& pin) const {
    constexpr double kBeyond = 11.0;
    const auto is_held = [this](GridCell end) {
      return std::ranges::any_of(router_.steps(), [end](const SchemeRouter::Step& step) {
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
            .height = grid_.height(pin.row)};
  }

  // Steps of one line become one.
  void add_shafts(SchemeLayout& layout) const {
    std::map<std::tuple<int, bool, int>, std::set<int>> runs;
    for (const SchemeRouter::Step& step : router_.steps()) {
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
        layout.shafts.push_back(
            {.body = body_of(net),
             .from = grid_.place(is_along ? GridCell{from, where} : GridCell{where, from}),
             .to = grid_.place(is_along ? GridCell{to, where} : GridCell{where, to})});
      }
    }
  }

  const SchemeTrain& train_;
  RouteOrder order_;
  SchemeGrid grid_;
  SchemeRouter router_;
  std::map<int, std::vector<Group>> groups_;  // of each net: what is to be joined
  std::vector<Pin> pins_;
  std::vector<Symbol> symbols_;
  int housing_parts_ = 0;
  int missing_ = 0;  // connections that found no way
};

}  // namespace

SchemeLayout lay_out_scheme(const SchemeTrain& train) {
  const SchemeRadii radii = find_radii(train);
  const SchemeColumns columns = find_columns(train, radii);
  SchemeLayout best;
  double least = std::numeric_limits<double>::infinity();
  for (const RouteOrder order : {RouteOrder::small_first,
                                 RouteOrder::as_in_file,
                                 RouteOrder::large_first,
                                 RouteOrder::reversed}) {
    SchemeBuilder builder(train, radii, columns, order);
    SchemeLayout layout = builder.build();
    if (builder.price() < least) {
      least = builder.price();
      best = std::move(layout);
    }
  }
  return best;
}

}  // namespace kinestat
