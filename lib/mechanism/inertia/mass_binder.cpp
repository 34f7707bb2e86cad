#include "mechanism/inertia/mass_binder.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "description/gear_expansion.hpp"
#include "math/dense/principal_values.hpp"
#include "mechanism/check/report_name_check.hpp"
#include "mechanism/gears/gear_train.hpp"
#include "mechanism/gears/internal/planet_set.hpp"
#include "mechanism/inertia/mass_numbers.hpp"

namespace kinestat {

namespace {

constexpr NumberRule kMass = {
    .kind = QuantityKind::mass, .range = kNotNegative, .allowed = "a mass that is not negative"};

constexpr NumberRule kMomentOfInertia = {.kind = QuantityKind::inertia,
                                         .range = kNotNegative,
                                         .allowed = "a moment of inertia that is not negative"};

// Accelerations are given, or the equivalent inertia is told, as of every gear.
bool has_inertia(const MechanismDescription& description) {
  const bool sweeps =
      description.sweep && std::ranges::any_of(description.sweep->report, [](const Name& name) {
        return name.text == kEquivalentInertiaWord;
      });
  return sweeps || description.shift.has_value() ||
         std::ranges::any_of(description.cases, &CaseDescription::has_inertia);
}

void warn_of_idle_centre(const BodyDescription& body, const SectionContext& context) {
  context.found.warning("W0301",
                        body.centre_of_mass->where,
                        fmt::format("body '{}' has a centre of mass and no mass, so that neither "
                                    "gravity nor acceleration acts there",
                                    body.name.text),
                        "add 'mass', or remove 'centre_of_mass'");
}

class MassBinder {
 public:
  MassBinder(const BodyDescription& body, const SectionContext& context)
      : body_(body), context_(context) {}

  BodyMass bind() {
    BodyMass result;
    result.mass = context_.number(body_.mass, kMass, fmt::format("'mass' of body '{}'", name()))
                      .value_or(0.0);
    if (body_.centre_of_mass) {
      result.centre = context_.place(*body_.centre_of_mass).value_or(Vec3::Zero());
    }
    result.where = body_.mass               ? body_.mass->where
                   : !body_.inertia.empty() ? body_.inertia.front().where
                                            : body_.name.where;
    const bool lacks_centre = body_.mass && !body_.centre_of_mass && has_inertia(description()) &&
                              !is_on_axis(description(), name());
    if (lacks_centre && !description().gravity) {  // which has its own complaint
      complain_of_missing_centre();
    }
    if (!body_.inertia.empty()) {
      bind_inertia(body_.inertia.front(), result);
    }
    return result;
  }

 private:
  const std::string& name() const { return body_.name.text; }

  const MechanismDescription& description() const { return context_.description; }

  void complain_of_missing_centre() const {
    context_.found.error(
        "E0303",
        body_.mass->where,
        fmt::format("body '{}' has a mass, which accelerations act on, but no centre of mass",
                    name()),
        fmt::format("add centre_of_mass: {}, a point in the drawn position, or remove the mass",
                    description().space == Space::planar ? "[x, y]" : "[x, y, z]"));
  }

  void bind_inertia(const InertiaDescription& inertia, BodyMass& result) {
    result.has_inertia = true;
    const std::vector<Value>& entries = inertia.entries;
    if (entries.size() == 1) {
      const double moment =
          context_
              .number(
                  entries.front(), kMomentOfInertia, fmt::format("'inertia' of body '{}'", name()))
              .value_or(0.0);
      bind_single(inertia, moment, result);
      return;
    }
    std::vector<double> numbers;
    for (const Value& entry : entries) {
      numbers.push_back(context_.evaluator.number(entry, QuantityKind::inertia).value_or(0.0));
    }
    result.inertia = inertia_tensor<double>(numbers, std::nullopt);
    if (check_symmetry(result.inertia)) {
      check_moments(result);
    }
  }

  void bind_single(const InertiaDescription& inertia, double moment, BodyMass& result) {
    if (inertia.axis) {
      const std::optional<AxisOf<double>> axis = context_.evaluator.axis(*inertia.axis);
      if (!axis) {
        return;
      }
      result.polar_axis = axis->direction;
    }
    result.inertia = inertia_tensor<double>(std::span(&moment, 1), result.polar_axis);
  }

  bool check_symmetry(const Mat3& tensor) const {
    const std::vector<Value>& entries = body_.inertia.front().entries;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i + 1; j < 3; ++j) {
        const auto row = static_cast<Eigen::Index>(i);
        const auto column = static_cast<Eigen::Index>(j);
        if (tensor(row, column) != tensor(column, row)) {
          context_.found.error(
              "E0322",
              entries[3 * j + i].where,
              fmt::format("'inertia' of body '{}' is not symmetric: {} in row {} is {} in row {}",
                          name(),
                          entries[3 * i + j].expression.text(),
                          i + 1,
                          entries[3 * j + i].expression.text(),
                          j + 1),
              "write the same number in both places");
          return false;
        }
      }
    }
    return true;
  }

