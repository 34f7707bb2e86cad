#include "mechanism/gears/internal/tooth_binder.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/check/geometry_check.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

// The pressure angle in the section across the teeth.
template <class Scalar>
Scalar normal_angle(const Scalar& alpha, const Scalar& beta) {
  using std::atan, std::cos, std::tan;
  return atan(tan(alpha) * cos(beta));
}

// Straight teeth keep an exact angle.
template <>
ExactInput normal_angle<ExactInput>(const ExactInput& alpha, const ExactInput& beta) {
  const ExactInput normal = atan(tan(alpha) * cos(beta));
  return is_zero(beta) ? ExactInput(normal.value, alpha.precise, alpha.exact, alpha.pi_power)
                       : normal;
}

template <class Scalar>
class ToothBinder {
 public:
  ToothBinder(const CouplingDescription& coupling,
              Space space,
              EvaluatorOf<Scalar>& evaluator,
              Diagnostics& found)
      : coupling_(coupling),
        space_(space),
        evaluator_(evaluator),
        found_(found),
        directions_(coupling, space, evaluator, found) {}

  std::optional<Vec3Of<Scalar>> bind(const AxisOf<Scalar>& axis) {
    if (coupling_.line_of_action) {
      return given();
    }
    if (is_counted_only(coupling_)) {
      return Vec3Of<Scalar>::UnitX();
    }
    if (coupling_.type != CouplingType::gear) {
      lacks("line_of_action", "add line_of_action: the direction of the force of tail on head");
      return std::nullopt;
    }
    if (!coupling_.tangent || !coupling_.pressure_angle) {
      lacks(coupling_.tangent ? "pressure_angle" : "tangent",
            "add tangent: x (or a vector) and pressure_angle: 20 deg, or line_of_action: a vector");
      return std::nullopt;
    }
    return from_tangent(axis, 1.0);
  }

  std::optional<Vec3Of<Scalar>> bind_other(const AxisOf<Scalar>& axis) {
    const bool has_tangent = coupling_.tangent && coupling_.pressure_angle;
    return has_tangent ? from_tangent(axis, -1.0) : std::nullopt;
  }

  std::optional<Vec3Of<Scalar>> bind(const MeshTeethOf<Scalar>& teeth) {
    const std::optional<Scalar> beta = angle(coupling_.helix_angle, "helix angle");
    const std::optional<Scalar> normal = beta ? normal_pressure_angle(*beta) : std::nullopt;
    if (!normal || !check_helix_in_space()) {
      return std::nullopt;
    }
    return force_of_teeth(Vec3Of<Scalar>::UnitZ(),
                          teeth.tangent,
                          Scalar(teeth.flank) * *normal,
                          Scalar(teeth.hand) * *beta);
  }

 private:
  void lacks(std::string_view key, std::string hint) {
    directions_.refuse(coupling_.name.where,
                       fmt::format("{} lacks the key '{}'", directions_.title(), key),
                       std::move(hint));
  }

  std::optional<Vec3Of<Scalar>> given() {
    if (coupling_.tangent || coupling_.pressure_angle || coupling_.helix_angle) {
      directions_.refuse(coupling_.line_of_action->where,
                         fmt::format("{} has both a line of action and a tangent, pressure angle "
                                     "or helix angle",
                                     directions_.title()),
                         "keep 'line_of_action', or 'tangent' with the angles");
      return std::nullopt;
    }
    const auto line = directions_.bind(*coupling_.line_of_action, DirectionRole::in_plane);
    return line ? std::optional(line->direction) : std::nullopt;
  }

  // An angle between -90 and 90 degrees; 0 if it is absent.
  std::optional<Scalar> angle(const std::optional<Value>& value, std::string_view what) {
    if (!value) {
      return Scalar(0.0);
    }
    const std::optional<Scalar> angle = evaluator_.number(*value, QuantityKind::angle);
    if (angle && std::abs(value_of(*angle)) >= std::numbers::pi / 2) {
      directions_.refuse(value->where,
                         fmt::format("a {} lies between -90 and 90 degrees", what),
                         what == "pressure angle" ? "write for example pressure_angle: 20 deg"
                                                  : "write for example helix_angle: 15 deg");
      return std::nullopt;
    }
    return angle;
  }

  std::optional<Scalar> normal_pressure_angle(const Scalar& beta) {
    if (coupling_.normal_pressure_angle) {
      return angle(coupling_.normal_pressure_angle, "pressure angle");
    }
    const std::optional<Scalar> alpha = angle(coupling_.pressure_angle, "pressure angle");
    return alpha ? std::optional(normal_angle<Scalar>(*alpha, beta)) : std::nullopt;
  }

  bool check_helix_in_space() {
    if (!coupling_.helix_angle || space_ == Space::spatial) {
      return true;
    }
    directions_.refuse(
        coupling_.helix_angle->where,
        fmt::format("the helix angle of {} needs a spatial mechanism", directions_.title()),
        "write 'space: spatial' at the top of the file, as helical teeth push along "
        "their axes");
    return false;
  }

