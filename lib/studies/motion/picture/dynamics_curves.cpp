#include "studies/motion/picture/dynamics_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/axis_name.hpp"

namespace kinestat {

namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr double kBesideOthers = 0.08;  // stems of an order stand so far apart

// A force along the motion, in the unit of the file.
struct ForcePath {
  std::string name;
  std::vector<Vec3> forces;
};

std::vector<ForcePath> balanced_paths(const MotionDynamics& dynamics) {
  std::vector<ForcePath> paths = {{"without counterweights", {}}, {"with them", {}}};
  const auto in_unit = [&](double x) { return dynamics.units.from_si(QuantityKind::force, x); };
  for (const ShakingPoint& point : dynamics.balance->path) {
    paths[0].forces.emplace_back(point.before.unaryExpr(in_unit));
    paths[1].forces.emplace_back(point.after.unaryExpr(in_unit));
  }
  return paths;
}

// Of the columns of the report; empty unit: there are none.
std::vector<ForcePath> reported_path(const MotionTable& motion, std::string& unit) {
  std::array<std::size_t, 3> columns = {};
  columns.fill(motion.columns.size());
  for (std::size_t c = 0; c < motion.columns.size(); ++c) {
    const MotionColumn& column = motion.columns[c];
    const bool is_component = column.quantity.size() == std::string_view("force/x").size();
    if (column.element == "shaking" && column.quantity.starts_with("force/") && is_component) {
      columns[static_cast<std::size_t>(column.quantity.back() - 'x')] = c;
      unit = column.unit;
    }
  }
  ForcePath path{.name = "shaking force", .forces = {}};
  for (const MotionRow& row : motion.rows) {
    Vec3 force = Vec3::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] < row.values.size()) {
        force[static_cast<Eigen::Index>(i)] = row.values[columns[i]].value_or(kGap);
      }
    }
    path.forces.push_back(force);
  }
  return unit.empty() || path.forces.empty() ? std::vector<ForcePath>()
                                             : std::vector<ForcePath>{std::move(path)};
}

bool changes_upwards(const std::vector<ForcePath>& paths) {
  return std::ranges::any_of(paths, [](const ForcePath& path) {
    return std::ranges::any_of(path.forces, [](const Vec3& force) { return force.z() != 0.0; });
  });
}

Chart path_of(const std::vector<ForcePath>& paths, int up, const std::string& unit) {
  const std::string axis = kAxisNames[static_cast<std::size_t>(up)];
  Chart chart = {.title = axis + " over x",
                 .x = {.label = "shaking force along x", .unit = unit},
                 .y = {.label = "along " + axis, .unit = unit},
                 .series = {},
                 .has_equal_scales = true};
  for (const ForcePath& path : paths) {
    Series series = {.name = path.name};
    for (const Vec3& force : path.forces) {
      series.x.push_back(force.x());
      series.y.push_back(force[up]);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Chart orders_of(const MotionDynamics& dynamics, QuantityKind kind, const std::string& drive) {
  std::vector<const HarmonicSeries*> shown;
  for (const HarmonicSeries& one : dynamics.harmonics) {
    if (one.kind == kind) {
      shown.push_back(&one);
    }
  }
  Chart chart = {
      .x = {.label = "order by the turn of " + drive, .unit = "", .low = 0.0, .least_step = 1.0},
      .y = {.label = kind == QuantityKind::force ? "amplitude of forces" : "amplitude of moments",
            .unit = dynamics.units.text(kind)},
      .series = {}};
  for (std::size_t s = 0; s < shown.size(); ++s) {
    const double aside =
        kBesideOthers * (static_cast<double>(s) - 0.5 * static_cast<double>(shown.size() - 1));
    Series stems = {.name = shown[s]->name};
    for (const Harmonic& one : shown[s]->orders) {
      const double at = one.order + aside;
      const double height = dynamics.units.from_si(kind, one.amplitude);
      stems.x.insert(stems.x.end(), {at, at, at});
      stems.y.insert(stems.y.end(), {0.0, height, kGap});
    }
    chart.series.push_back(std::move(stems));
  }
  return chart;
}

}  // namespace

Figure shaking_figure(const MotionTable& motion, const std::string& title) {
  Figure figure = {.name = "shaking",
                   .title = title,
                   .description = "The shaking force on the frame: its tip through the motion.",
                   .charts = {}};
  std::string unit;
  std::vector<ForcePath> paths;
  if (motion.dynamics && motion.dynamics->balance) {
    unit = motion.dynamics->units.text(QuantityKind::force);
    paths = balanced_paths(*motion.dynamics);
  } else {
    paths = reported_path(motion, unit);
  }
  if (!paths.empty()) {
    figure.charts.push_back(path_of(paths, 1, unit));
    if (changes_upwards(paths)) {
      figure.charts.push_back(path_of(paths, 2, unit));
    }
  }
  return figure;
}

Figure harmonic_figure(const MotionTable& motion, const std::string& title) {
  Figure figure = {.name = "harmonics",
                   .title = title,
                   .description = "Amplitudes of what acts in a cycle, over their orders.",
                   .charts = {}};
  if (!motion.dynamics || motion.dynamics->harmonics.empty()) {
    return figure;
  }
  for (const QuantityKind kind : {QuantityKind::force, QuantityKind::moment}) {
    Chart chart = orders_of(*motion.dynamics, kind, motion.drives.front().name);
    if (!chart.series.empty()) {
      figure.charts.push_back(std::move(chart));
    }
  }
  return figure;
}

}  // namespace kinestat
