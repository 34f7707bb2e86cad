#include "studies/motion/picture/actuator_curves.hpp"

#include <utility>

#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

Figure figure_of(std::string name, const std::string& title, std::string description) {
  return {
      .name = std::move(name), .title = title, .description = std::move(description), .charts = {}};
}

class ActuatorCharts {
 public:
  explicit ActuatorCharts(const MotionTable& motion) : motion_(motion), of_(*motion.dynamics) {}

  // A chart an actuator: those of one mechanism may differ by orders.
  Chart over_way(const ActuatorFigures& one) const {
    const QuantityKind kind = action_kind(one.turns);
    Chart chart = {.title = one.name,
                   .x = of_.is_steady ? axis(motion_.drives.front().name, of_.place_kind())
                                      : axis("time", QuantityKind::time),
                   .y = axis(one.turns ? "torque" : "force", kind),
                   .series = {}};
    Series curve = {.name = one.name};
    for (const ActuatorPoint& point : one.path) {
      curve.x.push_back(place(point));
      curve.y.push_back(of_.units.from_si(kind, point.action));
    }
    chart.series.push_back(std::move(curve));
    chart.series.push_back(level("mean", one, of_.units.from_si(kind, one.mean)));
    chart.series.push_back(level("RMS", one, of_.units.from_si(kind, one.rms)));
    return chart;
  }

  Chart over_speed(const ActuatorFigures& one) const {
    const QuantityKind kind = action_kind(one.turns);
    Chart chart = {.title = one.name,
                   .x = axis("speed", rate_kind(one.turns)),
                   .y = axis(one.turns ? "torque" : "force", kind),
                   .series = {}};
    Series curve = {.name = one.name};
    for (const ActuatorPoint& point : one.path) {
      curve.x.push_back(of_.units.from_si(rate_kind(one.turns), point.speed));
      curve.y.push_back(of_.units.from_si(kind, point.action));
    }
    chart.series.push_back(std::move(curve));
    return chart;
  }

 private:
  ChartAxis axis(std::string label, QuantityKind kind) const {
    return {.label = std::move(label), .unit = of_.units.text(kind)};
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

template <class Draw>
void add_charts(const MotionTable& motion, const Draw& draw, Figure& figure) {
  if (!motion.dynamics) {
    return;
  }
  const ActuatorCharts charts(motion);
  for (const ActuatorFigures& one : motion.dynamics->actuators) {
    figure.charts.push_back(draw(charts, one));
  }
}

}  // namespace

Figure actuator_figure(const MotionTable& motion, const std::string& title) {
  Figure figure =
      figure_of("drive-torque",
                title,
                "Required torque or force of each actuator, with its mean and RMS in time.");
  add_charts(
      motion,
      [](const ActuatorCharts& charts, const ActuatorFigures& one) { return charts.over_way(one); },
      figure);
  return figure;
}

Figure speed_torque_figure(const MotionTable& motion, const std::string& title) {
  Figure figure = figure_of(
      "speed-torque", title, "Required torque or force of each actuator over its own speed.");
  add_charts(
      motion,
      [](const ActuatorCharts& charts, const ActuatorFigures& one) {
        return charts.over_speed(one);
      },
      figure);
  return figure;
}

}  // namespace kinestat