  // A body has principal moments none of which exceeds the sum of the others.
  void check_moments(const BodyMass& result) const {
    const Vec3 moments = principal_values(result.inertia);  // ascending
    const double sum = moments[0] + moments[1];
    const double rounding = kTriangleRounding * moments[2];
    const bool is_negative = moments[0] < -rounding;
    if (!is_negative && moments[2] <= (1.0 + kTriangleRounding) * sum) {
      return;
    }
    const FileUnits& units = description().units;
    const auto shown = [&](double moment) {
      return fmt::format("{:.4g}", units.from_si(QuantityKind::inertia, moment));
    };
    context_.found.error(
        "E0322",
        body_.inertia.front().where,
        fmt::format("no body has the principal moments of inertia of '{}', {}, {} and {} {}: {}",
                    name(),
                    shown(moments[0]),
                    shown(moments[1]),
                    shown(moments[2]),
                    units.text(QuantityKind::inertia),
                    is_negative ? "one is negative" : "one exceeds the sum of the others"),
        "look for a decimal point, the order of the numbers, a tensor that is not about the centre "
        "of mass, and the sign of its products: Jxy = -integral of x*y; of a rotor write {polar: "
        "NUMBER, axis: z}");
  }

  const BodyDescription& body_;
  const SectionContext& context_;
};

// Its first bearing on its axis.
std::optional<CouplingId> bearing_on_axis(const GearTrain& train,
                                          const Topology& topology,
                                          BodyId body) {
  const std::string& name = topology.body(body).name;
  const int axis = train.axis_on(name);
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    const CouplingTopology& coupling = topology.couplings[e];
    const bool is_of_body = coupling.tail == body || coupling.head == body;
    if (is_of_body && coupling.type == CouplingType::revolute &&
        train.axis_between(topology.body(coupling.tail).name, topology.body(coupling.head).name) ==
            axis) {
      return CouplingId{static_cast<int>(e)};
    }
  }
  return std::nullopt;
}

// The largest moment of inertia of a body with a mass as that of a ring of this radius.
void warn_of_gyration(const BodyMass& one,
                      const std::string& body,
                      double length,
                      const SectionContext& context) {
  const double largest = one.inertia.diagonal().maxCoeff();
  if (one.mass == 0.0 || largest == 0.0) {
    return;
  }
  const double radius = std::sqrt(largest / one.mass);
  if (radius <= length && radius >= kLeastGyration * length) {
    return;
  }
  const FileUnits& units = context.description.units;
  context.found.warning(
      "W0311",
      one.where,
      fmt::format("body '{}' has a radius of gyration of {:.3g} {}, but the size of the mechanism "
                  "is {:.3g} {}",
                  body,
                  units.from_si(QuantityKind::length, radius),
                  units.text(QuantityKind::length),
                  units.from_si(QuantityKind::length, length),
                  units.text(QuantityKind::length)),
      fmt::format("check the units: bare moments of inertia count in {}, bare masses in {}",
                  units.text(QuantityKind::inertia),
                  units.text(QuantityKind::mass)));
}

}  // namespace

bool is_on_axis(const MechanismDescription& description, const std::string& body) {
  if (!description.gears) {
    return false;
  }
  const auto& members = description.gears->members;
  return std::ranges::any_of(members, [&](const GearMember& one) { return one.body.text == body; });
}

std::vector<BodyMass> masses_of_bodies(const SectionContext& context,
                                       const Mechanism& mechanism,
                                       const std::vector<DescribedMass>& masses) {
  const MechanismDescription& description = context.description;
  const Topology& topology = mechanism.topology;
  std::vector<BodyMass> result(topology.bodies.size());
  const bool has_train = description.gears && has_all_meshes(description);
  const GearTrain train = has_train ? find_gear_train(description) : GearTrain{};
  const std::vector<int> counts = bind_body_counts(description, topology, context.evaluator);
  for (const DescribedMass& described : masses) {
    const BodyDescription& body = description.bodies[described.body];
    const int b = context.names.bodies.find(body.name.text);
    if (b <= 0 || !described.mass.counts()) {
      continue;
    }
    BodyMass& one = result[static_cast<std::size_t>(b)];
    one = described.mass;
    one.count = counts[static_cast<std::size_t>(b)];
    if (!body.centre_of_mass && has_train) {
      const std::optional<CouplingId> bearing = bearing_on_axis(train, topology, BodyId{b});
      one.centre = bearing ? mechanism.geometry.points[static_cast<std::size_t>(bearing->value)]
                           : Vec3::Zero();
    }
    warn_of_gyration(one, body.name.text, mechanism.geometry.length, context);
  }
  return result;
}

std::optional<CouplingId> centre_bearing(const MechanismDescription& description,
                                         const Topology& topology,
                                         BodyId body) {
  return description.gears && has_all_meshes(description)
             ? bearing_on_axis(find_gear_train(description), topology, body)
             : std::nullopt;
}

std::vector<DescribedMass> bind_masses(const SectionContext& context) {
  std::vector<DescribedMass> masses;
  const std::vector<BodyDescription>& bodies = context.description.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].centre_of_mass && !bodies[b].mass) {
      warn_of_idle_centre(bodies[b], context);
    }
    if (bodies[b].mass || !bodies[b].inertia.empty()) {
      masses.push_back({.body = b, .mass = MassBinder(bodies[b], context).bind()});
    } else if (bodies[b].centre_of_mass) {
      context.point(bodies[b].centre_of_mass);
    }
  }
  return masses;
}

}  // namespace kinestat
