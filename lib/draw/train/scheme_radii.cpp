#include "draw/train/scheme_radii.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/index.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// A sum of radii and distances of pins that must vanish.
struct Touch {
  std::vector<std::pair<std::size_t, double>> terms;  // variable, factor
};

class RadiusFinder {
 public:
  RadiusFinder(const SchemeTrain& train, std::span<const int> order)
      : train_(train), order_(order.begin(), order.end()) {
    for (const SchemeWheel& wheel : train.wheels) {
      values_.push_back(wheel.radius);
      ease_.push_back(wheel.radius * wheel.radius);
    }
    add_planets();
    add_gaps();
    for (const SchemeMesh& mesh : train.meshes) {
      add_touch(mesh);
    }
  }

  // The nearest values that meet all conditions, by projection on one after the other (Kaczmarz):
  // each variable gives way by its square, the pins much more easily.
  SchemeRadii find() {
    constexpr int kMostRounds = 200'000;
    const double near = kSameValue * *std::ranges::max_element(values_);
    double worst = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMostRounds && worst > near; ++round) {
      worst = 0.0;
      for (const Touch& touch : touches_) {
        worst = std::max(worst, std::abs(project(touch)));
      }
    }
    const auto wheels = static_cast<std::ptrdiff_t>(train_.wheels.size());
    const auto planets = static_cast<std::ptrdiff_t>(train_.planets.size());
    SchemeRadii result{.wheels = {values_.begin(), values_.begin() + wheels},
                       .planets = {values_.begin() + wheels, values_.begin() + wheels + planets}};
    stack_axes(result);
    return result;
  }

 private:
  std::size_t pin(int planet) const { return train_.wheels.size() + at(planet); }

  const SchemeWheel& wheel(int i) const { return train_.wheels[at(i)]; }

  // A planet on another begins beyond it.
  void add_planets() {
    double largest = 0.0;
    for (const SchemeWheel& one : train_.wheels) {
      largest = std::max(largest, one.radius);
    }
    for (std::size_t p = 0; p < train_.planets.size(); ++p) {
      double distance = 0.0;
      for (const SchemeMesh& mesh : train_.meshes) {
        for (const auto& [a, b] :
             {std::pair(mesh.first, mesh.second), std::pair(mesh.second, mesh.first)}) {
          const bool is_of_planet = wheel(a).planet == static_cast<int>(p);
          if (is_of_planet && wheel(b).planet < 0 && distance == 0.0) {
            distance =
                std::abs(wheel(b).radius + (wheel(b).is_ring ? -1.0 : 1.0) * wheel(a).radius);
          }
        }
      }
      values_.push_back(distance);
      ease_.push_back(100.0 * largest * largest);
    }
  }

  std::size_t gap(std::size_t i) const { return train_.wheels.size() + train_.planets.size() + i; }

  // Between an axis of the order and the next; 0 until a mesh says more.
  void add_gaps() {
    double largest = 0.0;
    for (const SchemeWheel& one : train_.wheels) {
      largest = std::max(largest, one.radius);
    }
    for (std::size_t i = 0; i + 1 < order_.size(); ++i) {
      values_.push_back(0.0);
      ease_.push_back(largest * largest);
      for (const SchemeMesh& mesh : train_.meshes) {
        if (is_between(mesh, i)) {
          values_.back() = wheel(mesh.first).radius + wheel(mesh.second).radius;
          break;
        }
      }
    }
  }

  bool is_between(const SchemeMesh& mesh, std::size_t i) const {
    const int a = wheel(mesh.first).axis;
    const int b = wheel(mesh.second).axis;
    return (a == order_[i] && b == order_[i + 1]) || (b == order_[i] && a == order_[i + 1]);
  }

  void stack_axes(SchemeRadii& result) const {
    result.axes.resize(std::max<std::size_t>(order_.size(), 1), 0.0);
    double height = 0.0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      result.axes[at(order_[i])] = height;
      if (i + 1 < order_.size()) {
        const double asked = values_[gap(i)];
        height += asked > 0.0
                      ? asked
                      : 1.1 * (reach(result, order_[i], 1) + reach(result, order_[i + 1], -1));
      }
    }
    const double main = result.axes.front();
    for (double& axis : result.axes) {
      axis -= main;
    }
  }

  // How far the wheels of an axis reach upwards or, halves do not, downwards.
  double reach(const SchemeRadii& result, int axis, int side) const {
    double reach = 0.0;
    for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
      const int planet = wheel(w).planet;
      if (wheel(w).axis == axis && (side > 0 || is_whole(train_, w))) {
        reach =
            std::max(reach, result.wheels[at(w)] + (planet < 0 ? 0.0 : result.planets[at(planet)]));
      }
    }
    return reach;
  }

  // Which of two planets in mesh is farther out: the one that reaches a ring.
  bool is_outer(int planet) const {
    return std::ranges::any_of(train_.meshes, [&](const SchemeMesh& mesh) {
      const SchemeWheel& a = wheel(mesh.first);
      const SchemeWheel& b = wheel(mesh.second);
      return (a.planet == planet && b.is_ring) || (b.planet == planet && a.is_ring);
    });
  }

  void add_touch(const SchemeMesh& mesh) {
    if (wheel(mesh.first).axis != wheel(mesh.second).axis) {
      for (std::size_t i = 0; i + 1 < order_.size(); ++i) {
        if (is_between(mesh, i)) {
          touches_.push_back(
              {.terms = {{gap(i), 1.0}, {at(mesh.first), -1.0}, {at(mesh.second), -1.0}}});
        }
      }
      return;
    }
    int inner = mesh.first;
    int outer = mesh.second;
    if (wheel(inner).planet >= 0 && (wheel(outer).planet < 0 || (is_outer(wheel(inner).planet) &&
                                                                 !is_outer(wheel(outer).planet)))) {
      std::swap(inner, outer);
    }
    if (wheel(outer).planet < 0) {
      return;  // two wheels of one axis: the file is wrong
    }
    Touch touch;
    if (wheel(inner).planet >= 0) {
      // y_outer - y_inner = r_inner + r_outer
      touch.terms = {{pin(wheel(outer).planet), 1.0},
                     {pin(wheel(inner).planet), -1.0},
                     {at(inner), -1.0},
                     {at(outer), -1.0}};
    } else {
      // r = y ± r_planet
      const double side = wheel(inner).is_ring ? -1.0 : 1.0;
      touch.terms = {{pin(wheel(outer).planet), -1.0}, {at(inner), 1.0}, {at(outer), side}};
    }
    touches_.push_back(std::move(touch));
  }

  // By how much it missed.
  double project(const Touch& touch) {
    double miss = 0.0;
    double ease = 0.0;
    for (const auto& [variable, factor] : touch.terms) {
      miss += factor * values_[variable];
      ease += factor * factor * ease_[variable];
    }
    for (const auto& [variable, factor] : touch.terms) {
      values_[variable] -= miss / ease * ease_[variable] * factor;
    }
    return miss;
  }

  const SchemeTrain& train_;
  std::vector<int> order_;      // of axes; empty of a half section
  std::vector<double> values_;  // radii of wheels, then distances of pins, then gaps
  std::vector<double> ease_;
  std::vector<Touch> touches_;
};

