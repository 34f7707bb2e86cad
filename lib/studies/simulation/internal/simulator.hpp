// A simulation on its way.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "studies/simulation/internal/extreme_watch.hpp"
#include "studies/simulation/internal/happening.hpp"
#include "studies/simulation/internal/state_in_time.hpp"
#include "studies/simulation/simulation.hpp"

namespace kinestat {

class Simulator : private StateInTime {
 public:
  Simulator(const Mechanism& mechanism,
            const MotionNetwork& network,
            std::span<const DrawnCoupling> drawn,
            const SimulationPlan& plan);
  SimulationSolution run(const Configuration& start,
                         const std::vector<int>& coordinates,
                         const VecX& rates);

 private:
  // What is shorter is no step.
  double least_step() const;

  // False where things happen again and again at one time, or steps are too many; `told`: events
  // before the step that began then.
  bool makes_progress(double before, std::size_t told);
  void find_turns();
  double next_turn() const;  // no step goes over it
  double next_end() const;

  // One step, cut short by what happens in it.
  bool advance();

  // Or others, where these tell the motions apart much worse.
  bool keep_coordinates();

  // Positive before it happens.
  std::optional<double> distance(const Happening& what, double time);
  std::optional<double> distance(const Happening& what, double time, std::span<const double> y);
  // Whether it does not slide although nothing holds it: at a dead point, or by other means.
  bool rests(std::size_t friction) const;

  // What moves a friction, by unit speeds of the free coordinates in radians and sizes.
  VecX direction_in_sizes(std::size_t friction) const;
  VecX direction_at_rest(std::size_t friction) const;
  std::vector<VecX> directions_of(const std::vector<StuckGroup>& groups) const;
  bool is_joint(std::size_t friction) const;      // of the tree, so that it can be held
  double no_sliding(std::size_t friction) const;  // what counts as none

  void read_senses();  // which frictions slide, by the speeds there are
  // What slides on, sticks and gives way where speeds are zero: of all ways the one that fits, with
  // most that sticks. `given` gives way. False where none does, or several.
  bool decide_friction(const std::optional<Happening>& given);
  std::vector<StuckGroup> groups_at_rest() const;
  std::optional<SimulationObstacle> obstacle_of(const std::vector<StuckGroup>& groups) const;
  std::optional<std::vector<int>> find_pattern(const std::vector<StuckGroup>& groups,
                                               const VecX& rates,
                                               std::optional<std::size_t> forced,
                                               int sense);
  bool is_consistent(const std::vector<StuckGroup>& groups,
                     const std::vector<int>& pattern,
                     const VecX& rates,
                     std::optional<std::size_t> given);
  bool stick_together(const std::vector<StuckGroup>& groups,
                      const VecX& rates,
                      std::optional<std::size_t> gives_way);
  void tell_changes(const std::vector<StuckGroup>& before);
  void take(const std::vector<StuckGroup>& groups, const std::vector<int>& pattern);

  // The acceleration by which a stuck group would give way in that sense; empty where it jams.
  std::optional<double> breakaway(std::size_t group,
                                  int sense,
                                  double time,
                                  const Configuration& configuration,
                                  std::span<const double> y);

  std::size_t held_place(std::size_t stop) const;
  // Whether what is held keeps it where it is, at the state that was accelerated last.
  bool is_kept(int freedom) const;
  std::vector<Happening> possible() const;

  // What ends the simulation because a cable or a contact does not hold, and how far it is from
  // that, in a state or by the actions that are borne.
  std::vector<Happening> possible_partings() const;
  std::optional<double> distance_to_parting(const Happening& what,
                                            double time,
                                            std::span<const double> y);
  std::optional<double> margin(const Happening& what,
                               const std::vector<std::optional<double>>& borne) const;
  const std::vector<std::optional<double>>& borne_at(double time, std::span<const double> y);

  // Where the state, or what acts, has just changed. False where it cannot be told.
  bool look_at_once();
  bool parts_by(std::size_t stop, const ReducedSystem::Impulse& impulse, double change);
  void end_by(const Happening& what);

  std::optional<Happening> find_first();  // in the last step
  // The first time in it at which a curve is at a point, or a one-sided spring turns.
  std::optional<double> find_turn();
  using SpringValue = double (ReducedSystem::*)(std::size_t) const;
  std::optional<double> spring_turn(std::size_t spring, SpringValue of, double from, double to);

  int parts_of(double from, double to);  // in which a step is looked at
  double root(const Happening& what, double low, double high);

  void note_signs();
  bool meet(const Happening& what);
  SimulationEvent& note(SimulationEvent::Kind kind, const NamedFreedom& of);
  void note_impact(const SimulationStop& stop, double before);
  // Newton's impact, and those that it makes of other stops that are touched. What rests is let go
  // before and rests again behind, if it does.
  bool strike(std::size_t index);

  // What leaves its stop by less than the tolerance rests, `rested` maybe before; else it flies.
  bool settle(const std::vector<bool>& touched, const std::vector<bool>& rested);

  bool choose_rests(const std::vector<bool>& candidates, const VecX& rates);
  bool bears(const std::vector<std::size_t>& touched, const VecX& rates);

  bool begin_contacts();
  bool add_rows(double until);
  bool add_row(double time, std::span<const double> y);
  void look_between_rows(double end);
  void note_energies(const SimulationRow& row);
  void state_in_step(double time, std::vector<double>& y) const;
  void note_borne(const std::vector<std::optional<double>>& borne);
  SimulationSolution stuck();
  SimulationSolution finish();
  ExtremeWatch watch_;
  std::vector<double> signs_;                 // of each goal
  std::vector<StuckGroup> stuck_before_;      // the impact that let them go
  std::vector<double> turns_;                 // of curves over time
  std::optional<double> turn_;                // the next one of another curve, once it is seen
  std::vector<std::optional<double>> borne_;  // all actions
  std::optional<double> borne_at_;            // then
  std::vector<double> arcs_;                  // of cables on pulleys, there
  std::vector<std::size_t> one_sided_springs_;
  int parts_left_ = 50'000;  // for steps in which much turns
  int next_row_ = 0;
  int standstill_ = 0;           // events at one time
  std::size_t told_before_ = 0;  // events before these
  SimulationSolution result_;
};

}  // namespace kinestat
