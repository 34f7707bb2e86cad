// A case solved once with all its losses, for points in which everything moves in the same sense.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cases/analysis.hpp"
#include "mechanism/gears/mesh.hpp"
#include "statics/lossy_system.hpp"
#include "studies/duty/case_motions.hpp"
#include "studies/duty/duty_state.hpp"

namespace kinestat {

/// Whether points of a mechanism need no analysis each: no contacts, cables or redundant actions
/// whose answer depends on more than senses, and no springs, whose loads an analysis adds.
bool has_plain_statics(const Mechanism& mechanism);

/// The state of an analysed case; empty where it has none. `meshes` are those of the mechanism.
std::optional<DutyState> state_of(const Mechanism& mechanism,
                                  const CaseAnalysis& one,
                                  std::span<const Mesh> meshes);

struct DutyFrictionSense;

/// A friction of a coupling at a point, as LossySystem takes it.
struct FrictionPoint {
  double speed = 0.0;
  double constant = 0.0;
};

/// Of a mechanism with plain statics. Everything given must outlive it.
class DutyCase {
 public:
  /// `which` with the magnitudes of a point.
  DutyCase(const Mechanism& drawn,
           Case which,
           const CaseMotions& motions,
           std::span<const Mesh> meshes);
  DutyCase(const DutyCase&) = delete;
  DutyCase& operator=(const DutyCase&) = delete;
  ~DutyCase();

  /// False where equilibrium leaves something open, or the point has no answer.
  bool is_prepared() const { return prepared_ != nullptr; }

  /// As every command solves it.
  const CaseAnalysis& analysis() const { return analysis_; }

  /// Whether everything moves there as in the point it was made for.
  bool moves_alike(std::span<const double> known) const;

  /// Whether teeth press there with the flanks of that point.
  bool presses_alike(std::span<const double> motions, std::span<const double> actions);

  /// Where it moves alike; empty where there is no answer.
  std::optional<DutyState> state_at(std::span<const double> motions,
                                    std::span<const double> actions);

 private:
  struct Prepared;

  std::optional<double> couple_of(const ConverterLaw& law,
                                  const DutyFrictionSense& friction,
                                  std::span<const double> known) const;
  std::vector<std::optional<FrictionPoint>> friction_points(std::span<const double> known) const;

  Mechanism mechanism_;  ///< with the flanks on which the teeth press
  Case which_;
  CaseAnalysis analysis_;
  const CaseMotions& motions_;
  std::span<const Mesh> meshes_;
  std::unique_ptr<Prepared> prepared_;  ///< none where the point has no answer
};

}  // namespace kinestat
