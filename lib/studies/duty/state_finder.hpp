// The states of one case at points of a duty.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mechanism/duty/duty_point.hpp"
#include "studies/duty/duty_case.hpp"
#include "studies/duty/slip_finder.hpp"

namespace kinestat {

/// Called with each whole analysis that answers for a point.
using OnAnalysis = std::function<void(const CaseAnalysis&)>;

/// A case whose motions determine all others, whatever the senses in which it moves.
class ClosedCase {
 public:
  /// All must outlive it.
  ClosedCase(const Mechanism& mechanism,
             Case which,
             std::span<const Mesh> meshes,
             OnAnalysis on_analysis);
  ClosedCase(const ClosedCase&) = delete;
  ClosedCase& operator=(const ClosedCase&) = delete;

  const Case& which() const { return which_; }

  const CaseMotions& motions() const { return motions_; }

  /// Whether points may be solved together.
  bool is_plain() const { return is_plain_; }

  /// For magnitudes of its motions and actions; empty where there is no answer: `take_analysis`
  /// shows why.
  std::optional<DutyState> find(std::span<const double> motions, std::span<const double> actions);

  CaseAnalysis take_analysis() { return std::move(last_); }

 private:
  bool has_right_freewheels(const DutyState& state) const;
  std::optional<DutyState> find_anew(Case there,
                                     std::span<const double> motions,
                                     std::span<const double> actions);

  const Mechanism& mechanism_;
  Case which_;
  std::span<const Mesh> meshes_;
  OnAnalysis on_analysis_;
  CaseMotions motions_;
  bool is_plain_ = false;
  std::vector<std::unique_ptr<DutyCase>> known_;  // the last used first
  CaseAnalysis last_;
};

/// Any case, also one that leaves a motion to a torque converter.
class StateFinder {
 public:
  /// All must outlive it.
  StateFinder(const Mechanism& mechanism,
              std::size_t which,
              std::span<const Mesh> meshes,
              const OnAnalysis& on_analysis);

  /// Empty where there is no answer.
  std::optional<DutyState> find(const DutyPoint& point);

  /// Of the first point without an answer.
  CaseAnalysis take_unanswered() { return std::move(unanswered_); }

 private:
  /// The case with its slip as a known motion instead of the action that decides it.
  struct ByConverter {
    std::size_t deciding = 0;  ///< index into the actions of the open case
    std::unique_ptr<ClosedCase> closed;
    std::unique_ptr<SlipFinder> slips = {};
  };

  std::optional<DutyState> find_open(const DutyPoint& point);
  std::optional<DutyState> analyse(const DutyPoint& point);
  void add_converter(const ConverterSearch& search);

  const Mechanism& mechanism_;
  std::span<const Mesh> meshes_;
  OnAnalysis on_analysis_;
  ClosedCase drawn_;
  std::optional<ByConverter> by_converter_;  ///< empty where its points are analysed each
  bool has_tried_converter_ = false;
  bool has_unanswered_ = false;
  CaseAnalysis unanswered_;
};

}  // namespace kinestat
