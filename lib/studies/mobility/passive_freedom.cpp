#include "studies/mobility/passive_freedom.hpp"

#include <algorithm>
#include <utility>

#include "core/tolerance.hpp"
#include "math/dense/span.hpp"
#include "screw/point_motion.hpp"

namespace kinestat {

namespace {

// The legs of platforms have two bodies, those with a gimbal at both ends four.
constexpr std::size_t kLongestChain = 4;

// A coupling at the border of a group of bodies; +1 if its head is inside.
struct Border {
  CouplingId coupling;
  int sign = 1;
};

// Whether a turn about the axis turns the vector.
bool is_across(const Vec3& vector, const Vec3& axis) {
  return axis.cross(vector).norm() > kRankZero * axis.norm() * vector.norm();
}

// Lengths count in that of the mechanism.
double unit_of(const Mechanism& mechanism, int freedom) {
  const bool is_rotation =
      mechanism.topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation;
  return is_rotation ? 1.0 : mechanism.geometry.length;
}

// Of a body; null if it rests.
const Twist* twist_of(const PassiveFreedom& one, BodyId body) {
  const auto at = std::ranges::find(one.bodies, body);
  return at == one.bodies.end() ? nullptr
                                : &one.twists[static_cast<std::size_t>(at - one.bodies.begin())];
}

// What is rounding beside the largest becomes zero.
void snap(const Mechanism& mechanism, VecX& rates) {
  VecX sizes = rates.cwiseAbs();
  for (int f = 0; f < mechanism.topology.freedom_count(); ++f) {
    sizes[f] /= unit_of(mechanism, f);
  }
  const double zero = kRankZero * sizes.maxCoeff();
  rates = (sizes.array() <= zero).select(0.0, rates);
}

// Columns: sums of motions, whose rates those of the matrix are, in which the freedoms rest.
MatX sums_at_rest(const MatX& rates, std::span<const int> freedoms) {
  if (rates.cols() == 0) {
    return MatX(0, 0);
  }
  MatX felt(static_cast<Eigen::Index>(freedoms.size()), rates.cols());
  Eigen::Index rows = 0;
  for (const int f : freedoms) {
    felt.row(rows) = rates.row(f);
    rows += (felt.row(rows).array() != 0.0).any() ? 1 : 0;
  }
  return rows == 0 ? MatX::Identity(rates.cols(), rates.cols()) : null_space(felt.topRows(rows));
}

PassiveFreedom sum_of(const std::vector<PassiveFreedom>& passive, const VecX& shares) {
  PassiveFreedom sum{.bodies = {}, .twists = {}, .rates = VecX::Zero(passive.front().rates.size())};
  for (std::size_t p = 0; p < passive.size(); ++p) {
    const double share = shares[static_cast<Eigen::Index>(p)];
    if (share == 0.0) {
      continue;
    }
    sum.rates += share * passive[p].rates;
    for (std::size_t i = 0; i < passive[p].bodies.size(); ++i) {
      const auto at = std::ranges::find(sum.bodies, passive[p].bodies[i]);
      const auto body = static_cast<std::size_t>(at - sum.bodies.begin());
      if (at == sum.bodies.end()) {
        sum.bodies.push_back(passive[p].bodies[i]);
        sum.twists.emplace_back();
      }
      sum.twists[body] = sum.twists[body] + share * passive[p].twists[i];
    }
  }
  return sum;
}

class PassiveSearch {
 public:
  PassiveSearch(const Mechanism& mechanism, const CoordinateBasis& basis)
      : mechanism_(mechanism),
        topology_(mechanism.topology),
        basis_(basis),
        at_body_(topology_.bodies.size()) {
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology_.coupling({e});
      at_body_[static_cast<std::size_t>(coupling.tail.value)].push_back({e});
      at_body_[static_cast<std::size_t>(coupling.head.value)].push_back({e});
    }
    note_felt();
  }

  std::vector<PassiveFreedom> run() {
    for (std::size_t length = 1; length <= kLongestChain; ++length) {
      for (int b = 1; b < topology_.body_count(); ++b) {
        for (const std::vector<BodyId>& chain : chains_from({b}, length)) {
          try_bodies(chain);
        }
      }
    }
    return std::move(found_);
  }

