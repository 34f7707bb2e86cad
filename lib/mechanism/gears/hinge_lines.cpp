#include "mechanism/gears/hinge_lines.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "graph/components.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

namespace {

struct Hinge {
  CouplingId coupling;
  BodyId tail;
  BodyId head;
  Vec3 direction;
  Vec3 point;
  double mark = 0.0;  // the same for hinges on one line, up to rounding
};

// Where the line comes nearest to the origin, along a direction in which few mechanisms lie.
double mark_of(const Vec3& point, const Vec3& direction) {
  const Vec3 foot = point - point.dot(direction) * direction;
  return foot.dot(Vec3(0.61, 0.67, 0.43));
}

template <class Line>
bool is_one_line(const Line& a, const Line& b, double length) {
  const Vec3 between = b.point - a.point;
  return a.direction.cross(b.direction).norm() <= kParallelAxes &&
         between.cross(a.direction).norm() <= kParallelAxes * length;
}

class LineSearch {
 public:
  LineSearch(const Topology& topology, const Geometry& geometry)
      : length_(geometry.length), hinges_at_(topology.bodies.size()) {
    for (int e = 0; e < topology.coupling_count(); ++e) {
      if (is_hinge(topology.coupling(CouplingId{e}).type)) {
        add(CouplingId{e}, topology, geometry);
      }
    }
  }

  std::vector<HingeLine> run() {
    Digraph joined{.vertex_count = static_cast<int>(hinges_.size()), .edges = {}};
    for (std::vector<int>& hinges : hinges_at_) {
      join_lines(hinges, joined);
    }
    std::vector<HingeLine> lines;
    for (const std::vector<int>& hinges : find_components(joined)) {
      const Hinge& first = hinges_[at(hinges.front())];
      HingeLine line{
          .direction = first.direction, .point = first.point, .hinges = {}, .bodies = {}};
      for (const int h : hinges) {
        const Hinge& hinge = hinges_[at(h)];
        line.hinges.push_back(hinge.coupling);
        line.bodies.push_back(hinge.tail);
        line.bodies.push_back(hinge.head);
      }
      std::ranges::sort(line.bodies, {}, &BodyId::value);
      line.bodies.erase(std::unique(line.bodies.begin(), line.bodies.end()), line.bodies.end());
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  void add(CouplingId id, const Topology& topology, const Geometry& geometry) {
    const CouplingTopology& coupling = topology.coupling(id);
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      const std::optional<ScrewAxis> axis = find_axis(geometry.motions[at(f)], geometry.length);
      if (topology.freedoms[at(f)].is_rotation && axis && axis->point) {
        hinges_at_[at(coupling.tail.value)].push_back(static_cast<int>(hinges_.size()));
        hinges_at_[at(coupling.head.value)].push_back(static_cast<int>(hinges_.size()));
        hinges_.push_back({.coupling = id,
                           .tail = coupling.tail,
                           .head = coupling.head,
                           .direction = axis->direction,
                           .point = *axis->point,
                           .mark = mark_of(*axis->point, axis->direction)});
        farthest_ = std::max(farthest_, axis->point->norm());
        return;
      }
    }
  }

  // Joins the hinges of one body that lie on one line. Sorted by their marks, each need be compared
  // only with the first of each line near it: of many shafts in a housing, few.
  void join_lines(std::vector<int>& hinges, Digraph& joined) const {
    const double slack = 4.0 * kParallelAxes * (length_ + farthest_);
    std::ranges::sort(hinges, {}, [this](int h) { return hinges_[at(h)].mark; });
    std::vector<int> lines;
    for (const int h : hinges) {
      const Hinge& hinge = hinges_[at(h)];
      auto line = lines.rbegin();
      while (line != lines.rend() && hinges_[at(*line)].mark >= hinge.mark - slack &&
             !is_one_line(hinges_[at(*line)], hinge, length_)) {
        ++line;
      }
      if (line != lines.rend() && hinges_[at(*line)].mark >= hinge.mark - slack) {
        joined.edges.push_back({.tail = *line, .head = h});
      } else {
        lines.push_back(h);
      }
    }
  }

  double length_;
  double farthest_ = 0.0;  // of all points from the origin
  std::vector<Hinge> hinges_;
  std::vector<std::vector<int>> hinges_at_;  // of each body, by their marks
};

}  // namespace

bool is_hinge(CouplingType type) {
  return kind_of(type).is_hinge;
}

std::vector<HingeLine> find_hinge_lines(const Topology& topology, const Geometry& geometry) {
  return LineSearch(topology, geometry).run();
}

bool are_one_line(const HingeLine& a, const HingeLine& b, double length) {
  return is_one_line(a, b, length);
}

}  // namespace kinestat
