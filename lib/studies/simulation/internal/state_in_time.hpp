// The state of a simulation, in the coordinates that tell it at a time.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "math/dense/initial_value.hpp"
#include "studies/simulation/simulation.hpp"

namespace kinestat {

class StateInTime {
 protected:
  // Frictions that slide together or not at all; the first has a joint of the tree.
  struct StuckGroup {
    std::vector<std::size_t> frictions;
    std::vector<int> senses;  // in which each slides where the first slides forwards
  };

  StateInTime(const Mechanism& mechanism,
              const MotionNetwork& network,
              std::span<const DrawnCoupling> drawn,
              const SimulationPlan& plan);
  ~StateInTime() = default;

  std::size_t free_count() const { return system_->free_count(); }

  // Of places and speeds of a freedom: 1 rad, or the size of its part of the mechanism [m].
  double unit(int freedom) const;
  double unit_of(std::size_t drive) const;

  // Of the rate of its joint: 1 rad, or the size of the mechanism [m].
  double unit_of_rate(int freedom) const;

  // Of joints: what is held, what rests at stops, what sticks.
  std::vector<int> held_rates() const;

  // The free ones among the joints, `preferred` first.
  void choose_coordinates(std::vector<int> preferred);
  std::unique_ptr<ReducedSystem> make_system(const std::vector<int>& held,
                                             const std::vector<int>& preferred);

  // The rates of all joints in the state, from those of the coordinates.
  std::optional<VecX> joint_rates(const Configuration& configuration,
                                  std::span<const double> speeds);

  // Steadily, those of stops not at all.
  double held_speed(std::size_t k) const;

  // With the coordinates that there are; `rates` are of all joints.
  void begin_at(double time, const VecX& rates);

  // With coordinates chosen anew.
  bool go_on_with(const VecX& rates);

  void restart();
  double first_step() const;
  std::vector<double> drives_at(double time, std::span<const double> y) const;
  std::vector<double> speeds_of(std::span<const double> y) const;

  bool place(double time, std::span<const double> y, Configuration& configuration);
  bool accelerate(double time,
                  const Configuration& configuration,
                  std::span<const double> y,
                  std::span<double> accelerations);
  bool slope(double time, std::span<const double> y, std::span<double> f);

  // All that is told of a state in the step, with what is borne where friction needs it. Empty
  // where there is none: `obstacle_`.
  std::optional<SimulationRow> row_at(double time, std::span<const double> y);
  std::optional<SimulationRow> singular_row_at(double time,
                                               std::span<const double> y,
                                               Configuration configuration);

  // Places by the size, speeds by the fastest so far, work by the largest energy so far or in the
  // step.
  void allow(std::span<const double> y,
             std::span<const double> f,
             double step,
             std::span<double> most);

  // Of a freedom in the step; `speed_along` where it was accelerated last.
  std::optional<double> position_at(int freedom, double time, std::span<const double> y);
  std::optional<double> speed_at(int freedom, double time, std::span<const double> y);
  double speed_along(int freedom) const;

  bool has_dry() const { return !dry_.empty(); }

  // The first, of which it has the kind.
  int freedom_of(std::size_t friction) const;
  std::optional<double> sliding_at(std::size_t friction, double time, std::span<const double> y);

  // By the speeds of the free coordinates in the state.
  void note_fastest();

  // So far and now [rad/s or sizes/s].
  double fastest() const;

  const Mechanism& mechanism_;
  const Topology& topology_;
  const MotionNetwork& network_;
  std::span<const DrawnCoupling> drawn_;
  const SimulationPlan& plan_;
  StateBalance balance_;
  bool needs_balance_ = false;
  std::vector<Rubbing> frictions_;
  std::vector<std::size_t> dry_;       // of these
  std::vector<int> one_sided_;         // actions that bodies bear in one direction only
  std::vector<FrictionSense> senses_;  // of all frictions
  std::vector<StuckGroup> groups_;
  std::vector<std::unique_ptr<ReducedSystem>> trials_;  // each with one group that is free
  std::vector<std::optional<double>> slid_;             // rates of freedoms
  std::optional<double> slid_at_;                       // then
  std::vector<int> held_;                               // rates
  std::vector<bool> rests_;                             // at each stop
  std::unique_ptr<ReducedSystem> system_;
  std::unique_ptr<InitialValueProblem> integration_;
  Configuration anchor_;  // where the step begins
  std::vector<double> held_begin_;
  double held_time_ = 0.0;
  double time_ = 0.0;
  std::vector<double> state_;  // free coordinates, their speeds, work supplied and lost
  double supplied_ = 0.0;
  double lost_ = 0.0;
  double fastest_ = 0.0;       // [rad/s or sizes/s]
  double energy_scale_ = 0.0;  // the largest so far, of all kinds [J]

  // Of each freedom, so far.
  struct Largest {
    std::vector<double> positions;
    std::vector<double> rates;
    std::vector<double> rate_rates;
  };

  Largest largest_;
  std::optional<double> step_;
  bool begins_anew_ = true;  // another state, or something else acts
  int starts_ = 0;           // of the integration
  int evaluations_ = 0;
  SimulationObstacle obstacle_;
};

}  // namespace kinestat