  // On the flank 1 a positive pressure angle pushes along axis x tangent, on -1 against it.
  std::optional<Vec3Of<Scalar>> from_tangent(const AxisOf<Scalar>& axis, double flank) {
    const auto tangent = directions_.bind(*coupling_.tangent, DirectionRole::in_plane);
    const std::optional<Scalar> beta = angle(coupling_.helix_angle, "helix angle");
    const std::optional<Scalar> normal = beta ? normal_pressure_angle(*beta) : std::nullopt;
    if (!tangent || !normal || !check_helix_in_space() ||
        !directions_.check_perpendicular(
            *tangent,
            axis,
            coupling_.tangent->where,
            fmt::format("the tangent of {} is not perpendicular to its axis", directions_.title()),
            "the tangent touches both pitch circles at the pitch point")) {
      return std::nullopt;
    }
    return force_of_teeth(axis.direction, tangent->direction, Scalar(flank) * *normal, *beta);
  }

  static Vec3Of<Scalar> force_of_teeth(const Vec3Of<Scalar>& a,
                                       const Vec3Of<Scalar>& t,
                                       const Scalar& normal,
                                       const Scalar& beta) {
    using std::cos, std::sin;
    return Vec3Of<Scalar>(cos(normal) * cos(beta) * t + sin(normal) * a.cross(t) +
                          cos(normal) * sin(beta) * a);
  }

  const CouplingDescription& coupling_;
  Space space_;
  EvaluatorOf<Scalar>& evaluator_;
  Diagnostics& found_;
  DirectionBinder<Scalar> directions_;
};

}  // namespace

template <class Scalar>
std::optional<Vec3Of<Scalar>> bind_line_of_action(const CouplingDescription& coupling,
                                                  Space space,
                                                  const AxisOf<Scalar>& axis,
                                                  EvaluatorOf<Scalar>& evaluator,
                                                  Diagnostics& found) {
  return ToothBinder<Scalar>(coupling, space, evaluator, found).bind(axis);
}

bool turns_flank(const CouplingDescription& coupling) {
  return has_teeth(coupling.type) && !coupling.is_mesh() && !is_counted_only(coupling) &&
         coupling.flank == Flank::loaded;
}

template <class Scalar>
std::optional<Vec3Of<Scalar>> bind_other_line_of_action(const CouplingDescription& coupling,
                                                        Space space,
                                                        const AxisOf<Scalar>& axis,
                                                        EvaluatorOf<Scalar>& evaluator,
                                                        Diagnostics& found) {
  return ToothBinder<Scalar>(coupling, space, evaluator, found).bind_other(axis);
}

template <class Scalar>
std::optional<Vec3Of<Scalar>> bind_mesh_line_of_action(const CouplingDescription& coupling,
                                                       Space space,
                                                       const MeshTeethOf<Scalar>& teeth,
                                                       EvaluatorOf<Scalar>& evaluator,
                                                       Diagnostics& found) {
  return ToothBinder<Scalar>(coupling, space, evaluator, found).bind(teeth);
}

template std::optional<Vec3> bind_mesh_line_of_action(
    const CouplingDescription&, Space, const MeshTeethOf<double>&, Evaluator&, Diagnostics&);
template std::optional<Vec3Of<Dual>> bind_mesh_line_of_action(
    const CouplingDescription&, Space, const MeshTeethOf<Dual>&, EvaluatorOf<Dual>&, Diagnostics&);
template std::optional<Vec3> bind_line_of_action(
    const CouplingDescription&, Space, const Axis&, EvaluatorOf<double>&, Diagnostics&);
template std::optional<Vec3Of<Dual>> bind_line_of_action(
    const CouplingDescription&, Space, const AxisOf<Dual>&, EvaluatorOf<Dual>&, Diagnostics&);
template std::optional<Vec3Of<ExactInput>> bind_mesh_line_of_action(const CouplingDescription&,
                                                                    Space,
                                                                    const MeshTeethOf<ExactInput>&,
                                                                    EvaluatorOf<ExactInput>&,
                                                                    Diagnostics&);
template std::optional<Vec3Of<ExactInput>> bind_line_of_action(const CouplingDescription&,
                                                               Space,
                                                               const AxisOf<ExactInput>&,
                                                               EvaluatorOf<ExactInput>&,
                                                               Diagnostics&);
template std::optional<Vec3> bind_other_line_of_action(
    const CouplingDescription&, Space, const Axis&, EvaluatorOf<double>&, Diagnostics&);
template std::optional<Vec3Of<Dual>> bind_other_line_of_action(
    const CouplingDescription&, Space, const AxisOf<Dual>&, EvaluatorOf<Dual>&, Diagnostics&);
template std::optional<Vec3Of<ExactInput>> bind_other_line_of_action(const CouplingDescription&,
                                                                     Space,
                                                                     const AxisOf<ExactInput>&,
                                                                     EvaluatorOf<ExactInput>&,
                                                                     Diagnostics&);

}  // namespace kinestat
