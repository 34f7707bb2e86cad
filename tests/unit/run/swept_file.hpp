// Sweeps made ready, from a file of the library or from text.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "files/load_file.hpp"
#include "format/mechanism_reader.hpp"
#include "studies/sweep/task/state_solver.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

/// A task, in a place where it stays, with its tape where it has one.
class SweptFile {
 public:
  /// The text of a file without `sweep`, and what that section holds.
  SweptFile(const std::string& text, const std::string& sweep) {
    const SourceFile source{.path = "test", .text = text + "\nsweep: " + sweep + "\n"};
    Diagnostics found;
    const auto tree = read_yaml(source, {}, found);
    auto description = tree ? read_mechanism(*tree, found) : std::nullopt;
    auto loaded = description ? bind_loaded(*std::move(description), found) : std::nullopt;
    if (loaded) {
      task_ = make_sweep_task(source, *std::move(loaded), SweepOptions{}, found);
    }
    if (!task_) {
      const auto error = std::ranges::find(found.items(), Severity::error, &Diagnostic::severity);
      throw std::runtime_error(error == found.items().end() ? "no task" : error->message);
    }
    task_->tapes = record_tapes(*task_);
  }

  SweepTask& task() { return *task_; }

 private:
  std::optional<SweepTask> task_;
};

/// A planetary set of S and P teeth: the ring follows from them.
inline const char* const kTrain = R"(
kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {S: 24, P: 18, R: S + 2*P, alpha: 20 deg, module: 2, torque: 5 N*m}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  b: {type: revolute, bodies: [housing, ring], at: [0, 0]}
  c: {type: revolute, bodies: [housing, carrier], at: [0, 0]}
  d: {type: revolute, bodies: [carrier, planet], at: [0, (S + P)/2*module]}
  e: {type: gear, bodies: [sun, planet], at: [0, S/2*module], tangent: x, pressure_angle: alpha}
  f: {type: gear, bodies: [ring, planet], at: [0, R/2*module], tangent: x, pressure_angle: alpha,
      internal: true}
actuators: {motor: {coupling: a}, wheel: {coupling: c}, brake: {coupling: b}}
cases:
  low: {motion: {motor: 100 rpm, brake: 0}, action: {motor: torque}, input: motor, output: wheel}
  back: {motion: {motor: 100 rpm, wheel: 0}, action: {motor: torque}, input: motor, output: brake}
)";

/// A four-bar a (0, 0), b (2, y), c (6, 3), d (8, 0), driven at d: at y = 1 crank and coupler are
/// in line.
inline const char* const kFourBar = R"(
kinestat: 1
space: planar
parameters: {y: 2}
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [2, y]}
  c: {type: revolute, bodies: [coupler, rocker], at: [6, 3]}
  d: {type: revolute, bodies: [frame, rocker], at: [8, 0]}
actuators: {crank: {coupling: a}, rocker: {coupling: d}}
cases:
  push: {motion: {rocker: 1 rad/s}, action: {rocker: 5 N*m}, input: rocker, output: crank}
)";

}  // namespace kinestat
