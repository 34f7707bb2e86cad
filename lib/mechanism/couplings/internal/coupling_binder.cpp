#include "mechanism/couplings/internal/coupling_binder.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/bind/direction_binder.hpp"
#include "mechanism/bind/place_binder.hpp"
#include "mechanism/check/geometry_check.hpp"
#include "mechanism/gears/internal/tooth_binder.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kAxisHint = "add axis: x, y, z, -x, … or a vector";

/// A key that gives a direction.
struct DirectionKey {
  CouplingKey key;
  std::string_view word;
  std::optional<AxisDescription> CouplingDescription::*direction;
  DirectionRole role;
  std::string_view hint;              ///< where it lacks
  std::string_view hint_across = {};  ///< where it is not perpendicular to the one before it
};

constexpr auto kDirections = std::to_array<DirectionKey>({
    {CouplingKey::turning_axis,
     "axis",
     &CouplingDescription::axis,
     DirectionRole::turning,
     kAxisHint},
    {CouplingKey::sliding_axis,
     "axis",
     &CouplingDescription::axis,
     DirectionRole::in_plane,
     kAxisHint},
    {CouplingKey::normal,
     "normal",
     &CouplingDescription::normal,
     DirectionRole::in_plane,
     "add normal: x, y, z, -x, … or a vector"},
    {CouplingKey::line,
     "line",
     &CouplingDescription::line,
     DirectionRole::in_plane,
     "add line: the direction of the line along which the bodies touch",
     "the line lies in both surfaces, the normal is perpendicular to them"},
    {CouplingKey::slot,
     "slot",
     &CouplingDescription::slot,
     DirectionRole::in_plane,
     "add slot: x or a vector"},
});

std::string hint_across(const DirectionKey& first, const DirectionKey& second) {
  return second.hint_across.empty()
             ? fmt::format("write a {} perpendicular to the {}", second.word, first.word)
             : std::string(second.hint_across);
}

template <class Scalar>
Scalar radians_of_a_turn() {
  return Scalar(2.0 * std::numbers::pi);
}

template <>
ExactInput radians_of_a_turn<ExactInput>() {
  return ExactInput(2.0) * exact_input_pi();
}

template <class Scalar>
class GeometryBinder {
 public:
  GeometryBinder(const CouplingDescription& coupling,
                 Space space,
                 const GearFrameOf<Scalar>* gears,
                 EvaluatorOf<Scalar>& evaluator,
                 Diagnostics& found)
      : coupling_(coupling),
        space_(space),
        gears_(gears),
        evaluator_(evaluator),
        found_(found),
        directions_(coupling, space, evaluator, found) {}

  std::optional<CouplingGeometryOf<Scalar>> bind() {
    const int errors_before = found_.error_count();
    bind_place<Scalar>(coupling_, gears_, evaluator_, found_, geometry_);
    bind_directions();
    bind_pitch();
    bind_screws(coupling_.freedoms, geometry_.freedoms);
    bind_screws(coupling_.constraints, geometry_.constraints);
    return found_.error_count() == errors_before ? std::optional(geometry_) : std::nullopt;
  }

 private:
  // Notes an answer; an empty one has left its error.
  template <class Item>
  static void take(const std::optional<Item>& answer, Item& where) {
    if (answer) {
      where = *answer;
    }
  }

  void bind_directions() {
    const CouplingKind& kind = kind_of(coupling_.type);
    if (kind.teeth != Teeth::none) {
      bind_teeth();
    } else if (takes(kind, CouplingKey::axes)) {
      bind_universal();
    } else {
      bind_listed(kind);
    }
  }

  // The first direction that the kind takes, and a second perpendicular to it.
  void bind_listed(const CouplingKind& kind) {
    const int errors_before = found_.error_count();
    const DirectionKey* first = nullptr;
    for (const KindKey& own : kind.keys) {
      const auto* const one = std::ranges::find(kDirections, own.key, &DirectionKey::key);
      if (one == kDirections.end()) {
        continue;
      }
      take(directions_.bind(coupling_.*one->direction, one->word, one->role, one->hint),
           first == nullptr ? geometry_.axis : geometry_.second);
      if (first != nullptr && found_.error_count() == errors_before) {
        check_perpendicular(*first, *one);
      }
      first = one;
    }
  }

  // Of a coupling that is only counted both may be missing.
  void check_perpendicular(const DirectionKey& first, const DirectionKey& second) {
    if (coupling_.*first.direction && coupling_.*second.direction) {
      directions_.check_perpendicular(geometry_.axis,
                                      geometry_.second,
                                      (coupling_.*second.direction)->where,
                                      fmt::format("the {} of {} is not perpendicular to its {}",
                                                  second.word,
                                                  directions_.title(),
                                                  first.word),
                                      hint_across(first, second));
    }
  }

  void bind_universal() {
    if (coupling_.axes.size() != 2) {
      if (!is_counted_only(coupling_)) {
        directions_.refuse(coupling_.name.where,
                           fmt::format("{} lacks the key 'axes'", directions_.title()),
                           "add axes: [x, z]: the first fixed in the tail, the second in the head");
      }
      geometry_.second = {.direction = Vec3Of<Scalar>::UnitX(), .keyword = 'x'};
      return;
    }
    const int errors_before = found_.error_count();
    take(directions_.bind(coupling_.axes[0], DirectionRole::turning), geometry_.axis);
    take(directions_.bind(coupling_.axes[1], DirectionRole::turning), geometry_.second);
    const Vec3 first = values_of<Scalar>(geometry_.axis.direction);
    const Vec3 second = values_of<Scalar>(geometry_.second.direction);
    if (found_.error_count() == errors_before && first.cross(second).norm() <= kParallelAxes) {
      directions_.refuse(coupling_.axes[1].where,
                         fmt::format("the axes of {} are parallel", directions_.title()),
                         "the two axes of the cross are perpendicular to each other");
    }
  }

