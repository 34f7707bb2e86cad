// Straight-line arithmetic, worked out once and played for many states at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/tapes/internal/lane_operation.hpp"

namespace kinestat {

/// How many states a tape is played for at once, where not for one alone.
inline constexpr std::size_t kLanes = 8;

/// The operations of a LaneRecorder, without what the outputs and the demands do not need. A lane
/// is one state. All lanes take the same steps, each with the roundings that it would have alone:
/// its results do not depend on how many there are.
class LaneTape {
 public:
  /// Numbers that playing needs, one set a thread; with them it allocates nothing.
  class Workspace {
   public:
    std::size_t lanes() const { return lanes_; }

    void set(std::size_t cell, std::size_t lane, double value) {
      cells()[cell * lanes_ + lane] = value;
    }

    double number(std::size_t cell, std::size_t lane) const {
      return cells()[cell * lanes_ + lane];
    }

    /// Of all lanes.
    const double* numbers(std::size_t cell) const { return cells() + cell * lanes_; }

   private:
    friend class LaneTape;

    struct alignas(kLanes * sizeof(double)) Group {
      double numbers[kLanes] = {};
    };

    double* cells() { return groups_.data()->numbers; }

    const double* cells() const { return groups_.data()->numbers; }

    std::vector<Group> groups_;
    std::size_t lanes_ = kLanes;
    std::int64_t failures_[kLanes] = {};  ///< not 0 where a demand is not met
  };

  /// For one lane or kLanes.
  Workspace make_workspace(std::size_t lanes) const;

  std::size_t input_count() const { return reads_input_.size(); }

  /// Whether anything depends on it.
  bool reads_input(std::size_t input) const { return reads_input_[input]; }

  std::size_t operation_count() const { return operations_.size(); }

  void set_input(Workspace& workspace, std::size_t input, std::size_t lane, double value) const {
    workspace.set(input_cell(input), lane, value);
  }

  /// Where workspaces have an input and an output.
  std::size_t input_cell(std::size_t input) const { return constants_.size() + input; }

  std::size_t output_cell(std::size_t output) const {
    return static_cast<std::size_t>(outputs_[output]);
  }

  /// From the inputs, which stay as they are, to the outputs of every lane.
  void play(Workspace& workspace) const;

  /// Whether the lane meets all demands; its outputs count only then.
  bool is_met(const Workspace& workspace, std::size_t lane) const {
    return workspace.failures_[lane] == 0;
  }

  double output(const Workspace& workspace, std::size_t output, std::size_t lane) const {
    return workspace.number(output_cell(output), lane);
  }

 private:
  friend class LaneTapeMaker;

  std::vector<double> constants_;  ///< the first cells; the inputs follow
  std::vector<bool> reads_input_;
  std::size_t cell_count_ = 0;
  std::vector<LaneOperation> operations_;
  std::vector<LaneProduct> products_;
  std::vector<std::int32_t> outputs_;  ///< cells
};

}  // namespace kinestat
