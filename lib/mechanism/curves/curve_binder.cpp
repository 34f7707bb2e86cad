#include "mechanism/curves/curve_binder.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "core/utf8.hpp"

namespace kinestat {

namespace {

std::optional<QuantityKind> place_kind_of(Curve::Over over, DriveKind drive) {
  if (over == Curve::Over::time) {
    return QuantityKind::time;
  }
  const bool is_speed = over == Curve::Over::speed;
  switch (drive) {
    case DriveKind::turning:
      return is_speed ? QuantityKind::angular_velocity : QuantityKind::angle;
    case DriveKind::sliding:
      return is_speed ? QuantityKind::velocity : QuantityKind::length;
    case DriveKind::unknown:
      break;
  }
  return std::nullopt;
}

class CurveBinder {
 public:
  CurveBinder(const CurveDescription& curve,
              const SectionContext& context,
              const Topology* topology)
      : curve_(curve), context_(context), topology_(topology) {}

  Curve bind() {
    const int errors_before = context_.found.error_count();
    result_.name = curve_.name.text;
    result_.where = curve_.name.where;
    check_name();
    bind_argument();
    bind_points();
    if (is_good(errors_before)) {
      check_rising();
    }
    if (is_good(errors_before)) {
      bind_ends();
    }
    if (is_good(errors_before)) {
      bind_slopes();
    }
    if (!is_good(errors_before)) {
      result_.at.clear();
    }
    return std::move(result_);
  }

 private:
  bool is_good(int errors_before) const {
    return context_.found.error_count() == errors_before &&
           result_.at.size() >= std::max<std::size_t>(curve_.points.size(), 2);
  }

  bool is_of_table() const { return !curve_.table.empty(); }

  void refuse(std::string_view code, SourceRange where, std::string message, std::string hint) {
    context_.found.error(code, where, std::move(message), std::move(hint));
  }

  // Points of a table have no place in the file.
  void refuse_points(std::string_view code,
                     SourceRange where,
                     const std::string& message,
                     std::string hint) {
    is_of_table()
        ? refuse(code, {}, fmt::format("{}: {}", printable(curve_.table), message), std::move(hint))
        : refuse(code, where, message, std::move(hint));
  }

  void check_name() {
    if (context_.names.parameters.contains(curve_.name.text)) {
      refuse("E0307",
             curve_.name.where,
             fmt::format("'{}' is a curve, and a parameter too", curve_.name.text),
             "give one of the two another name");
    }
  }

  void bind_argument() {
    std::string name = curve_.over.text;
    if (name == kTimeWord) {
      if (context_.names.actuators.contains(name)) {
        refuse("E0307",
               curve_.over.where,
               fmt::format("curve '{}' is over time, and an actuator has that name too",
                           curve_.name.text),
               "give the actuator another name");
      }
      return;
    }
    result_.over = Curve::Over::position;
    if (name.ends_with(kSpeedSuffix)) {
      result_.over = Curve::Over::speed;
      name.resize(name.size() - std::string_view(kSpeedSuffix).size());
    }
    const Name actuator{.text = name, .where = curve_.over.where};
    context_.names.check_actuator(
        actuator, fmt::format("curve '{}' is over", curve_.name.text), context_.found);
    result_.actuator = name;
    drive_ = context_.names.kind_of_actuator(name);
    if (topology_ == nullptr) {
      return;
    }
    const auto at = std::ranges::find(topology_->actuators, name, &ActuatorTopology::name);
    if (at != topology_->actuators.end()) {
      result_.freedom = at->freedom;
      const bool turns = topology_->freedoms[static_cast<std::size_t>(at->freedom)].is_rotation;
      drive_ = turns ? DriveKind::turning : DriveKind::sliding;
    }
  }

  std::optional<double> place(const Value& value, Evaluator& evaluator) {
    const std::optional<QuantityKind> kind = place_kind_of(result_.over, drive_);
    if (!kind) {
      (void)evaluator.quantity(value);
      return std::nullopt;
    }
    result_.place_kind = *kind;
    return evaluator.number(value, *kind);
  }

  // The first line of a table has its units.
  std::string hint_at_head(std::size_t column) const {
    const std::optional<QuantityKind> kind = place_kind_of(result_.over, drive_);
    return column == 0 && kind
               ? fmt::format(
                     "write the unit into its first line, such as [{}], or none, which is "
                     "that of the file",
                     context_.description.units.text(*kind))
               : "change the number, or the unit in the first line";
  }

