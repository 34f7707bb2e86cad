// What a duty asks of a mechanism: energies, and the wear of gears and bearings.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/analysis.hpp"
#include "mechanism/duty/duty_plan.hpp"

namespace kinestat {

/// Energies of a while [J]. What actuators and loads give is what they take and what is lost.
struct DutyEnergy {
  double duration = 0.0;           ///< [s]
  double given = 0.0;              ///< by whatever drives
  double taken = 0.0;              ///< by whatever is driven
  double lost = 0.0;               ///< in teeth, bearings, dampers, and elements that slip or drag
  std::string no_efficiency = {};  ///< why it is none, where masses or springs store energy

  /// Taken by given; empty where nothing is given, or part of what is taken is stored.
  std::optional<double> efficiency() const;
};

enum class DutyStatus {
  solved,
  at_rest,     ///< nothing moves, so that no energy flows; what acts is not looked at
  both_ends,   ///< solved: losses take more than the inputs give, and the outputs drive too
  unanswered,  ///< as the case of the point is where it is analysed
};

struct DutyPointState {
  DutyStatus status = DutyStatus::solved;
  DutyEnergy energy;
  double balance_residual = 0.0;     ///< |given - taken - lost| relative to the largest power
  std::string_view impossible = {};  ///< why the mechanism cannot have the answer, by
                                     ///< `impossible_status`; otherwise empty
};

/// How a gear or bearing is used. `equivalent` is the constant load that, in as many revolutions,
/// wears as much by Miner's rule, (Σ n F^p / Σ n)^(1/p); empty without an exponent p, or where
/// nothing turns. Both it and `revolutions` are empty where some speed is not determined; it and
/// `largest` where equilibrium leaves some load open.
struct DutyWear {
  std::optional<double> revolutions;
  std::optional<double> largest;
  std::optional<double> equivalent;
};

/// Teeth of one gear in one mesh. Of several equal planets, of the most loaded one.
struct GearDuty {
  CouplingId mesh;
  BodyId gear;
  int planets = 1;
  DutyWear wear;  ///< torque [N·m] and revolutions in the carrier
};

/// A bearing about which bodies turn; of several equal planets, that of the most loaded one.
struct BearingDuty {
  CouplingId bearing;
  int planets = 1;
  DutyWear wear;  ///< force across the axis and along it together [N]
};

/// A clutch or brake.
struct ElementDuty {
  int actuator = 0;
  double engaged = 0.0;  ///< [s]
  double largest = 0.0;  ///< torque [N·m]
  double lost = 0.0;     ///< where it slips under a torque that is known [J]; its drag is friction
};

struct CouplingLoss {
  CouplingId coupling;
  double energy = 0.0;  ///< [J]
};

struct DamperLoss {
  std::size_t spring = 0;  ///< index into mechanism.springs
  double energy = 0.0;     ///< [J]
};

struct DutyCaseEnergy {
  std::size_t which = 0;  ///< index into Mechanism::cases
  DutyEnergy energy;
};

/// A case of which points have no answer, with an analysis that shows why.
struct UnansweredCase {
  std::size_t which = 0;
  std::size_t first = 0;  ///< index of the first point
  int count = 0;
  CaseAnalysis analysis;
};

/// Of all repetitions, but for `points`, which are of one.
struct DutySolution {
  std::vector<DutyPointState> points;
  DutyEnergy whole;
  std::vector<DutyCaseEnergy> cases;    ///< those of the points, in the order of the mechanism
  std::vector<CouplingLoss> meshes;     ///< as mechanism.lossy_meshes
  std::vector<CouplingLoss> frictions;  ///< as mechanism.frictions, a torque converter as one
  std::vector<DamperLoss> dampers;      ///< of the springs with damping
  std::vector<GearDuty> gears;
  std::vector<BearingDuty> bearings;
  std::vector<ElementDuty> elements;
  std::vector<UnansweredCase> unanswered;
  double at_rest = 0.0;           ///< [s]
  double both_ends = 0.0;         ///< [s]
  double balance_residual = 0.0;  ///< the largest of all points
};

/// Called with each whole analysis that answers for a point of the plan; many points are solved
/// without one, all of whose motions have the senses of an analysis before.
using OnPointAnalysis = std::function<void(std::size_t point, const CaseAnalysis&)>;

DutySolution solve_duty(const Mechanism& mechanism,
                        const DutyPlan& plan,
                        const OnPointAnalysis& on_analysis = {});

}  // namespace kinestat
