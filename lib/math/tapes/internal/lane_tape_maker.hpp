// From the notes of a recorder to a tape: what is needed, and cells that are used again.
#pragma once

#include <span>
#include <vector>

#include "math/tapes/lane_recorder.hpp"

namespace kinestat {

class LaneTapeMaker {
 public:
  explicit LaneTapeMaker(const LaneRecorder& recorder) : recorder_(recorder) {}

  LaneTape make(std::span<const TapeNumber> outputs);

 private:
  using Node = LaneRecorder::Node;

  template <class Visit>
  void visit_operands(const Node& node, const Visit& visit) const;

  void find_needed(std::span<const TapeNumber> outputs);
  void place_constants();
  int take_cell();
  void place_operation(int node);
  void release_operands(const Node& node, int after);

  const LaneRecorder& recorder_;
  std::vector<bool> is_needed_;  ///< of each node
  std::vector<int> last_use_;    ///< of each node: the last one that reads it
  std::vector<int> cells_;       ///< of each node
  std::vector<int> free_;        ///< cells
  LaneTape tape_;
};

}  // namespace kinestat