 private:
  void note_felt() {
    for (const ActuatorTopology& actuator : topology_.actuators) {
      felt_.push_back(actuator.freedom);
    }
    for (const Case& which : mechanism_.cases) {
      for (const Primary& primary : which.motions) {
        const auto f = static_cast<std::size_t>(primary.index);
        if (topology_.coupling(topology_.freedoms[f].coupling).freedom_count == 1) {
          felt_.push_back(primary.index);
        }
      }
    }
  }

  bool is_binary(BodyId body) const {
    return body.value > 0 && at_body_[static_cast<std::size_t>(body.value)].size() == 2;
  }

  // Chains of binary bodies that begin with a body and end with one of a larger number, so that
  // each is found once; of length 1 any body.
  std::vector<std::vector<BodyId>> chains_from(BodyId first, std::size_t length) const {
    if (length == 1) {
      return {{first}};
    }
    std::vector<std::vector<BodyId>> chains;
    for (const CouplingId start : at_body_[static_cast<std::size_t>(first.value)]) {
      std::vector<BodyId> chain = {first};
      CouplingId next = start;
      while (chain.size() < length && is_binary(chain.back())) {
        const BodyId other = across(next, chain.back());
        if (!is_binary(other) || std::ranges::find(chain, other) != chain.end()) {
          break;
        }
        chain.push_back(other);
        const auto& both = at_body_[static_cast<std::size_t>(other.value)];
        next = both[0] == next ? both[1] : both[0];
      }
      if (chain.size() == length && is_binary(first) && chain.front() < chain.back()) {
        chains.push_back(std::move(chain));
      }
    }
    return chains;
  }

  BodyId across(CouplingId id, BodyId body) const {
    const CouplingTopology& coupling = topology_.coupling(id);
    return coupling.tail == body ? coupling.head : coupling.tail;
  }

  // Empty unless the group has two neighbours at least.
  std::vector<Border> border_of(const std::vector<BodyId>& bodies) const {
    std::vector<Border> border;
    std::vector<BodyId> neighbours;
    for (const BodyId body : bodies) {
      for (const CouplingId id : at_body_[static_cast<std::size_t>(body.value)]) {
        const BodyId other = across(id, body);
        if (std::ranges::find(bodies, other) == bodies.end()) {
          border.push_back({.coupling = id, .sign = topology_.coupling(id).head == body ? 1 : -1});
          if (std::ranges::find(neighbours, other) == neighbours.end()) {
            neighbours.push_back(other);
          }
        }
      }
    }
    return neighbours.size() < 2 ? std::vector<Border>() : border;
  }

  MatX freedoms_of(CouplingId id) const {
    const CouplingTopology& coupling = topology_.coupling(id);
    MatX columns(basis_.order(), coupling.freedom_count);
    for (int i = 0; i < coupling.freedom_count; ++i) {
      const auto f = static_cast<std::size_t>(coupling.first_freedom + i);
      columns.col(i) = basis_.coordinates_of(mechanism_.geometry.motions[f].coordinates());
    }
    return columns;
  }

  void try_bodies(const std::vector<BodyId>& bodies) {
    const std::vector<Border> border = border_of(bodies);
    if (border.empty()) {
      return;
    }
    std::vector<MatX> spans;
    for (const Border& one : border) {
      spans.push_back(freedoms_of(one.coupling));
      if (spans.back().cols() == 0) {
        return;
      }
    }
    const MatX common = intersect_spans(spans, basis_.order());
    if (common.cols() == 0) {
      return;
    }
    MatX rates(topology_.freedom_count(), common.cols());
    for (Eigen::Index j = 0; j < common.cols(); ++j) {
      rates.col(j) = rates_of(border, spans, common.col(j));
    }
    const MatX unfelt = common * sums_at_rest(rates, felt_);
    for (Eigen::Index j = 0; j < unfelt.cols(); ++j) {
      add(bodies, unfelt.col(j), rates_of(border, spans, unfelt.col(j)));
    }
  }

  VecX rates_of(const std::vector<Border>& border,
                const std::vector<MatX>& spans,
                const VecX& twist) const {
    VecX all = VecX::Zero(topology_.freedom_count());
    for (std::size_t i = 0; i < border.size(); ++i) {
      const int first = topology_.coupling(border[i].coupling).first_freedom;
      const std::vector<int> columns = independent_columns(spans[i]);
      MatX chosen(spans[i].rows(), static_cast<Eigen::Index>(columns.size()));
      for (std::size_t c = 0; c < columns.size(); ++c) {
        chosen.col(static_cast<Eigen::Index>(c)) = spans[i].col(columns[c]);
      }
      const VecX rates = coordinates_in(chosen, twist);
      for (std::size_t c = 0; c < columns.size(); ++c) {
        all[first + columns[c]] = border[i].sign * rates[static_cast<Eigen::Index>(c)];
      }
    }
    snap(mechanism_, all);
    return all;
  }

