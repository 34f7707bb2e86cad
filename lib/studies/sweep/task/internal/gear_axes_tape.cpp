#include "studies/sweep/task/internal/gear_axes_tape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/tolerance.hpp"
#include "mechanism/gears/mesh.hpp"

namespace kinestat {

namespace {

// Two axes closer than this share of the size are left to the whole analysis.
constexpr double kNearAxes = 1e3 * kParallelAxes;

// The first rotation of a coupling about which gears may turn.
struct HingeAxis {
  std::size_t freedom = 0;
  Vec3 direction;
  BodyId tail;
  BodyId head;

  bool shares_body(const HingeAxis& other) const {
    return tail == other.tail || tail == other.head || head == other.tail || head == other.head;
  }
};

std::vector<HingeAxis> hinge_axes(const Mechanism& mechanism) {
  std::vector<HingeAxis> axes;
  for (const CouplingTopology& coupling : mechanism.topology.couplings) {
    const int end = coupling.first_freedom + coupling.freedom_count;
    for (int f = coupling.first_freedom; is_hinge(coupling.type) && f < end; ++f) {
      const auto i = static_cast<std::size_t>(f);
      if (mechanism.topology.freedoms[i].is_rotation) {
        axes.push_back({.freedom = i,
                        .direction = mechanism.geometry.motions[i].angular,
                        .tail = coupling.tail,
                        .head = coupling.head});
        break;
      }
    }
  }
  return axes;
}

// Of two axes that are parallel: one line, or two, as in the recorded state.
void demand_same_line(
    const TapedScrew& a, const TapedScrew& b, double sense, double length, LaneRecorder& recorder) {
  std::array<TapeNumber, 3> between;
  TapeNumber widest = recorder.constant(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    between[i] = recorder.subtract_product(a[i + 3], b[i + 3], recorder.constant(sense));
    if (std::abs(recorder.value(between[i])) > std::abs(recorder.value(widest))) {
      widest = between[i];
    }
  }
  if (std::abs(recorder.value(widest)) > kParallelAxes * length) {
    recorder.demand_at_least(widest, recorder.constant(kNearAxes * length));
    return;
  }
  for (const TapeNumber one : between) {
    recorder.demand_at_most(one, recorder.constant(kParallelAxes * length / 2.0));
  }
}

}  // namespace

bool demand_same_axes(const Mechanism& mechanism,
                      std::span<const TapedScrew> motions,
                      LaneRecorder& recorder) {
  const std::vector<HingeAxis> axes = hinge_axes(mechanism);
  for (const HingeAxis& one : axes) {
    const TapedScrew& screw = motions[one.freedom];
    if (!std::ranges::all_of(std::span(screw).first(3),
                             [&](TapeNumber part) { return recorder.is_constant(part); })) {
      return false;
    }
  }
  // Carriers follow from which hinges of one body lie on one line; that planets of two sets come to
  // stand on one line decides nothing.
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t j = i + 1; j < axes.size(); ++j) {
      if (axes[i].shares_body(axes[j]) &&
          axes[i].direction.cross(axes[j].direction).norm() <= kParallelAxes) {
        demand_same_line(motions[axes[i].freedom],
                         motions[axes[j].freedom],
                         axes[i].direction.dot(axes[j].direction) < 0.0 ? -1.0 : 1.0,
                         mechanism.geometry.length,
                         recorder);
      }
    }
  }
  return true;
}

}  // namespace kinestat
