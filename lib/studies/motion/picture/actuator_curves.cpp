#include "studies/motion/picture/actuator_curves.hpp"

#include <utility>

#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

class ActuatorCharts {
 public:
  explicit ActuatorCharts(const MotionTable& motion) : motion_(motion), of_(*motion.dynamics) {}

  // A chart an actuator: those of one mechanism may differ by orders.
  Chart over_way(const ActuatorFigures& one) const {
    const QuantityKind kind = action_kind(one.turns);
    Chart chart = action_over(one,
                              of_.is_steady ? axis(motion_.drives.front().name, of_.place_kind())
                                            : axis("time", QuantityKind::time),
                              [&](const ActuatorPoint& point) { return place(point); });
    chart.series.push_back(level("mean", one, of_.units.from_si(kind, one.mean)));
    chart.series.push_back(level("RMS", one, of_.units.from_si(kind, one.rms)));
    return chart;
  }

  Chart over_speed(const ActuatorFigures& one) const {
    const QuantityKind kind = rate_kind(one.turns);
    return action_over(one, axis("speed", kind), [&](const ActuatorPoint& point) {
      return of_.units.from_si(kind, point.speed);
    });
  }

 private:
  ChartAxis axis(std::string label, QuantityKind kind) const {
    return {.label = std::move(label), .unit = of_.units.text(kind)};
  }

  template <class PlaceOf>
  Chart action_over(const ActuatorFigures& one, ChartAxis x, const PlaceOf& place_of) const {
    const QuantityKind kind = action_kind(one.turns);
    Series curve = {.name = one.name};
    for (const ActuatorPoint& point : one.path) {
      curve.x.push_back(place_of(point));
      curve.y.push_back(of_.units.from_si(kind, point.action));
    }
    return {.title = one.name,
            .x = std::move(x),
            .y = axis(one.turns ? "torque" : "force", kind),
            .series = {std::move(curve)}};
  }

  double place(const ActuatorPoint& point) const {
    return of_.is_steady ? of_.units.from_si(of_.place_kind(), point.drive)
                         : of_.units.from_si(QuantityKind::time, point.time);
  }

  Series level(std::string name, const ActuatorFigures& one, double height) const {
    return {.name = std::move(name),
            .x = {place(one.path.front()), place(one.path.back())},
            .y = {height, height}};
  }

  const MotionTable& motion_;
  const MotionDynamics& of_;
};

using ChartOf = Chart (ActuatorCharts::*)(const ActuatorFigures&) const;

Figure figure_with(ChartOf chart_of, const MotionTable& motion, Figure figure) {
  if (motion.dynamics) {
    const ActuatorCharts charts(motion);
    for (const ActuatorFigures& one : motion.dynamics->actuators) {
      figure.charts.push_back((charts.*chart_of)(one));
    }
  }
  return figure;
}

}  // namespace

Figure actuator_figure(const MotionTable& motion, const std::string& title) {
  return figure_with(
      &ActuatorCharts::over_way,
      motion,
      {.name = "drive-torque",
       .title = title,
       .description = "Required torque or force of each actuator, with its mean and RMS in time.",
       .charts = {}});
}

Figure speed_torque_figure(const MotionTable& motion, const std::string& title) {
  return figure_with(
      &ActuatorCharts::over_speed,
      motion,
      {.name = "speed-torque",
       .title = title,
       .description = "Required torque or force of each actuator over its own speed.",
       .charts = {}});
}

}  // namespace kinestat
