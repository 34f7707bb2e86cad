#include "mechanism/gears/internal/gear_binder.hpp"

#include <utility>

#include "description/gear_expansion.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

template <class Scalar>
class NumberBinder {
 public:
  NumberBinder(const GearsDescription& gears, EvaluatorOf<Scalar>& evaluator)
      : gears_(gears), evaluator_(evaluator) {}

  std::optional<GearNumbersOf<Scalar>> bind(const GearTrain& train) {
    for (const GearMember& member : gears_.members) {
      const Scalar teeth = number(member.teeth, QuantityKind::dimensionless);
      result_.teeth.push_back(member.internal ? -teeth : teeth);
    }
    for (const MeshDescription& mesh : gears_.meshes) {
      result_.module.push_back(length(mesh.module ? mesh.module : gears_.module));
      result_.at.push_back(length(mesh.at).value_or(Scalar(0.0)));
    }
    for (const GearAxis& axis : train.axes) {
      result_.distance.push_back(axis.distance == nullptr
                                     ? std::nullopt
                                     : std::optional(number(*axis.distance, QuantityKind::length)));
    }
    return is_good_ ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  std::optional<Scalar> length(const std::optional<Value>& value) {
    return value ? std::optional(number(*value, QuantityKind::length)) : std::nullopt;
  }

  Scalar number(const Value& value, QuantityKind kind) {
    const std::optional<Scalar> number = evaluator_.number(value, kind);
    is_good_ = is_good_ && number.has_value();
    return number.value_or(Scalar(0.0));
  }

  const GearsDescription& gears_;
  EvaluatorOf<Scalar>& evaluator_;
  GearNumbersOf<Scalar> result_;
  bool is_good_ = true;
};

}  // namespace

template <class Scalar>
std::optional<GearNumbersOf<Scalar>> bind_gear_numbers(const GearsDescription& gears,
                                                       const GearTrain& train,
                                                       EvaluatorOf<Scalar>& evaluator) {
  return NumberBinder<Scalar>(gears, evaluator).bind(train);
}

template <class Scalar>
std::optional<GearFrameOf<Scalar>> bind_gear_frame(const MechanismDescription& description,
                                                   EvaluatorOf<Scalar>& evaluator) {
  if (!description.gears || !has_all_meshes(description)) {
    return std::nullopt;
  }
  GearTrain train = find_gear_train(description);
  const auto numbers = bind_gear_numbers<Scalar>(*description.gears, train, evaluator);
  auto layout = numbers ? find_layout<Scalar>(std::move(train), *numbers) : std::nullopt;
  return layout ? std::optional(GearFrameOf<Scalar>{.gears = &*description.gears,
                                                    .layout = *std::move(layout)})
                : std::nullopt;
}

template <class Scalar>
MeshTeethOf<Scalar> teeth_of(const GearFrameOf<Scalar>& frame,
                             const CouplingDescription& coupling) {
  const GearsDescription& gears = *frame.gears;
  const auto index = static_cast<std::size_t>(coupling.mesh);
  const auto second = static_cast<std::size_t>(frame.layout.train.second[index]);
  const bool has_own_helix = gears.meshes[index].helix_angle.has_value();
  const int hand = has_own_helix ? 1 : frame.layout.train.hand[index];
  const bool pulls = gears.flank == Flank::loaded && coupling.internal;
  return {.tangent = frame.layout.meshes[index].tangent,
          .hand = static_cast<double>(gears.members[second].internal ? -hand : hand),
          .flank = pulls ? -1.0 : 1.0};
}

template MeshTeethOf<double> teeth_of(const GearFrame&, const CouplingDescription&);
template MeshTeethOf<Dual> teeth_of(const GearFrameOf<Dual>&, const CouplingDescription&);
template std::optional<GearNumbersOf<double>> bind_gear_numbers(const GearsDescription&,
                                                                const GearTrain&,
                                                                Evaluator&);
template std::optional<GearNumbersOf<Dual>> bind_gear_numbers(const GearsDescription&,
                                                              const GearTrain&,
                                                              EvaluatorOf<Dual>&);
template std::optional<GearFrame> bind_gear_frame(const MechanismDescription&, Evaluator&);
template std::optional<GearFrameOf<Dual>> bind_gear_frame(const MechanismDescription&,
                                                          EvaluatorOf<Dual>&);
template MeshTeethOf<ExactInput> teeth_of(const GearFrameOf<ExactInput>&,
                                          const CouplingDescription&);
template std::optional<GearNumbersOf<ExactInput>> bind_gear_numbers(const GearsDescription&,
                                                                    const GearTrain&,
                                                                    EvaluatorOf<ExactInput>&);
template std::optional<GearFrameOf<ExactInput>> bind_gear_frame(const MechanismDescription&,
                                                                EvaluatorOf<ExactInput>&);

}  // namespace kinestat
