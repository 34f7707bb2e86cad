#include "draw/train/scheme_axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <set>

#include "core/index.hpp"

namespace kinestat {

namespace {

// Some neighbours are taken out and put in again at a place.
std::vector<int> moved(std::vector<int> order, int from, int length, int to) {
  const auto begin = order.begin() + from;
  const std::vector<int> some(begin, begin + length);
  order.erase(begin, begin + length);
  order.insert(order.begin() + to, some.begin(), some.end());
  return order;
}

// The cheapest order: of all of a few things, else of what moving some after the others finds, from
// 0, 1, 2 on.
template <class Cost>
std::vector<int> best_order(int count, const Cost& cost) {
  constexpr int kFew = 5;
  constexpr int kMostMoved = 3;
  std::vector<int> order(at(count));
  std::iota(order.begin(), order.end(), 0);
  std::vector<int> best = order;
  double least = cost(best);
  const auto try_order = [&](const std::vector<int>& other) {
    const double price = cost(other);
    const bool is_better = price < least;
    if (is_better) {
      least = price;
      best = other;
    }
    return is_better;
  };
  if (count <= kFew) {
    while (std::ranges::next_permutation(order).found) {
      try_order(order);
    }
    return best;
  }
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (int length = 1; length <= kMostMoved; ++length) {
      for (int from = 0; from + length <= count; ++from) {
        for (int to = 0; to + length <= count; ++to) {
          goes_on = try_order(moved(best, from, length, to)) || goes_on;
        }
      }
    }
  }
  return best;
}

std::vector<int> places_of(const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[at(order[i])] = static_cast<int>(i);
  }
  return place;
}

double price_of_axes(const SchemeTrain& train, const std::vector<int>& order) {
  constexpr double kApart = 10.0;
  constexpr double kFurther = 3.0;
  constexpr double kOffMiddle = 0.5;
  constexpr double kBelow = 0.2;
  constexpr double kInner = 0.4;
  const std::vector<int> place = places_of(order);
  const int last = train.axis_count - 1;
  double price = kOffMiddle * std::abs(2 * place.front() - last) / 2.0;
  for (const SchemeMesh& mesh : train.meshes) {
    const int between = std::abs(place[at(train.wheels[at(mesh.first)].axis)] -
                                 place[at(train.wheels[at(mesh.second)].axis)]) -
                        1;
    price += between > 0 ? kApart + kFurther * between : 0.0;
  }
  price += place[1] < place[0] ? kBelow : 0.0;
  for (const SchemeElement& element : train.elements) {
    const int of = place[at(element.axis)];
    const bool is_side = element.kind == SchemeElementKind::output && element.axis > 0;
    price += is_side && of > 0 && of < last ? kInner : 0.0;
  }
  return price;
}

class ExtentFinder {
 public:
  ExtentFinder(const SchemeTrain& train, const SchemeColumns& columns)
      : train_(train), columns_(columns) {}

  std::map<int, SchemeExtent> find() {
    for (std::size_t w = 0; w < train_.wheels.size(); ++w) {
      const SchemeWheel& wheel = train_.wheels[w];
      if (columns_.last[w] < 0) {
        continue;
      }
      if (wheel.planet < 0) {
        reach(wheel.body, wheel.axis, columns_.first[w], columns_.last[w]);
      } else {
        const SchemePlanet& planet = train_.planets[at(wheel.planet)];
        reach(planet.carrier, planet.axis, columns_.first[w] - kBeside, columns_.last[w] + kBeside);
        continue;
      }
      found_[wheel.body].is_on_axis = true;
    }
    for (const SchemeElement& element : train_.elements) {
      if (element.kind == SchemeElementKind::input) {
        reach(element.body, element.axis, -1, -1);
      } else if (element.kind == SchemeElementKind::output) {
        reach(element.body, element.axis, columns_.count, columns_.count);
      }
    }
    const std::vector<std::pair<int, int>> pairs = find_bearing_pairs(train_);
    for (std::size_t round = 0; round < pairs.size(); ++round) {
      for (const auto& [inner, outer] : pairs) {
        if (const auto held = found_.find(outer); held != found_.end()) {
          const SchemeExtent of = held->second;
          reach(inner, of.axis, of.low, of.high);
          found_[inner].is_on_axis = true;
        }
      }
    }
    found_.erase(0);
    find_levels(pairs);
    return std::move(found_);
  }

 private:
  static constexpr double kBeside = 0.4;

  void reach(int body, int axis, double low, double high) {
    const auto [at, is_new] =
        found_.try_emplace(body, SchemeExtent{.axis = axis, .low = low, .high = high});
    if (!is_new) {
      at->second.low = std::min(at->second.low, low);
      at->second.high = std::max(at->second.high, high);
    }
  }

