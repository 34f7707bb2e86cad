#include "studies/synthesis/positions/plane_record.hpp"

#include "expression/unit_quotient.hpp"

namespace kinestat {

Shape point_shape(const Measure& measure, bool is_nullable) {
  // A length may be beyond all numbers, and then has no value.
  const bool may_lack = std::holds_alternative<QuantityKind>(measure);
  return tuple_shape(number_shape(measure, may_lack), 2, is_nullable);
}

void write_point(const Point& point, const Measure& measure, Archive& to) {
  to.begin_list();
  for (const double component : {point.real(), point.imag()}) {
    if (const auto* kind = std::get_if<QuantityKind>(&measure)) {
      to.quantity(component, *kind);
    } else {
      to.number(component, {});
    }
  }
  to.end_list();
}

std::pair<std::optional<double>, std::string> per_length(const std::optional<double>& si,
                                                         const FileUnits& units) {
  const std::string& unit = units.text(QuantityKind::length);
  return {si ? std::optional(*si * units.factor(QuantityKind::length)) : std::nullopt,
          unit_quotient("", unit)};
}

const Record<Circle>& circle_record() {
  static const Record<Circle> record("A circle.", [](Record<Circle>& keys) {
    add_point(
        keys, "centre", QuantityKind::length, "Its centre, fixed frame.", [](const Circle& v) {
          return v.centre;
        });
    keys.quantity("radius", QuantityKind::length, "Its radius.", [](const Circle& v) {
      return std::optional(v.radius);
    });
  });
  return record;
}

}  // namespace kinestat
