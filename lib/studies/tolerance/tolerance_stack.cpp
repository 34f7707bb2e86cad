#include "studies/tolerance/tolerance_stack.hpp"

#include <cmath>

#include "core/index.hpp"
#include "core/rounding.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "mechanism/label_kind.hpp"
#include "studies/tolerance/central_deviation.hpp"

namespace kinestat {

namespace {

// A unit vector; what rounding leaves of its components is zero.
Vec3 direction_of(const Vec3& vector, double size) {
  return (vector / size).unaryExpr([](double x) { return zero_within_bound(x, kDataRounding); });
}

class StackMaker {
 public:
  StackMaker(const Mechanism& mechanism,
             const Case& which,
             std::span<const Deviation> deviations,
             const std::vector<bool>& fits,
             const PartTolerances& tolerances)
      : topology_(mechanism.topology),
        which_(which),
        deviations_(deviations),
        fits_(fits),
        tolerances_(tolerances) {}

  ToleranceStack stack(const WatchedPosition& position, const Influence& influence) const {
    ToleranceStack result{.position = position};
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      add_coupling(CouplingId{e}, false, influence.by_parts, result.shares);
      add_coupling(CouplingId{e}, true, influence.by_parts, result.shares);
    }
    for (std::size_t h = 0; h < influence.by_drives.size(); ++h) {
      result.shares.push_back(drive_share(h, influence.by_drives[h]));
    }
    double squares = 0.0;
    for (const ToleranceShare& share : result.shares) {
      result.worst_case += share.moved;
      squares += share.moved * share.moved;
    }
    result.root_sum_square = std::sqrt(squares);
    return result;
  }

 private:
  void add_coupling(CouplingId coupling,
                    bool is_angle,
                    const std::vector<double>& by_parts,
                    std::vector<ToleranceShare>& shares) const {
    std::vector<Vec3> directions;
    std::vector<double> influences;
    for (std::size_t d = 0; d < deviations_.size(); ++d) {
      const Deviation& one = deviations_[d];
      if (topology_.actions[at(one.action)].coupling == coupling && one.is_angle == is_angle &&
          one.is_counted && fits_[d]) {
        directions.push_back(one.direction);
        influences.push_back(by_parts[d]);
      }
    }
    if (directions.empty()) {
      return;
    }
    const Vec3 vector = influence_vector(directions, influences);
    const double size = vector.norm();
    const std::vector<double>& tolerances = is_angle ? tolerances_.angles : tolerances_.places;
    const double tolerance = tolerances[at(coupling.value)];
    shares.push_back(
        {.name = topology_.coupling(coupling).name + (is_angle ? "/angle" : "/place"),
         .kind = position_kind(is_angle),
         .influence = size,
         .direction = size > 0.0 ? std::optional<Vec3>(direction_of(vector, size)) : std::nullopt,
         .tolerance = tolerance,
         .moved = size * tolerance});
  }

  ToleranceShare drive_share(std::size_t held, double influence) const {
    const Primary& drive = which_.motions[held];
    const double tolerance = tolerances_.drives[held];
    return {.name = drive.given + "/drive",
            .kind = position_kind(topology_.freedoms[at(drive.index)].is_rotation),
            .influence = influence,
            .direction = std::nullopt,
            .tolerance = tolerance,
            .moved = std::abs(influence) * tolerance};
  }

  const Topology& topology_;
  const Case& which_;
  std::span<const Deviation> deviations_;
  const std::vector<bool>& fits_;
  const PartTolerances& tolerances_;
};

}  // namespace

std::vector<ToleranceStack> stack_tolerances(const Mechanism& mechanism,
                                             const Case& which,
                                             std::span<const Deviation> deviations,
                                             std::span<const WatchedPosition> watched,
                                             const Influences& influences,
                                             const PartTolerances& tolerances) {
  const StackMaker maker(mechanism, which, deviations, influences.fits, tolerances);
  std::vector<ToleranceStack> result;
  for (std::size_t w = 0; w < watched.size(); ++w) {
    if (influences.of[w]) {
      result.push_back(maker.stack(watched[w], *influences.of[w]));
    }
  }
  return result;
}

}  // namespace kinestat