  // Of a table the errors are those of the number of a point.
  template <class Bind>
  auto bind_of_point(std::size_t point, std::size_t column, const Bind& bind)
      -> decltype(bind(std::declval<Evaluator&>())) {
    if (!is_of_table()) {
      return bind(context_.evaluator);
    }
    Diagnostics said;
    Evaluator evaluator = context_.evaluator.complaining_to(said);
    const auto result = bind(evaluator);
    for (const Diagnostic& one : said.items()) {
      refuse_points(
          one.code, {}, fmt::format("point {}: {}", point + 1, one.message), hint_at_head(column));
    }
    return result;
  }

  void bind_points() {
    if (curve_.points.size() < 2) {
      refuse_points(
          "E0325",
          curve_.name.where,
          fmt::format("curve '{}' has {}",
                      curve_.name.text,
                      curve_.points.empty() ? "no points" : "one point"),
          is_of_table()
              ? "write at least two below the first line, with arguments in increasing order"
              : "give at least two, [[0 deg, -900 N], [90 deg, -1500 N]]; a number that does not "
                "move is written where it is used, or is a parameter");
      return;
    }
    bool has_dimension = false;  // which a zero need not name
    for (std::size_t i = 0; i < curve_.points.size(); ++i) {
      const CurvePointDescription& point = curve_.points[i];
      const std::optional<double> at =
          bind_of_point(i, 0, [&](Evaluator& by) { return place(point.at, by); });
      const std::optional<Quantity> value =
          bind_of_point(i, 1, [&](Evaluator& by) { return by.quantity(point.value); });
      if (is_of_table() && (!at || !value)) {
        return;  // the others have the same units
      }
      if (!at || !value) {
        continue;
      }
      const bool is_plain_zero = value->value == 0.0 && is_bare(value->dimension);
      if (!is_plain_zero && !has_dimension) {
        result_.dimension = value->dimension;
        has_dimension = true;
      } else if (!is_plain_zero && value->dimension != result_.dimension) {
        refuse("E0309",
               point.value.where,
               fmt::format("the value of point {} of curve '{}' is {}, others are {}",
                           i + 1,
                           curve_.name.text,
                           phrase_of(value->dimension),
                           phrase_of(result_.dimension)),
               "give all values of a curve the same kind of unit");
        return;
      }
      result_.at.push_back(*at);
      result_.values.push_back(value->value);
    }
  }

  void check_rising() {
    for (std::size_t i = 1; i < result_.at.size(); ++i) {
      if (!(result_.at[i - 1] < result_.at[i])) {
        refuse_points(
            "E0325",
            curve_.points[i].at.where,
            fmt::format("the points of curve '{}' are not in increasing order: {} comes after {}",
                        curve_.name.text,
                        curve_.points[i].at.expression.text(),
                        curve_.points[i - 1].at.expression.text()),
            "write the points in increasing order, none of them twice");
        return;
      }
    }
  }

  bool ends_as_it_began() const {
    const double first = result_.values.front();
    const double last = result_.values.back();
    return std::abs(last - first) <= kSameValue * (std::abs(first) + std::abs(last));
  }

  void refuse_end(std::string hint) {
    refuse_points("E0325",
                  curve_.points.back().value.where,
                  fmt::format("curve '{}' repeats, and ends with {} where it began with {}",
                              curve_.name.text,
                              curve_.points.back().value.expression.text(),
                              curve_.points.front().value.expression.text()),
                  std::move(hint));
  }