class ColumnFinder {
 public:
  ColumnFinder(const SchemeTrain& train, const SchemeRadii& radii) : train_(train), radii_(radii) {}

  SchemeColumns find() {
    result_.first.resize(train_.wheels.size(), std::numeric_limits<int>::max());
    result_.last.resize(train_.wheels.size(), -1);
    result_.mesh.resize(train_.meshes.size(), -1);
    for (const std::size_t m : order_of_meshes()) {
      if (train_.meshes[m].is_apart) {
        continue;
      }
      const int column = column_for(m);
      result_.mesh[m] = column;
      for (const int w : {train_.meshes[m].first, train_.meshes[m].second}) {
        put(w, column);
      }
    }
    for (const std::size_t m : order_of_meshes()) {
      if (train_.meshes[m].is_apart) {
        place_apart(train_.meshes[m].first, train_.meshes[m].second);
        place_apart(train_.meshes[m].second, train_.meshes[m].first);
      }
    }
    result_.links.resize(wheels_in_.size(), 0);
    result_.count = static_cast<int>(wheels_in_.size());
    return std::move(result_);
  }

 private:
  std::vector<std::size_t> order_of_meshes() const {
    std::vector<std::size_t> order(train_.meshes.size());
    for (std::size_t m = 0; m < order.size(); ++m) {
      order[m] = m;
    }
    const std::vector<int> sets = sets_of_meshes();
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      if (train_.has_places) {
        return train_.meshes[a].at < train_.meshes[b].at;
      }
      return sets[a] < sets[b];
    });
    return order;
  }

  void put(int wheel, int column) {
    wheels_in_[at(column)].insert(wheel);
    result_.first[at(wheel)] = std::min(result_.first[at(wheel)], column);
    result_.last[at(wheel)] = std::max(result_.last[at(wheel)], column);
  }

  // A wheel that has no neighbour to mesh with stands where its mate does, if it may; else it is a
  // set of its own.
  void place_apart(int wheel, int mate) {
    if (result_.last[at(wheel)] >= 0) {
      return;
    }
    for (int column = result_.first[at(mate)]; column <= result_.last[at(mate)]; ++column) {
      if (has_room(column, wheel)) {
        put(wheel, column);
        return;
      }
    }
    wheels_in_.emplace_back();
    put(wheel, static_cast<int>(wheels_in_.size()) - 1);
    result_.set_of.push_back(static_cast<int>(train_.meshes.size() + wheels_in_.size()));
  }

  // Meshes that share a wheel, or a planet, are of one set; numbered by their first mesh.
  std::vector<int> sets_of_meshes() const {
    std::vector<int> sets(train_.meshes.size());
    for (std::size_t m = 0; m < sets.size(); ++m) {
      sets[m] = static_cast<int>(m);
    }
    for (std::size_t changed = 1; changed > 0;) {
      changed = 0;
      for (std::size_t a = 0; a < sets.size(); ++a) {
        for (std::size_t b = 0; b < sets.size(); ++b) {
          if (sets[b] < sets[a] && are_joined(train_.meshes[a], train_.meshes[b])) {
            sets[a] = sets[b];
            ++changed;
          }
        }
      }
    }
    return sets;
  }

  bool are_joined(const SchemeMesh& a, const SchemeMesh& b) const {
    for (const int i : {a.first, a.second}) {
      for (const int j : {b.first, b.second}) {
        const int planet = train_.wheels[at(i)].planet;
        if (i == j || (planet >= 0 && planet == train_.wheels[at(j)].planet)) {
          return true;
        }
      }
    }
    return false;
  }

  // The last column that has one of the two wheels and room for both, else a new one.
  int column_for(std::size_t m) {
    const SchemeMesh& mesh = train_.meshes[m];
    const int set = sets_of_meshes()[m];
    for (int column = static_cast<int>(wheels_in_.size()) - 1; column >= 0; --column) {
      const std::set<int>& wheels = wheels_in_[at(column)];
      const bool shares = wheels.contains(mesh.first) || wheels.contains(mesh.second);
      if (shares && has_room(column, mesh.first) && has_room(column, mesh.second)) {
        return column;
      }
    }
    wheels_in_.emplace_back();
    result_.set_of.push_back(set);
    return static_cast<int>(wheels_in_.size()) - 1;
  }

  bool has_room(int column, int wheel) const {
    return std::ranges::all_of(wheels_in_[at(column)], [&](int other) {
      return other == wheel ||
             !overlap(span_of(train_, radii_, wheel), span_of(train_, radii_, other));
    });
  }

  static bool overlap(const WheelSpan& a, const WheelSpan& b) {
    const double common = std::min(a.high, b.high) - std::max(a.low, b.low);
    return common > kDrawnTogether * std::max(std::abs(a.high), std::abs(b.high));
  }

  const SchemeTrain& train_;
  const SchemeRadii& radii_;
  SchemeColumns result_;
  std::vector<std::set<int>> wheels_in_;  // of each column
};

}  // namespace