  // A shaft runs round those that reach as far to both sides.
  void find_levels(const std::vector<std::pair<int, int>>& pairs) {
    std::vector<int> bodies;
    for (const auto& [body, extent] : found_) {
      bodies.push_back(body);
    }
    const auto width = [&](int body) { return found_[body].high - found_[body].low; };
    const auto bears = [&](int a, int b) {
      return std::ranges::find(pairs, std::pair(a, b)) != pairs.end();
    };
    std::ranges::stable_sort(bodies, [&](int a, int b) { return width(a) > width(b); });
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < bodies.size(); ++j) {
        if (width(bodies[i]) == width(bodies[j]) && bears(bodies[j], bodies[i])) {
          std::swap(bodies[i], bodies[j]);
        }
      }
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      SchemeExtent& outer = found_[bodies[i]];
      for (std::size_t j = 0; j < i; ++j) {
        const SchemeExtent& inner = found_[bodies[j]];
        if (inner.is_on_axis && inner.axis == outer.axis && inner.low <= outer.low &&
            outer.high <= inner.high) {
          outer.level = std::max(outer.level, inner.level + 1);
        }
      }
    }
  }

  const SchemeTrain& train_;
  const SchemeColumns& columns_;
  std::map<int, SchemeExtent> found_;
};

SchemeColumns reordered(const SchemeColumns& columns, const std::vector<int>& sets) {
  std::vector<int> place(at(columns.count));
  SchemeColumns result = columns;
  int next = 0;
  for (const int set : sets) {
    for (int column = 0; column < columns.count; ++column) {
      if (columns.set_of[at(column)] == set) {
        result.set_of[at(next)] = set;
        result.links[at(next)] = columns.links[at(column)];
        place[at(column)] = next++;
      }
    }
  }
  for (std::size_t w = 0; w < columns.first.size(); ++w) {
    if (columns.last[w] >= 0) {
      const int a = place[at(columns.first[w])];
      const int b = place[at(columns.last[w])];
      result.first[w] = std::min(a, b);
      result.last[w] = std::max(a, b);
    }
  }
  for (int& column : result.mesh) {
    column = column < 0 ? column : place[at(column)];
  }
  return result;
}

class ColumnPrice {
 public:
  ColumnPrice(const SchemeTrain& train, const SchemeRadii& radii, const SchemeColumns& columns)
      : train_(train),
        radii_(radii),
        columns_(columns),
        pairs_(find_bearing_pairs(train)),
        extents_(find_extents(train, columns)) {}

  double price() const {
    double price = 0.0;
    for (const auto& [body, extent] : extents_) {
      price += kLength * (extent.high - extent.low) + kBlocked * wheels_over(extent);
      for (const auto& [other, of] : extents_) {
        if (other > body && of.axis == extent.axis) {
          price += kBlocked * std::min(wheels_within(body, of), wheels_within(other, extent));
        }
      }
    }
    for (const SchemeElement& element : train_.elements) {
      if (element.kind == SchemeElementKind::clutch) {
        price += price_of(element);
      }
    }
    for (const SchemeMesh& mesh : train_.meshes) {
      price += mesh.is_apart ? kBetween * columns_between(mesh.first, mesh.second) : 0.0;
    }
    return price;
  }

 private:
  static constexpr double kLength = 1.0;
  static constexpr double kBlocked = 100.0;
  static constexpr double kBetween = 10.0;

  // Of a body, or on it.
  int wheels_within(int body, const SchemeExtent& extent) const {
    int count = 0;
    for (std::size_t w = 0; w < train_.wheels.size(); ++w) {
      const SchemeWheel& wheel = train_.wheels[w];
      const bool is_borne = std::ranges::find(pairs_, std::pair(body, wheel.body)) != pairs_.end();
      const bool is_within = columns_.last[w] > extent.low && columns_.first[w] < extent.high;
      count += wheel.planet < 0 && (wheel.body == body || is_borne) && is_within ? 1 : 0;
    }
    return count;
  }

  int columns_between(int a, int b) const {
    const int from = std::min(columns_.last[at(a)], columns_.last[at(b)]);
    const int to = std::max(columns_.first[at(a)], columns_.first[at(b)]);
    return std::max(0, to - from);
  }