  void bind_teeth() {
    if (coupling_.is_mesh()) {
      return bind_mesh();
    }
    geometry_.is_contact = coupling_.contact;
    const int errors_before = found_.error_count();
    if (coupling_.screw) {
      geometry_.relative = bind_screw(*coupling_.screw);
    } else {
      take(directions_.bind(coupling_.axis, "axis", DirectionRole::turning, kAxisHint),
           geometry_.axis);
    }
    if (found_.error_count() == errors_before) {
      take(bind_line_of_action<Scalar>(coupling_, space_, geometry_.axis, evaluator_, found_),
           geometry_.line_of_action);
    }
    // Where teeth only touch, the other flank touches elsewhere.
    if (found_.error_count() == errors_before && turns_flank(coupling_) && !coupling_.contact) {
      geometry_.other_flank =
          bind_other_line_of_action<Scalar>(coupling_, space_, geometry_.axis, evaluator_, found_);
    }
  }

  void bind_mesh() {
    const int errors_before = found_.error_count();
    MeshTeethOf<Scalar> teeth = teeth_of<Scalar>(*gears_, coupling_);
    take(bind_mesh_line_of_action<Scalar>(coupling_, space_, teeth, evaluator_, found_),
         geometry_.line_of_action);
    const bool is_good = found_.error_count() == errors_before;
    if (is_good && gears_->gears->flank == Flank::loaded) {
      teeth.flank = -teeth.flank;
      geometry_.other_flank =
          bind_mesh_line_of_action<Scalar>(coupling_, space_, teeth, evaluator_, found_);
    }
  }

  void bind_pitch() {
    if (coupling_.pitch) {
      take(evaluator_.number(*coupling_.pitch, QuantityKind::pitch), geometry_.pitch);
    } else if (coupling_.lead) {
      take(evaluator_.number(*coupling_.lead, QuantityKind::lead), geometry_.pitch);
      geometry_.pitch = geometry_.pitch / radians_of_a_turn<Scalar>();
    }
  }

  // The first screw with a line places the coupling.
  void bind_screws(const std::vector<ScrewDescription>& list,
                   std::vector<ScrewGeometryOf<Scalar>>& screws) {
    for (const ScrewDescription& one : list) {
      const auto screw = bind_screw(one);
      if (!screw) {
        continue;
      }
      if (one.at && !has_place_) {
        geometry_.at = screw->at;
        has_place_ = true;
      }
      screws.push_back(*screw);
    }
  }

  // In the plane rotations and couples are about z, without pitch; the others lie in the plane.
  std::optional<ScrewGeometryOf<Scalar>> bind_screw(const ScrewDescription& description) {
    ScrewGeometryOf<Scalar> screw;
    screw.kind = description.kind;
    const int errors_before = found_.error_count();
    const bool turns =
        description.kind == ScrewWord::rotation || description.kind == ScrewWord::couple;
    take(directions_.bind(description.direction,
                          turns ? DirectionRole::turning : DirectionRole::in_plane),
         screw.direction);
    if (description.at) {
      take(evaluator_.point(*description.at), screw.at);
    } else {
      screw.at = evaluator_.from_origin(Vec3Of<Scalar>::Zero());
    }
    if (description.pitch) {
      take(evaluator_.number(*description.pitch, QuantityKind::pitch), screw.pitch);
      if (space_ == Space::planar) {
        directions_.refuse(
            description.pitch->where,
            fmt::format("a screw of {} has a pitch, which leaves the plane", directions_.title()),
            "remove 'pitch', or write 'space: spatial' at the top of the file");
      }
    }
    return found_.error_count() == errors_before ? std::optional(screw) : std::nullopt;
  }

  const CouplingDescription& coupling_;
  Space space_;
  const GearFrameOf<Scalar>* gears_;
  EvaluatorOf<Scalar>& evaluator_;
  Diagnostics& found_;
  DirectionBinder<Scalar> directions_;
  CouplingGeometryOf<Scalar> geometry_;
  bool has_place_ = false;  ///< of a list of screws
};

}  // namespace

bool has_place(const CouplingDescription& coupling) {
  const auto has_line = [](const ScrewDescription& screw) { return screw.at.has_value(); };
  return coupling.at || coupling.is_mesh() || (coupling.from && coupling.to) ||
         coupling.is_segment() || std::ranges::any_of(coupling.freedoms, has_line) ||
         std::ranges::any_of(coupling.constraints, has_line);
}

template <class Scalar>
std::optional<CouplingGeometryOf<Scalar>> bind_geometry(const CouplingDescription& coupling,
                                                        Space space,
                                                        const GearFrameOf<Scalar>* gears,
                                                        EvaluatorOf<Scalar>& evaluator,
                                                        Diagnostics& found) {
  return GeometryBinder<Scalar>(coupling, space, gears, evaluator, found).bind();
}

template std::optional<CouplingGeometry> bind_geometry(
    const CouplingDescription&, Space, const GearFrame*, Evaluator&, Diagnostics&);
template std::optional<CouplingGeometryOf<Dual>> bind_geometry(
    const CouplingDescription&, Space, const GearFrameOf<Dual>*, EvaluatorOf<Dual>&, Diagnostics&);
template std::optional<CouplingGeometryOf<ExactInput>> bind_geometry(const CouplingDescription&,
                                                                     Space,
                                                                     const GearFrameOf<ExactInput>*,
                                                                     EvaluatorOf<ExactInput>&,
                                                                     Diagnostics&);

}  // namespace kinestat