SchemeRadii find_radii(const SchemeTrain& train) {
  return RadiusFinder(train, {}).find();
}

SchemeRadii find_radii(const SchemeTrain& train, std::span<const int> order) {
  return RadiusFinder(train, order).find();
}

bool is_whole(const SchemeTrain& train, int wheel) {
  const SchemeWheel& of = train.wheels[at(wheel)];
  bool has_planet = false;
  bool has_shaft = false;
  for (const SchemeMesh& mesh : train.meshes) {
    if (mesh.first == wheel || mesh.second == wheel) {
      const bool is_of_planet =
          train.wheels[at(mesh.first)].axis == train.wheels[at(mesh.second)].axis;
      (is_of_planet ? has_planet : has_shaft) = true;
    }
  }
  return train.axis_count > 1 && of.planet < 0 && !of.is_ring && (has_shaft || !has_planet);
}

// A sun keeps what is within it, a ring what is just beyond it.
WheelSpan span_of(const SchemeTrain& train, const SchemeRadii& radii, int wheel) {
  const SchemeWheel& of = train.wheels[at(wheel)];
  const double radius = radii.wheels[at(wheel)];
  const double axis = radii.axes[at(of.axis)];
  if (of.planet >= 0) {
    const double y = axis + radii.planets[at(of.planet)];
    return {.low = y - radius, .high = y + radius};
  }
  if (of.is_ring) {
    return {.low = axis + radius, .high = axis + 1.1 * radius};
  }
  return {.low = is_whole(train, wheel) ? axis - radius : axis, .high = axis + radius};
}

SchemeColumns find_columns(const SchemeTrain& train, const SchemeRadii& radii) {
  return ColumnFinder(train, radii).find();
}

}  // namespace kinestat