  // Of other axes, in the way of a shaft.
  int wheels_over(const SchemeExtent& extent) const {
    const double height = radii_.axes[at(extent.axis)];
    int count = 0;
    for (std::size_t w = 0; w < train_.wheels.size(); ++w) {
      const WheelSpan span = span_of(train_, radii_, static_cast<int>(w));
      const bool is_over = columns_.last[w] > extent.low && columns_.first[w] < extent.high &&
                           span.low < height && height < span.high;
      count += is_over && train_.wheels[w].axis != extent.axis ? 1 : 0;
    }
    return count;
  }

  // What stands between two bodies that a clutch is to join.
  double price_of(const SchemeElement& clutch) const {
    const auto a = extents_.find(clutch.body);
    const auto b = extents_.find(clutch.other);
    if (a == extents_.end() || b == extents_.end()) {
      return 0.0;
    }
    const double low = std::min(a->second.high, b->second.high);
    const double high = std::max(a->second.low, b->second.low);
    double price = kLength * std::max(0.0, high - low);
    for (std::size_t w = 0; w < train_.wheels.size(); ++w) {
      const SchemeWheel& wheel = train_.wheels[w];
      const bool is_between = columns_.first[w] > low && columns_.last[w] < high;
      price += is_between && wheel.axis == a->second.axis && wheel.planet < 0 ? kBetween : 0.0;
    }
    return price;
  }

  const SchemeTrain& train_;
  const SchemeRadii& radii_;
  const SchemeColumns& columns_;
  std::vector<std::pair<int, int>> pairs_;
  std::map<int, SchemeExtent> extents_;
};

double price_of_columns(const SchemeTrain& train,
                        const SchemeRadii& radii,
                        const SchemeColumns& columns) {
  return ColumnPrice(train, radii, columns).price();
}

}  // namespace

std::vector<int> find_axis_order(const SchemeTrain& train) {
  return best_order(train.axis_count,
                    [&](const std::vector<int>& order) { return price_of_axes(train, order); });
}

// Where a file has all bearings in the housing, clutches tell.
std::vector<std::pair<int, int>> find_bearing_pairs(const SchemeTrain& train) {
  std::map<int, int> bearings;
  std::map<int, int> clutches;
  std::map<int, int> wheels;
  std::set<int> has_port;
  for (const SchemeBearing& one : train.bearings) {
    ++bearings[one.first];
    ++bearings[one.second];
  }
  for (const SchemeWheel& wheel : train.wheels) {
    ++wheels[wheel.body];
  }
  for (const SchemeElement& element : train.elements) {
    if (element.kind == SchemeElementKind::clutch) {
      ++clutches[element.body];
      ++clutches[element.other];
    } else if (element.kind != SchemeElementKind::brake) {
      has_port.insert(element.body);
    }
  }
  std::vector<std::pair<int, int>> pairs;
  const auto add = [&](int inner, int outer) {
    if (!has_port.contains(outer)) {
      pairs.emplace_back(inner, outer);
    }
  };
  for (const SchemeBearing& one : train.bearings) {
    const bool is_turned = bearings[one.second] > bearings[one.first];
    add(is_turned ? one.second : one.first, is_turned ? one.first : one.second);
  }
  // An idler that nothing but clutches holds runs on that which most clutches join.
  std::map<int, int> bearer;
  for (const SchemeElement& element : train.elements) {
    for (const auto& [inner, outer] :
         {std::pair(element.body, element.other), std::pair(element.other, element.body)}) {
      const bool is_idler = element.kind == SchemeElementKind::clutch && bearings[outer] == 0 &&
                            wheels[outer] == 1 && clutches[outer] < clutches[inner];
      if (is_idler) {
        int& best = bearer.try_emplace(outer, inner).first->second;
        best = clutches[inner] > clutches[best] ? inner : best;
      }
    }
  }
  for (const auto& [outer, inner] : bearer) {
    add(inner, outer);
  }
  return pairs;
}

std::map<int, SchemeExtent> find_extents(const SchemeTrain& train, const SchemeColumns& columns) {
  return ExtentFinder(train, columns).find();
}

SchemeColumns order_columns(const SchemeTrain& train,
                            const SchemeRadii& radii,
                            const SchemeColumns& columns) {
  if (train.has_places) {
    return columns;
  }
  std::vector<int> sets;
  for (const int set : columns.set_of) {
    if (std::ranges::find(sets, set) == sets.end()) {
      sets.push_back(set);
    }
  }
  const auto in_order = [&](const std::vector<int>& order) {
    std::vector<int> chosen;
    for (const int i : order) {
      chosen.push_back(sets[at(i)]);
    }
    return reordered(columns, chosen);
  };
  return in_order(best_order(static_cast<int>(sets.size()), [&](const std::vector<int>& order) {
    return price_of_columns(train, radii, in_order(order));
  }));
}

}  // namespace kinestat
