#include "power/tooth_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/tolerance.hpp"
#include "math/elimination/exact_elimination.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/mesh.hpp"

namespace kinestat {

namespace {

// Sums of angular speeds of bodies about the main axis, each equal to a share of the one speed that
// is known.
class SpeedSystem {
 public:
  SpeedSystem(const MechanismDescription& description, const Mechanism& mechanism)
      : description_(description), mechanism_(mechanism) {}

  std::optional<Rational> ratio(const Case& which, int output) {
    if (!description_.gears || which.inputs.empty() || !add_couplings() || !add_known(which)) {
      return std::nullopt;
    }
    const ExactMatrix matrix{
        .rows = rows_, .columns = mechanism_.topology.body_count() - 1, .entries = entries_};
    const ExactElimination elimination(matrix, {});
    const ExactSolution solution = elimination.solve({}, right_);
    if (!solution.consistent) {
      return std::nullopt;
    }
    free_ = elimination.null_vectors();
    const std::optional<Rational> slow = rate_of(output, solution.x);
    std::optional<Rational> fast;
    for (const int input : which.inputs) {
      const std::optional<Rational> rate = rate_of(input, solution.x);
      if (!rate || (fast && *fast != *rate)) {
        return std::nullopt;
      }
      fast = rate;
    }
    return slow && *slow != 0 ? std::optional<Rational>(*fast / *slow) : std::nullopt;
  }

 private:
  // The ground rests, and has no column.
  void add_entry(BodyId body, const Rational& factor) {
    if (body.value > 0) {
      entries_.push_back({.row = rows_, .column = body.value - 1, .value = factor});
    }
  }

  void end_row(const Rational& right) {
    right_.push_back(right);
    ++rows_;
  }

  bool add_couplings() {
    for (const CouplingTopology& coupling : mechanism_.topology.couplings) {
      if (coupling.type == CouplingType::rigid) {
        add_entry(coupling.head, 1);
        add_entry(coupling.tail, -1);
        end_row(0);
      } else if (!is_hinge(coupling.type) && !add_mesh(coupling)) {
        return false;
      }
    }
    return true;
  }

  std::optional<BodyId> body_named(const std::string& name) const {
    const auto& bodies = mechanism_.topology.bodies;
    const auto at = std::ranges::find(bodies, name, &BodyTopology::name);
    return at == bodies.end() ? std::nullopt
                              : std::optional(BodyId{static_cast<int>(at - bodies.begin())});
  }

  std::optional<Rational> teeth_of(const Name& member, Evaluator& evaluator) const {
    for (const GearMember& one : description_.gears->members) {
      if (one.name.text == member.text) {
        const auto teeth = evaluator.number(one.teeth, QuantityKind::dimensionless);
        return teeth ? std::optional<Rational>(std::llround(one.internal ? -*teeth : *teeth))
                     : std::nullopt;
      }
    }
    return std::nullopt;
  }

  bool add_mesh(const CouplingTopology& coupling) {
    const std::vector<MeshDescription>& meshes = description_.gears->meshes;
    const auto mesh = std::ranges::find_if(
        meshes, [&](const MeshDescription& one) { return one.name.text == coupling.name; });
    if (coupling.type != CouplingType::gear || mesh == meshes.end()) {
      return false;
    }
    Diagnostics ignored;
    Evaluator evaluator = make_evaluator(description_, ignored);
    const std::optional<Rational> first = teeth_of(mesh->first, evaluator);
    const std::optional<Rational> second = teeth_of(mesh->second, evaluator);
    const std::optional<BodyId> carrier =
        mesh->carrier ? body_named(mesh->carrier->text) : BodyId{0};
    if (!first || !second || !carrier) {
      return false;
    }
    add_entry(coupling.tail, *first);
    add_entry(coupling.head, *second);
    add_entry(*carrier, -*first - *second);
    end_row(0);
    return true;
  }

  // Along or against the main axis; 0: neither.
  int sense_of(int freedom) const {
    const auto f = static_cast<std::size_t>(freedom);
    const Vec3& axis = mechanism_.geometry.motions[f].angular;
    const bool is_on_axis = mechanism_.topology.freedoms[f].is_rotation &&
                            std::abs(std::abs(axis.z()) - 1.0) <= kParallelAxes;
    return !is_on_axis ? 0 : (axis.z() < 0.0 ? -1 : 1);
  }

  bool add_known(const Case& which) {
    double speed = 0.0;
    for (const Primary& known : which.motions) {
      const int sense = sense_of(known.index);
      speed = speed == 0.0 ? known.value : speed;
      if (sense == 0 || std::abs(known.value) != (known.value == 0.0 ? 0.0 : std::abs(speed))) {
        return false;
      }
      const auto& freedom = mechanism_.topology.freedoms[static_cast<std::size_t>(known.index)];
      const CouplingTopology& coupling = mechanism_.topology.coupling(freedom.coupling);
      add_entry(coupling.head, sense);
      add_entry(coupling.tail, -sense);
      end_row(known.value == 0.0 ? 0 : (known.value == speed ? 1 : -1));
    }
    return speed != 0.0;
  }

  // Empty where the equations leave it open.
  std::optional<Rational> rate_of(int actuator, std::span<const Rational> speeds) const {
    const Topology& topology = mechanism_.topology;
    const int freedom = topology.actuators[static_cast<std::size_t>(actuator)].freedom;
    const CouplingTopology& coupling =
        topology.coupling(topology.freedoms[static_cast<std::size_t>(freedom)].coupling);
    const auto between = [&](std::span<const Rational> of_bodies) {
      const auto at = [&](BodyId body) {
        return body.value == 0 ? Rational(0) : of_bodies[static_cast<std::size_t>(body.value - 1)];
      };
      return Rational((at(coupling.head) - at(coupling.tail)) * sense_of(freedom));
    };
    const bool is_open =
        sense_of(freedom) == 0 || std::ranges::any_of(free_, [&](const std::vector<Rational>& one) {
          return between(one) != 0;
        });
    return is_open ? std::nullopt : std::optional(between(speeds));
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  std::vector<ExactEntry> entries_;
  std::vector<Rational> right_;
  int rows_ = 0;
  std::vector<std::vector<Rational>> free_;
};

}  // namespace

std::optional<Rational> tooth_ratio(const MechanismDescription& description,
                                    const Mechanism& mechanism,
                                    const Case& which,
                                    double ratio) {
  std::optional<Rational> exact =
      SpeedSystem(description, mechanism).ratio(which, which.outputs.front());
  const bool agrees =
      exact && std::abs(to_double(*exact) - ratio) <= kReportsAgree * std::abs(ratio);
  return agrees ? exact : std::nullopt;
}

}  // namespace kinestat
