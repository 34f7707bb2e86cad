// States of a sweep by a tape: the numbers alone, without a file, a name or a report, several
// states at a time.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "math/tapes/lane_tape.hpp"
#include "mechanism/bind/rebind.hpp"
#include "power/efficiency.hpp"
#include "studies/sweep/report/sweep_rows.hpp"
#include "studies/sweep/state_walk.hpp"
#include "studies/sweep/task/sweep_tapes.hpp"

namespace kinestat {

class StateBinder;
struct LaneMagnitudes;
struct SweepTask;

/// What stands in a row where a quantity has no value.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Each worker has its own. After it was made it allocates nothing, but for states that are bound
/// as a whole, combinations of `shift` that are no gears with the parameters of the file, and
/// reasons not to have an efficiency.
class TapeSolver {
 public:
  /// Both must outlive it. `lanes` is 1 or kLanes.
  TapeSolver(const SweepTask& task, const SweepTapes& tapes, std::size_t lanes);
  ~TapeSolver();

  /// How many states it may take at once: those that are alike, or one where screws or primaries
  /// are bound for each.
  std::uint64_t takes(const StateWalk& walk) const { return binds_states_ ? 1 : walk.alike() + 1; }

  /// Takes the state at which the walk stands, and as many that are alike as `count` says with it,
  /// into lanes from this one on.
  void load(const StateWalk& walk, std::size_t lane, std::size_t count = 1);

  /// Works out all lanes.
  void play() { tapes_.tape.play(workspace_); }

  /// Fills the rows of the states in so many lanes, from the first, lane by lane and case by case.
  void fill(std::size_t count, std::span<SweepRow> rows);

  /// After fill: false where the tape has no answer for the state; it must be analysed as a whole.
  bool has_answer(std::size_t lane) const { return has_answer_[lane] != 0; }

 private:
  // In SI; empty where there is none.
  struct TapedRatios {
    std::optional<double> ratio;
    std::optional<double> torque_ratio;
  };

  bool rebind(const StateWalk& walk);
  bool bind_whole(std::uint64_t state);
  void load_axes(const StateWalk& walk, std::size_t lane, std::size_t count);
  bool bind(const StateWalk& walk, std::size_t lane);
  bool load_other(const SweepInput& input,
                  std::size_t cell,
                  const StateWalk& walk,
                  std::size_t lane);
  bool decide_gears(std::size_t lane);
  void fill_columns(std::size_t i, std::span<SweepRow> rows);
  void demand_clear_ends(std::span<const std::size_t> inputs, std::span<const std::size_t> outputs);
  void keep_clear(const LaneMagnitudes& magnitudes);
  bool fill_cases(std::size_t lane, std::span<SweepRow> rows);
  bool fill_case(std::size_t i, std::size_t lane, SweepRow& row);
  bool is_possible(const CaseTape& taped, std::size_t lane) const;
  bool drives_output(const CaseTape& taped, std::size_t lane);
  bool sums_inputs(const CaseTape& taped, std::size_t lane);
  TapedRatios find_ratios(const CaseTape& taped, std::size_t lane);
  std::string_view status_of(const CaseTape& taped, const TapedRatios& ratios, std::size_t lane);
  bool fill_powers(std::size_t i, std::size_t lane, SweepRow& row);
  bool fill_efficiency(std::size_t i, std::size_t lane, SweepRow& row);
  double read_powers(std::span<const std::size_t> cells, std::size_t lane);
  Efficiency efficiency_of(std::size_t i, double largest) const;
  bool has_clearly_no_efficiency(std::size_t i, const Efficiency& found, double largest) const;
  void fill_ratios(const CaseTape& taped, const TapedRatios& ratios, SweepRow& row) const;
  std::span<const double> read(std::span<const std::size_t> outputs, std::size_t lane);

  const SweepTask& task_;
  const SweepTapes& tapes_;
  LaneTape::Workspace workspace_;
  std::optional<Rebinder> rebinder_;  ///< empty where states are bound as a whole, by:
  std::unique_ptr<StateBinder> binder_;
  Mechanism mechanism_;          ///< with what of a state is bound
  std::vector<char> is_loaded_;  ///< of each lane
  std::vector<char> has_answer_;
  std::vector<char> has_plain_ratios_;  ///< of each lane and case: those of the tape count

  // An input that the tape reads.
  struct Load {
    std::size_t input = 0;
    std::size_t cell = 0;
  };

  // One that is varied.
  struct AxisLoad {
    std::size_t axis = 0;
    std::size_t cell = 0;
  };

  std::vector<AxisLoad> axes_;
  std::vector<Load> others_;        ///< what may have no value
  bool binds_states_ = false;       ///< more of a state is needed than its place on the axes
  bool asks_nothing_else_ = false;  ///< than columns of the tape, in all cases
  bool has_combinations_ = false;   ///< that are no gears with the parameters of the file
  std::vector<std::size_t> ratio_columns_;
  std::vector<std::size_t> torque_ratio_columns_;
  std::vector<std::size_t> efficiency_columns_;
  std::vector<std::size_t> recirculation_columns_;
  bool asks_steps_ = false;
  std::vector<std::string_view> statuses_;     ///< of each lane and case: of such a combination
  std::vector<std::optional<double>> ratios_;  ///< of each case that is a gear [SI]
  std::vector<Quantity> scratch_;
  std::vector<double> rates_;   ///< what was read last
  std::vector<double> powers_;  ///< of all actuators, likewise
  std::vector<double> no_loads_;
};

}  // namespace kinestat
