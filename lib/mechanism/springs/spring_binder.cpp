#include "mechanism/springs/spring_binder.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text.hpp"
#include "mechanism/bind/bare_damping.hpp"
#include "mechanism/curves/moving_number_binder.hpp"
#include "mechanism/springs/spring_numbers.hpp"

namespace kinestat {

namespace {

// A number that may be of a freedom that turns or of one that slides.
struct Kinds {
  QuantityKind position;
  QuantityKind action;
  QuantityKind stiffness;
};

constexpr Kinds kOfSlide = {.position = QuantityKind::length,
                            .action = QuantityKind::force,
                            .stiffness = QuantityKind::stiffness};
constexpr Kinds kOfTurn = {.position = QuantityKind::angle,
                           .action = QuantityKind::moment,
                           .stiffness = QuantityKind::angular_stiffness};

constexpr Dimension kForcePerVelocity = {.length = 0, .mass = 1, .time = -1, .angle = 0};
constexpr Dimension kCouplePerSpeed = {.length = 2, .mass = 1, .time = -1, .angle = 0};

class SpringBinder {
 public:
  SpringBinder(const SpringDescription& spring,
               const SectionContext& context,
               const Topology* topology,
               std::span<const Curve> curves)
      : spring_(spring), context_(context), topology_(topology), curves_(curves) {}

  // Empty if it is wrong, or the structure is not there.
  std::optional<Spring> bind() {
    const int errors_before = context_.found.error_count();
    Spring result;
    result.name = spring_.name.text;
    result.where = spring_.name.where;
    result.acts = spring_.acts;
    if (spring_.coupling) {
      bind_freedom(result);
    } else {
      bind_points(result);
    }
    if (spring_.coupling && topology_ == nullptr) {
      return std::nullopt;  // nothing tells whether it turns
    }
    const bool turns = turns_;
    const Kinds& kinds = turns ? kOfTurn : kOfSlide;
    result.stiffness = number(spring_.stiffness, kinds.stiffness, kNotNegative, "stiffness");
    result.damping = damping(turns);
    bind_free(kinds, result);
    if (spring_.force) {
      result.force = bind_moving_number(*spring_.force, kinds.action, curves_, context_.evaluator)
                         .value_or(MovingNumber{});
    }
    if (spring_.gas) {
      bind_gas(*spring_.gas, result);
    }
    const bool is_right = context_.found.error_count() == errors_before;
    return is_right && topology_ != nullptr ? std::optional(std::move(result)) : std::nullopt;
  }

 private:
  std::string title(std::string_view key) const {
    return fmt::format("'{}' of spring '{}'", key, spring_.name.text);
  }

  double number(const std::optional<Value>& value,
                QuantityKind kind,
                NumberRange range,
                std::string_view key) const {
    return context_
        .number(value, {.kind = kind, .range = range, .allowed = example_of(kind)}, title(key))
        .value_or(0.0);
  }

  // A bare number counts in the units of the file.
  double damping(bool turns) const {
    if (!spring_.damping) {
      return 0.0;
    }
    const auto value = context_.evaluator.quantity(*spring_.damping);
    if (!value) {
      return 0.0;
    }
    const FileUnits& units = context_.description.units;
    const QuantityKind action = turns ? QuantityKind::moment : QuantityKind::force;
    const QuantityKind rate = turns ? QuantityKind::angular_velocity : QuantityKind::velocity;
    Dimension dimension = value->dimension;
    dimension.angle = 0;
    const double si = damping_in_si(*value, turns, units);
    if (!is_bare(value->dimension) && dimension != (turns ? kCouplePerSpeed : kForcePerVelocity)) {
      context_.found.error(
          "E0309",
          spring_.damping->where,
          fmt::format("{} is {}, not {} per {}",
                      title("damping"),
                      phrase_of(value->dimension),
                      phrase_of(action),
                      name_of(rate)),
          turns ? "write for example 0.2 N*m*s/rad" : "write for example 200 N*s/m");
    } else if (si < 0.0) {
      context_.found.error("E0305",
                           spring_.damping->where,
                           fmt::format("{} is negative", title("damping")),
                           "write a number of at least 0");
    } else {
      warn_of_bare_damping(
          *spring_.damping, title("damping"), turns, units, context_.evaluator, context_.found);
    }
    return si;
  }

