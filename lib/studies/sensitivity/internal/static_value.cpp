#include "mechanism/label_kind.hpp"
#include "studies/sensitivity/internal/value_path.hpp"

namespace kinestat {

namespace {

using Found = std::optional<ReportedValue>;

const LocalOrigin& origin_of(const DualCase& values) {
  return values.mechanism().geometry.origin;
}

Found coupling_value(const DualCase& values, const PathParts& parts) {
  using enum QuantityKind;
  const auto e = index_of(values.topology().couplings, parts[2]);
  if (!e || parts.size() != 5) {
    return std::nullopt;
  }
  const Vec3Of<Dual> at = values.point(*e);
  if (parts[3] == "at") {
    return component(parts, {{length, origin_of(values).in_world<Dual>(at)}});
  }
  const auto wrench = values.coupling_wrench(*e);
  if (!wrench) {
    return std::nullopt;
  }
  if (parts[3] == "wrench") {
    const WrenchOf<Dual> world = about_world(*wrench, origin_of(values));
    return component(parts, {{moment, world.moment}, {force, world.force}});
  }
  if (parts[3] == "moment") {
    return component(parts, {{moment, moment_at(*wrench, at)}});
  }
  return parts[3] == "force" ? component(parts, {{force, wrench->force}}) : std::nullopt;
}

// Its size as a couple or a drag; the moment is about the point of the coupling.
Found friction_value(const DualCase& values, const PathParts& parts) {
  using enum QuantityKind;
  const auto i = index_where(values.friction_count(), parts[2], [&](int k) {
    const FrictionLawOf<Dual>& law = values.friction_law(static_cast<std::size_t>(k));
    return values.topology().coupling(law.coupling).name;
  });
  if (!i) {
    return std::nullopt;
  }
  const FrictionLawOf<Dual>& law = values.friction_law(*i);
  if (parts.size() == 4) {
    return parts[3] == (law.is_couple ? "couple" : "drag")
               ? as_value(law.is_couple ? moment : force, values.friction(*i))
               : std::nullopt;
  }
  const WrenchOf<Dual> wrench = values.friction_wrench(*i);
  if (parts.size() == 5 && parts[3] == "force") {
    return component(parts, {{force, wrench.force}});
  }
  if (parts.size() == 5 && parts[3] == "moment") {
    const Vec3Of<Dual> at = values.point(static_cast<std::size_t>(law.coupling.value));
    return component(parts, {{moment, moment_at(wrench, at)}});
  }
  return std::nullopt;
}

}  // namespace

Found find_static_value(const DualCase& values, const PathParts& parts) {
  const Topology& topology = values.topology();
  if (parts.size() == 3 && parts[1] == "actions") {
    const auto a = index_where(
        topology.actions.size(), parts[2], [&](int i) { return topology.action_name(i); });
    return a ? as_value(kind_of(topology.actions[*a]), values.magnitude(*a)) : std::nullopt;
  }
  if (parts.size() > 3 && parts[1] == "couplings") {
    return coupling_value(values, parts);
  }
  return parts.size() > 3 && parts[1] == "friction" ? friction_value(values, parts) : std::nullopt;
}

}  // namespace kinestat
