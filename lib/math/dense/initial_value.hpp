// Ordinary differential equations from a state onwards, in steps as long as a tolerance allows.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace kinestat {

/// y' = f(t, y) by Dormand and Prince 5(4). After a step the solution is known everywhere between
/// its two times.
class InitialValueProblem {
 public:
  /// Writes f; false where it has no value: then another step is tried, once a longer one, which
  /// may pass over that place, and then shorter ones.
  using Slope = std::function<bool(double time, std::span<const double> y, std::span<double> f)>;

  /// Writes by how much a step that came to this state may be off in each component.
  using Allowed = std::function<void(
      std::span<const double> y, std::span<const double> f, double step, std::span<double> most)>;

  InitialValueProblem(Slope slope, Allowed allowed);
  ~InitialValueProblem();
  InitialValueProblem(const InitialValueProblem&) = delete;
  InitialValueProblem& operator=(const InitialValueProblem&) = delete;

  /// From there on; `step` is tried first.
  void start(double time, std::span<const double> y, double step);

  /// On by a step that ends no later than `end`, which is behind the time, or no later than
  /// `latest` where that is how it passes over a place without a slope. False where none leads on,
  /// be it so short that it is lost in the rounding of the time: nothing has changed then.
  [[nodiscard]] bool step(double end, double latest);

  /// False where there is none to begin with: no step leads on from there.
  bool has_slope() const;

  double time_before() const;
  double time() const;
  double next_step() const;
  const std::vector<double>& state() const;
  const std::vector<double>& state_before() const;

  /// Between the two times of the last step.
  void state_at(double time, std::span<double> y) const;

 private:
  struct Stepper;

  std::unique_ptr<Stepper> stepper_;
};

}  // namespace kinestat