  void add(const std::vector<BodyId>& bodies, const VecX& twist, VecX rates) {
    PassiveFreedom one{.bodies = bodies,
                       .twists = std::vector<Twist>(
                           bodies.size(), Twist::from_coordinates(basis_.screw_of(twist))),
                       .rates = std::move(rates)};
    const bool is_felt = std::ranges::any_of(felt_, [&one](int f) { return one.moves(f); });
    if (!is_felt && is_new(one)) {
      found_.push_back(std::move(one));
    }
  }

  // A longer chain tells nothing if a part of it can move so by itself.
  bool is_new(const PassiveFreedom& one) const {
    return std::ranges::none_of(found_, [&](const PassiveFreedom& known) {
      return known.bodies.size() < one.bodies.size() &&
             std::ranges::all_of(known.bodies, [&](BodyId body) {
               return std::ranges::find(one.bodies, body) != one.bodies.end();
             });
    });
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  const CoordinateBasis& basis_;
  std::vector<std::vector<CouplingId>> at_body_;
  std::vector<int> felt_;  ///< freedoms
  std::vector<PassiveFreedom> found_;
};

}  // namespace

bool PassiveFreedom::turns(BodyId body, double length) const {
  const Twist* twist = twist_of(*this, body);
  return twist != nullptr && kinestat::turns(*twist, length);
}

bool PassiveFreedom::moves_point(BodyId body, const Vec3& drawn, double length) const {
  const Twist* twist = twist_of(*this, body);
  return twist != nullptr && kinestat::moves_point(*twist, drawn, length);
}

std::vector<PassiveFreedom> find_passive_freedoms(const Mechanism& mechanism,
                                                  const CoordinateBasis& basis) {
  return PassiveSearch(mechanism, basis).run();
}

std::vector<PassiveFreedom> passive_freedoms_beside(std::vector<PassiveFreedom> passive,
                                                    const Mechanism& mechanism,
                                                    std::span<const int> given) {
  MatX rates(mechanism.topology.freedom_count(), static_cast<Eigen::Index>(passive.size()));
  for (std::size_t p = 0; p < passive.size(); ++p) {
    rates.col(static_cast<Eigen::Index>(p)) = passive[p].rates;
  }
  std::vector<PassiveFreedom> beside;
  const MatX sums = sums_at_rest(rates, given);
  for (Eigen::Index j = 0; j < sums.cols(); ++j) {
    beside.push_back(sum_of(passive, sums.col(j)));
    snap(mechanism, beside.back().rates);
    for (const int f : given) {
      beside.back().rates[f] = 0.0;
    }
  }
  return beside;
}

std::vector<int> deciding_freedoms(const std::vector<PassiveFreedom>& passive,
                                   const Mechanism& mechanism) {
  MatX rows(static_cast<Eigen::Index>(passive.size()), mechanism.topology.freedom_count());
  for (Eigen::Index p = 0; p < rows.rows(); ++p) {
    rows.row(p) = passive[static_cast<std::size_t>(p)].rates.transpose();
  }
  for (int f = 0; f < mechanism.topology.freedom_count(); ++f) {
    rows.col(f) /= unit_of(mechanism, f);
  }
  return deciding_columns(std::move(rows));
}

bool turns_load(const PassiveFreedom& one, const Case& which) {
  const auto turns = [&](BodyId body, auto is_turned) {
    const auto found = std::ranges::find(one.bodies, body);
    return found != one.bodies.end() &&
           is_turned(one.twists[static_cast<std::size_t>(found - one.bodies.begin())].angular);
  };
  return std::ranges::any_of(which.loads,
                             [&](const Load& load) {
                               return load.frame == LoadFrame::body &&
                                      turns(load.acts.body, [&](const Vec3& axis) {
                                        return is_across(load.acts.wrench.force, axis) ||
                                               is_across(couple_of(load), axis);
                                      });
                             }) ||
         std::ranges::any_of(which.moving_loads, [&](const MovingLoad& load) {
           return load.frame == LoadFrame::body &&
                  turns(load.body, [](const Vec3& axis) { return axis.norm() > 0.0; });
         });
}

}  // namespace kinestat
