#include "studies/mobility/reshetov.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "graph/circuit.hpp"
#include "graph/matching.hpp"

namespace kinestat {

namespace {

// Along which axes a freedom can serve.
struct Serves {
  std::array<bool, 6> directly = {};   ///< as kClosures
  std::array<bool, 6> as_shift = {};   ///< a translation by turning about another axis
  std::optional<std::size_t> closure;  ///< the one that it is; none if it is oblique
  bool turns = true;
};

Serves service_of(const Twist& freedom, double length) {
  Serves serves;
  const double turn = freedom.angular.norm() * length;
  serves.turns = turn > kInfinitePitch * freedom.linear.norm();
  const Vec3 axis = (serves.turns ? freedom.angular : freedom.linear).normalized();
  const double pitch = serves.turns ? std::abs(axis.dot(freedom.linear)) : 0.0;
  const bool advances = pitch > kParallelAxes * length * freedom.angular.norm();
  for (int i = 0; i < 3; ++i) {
    const auto R = static_cast<std::size_t>(i);
    const std::size_t T = R + 3;
    const double along = std::abs(axis[i]);
    const double across = Vec3::Unit(i).cross(axis).norm();
    if (across <= kParallelAxes) {
      serves.closure = serves.turns ? R : T;
    }
    serves.directly[serves.turns ? R : T] = along > kParallelAxes;
    serves.as_shift[T] = serves.turns && (across > kParallelAxes || advances);
  }
  return serves;
}

class TableMaker {
 public:
  explicit TableMaker(const Mechanism& mechanism) : mechanism_(mechanism) {
    for (const Twist& freedom : mechanism.geometry.motions) {
      serves_.push_back(service_of(freedom, mechanism.geometry.length));
    }
  }

  ReshetovTable run() {
    ReshetovTable table;
    for (const Circuit& circuit : find_circuits(mechanism_.graph)) {
      table.circuits.push_back(open_circuit(circuit));
    }
    match(table);
    return table;
  }

 private:
  std::vector<int> freedoms_of(const ReshetovCircuit& circuit) const {
    std::vector<int> freedoms;
    for (const CouplingId id : circuit.couplings) {
      const CouplingTopology& coupling = mechanism_.topology.coupling(id);
      for (int i = 0; i < coupling.freedom_count; ++i) {
        freedoms.push_back(coupling.first_freedom + i);
      }
    }
    return freedoms;
  }

  ReshetovCircuit open_circuit(const Circuit& circuit) const {
    ReshetovCircuit result;
    result.chord = circuit.chord;
    for (const CircuitEdge& edge : circuit.edges) {
      result.couplings.push_back(edge.coupling);
    }
    std::ranges::sort(result.couplings);
    for (const int f : freedoms_of(result)) {
      const Serves& serves = serves_[static_cast<std::size_t>(f)];
      ++(serves.closure ? result.offered[*serves.closure]
         : serves.turns ? result.oblique_rotations
                        : result.oblique_translations);
    }
    return result;
  }

  // What covers a demand: first what is just that, then oblique freedoms, then rotations that
  // shift.
  std::vector<int> offers_for(std::size_t demand, const std::vector<int>& freedoms) const {
    std::vector<int> offers;
    for (const int rank : {0, 1, 2}) {
      for (const int f : freedoms) {
        const Serves& serves = serves_[static_cast<std::size_t>(f)];
        const bool is_it = serves.closure == demand;
        const int own = is_it ? 0 : serves.directly[demand] ? 1 : serves.as_shift[demand] ? 2 : 3;
        if (own == rank) {
          offers.push_back(f);
        }
      }
    }
    return offers;
  }

  void match(ReshetovTable& table) const {
    Offers offers;
    for (const ReshetovCircuit& circuit : table.circuits) {
      const std::vector<int> freedoms = freedoms_of(circuit);
      for (std::size_t demand = 0; demand < kClosures.size(); ++demand) {
        offers.push_back(offers_for(demand, freedoms));
      }
    }
    const int count = mechanism_.topology.freedom_count();
    const std::vector<std::optional<int>> offer_of = find_matching(offers, count);
    std::vector<bool> is_used(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < offer_of.size(); ++i) {
      const std::optional<int>& offer = offer_of[i];
      table.circuits[i / kClosures.size()].covered_by[i % kClosures.size()] = offer;
      if (offer) {
        is_used[static_cast<std::size_t>(*offer)] = true;
      } else {
        ++table.redundant;
      }
    }
    for (int f = 0; f < count; ++f) {
      if (!is_used[static_cast<std::size_t>(f)]) {
        table.unused.push_back(f);
      }
    }
    table.mobility = static_cast<int>(table.unused.size());
  }

  const Mechanism& mechanism_;
  std::vector<Serves> serves_;  ///< of each freedom
};

}  // namespace

ReshetovTable find_reshetov_table(const Mechanism& mechanism) {
  return TableMaker(mechanism).run();
}

}  // namespace kinestat