  void bind_points(Spring& result) {
    if (spring_.bodies.size() != 2) {
      return;
    }
    for (const Name& body : spring_.bodies) {
      context_.names.bodies.check(
          body, fmt::format("spring '{}' joins", spring_.name.text), context_.found);
    }
    result.tail = BodyId{context_.names.bodies.find(spring_.bodies[0].text)};
    result.head = BodyId{context_.names.bodies.find(spring_.bodies[1].text)};
    if (spring_.bodies[0].text == spring_.bodies[1].text) {
      context_.found.error("E0312",
                           spring_.bodies[1].where,
                           fmt::format("spring '{}' joins a body with itself", spring_.name.text),
                           "name two bodies");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const auto at = std::ranges::find(
          spring_.at, spring_.bodies[i].text, [](const auto& one) { return one.first.text; });
      if (at == spring_.at.end()) {
        context_.found.error(
            "E0303",
            spring_.name.where,
            fmt::format(
                "spring '{}' has no point on body '{}'", spring_.name.text, spring_.bodies[i].text),
            fmt::format(
                "write at: {{{}: […], {}: […]}}", spring_.bodies[0].text, spring_.bodies[1].text));
        continue;
      }
      (i == 0 ? result.from : result.to) =
          context_.evaluator.point(at->second).value_or(Vec3::Zero());
    }
  }

  void bind_freedom(Spring& result) {
    const Name& coupling = *spring_.coupling;
    const bool is_there = context_.names.couplings.check(
        coupling, fmt::format("spring '{}' is of", spring_.name.text), context_.found);
    if (!is_there || topology_ == nullptr) {
      return;
    }
    std::vector<std::string> names;
    for (int f = 0; f < topology_->freedom_count(); ++f) {
      const FreedomLabel& label = topology_->freedoms[static_cast<std::size_t>(f)];
      if (topology_->coupling(label.coupling).name != coupling.text) {
        continue;
      }
      names.push_back(label.name);
      if (!spring_.freedom || spring_.freedom->text == label.name) {
        result.freedom = f;
        result.tail = topology_->coupling(label.coupling).tail;
        result.head = topology_->coupling(label.coupling).head;
        turns_ = label.is_rotation;
      }
    }
    const bool is_open = !spring_.freedom && names.size() != 1;
    if (result.freedom < 0 || is_open) {
      context_.found.error(
          "E0313",
          spring_.freedom ? spring_.freedom->where : coupling.where,
          spring_.freedom
              ? fmt::format(
                    "coupling '{}' has no freedom '{}'", coupling.text, spring_.freedom->text)
              : fmt::format("coupling '{}' has {} freedoms", coupling.text, names.size()),
          names.empty() ? "choose a coupling that moves"
                        : fmt::format("write freedom: one of {}", plain_list(names)));
    }
  }

  // Where it has no force: as it says, or by what it does as drawn.
  void bind_free(const Kinds& kinds, Spring& result) {
    const double drawn = spring_.coupling ? 0.0 : (result.to - result.from).norm();
    result.free = spring_.coupling ? number(spring_.free, kinds.position, kAnyNumber, "free")
                  : spring_.free_length
                      ? number(spring_.free_length, kinds.position, kNotNegative, "free_length")
                      : drawn;
    if (!spring_.drawn) {
      return;
    }
    const double action = number(spring_.drawn, kinds.action, kAnyNumber, "drawn");
    if (spring_.free || spring_.free_length) {
      context_.found.error(
          "E0305",
          spring_.drawn->where,
          fmt::format("spring '{}' says in two ways where it has no force", spring_.name.text),
          "keep one of 'drawn', 'free' and 'free_length'");
    } else if (result.stiffness > 0.0) {
      result.free = free_by_force(drawn, action, result.stiffness);
    } else if (action != 0.0) {
      context_.found.error(
          "E0303",
          spring_.drawn->where,
          fmt::format("spring '{}' has a force as drawn and no stiffness", spring_.name.text),
          "add 'stiffness', or write a load");
    }
  }

  void bind_gas(const GasSpringDescription& gas, Spring& result) {
    using enum QuantityKind;
    const double exponent =
        gas.exponent ? number(gas.exponent, dimensionless, kAboveZero, "exponent") : 1.0;
    const double ratio = std::max(number(gas.ratio, dimensionless, kAtLeastOne, "ratio"), 1.0);
    result.gas = GasSpring{.force = number(gas.force, force, kNotNegative, "force"),
                           .length = number(gas.length, length, kAboveZero, "length"),
                           .stroke = number(gas.stroke, length, kAboveZero, "stroke"),
                           .hold = gas_hold(ratio, exponent),
                           .exponent = exponent};
  }

  const SpringDescription& spring_;
  const SectionContext& context_;
  const Topology* topology_;
  std::span<const Curve> curves_;
  bool turns_ = false;
};

}  // namespace

std::vector<Spring> bind_springs(const SectionContext& context,
                                 const Topology* topology,
                                 std::span<const Curve> curves) {
  std::vector<Spring> springs;
  for (const SpringDescription& one : context.description.springs) {
    if (std::optional<Spring> spring = SpringBinder(one, context, topology, curves).bind()) {
      springs.push_back(*std::move(spring));
    }
  }
  return springs;
}

}  // namespace kinestat
