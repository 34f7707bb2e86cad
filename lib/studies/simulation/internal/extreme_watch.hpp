// Where columns of a simulation are least and greatest, in its steps, and what they jump from and
// to between them.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "studies/simulation/simulation_readings.hpp"

namespace kinestat {

/// Between two looks nothing turns farther [rad], as long as there are not too many.
inline constexpr double kFarthestTurn = 0.25;

/// Looks into each step of the integration, which is smooth: at its ends, at its middle or more
/// often where much turns, and at the tops of parabolas through these.
class ExtremeWatch {
 public:
  /// Both must outlive it.
  ExtremeWatch(const Mechanism& mechanism, const SimulationPlan& plan);

  void take(const SimulationRow& row, const SimulationRow& first);

  /// Positions and speeds of the freedom that it is of.
  void take(const SimulationEvent& event);

  /// A step, up to just before something happens in it, where the next one begins. In one regime
  /// nothing jumps from step to step.
  struct Step {
    double begin = 0.0;
    double end = 0.0;
    int regime = 0;
  };

  /// Empty where there is none.
  using RowAt = std::function<std::optional<SimulationRow>(double time)>;

  void look(const Step& step, const SimulationRow& first, const RowAt& row_at);

  /// Of each of the readings that are wanted.
  std::vector<SimulationExtremes> extremes() const;

  /// The fastest that turned at the last look [rad/s].
  double turns() const { return turns_; }

  std::vector<SimulationSides> sides() const { return sides_; }

  /// False where some steps were too long to look everywhere.
  bool sees_all() const { return sees_all_; }

 private:
  using Values = std::vector<std::optional<double>>;

  struct Sample {
    double time = 0.0;
    Values values;
    double turns = 0.0;  // the fastest that turns [rad/s]
  };

  Sample sample_of(const SimulationRow& row, const SimulationRow& first);
  Sample sample_at(double time);
  int parts_of(const Sample& begin, const Sample& end);
  void climb(const std::vector<Sample>& samples, std::size_t column, double sign);
  void note(std::size_t column, double value, double time);

  const Mechanism& mechanism_;
  std::vector<SimulationReading> readings_;
  std::vector<SimulationExtremes> extremes_;  // of each
  std::map<QuantityKind, double> largest_;    // of a kind so far
  std::vector<SimulationSides> sides_;
  std::optional<Sample> last_;
  int regime_ = -1;  // of the last
  double turns_ = 0.0;
  int looks_ = 0;  // that long steps took
  bool sees_all_ = true;
  const RowAt* row_at_ = nullptr;  // of the step
  const SimulationRow* first_ = nullptr;
};

}  // namespace kinestat
