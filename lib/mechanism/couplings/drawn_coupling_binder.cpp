#include "mechanism/couplings/drawn_coupling_binder.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "mechanism/cables/internal/cable_station_binder.hpp"
#include "mechanism/couplings/internal/coupling_binder.hpp"

namespace kinestat {

namespace {

// What a description that was right when it was bound says again.
class DrawnBinder {
 public:
  DrawnBinder(const MechanismDescription& description, const LocalOrigin& origin)
      : description_(description),
        evaluator_(make_evaluator(description, found_)),
        gears_(bind_gear_frame<double>(description, evaluator_)) {
    evaluator_.measure_from(origin);
  }

  DrawnCoupling bind(const CouplingDescription& coupling) {
    DrawnCoupling result;
    const auto geometry = bind_geometry<double>(
        coupling, description_.space, gears_ ? &*gears_ : nullptr, evaluator_, found_);
    KINESTAT_EXPECTS(geometry.has_value());
    result.geometry = *geometry;
    result.has_place = has_place(coupling);
    result.at_head = point_on_head(coupling);
    if (coupling.is_segment()) {
      result.from = bind_station<double>(coupling.part->from, evaluator_);
      result.to = bind_station<double>(coupling.part->to, evaluator_);
    }
    if (coupling.radii.size() == 2) {
      result.tail_shape = shape_of(coupling.radii[0]);
      result.head_shape = shape_of(coupling.radii[1]);
    }
    return result;
  }

 private:
  ContactShape shape_of(const std::optional<Value>& radius) {
    const auto number = radius ? evaluator_.number(*radius, QuantityKind::length) : std::nullopt;
    return {.curvature = number ? 1.0 / *number : 0.0};
  }

  std::optional<Vec3> point_on_head(const CouplingDescription& coupling) {
    if (!coupling.at) {
      return std::nullopt;
    }
    for (const auto& [body, point] : coupling.at->of_bodies) {
      if (body.text == coupling.head.text) {
        return evaluator_.point(point);
      }
    }
    return std::nullopt;
  }

  const MechanismDescription& description_;
  Diagnostics found_;
  Evaluator evaluator_;
  std::optional<GearFrame> gears_;
};

}  // namespace

std::vector<DrawnCoupling> bind_drawn_couplings(const MechanismDescription& description,
                                                const Mechanism& mechanism) {
  KINESTAT_EXPECTS(static_cast<int>(description.couplings.size()) ==
                   mechanism.topology.coupling_count());
  DrawnBinder binder(description, mechanism.geometry.origin);
  std::vector<DrawnCoupling> result;
  result.reserve(description.couplings.size());
  for (const CouplingDescription& coupling : description.couplings) {
    result.push_back(binder.bind(coupling));
  }
  return result;
}

}  // namespace kinestat