  // A curve with a period has a point where it begins anew.
  void bind_ends() {
    if (curve_.ends && curve_.between != CurveCourse::cubic) {
      refuse("E0305",
             curve_.name.where,
             fmt::format("'ends' of curve '{}' is of between: cubic alone", curve_.name.text),
             "write between: cubic, or remove 'ends'");
      return;
    }
    if (curve_.ends && *curve_.ends != CurveEnds::periodic && curve_.period) {
      refuse("E0305",
             curve_.name.where,
             fmt::format("curve '{}' has a period and 'ends' too", curve_.name.text),
             "remove 'ends', or 'period'");
      return;
    }
    const double begin = result_.at.front();
    if (!curve_.period) {
      if (curve_.ends == CurveEnds::periodic) {
        if (!ends_as_it_began()) {
          refuse_end(
              "let the last value be the first, or add 'period' and leave the last point "
              "out");
          return;
        }
        result_.period = result_.at.back() - begin;
      }
      return;
    }
    const std::optional<double> period = place(*curve_.period, context_.evaluator);
    if (!period) {
      return;
    }
    if (!(*period > 0.0)) {
      refuse("E0305",
             curve_.period->where,
             fmt::format("'period' of curve '{}' is not above zero", curve_.name.text),
             "write after how much the curve repeats, such as 360 deg");
      return;
    }
    const double beyond = result_.at.back() - begin - *period;
    if (beyond > kCurveEnd * *period) {
      refuse_points("E0325",
                    curve_.points.back().at.where,
                    fmt::format("curve '{}' goes on beyond its period of {}",
                                curve_.name.text,
                                curve_.period->expression.text()),
                    "leave out the points behind it, or write a longer 'period'");
      return;
    }
    if (beyond < -kCurveEnd * *period) {
      result_.at.push_back(begin + *period);
      result_.values.push_back(result_.values.front());
    } else if (!ends_as_it_began()) {
      refuse_end(
          "let the last value be the first, or leave the last point out; a jump is two "
          "points near to each other");
      return;
    }
    result_.period = *period;
  }

  void bind_slopes() {
    result_.values.back() = result_.period ? result_.values.front() : result_.values.back();
    switch (curve_.between) {
      case CurveCourse::linear:
        return;
      case CurveCourse::monotone:
        result_.slopes = monotone_slopes(result_.at, result_.values, result_.period.has_value());
        return;
      case CurveCourse::cubic:
        break;
    }
    if (result_.period && result_.at.size() < 3) {
      refuse("E0325",
             curve_.name.where,
             fmt::format("curve '{}' repeats, and has one point in its period", curve_.name.text),
             "give more points; a number that does not move is written where it is used");
      return;
    }
    result_.slopes = spline_slopes(result_.at, result_.values, spline_ends());
  }

  SplineEnds spline_ends() const {
    if (result_.period) {
      return SplineEnds::periodic;
    }
    return curve_.ends == CurveEnds::rest ? SplineEnds::rest : SplineEnds::natural;
  }

  const CurveDescription& curve_;
  const SectionContext& context_;
  const Topology* topology_;
  Curve result_;
  DriveKind drive_ = DriveKind::unknown;
};

}  // namespace

std::vector<Curve> bind_curves(const SectionContext& context, const Topology* topology) {
  std::vector<Curve> curves;
  for (const CurveDescription& one : context.description.curves) {
    curves.push_back(CurveBinder(one, context, topology).bind());
  }
  return curves;
}

namespace {

// The names in all numbers that may move, and those of the curves of drives.
std::set<std::string_view> names_where_curves_stand(const MechanismDescription& description) {
  std::set<std::string_view> names;
  const auto add = [&](const Value& value) {
    names.insert(value.expression.names().begin(), value.expression.names().end());
  };
  const auto add_loads = [&](const std::vector<LoadDescription>& loads) {
    for (const LoadDescription& load : loads) {
      if (load.force) {
        std::ranges::for_each(load.force->coordinates, add);
      }
      std::ranges::for_each(load.couple, add);
    }
  };
  add_loads(description.loads);
  for (const CaseDescription& one : description.cases) {
    add_loads(one.loads);
    std::ranges::for_each(one.actions, add, &Assignment::value);
  }
  if (description.simulation) {
    std::ranges::for_each(description.simulation->actions, add, &Assignment::value);
  }
  for (const SpringDescription& spring : description.springs) {
    if (spring.force) {
      add(*spring.force);
    }
  }
  if (description.motion) {
    for (const DriveRange& drive : description.motion->drives) {
      names.insert(drive.curve ? std::string_view(drive.curve->text) : std::string_view());
    }
  }
  return names;
}

}  // namespace

void warn_of_unused_curves(const MechanismDescription& description, Diagnostics& found) {
  const std::set<std::string_view> used = names_where_curves_stand(description);
  for (const CurveDescription& curve : description.curves) {
    if (!used.contains(curve.name.text)) {
      found.warning("W0301",
                    curve.name.where,
                    fmt::format("curve '{}' is never used", curve.name.text),
                    "name it in a load, an action of a case, a spring or a drive, or remove it");
    }
  }
}

}  // namespace kinestat
