#include "studies/tolerance/central_deviation.hpp"

#include <optional>
#include <utility>

#include "core/index.hpp"
#include "core/rounding.hpp"
#include "math/dense/least_norm.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "mechanism/gears/central_hinge.hpp"

namespace kinestat {

namespace {

// The mechanism with these loads alone, since central hinges depend on what presses their bodies.
Mechanism loaded_with(Mechanism mechanism, std::span<const BodyWrench> loads) {
  Case which;
  for (const BodyWrench& load : loads) {
    which.loads.push_back({.name = {}, .acts = load, .point = std::nullopt, .where = {}});
  }
  mechanism.cases = {std::move(which)};
  mechanism.springs.clear();
  return mechanism;
}

// A sum of vectors of these sizes, without what is no more than their rounding.
Vec3 settled(const Vec3& vector, double sizes) {
  const double bound = kDataRounding * sizes;
  return vector.unaryExpr([bound](double x) { return zero_within_bound(x, bound); });
}

class PlanetCanceller {
 public:
  PlanetCanceller(const Mechanism& mechanism,
                  std::span<const BodyWrench> unit_loads,
                  std::span<const Deviation> deviations,
                  const std::vector<bool>& fits,
                  std::vector<double>& by_parts)
      : mechanism_(mechanism),
        central_(find_central_hinges(loaded_with(mechanism, unit_loads))),
        deviations_(deviations),
        fits_(fits),
        by_parts_(by_parts) {}

  void run() {
    const std::vector<double> drawn = by_parts_;
    for (std::size_t e = 0; e < central_.size(); ++e) {
      if (central_[e]) {
        settle(CouplingId{static_cast<int>(e)}, *central_[e], drawn);
      }
    }
  }

 private:
  std::vector<std::size_t> of(CouplingId coupling, bool is_angle) const {
    std::vector<std::size_t> found;
    for (std::size_t d = 0; d < deviations_.size(); ++d) {
      const Deviation& one = deviations_[d];
      if (mechanism_.topology.actions[at(one.action)].coupling == coupling &&
          one.is_angle == is_angle && fits_[d]) {
        found.push_back(d);
      }
    }
    return found;
  }

  Vec3 vector(CouplingId coupling, bool is_angle, const std::vector<double>& drawn) const {
    std::vector<Vec3> directions;
    std::vector<double> influences;
    for (const std::size_t d : of(coupling, is_angle)) {
      directions.push_back(deviations_[d].direction);
      influences.push_back(drawn[d]);
    }
    return directions.empty() ? Vec3(Vec3::Zero()) : influence_vector(directions, influences);
  }

  void settle(CouplingId id, const CentralHinge& hinge, const std::vector<double>& drawn) {
    const Vec3& point = mechanism_.geometry.points[at(id.value)];
    for (const bool is_angle : {false, true}) {
      const Vec3 own = vector(id, is_angle, drawn);
      Vec3 with_planets = own;
      double sizes = own.norm();
      for (const CountedCoupling& planet : hinge.planets) {
        const Vec3 place = vector(planet.coupling, false, drawn);
        const Vec3 arm = mechanism_.geometry.points[at(planet.coupling.value)] - point;
        const Vec3 turns = is_angle ? vector(planet.coupling, true, drawn) : Vec3(Vec3::Zero());
        with_planets += planet.sign * (is_angle ? Vec3(arm.cross(place) + turns) : place);
        sizes += (is_angle ? arm.norm() : 1.0) * place.norm() + turns.norm();
      }
      const Vec3 left = settled(borne(hinge, own, with_planets), sizes);
      for (const std::size_t d : of(id, is_angle)) {
        by_parts_[d] = deviations_[d].direction.dot(left);
      }
    }
  }

  const Mechanism& mechanism_;
  std::vector<std::optional<CentralHinge>> central_;
  std::span<const Deviation> deviations_;
  const std::vector<bool>& fits_;
  std::vector<double>& by_parts_;
};

}  // namespace

Vec3 influence_vector(const std::vector<Vec3>& directions, const std::vector<double>& influences) {
  MatX rows(std::ssize(directions), 3);
  VecX right(std::ssize(directions));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) = directions[i];
    right[static_cast<Eigen::Index>(i)] = influences[i];
  }
  return least_norm_solution(rows, right);
}

void cancel_planets(const Mechanism& mechanism,
                    std::span<const BodyWrench> unit_loads,
                    std::span<const Deviation> deviations,
                    const std::vector<bool>& fits,
                    std::vector<double>& by_parts) {
  if (has_planets(mechanism)) {
    PlanetCanceller(mechanism, unit_loads, deviations, fits, by_parts).run();
  }
}

}  // namespace kinestat
