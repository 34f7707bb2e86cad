#include "studies/sweep/report/sweep_status.hpp"

#include <algorithm>
#include <vector>

#include "cases/case_status.hpp"
#include "core/codes.hpp"
#include "core/contract.hpp"
#include "core/solve_status.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/shift/shift_state.hpp"

namespace kinestat {

namespace {

class StatusList {
 public:
  StatusList() {
    add_from(SolveStatus::solved);
    add_from(ShiftClass::neutral);  // a gear is solved as a case
    for (const std::string_view word : kCaseStatuses) {
      add(word);
    }
    for (const std::string_view word : {kLocked, kSingular, kNoRatio, kNoEfficiency, kNoNumber}) {
      add(word);
    }
    add_from(MotionEnd::limited);  // what is complete is solved
    // Figures of a motion pass its dead points.
    for (const std::string_view word : {kSingularEvent, kLimitEvent}) {
      add(word);
    }
    for (const Code& one : all_codes()) {
      add(one.code);
    }
  }

  const std::vector<std::string_view>& words() const { return words_; }

 private:
  // To the last: what is no enumerator has no word.
  template <class Enum>
  void add_from(Enum first) {
    for (int i = static_cast<int>(first); !word_of(static_cast<Enum>(i)).empty(); ++i) {
      add(word_of(static_cast<Enum>(i)));
    }
  }

  void add(std::string_view word) {
    if (std::ranges::find(words_, word) == words_.end()) {
      words_.push_back(word);
    }
  }

  std::vector<std::string_view> words_;
};

}  // namespace

std::span<const std::string_view> sweep_statuses() {
  static const StatusList list;
  return list.words();
}

std::size_t status_number(std::string_view word) {
  const std::span<const std::string_view> words = sweep_statuses();
  const auto at = std::ranges::find(words, word);
  KINESTAT_EXPECTS(at != words.end());
  return static_cast<std::size_t>(at - words.begin());
}

}  // namespace kinestat
