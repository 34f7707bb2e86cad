#include "mechanism/bind/place_binder.hpp"

#include <fmt/format.h>

#include "core/contract.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/cables/internal/cable_station_binder.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

template <class Scalar>
class PlaceBinder {
 public:
  PlaceBinder(const CouplingDescription& coupling,
              const GearFrameOf<Scalar>* gears,
              EvaluatorOf<Scalar>& evaluator,
              Diagnostics& found,
              CouplingGeometryOf<Scalar>& geometry)
      : coupling_(coupling),
        gears_(gears),
        evaluator_(evaluator),
        found_(found),
        geometry_(geometry) {}

  void bind() {
    if (coupling_.is_mesh()) {
      KINESTAT_EXPECTS(gears_ != nullptr);
      geometry_.at = evaluator_.from_origin(
          gears_->layout.meshes[static_cast<std::size_t>(coupling_.mesh)].pitch_point);
    } else if (coupling_.is_segment()) {
      bind_segment();
    } else if (coupling_.from && coupling_.to) {
      bind_ends();
    } else if (coupling_.at) {
      bind_point(*coupling_.at);
    }
  }

 private:
  // Notes an answer; an empty one has left its error.
  static void take(const std::optional<Vec3Of<Scalar>>& answer, Vec3Of<Scalar>& where) {
    if (answer) {
      where = *answer;
    }
  }

  void bind_point(const CouplingPoint& at) {
    if (at.point) {
      take(evaluator_.point(*at.point), geometry_.at);
    } else if (!at.of_bodies.empty()) {
      bind_points_of_bodies(at);
    } else {
      geometry_.at = evaluator_.from_origin(
          gears_ != nullptr ? gears_->layout.axis_of(coupling_.tail.text, coupling_.head.text)
                            : Vec3Of<Scalar>(Vec3Of<Scalar>::Zero()));
    }
    if (at.along_axis) {
      const auto along = evaluator_.number(*at.along_axis, QuantityKind::length);
      geometry_.at[2] =
          evaluator_.from_origin({Scalar(0.0), Scalar(0.0), along.value_or(Scalar(0.0))})[2];
    }
  }

  // The points as drawn on the two bodies; the tail's counts.
  void bind_points_of_bodies(const CouplingPoint& at) {
    for (const auto& [body, point] : at.of_bodies) {
      const std::optional<Vec3Of<Scalar>> drawn = evaluator_.point(point);
      if (body.text == coupling_.tail.text) {
        take(drawn, geometry_.at);
      } else if (body.text != coupling_.head.text) {
        found_.error(
            "E0313",
            body.where,
            fmt::format("'{}' is not a body of {} '{}'",
                        body.text,
                        word_of(coupling_.type),
                        coupling_.name.text),
            fmt::format("its bodies are {} and {}", coupling_.tail.text, coupling_.head.text));
      }
    }
  }

  // Where the segment of a cable touches its stations; check_cables has complained if it cannot.
  void bind_segment() {
    const auto from = bind_station<Scalar>(coupling_.part->from, evaluator_);
    const auto to = bind_station<Scalar>(coupling_.part->to, evaluator_);
    if (from && to) {
      const CableSpanOf<Scalar> span = tangent_span<Scalar>(*from, *to);
      geometry_.from = span.from;
      geometry_.to = span.to;
      geometry_.at = span.to;
    }
  }

  // The force of a cable on the head acts at its end there.
  void bind_ends() {
    take(evaluator_.point(*coupling_.from), geometry_.from);
    take(evaluator_.point(*coupling_.to), geometry_.to);
    geometry_.at = geometry_.to;
  }

  const CouplingDescription& coupling_;
  const GearFrameOf<Scalar>* gears_;
  EvaluatorOf<Scalar>& evaluator_;
  Diagnostics& found_;
  CouplingGeometryOf<Scalar>& geometry_;
};

}  // namespace

template <class Scalar>
void bind_place(const CouplingDescription& coupling,
                const GearFrameOf<Scalar>* gears,
                EvaluatorOf<Scalar>& evaluator,
                Diagnostics& found,
                CouplingGeometryOf<Scalar>& geometry) {
  PlaceBinder<Scalar>(coupling, gears, evaluator, found, geometry).bind();
}

template void bind_place(
    const CouplingDescription&, const GearFrame*, Evaluator&, Diagnostics&, CouplingGeometry&);
template void bind_place(const CouplingDescription&,
                         const GearFrameOf<Dual>*,
                         EvaluatorOf<Dual>&,
                         Diagnostics&,
                         CouplingGeometryOf<Dual>&);
template void bind_place(const CouplingDescription&,
                         const GearFrameOf<ExactInput>*,
                         EvaluatorOf<ExactInput>&,
                         Diagnostics&,
                         CouplingGeometryOf<ExactInput>&);

}  // namespace kinestat
