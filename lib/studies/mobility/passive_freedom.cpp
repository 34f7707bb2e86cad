#include "studies/mobility/passive_freedom.hpp"

#include <algorithm>

#include "core/tolerance.hpp"
#include "math/dense/span.hpp"

namespace kinestat {

namespace {

// The legs of platforms have two bodies, those with a gimbal at both ends four.
constexpr std::size_t kLongestChain = 4;

// A coupling at the border of a group of bodies; +1 if its head is inside.
struct Border {
  CouplingId coupling;
  int sign = 1;
};

class PassiveSearch {
 public:
  PassiveSearch(const Mechanism& mechanism, const CoordinateBasis& basis)
      : mechanism_(mechanism),
        topology_(mechanism.topology),
        basis_(basis),
        at_body_(topology_.bodies.size()),
        is_felt_(topology_.freedoms.size()) {
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
      is_felt_[static_cast<std::size_t>(actuator.freedom)] = true;
    }
    for (const Case& which : mechanism_.cases) {
      for (const Primary& primary : which.motions) {
        const auto f = static_cast<std::size_t>(primary.index);
        if (topology_.coupling(topology_.freedoms[f].coupling).freedom_count == 1) {
          is_felt_[f] = true;
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
    for (Eigen::Index j = 0; j < common.cols(); ++j) {
      add(bodies, border, spans, common.col(j));
    }
  }

  void add(const std::vector<BodyId>& bodies,
           const std::vector<Border>& border,
           const std::vector<MatX>& spans,
           const VecX& twist) {
    PassiveFreedom one{.bodies = bodies,
                       .twist = Twist::from_coordinates(basis_.screw_of(twist)),
                       .rates = VecX::Zero(topology_.freedom_count())};
    for (std::size_t i = 0; i < border.size(); ++i) {
      const int first = topology_.coupling(border[i].coupling).first_freedom;
      const std::vector<int> columns = independent_columns(spans[i]);
      MatX chosen(spans[i].rows(), static_cast<Eigen::Index>(columns.size()));
      for (std::size_t c = 0; c < columns.size(); ++c) {
        chosen.col(static_cast<Eigen::Index>(c)) = spans[i].col(columns[c]);
      }
      const VecX rates = coordinates_in(chosen, twist);
      for (std::size_t c = 0; c < columns.size(); ++c) {
        one.rates[first + columns[c]] = border[i].sign * rates[static_cast<Eigen::Index>(c)];
      }
    }
    snap(one.rates);
    if (!is_felt(one.rates) && is_new(one)) {
      found_.push_back(std::move(one));
    }
  }

  // What is rounding beside the largest, lengths counted in that of the mechanism.
  void snap(VecX& rates) const {
    VecX sizes = rates.cwiseAbs();
    for (int f = 0; f < topology_.freedom_count(); ++f) {
      if (!topology_.freedoms[static_cast<std::size_t>(f)].is_rotation) {
        sizes[f] /= mechanism_.geometry.length;
      }
    }
    const double zero = kRankZero * sizes.maxCoeff();
    rates = (sizes.array() <= zero).select(0.0, rates);
  }

  bool is_felt(const VecX& rates) const {
    for (std::size_t f = 0; f < is_felt_.size(); ++f) {
      if (is_felt_[f] && rates[static_cast<Eigen::Index>(f)] != 0.0) {
        return true;
      }
    }
    return false;
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
  std::vector<bool> is_felt_;
  std::vector<PassiveFreedom> found_;
};

}  // namespace

std::vector<PassiveFreedom> find_passive_freedoms(const Mechanism& mechanism,
                                                  const CoordinateBasis& basis) {
  return PassiveSearch(mechanism, basis).run();
}

}  // namespace kinestat
