// Before what evaluates for any type of number.
#include "mechanism/bind/near_description.hpp"

#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "expression/expression.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "screw/typed_vector.hpp"

namespace kinestat {

namespace {

class PointMover {
 public:
  PointMover(const MechanismDescription& description, const Vec3& origin)
      : origin_(origin),
        evaluator_(
            description, evaluate_parameters<Typed>(parameters_of(description)).table, found_) {}

  void move_all(MechanismDescription& description) {
    for (BodyDescription& body : description.bodies) {
      move(body.reference);
      move(body.centre_of_mass);
      for (PointDescription& point : body.outline) {
        move(point);
      }
    }
    for (CouplingDescription& coupling : description.couplings) {
      move_coupling(coupling);
    }
    move_loads(description.loads);
    for (CaseDescription& one : description.cases) {
      move_loads(one.loads);
    }
    if (description.motion) {
      for (TracePoint& trace : description.motion->trace) {
        move(trace.at);
      }
    }
  }

  bool is_known() const { return is_known_ && !found_.has_errors(); }

 private:
  void move_coupling(CouplingDescription& coupling) {
    if (coupling.at) {
      move(coupling.at->point);
      for (auto& [body, point] : coupling.at->of_bodies) {
        move(point);
      }
    }
    move(coupling.from);
    move(coupling.to);
    for (auto* list : {&coupling.freedoms, &coupling.constraints}) {
      for (ScrewDescription& screw : *list) {
        move(screw.at);
      }
    }
    if (coupling.screw != nullptr && coupling.screw->at) {
      ScrewDescription screw = *coupling.screw;
      move(screw.at);
      coupling.screw = std::make_shared<const ScrewDescription>(std::move(screw));
    }
  }

  void move_loads(std::vector<LoadDescription>& loads) {
    for (LoadDescription& load : loads) {
      move(load.at);
    }
  }

  void move(std::optional<PointDescription>& point) {
    if (point) {
      move(*point);
    }
  }

  void move(PointDescription& point) {
    const std::optional<Vec3Of<Typed>> place = evaluator_.point(point);
    if (!place) {
      is_known_ = false;
      return;
    }
    for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      point.coordinates[i].expression = difference((*place)[axis], origin_[axis]);
    }
  }

  // In metres.
  Expression difference(const Typed& coordinate, double origin) {
    const Typed local = coordinate - Typed(origin);
    if (!local.precise) {
      is_known_ = false;
      return {};
    }
    const auto number = static_cast<double>(*local.precise);
    auto parsed = parse_expression(fmt::format("{} m", number));
    if (!std::isfinite(number) || !std::holds_alternative<Expression>(parsed)) {
      is_known_ = false;
      return {};
    }
    return std::get<Expression>(std::move(parsed));
  }

  Vec3 origin_;
  Diagnostics found_;
  EvaluatorOf<Typed> evaluator_;
  bool is_known_ = true;
};

}  // namespace

std::optional<MechanismDescription> described_from(const MechanismDescription& description,
                                                   const Vec3& origin) {
  if (!description.cables.empty()) {
    return std::nullopt;
  }
  MechanismDescription result = description;
  PointMover mover(description, origin);
  mover.move_all(result);
  return mover.is_known() ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace kinestat
