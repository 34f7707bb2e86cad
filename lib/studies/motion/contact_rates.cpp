#include "studies/motion/contact_rates.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/rounding.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "studies/motion/internal/coupling_poses.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/pivoted_qr.hpp"

namespace kinestat {

namespace {

bool lacks_rates(const CouplingTopology& coupling, const MotionState& state) {
  const auto first = state.rates.begin() + coupling.first_freedom;
  return std::any_of(first, first + coupling.freedom_count, [](const std::optional<double>& rate) {
    return !rate;
  });
}

// Lengths in sizes of the mechanism, so that turns and slides are of one order.
Vec6 in_sizes(const Twist& twist, double length) {
  Vec6 result;
  result << twist.angular, twist.linear / length;
  return result;
}

// The relative motion of two bodies, and how far each component may be off.
struct RelativeMotion {
  Vec6 value;
  Vec6 bound;
};

RelativeMotion relative_motion(const CouplingTopology& coupling,
                               const MotionState& state,
                               double length) {
  RelativeMotion result{.value = Vec6::Zero(), .bound = Vec6::Zero()};
  for (const BodyId body : {coupling.tail, coupling.head}) {
    const double sense = body == coupling.head ? 1.0 : -1.0;
    const Vec6 twist = in_sizes(state.twists[at(body.value)], length);
    const BodyBounds& bounds = state.bounds.bodies[at(body.value)];
    result.value += sense * twist;
    result.bound += in_sizes({.angular = Vec3::Constant(bounds.angular),
                              .linear = Vec3::Constant(bounds.linear)},
                             length) +
                    kEpsilon * twist.cwiseAbs();
  }
  return result;
}

// Of independent screws: what each is of the components of a motion that they span.
MatX inverse_of(const Mat6X& screws) {
  const auto count = static_cast<int>(screws.cols());
  PivotedQr qr;
  qr.factor({screws.data(), static_cast<std::size_t>(screws.size())}, 6, count, kSize);
  MatX inverse(count, 6);
  std::vector<double> shares(at(count));
  for (int i = 0; i < 6; ++i) {
    const Vec6 unit = Vec6::Unit(i);
    qr.solve({unit.data(), 6}, shares);
    for (int f = 0; f < count; ++f) {
      inverse(f, i) = shares[at(f)];
    }
  }
  return inverse;
}

}  // namespace

void add_contact_rates(const MotionNetwork& network,
                       std::span<const DrawnCoupling> drawn,
                       const Mechanism& mechanism,
                       MotionState& state) {
  if (state.twists.empty()) {
    return;
  }
  KINESTAT_EXPECTS(!state.bounds.bodies.empty());
  const double length = network.length;
  for (int e = 0; e < mechanism.topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = mechanism.topology.coupling(CouplingId{e});
    if (!lacks_rates(coupling, state)) {
      continue;
    }
    const MovedCoupling moved =
        moved_coupling(mechanism,
                       CouplingId{e},
                       drawn[at(e)],
                       poses_of(network, mechanism.topology, state.poses, CouplingId{e}));
    Mat6X screws(6, coupling.freedom_count);
    for (int f = 0; f < coupling.freedom_count; ++f) {
      screws.col(f) = in_sizes(moved.motions[at(f)], length);
    }
    const RelativeMotion motion = relative_motion(coupling, state, length);
    const MatX inverse = inverse_of(screws);
    const VecX rates = inverse * motion.value;
    // The screws are off by as much as what they lie on.
    const double place = state.bounds.place + state.bounds.bodies[at(coupling.tail.value)].turn +
                         state.bounds.bodies[at(coupling.head.value)].turn + kDataRounding;
    const Vec6 bound = motion.bound + place * (screws.cwiseAbs() * rates.cwiseAbs() +
                                               Vec6::Constant(rates.cwiseAbs().sum()));
    const VecX bounds = inverse.cwiseAbs() * bound;
    for (int f = 0; f < coupling.freedom_count; ++f) {
      const std::size_t freedom = at(coupling.first_freedom + f);
      state.rates[freedom] = zero_within_bound(rates[f], bounds[f]);
      state.bounds.rates[freedom] = bounds[f];
    }
  }
}

}  // namespace kinestat
