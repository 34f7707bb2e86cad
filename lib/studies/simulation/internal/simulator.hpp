// A simulation on its way.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "math/dense/initial_value.hpp"
#include "studies/simulation/simulation.hpp"

namespace kinestat {

class Simulator {
 public:
  Simulator(const Mechanism& mechanism, const MotionNetwork& network, const SimulationPlan& plan);
  SimulationSolution run(const Configuration& start,
                         const std::vector<int>& coordinates,
                         const VecX& rates);

 private:
  std::size_t free_count() const { return system_->free_count(); }

  // What is shorter is no step.
  double least_step() const;

  // False where something happens again and again at one time, or the steps are too many; `told`
  // events were there before the step that began then.
  bool makes_progress(double before, std::size_t told);

  // Of places and speeds of a freedom: 1 rad, or the size of the mechanism [m].
  double unit(int freedom) const;
  double unit_of(std::size_t drive) const;
  std::vector<int> held_rates() const;

  // The free ones among the joints, `preferred` first.
  void choose_coordinates(const std::vector<int>& preferred);

  // The rates of all joints in the state, from those of the coordinates.
  std::optional<VecX> joint_rates(const Configuration& configuration,
                                  std::span<const double> speeds);

  // Steadily, those of stops not at all.
  double held_speed(std::size_t k) const;

  // With the coordinates that there are; `rates` are of all joints.
  void begin_at(double time, const VecX& rates);

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

  // Places by the size, speeds by the fastest so far; work follows from these.
  void allow(std::span<const double> y,
             std::span<const double> f,
             double step,
             std::span<double> most);

  void find_turns();
  double next_end() const;

  // One step, cut short by what happens in it.
  bool advance();

  // Or others, where these tell the motions apart much worse.
  bool keep_coordinates();

  // What may end a step: a goal, a stop that is struck, one that is left.
  struct Happening {
    SimulationEvent::Kind kind = SimulationEvent::Kind::goal;
    std::size_t index = 0;
    double time = 0.0;
  };

  // The position of a freedom in the step.
  std::optional<double> position_at(int freedom, double time, std::span<const double> y);
  std::optional<double> speed_at(int freedom, double time, std::span<const double> y);

  // Positive before it happens.
  std::optional<double> distance(const Happening& what, double time);
  std::optional<double> distance(const Happening& what, double time, std::span<const double> y);

  std::size_t held_place(std::size_t stop) const;
  std::vector<Happening> possible() const;

  std::optional<Happening> find_first();  // in the last step

  // The first time in it at which a curve over a position or a speed is at a point.
  std::optional<double> find_turn();

  // Between a place where it has not happened and one where it has.
  double root(const Happening& what, double low, double high);

  void note_signs();
  bool meet(const Happening& what);
  SimulationEvent& note(SimulationEvent::Kind kind, const NamedFreedom& of);
  bool go_on_with(const VecX& rates);

  // Newton's impact, and those that it makes of other stops that are touched. What rests is let go
  // before and rests again behind, if it does.
  bool strike(std::size_t index);

  double speed_along(int freedom) const;

  // What is pressed against its stop, and would leave it by less than the tolerance, rests there;
  // what leaves it takes its first steps within the flight.
  bool settle(const std::vector<bool>& touched);

  bool begin_contacts();
  bool add_rows(double until);
  bool add_row(double time, std::span<const double> y);
  SimulationSolution stuck();
  SimulationSolution finish();

  const Mechanism& mechanism_;
  const Topology& topology_;
  const MotionNetwork& network_;
  const SimulationPlan& plan_;
  std::vector<int> held_;      // rates
  std::vector<bool> rests_;    // at each stop
  std::vector<double> signs_;  // of each goal
  std::unique_ptr<ReducedSystem> system_;
  std::unique_ptr<InitialValueProblem> integration_;
  Configuration anchor_;  // where the step begins
  std::vector<double> held_begin_;
  double held_time_ = 0.0;
  std::vector<double> turns_;   // of curves over time
  std::optional<double> turn_;  // the next one of another curve, once it is seen
  double time_ = 0.0;
  std::vector<double> state_;  // free coordinates, their speeds, work supplied and lost
  double supplied_ = 0.0;
  double lost_ = 0.0;
  double fastest_ = 0.0;  // [rad/s or sizes/s]
  std::optional<double> step_;
  int next_row_ = 0;
  int standstill_ = 0;           // events at one time
  std::size_t told_before_ = 0;  // events before these
  SimulationObstacle obstacle_;
  SimulationSolution result_;
};

}  // namespace kinestat
