// The slip of a torque converter at points of a case that leaves it open.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cases/analysis.hpp"
#include "mechanism/couplings/speed_ratio_scan.hpp"
#include "studies/duty/case_motions.hpp"

namespace kinestat {

/// What a point says of the slip.
struct SlipAnswer {
  bool is_sure = false;        ///< else only an analysis of the point tells
  std::optional<double> rate;  ///< empty: none, or several; as the last motion of the closed case
};

/// The action that decides the slip is linear in the other actions and in the couples of frictions
/// that nothing presses, which follow from speeds that are linear in the motions: each is solved
/// once. Any other point, and one in which rounding may decide, is none of its business.
class SlipFinder {
 public:
  /// `closed` is the case with the slip as its last motion, as `search` made it of one point, and
  /// `motions` are its velocities. All must outlive it.
  SlipFinder(const Mechanism& mechanism,
             const Case& closed,
             const ConverterSearch& search,
             const CaseMotions& motions);

  /// Whether it can answer for any point.
  bool is_able() const { return is_able_; }

  /// For the motions but the slip, the actions but the one that decides, and that one.
  SlipAnswer find(std::span<const double> motions,
                  std::span<const double> actions,
                  double deciding);

 private:
  /// A friction, and what the deciding action has of a couple on its head along its freedom.
  struct Couple {
    const CouplingFriction* friction = nullptr;
    int freedom = 0;
    Vec3 axis = Vec3::Zero();
    double share = 0.0;
    bool follows_ratio = false;                        ///< of the converter that is searched
    std::vector<std::optional<double>> at_nodes = {};  ///< then: for a pump that turns at 1 rad/s
  };

  /// A drag, or what the deciding action misses.
  struct Sum {
    double value = 0.0;
    double size = 0.0;   ///< of all that it is made of
    double slack = 0.0;  ///< by how much it changes with senses that only rounding decides

    /// Whether rounding may decide on its sign.
    bool is_doubtful() const;
  };

  std::optional<double> share_of(const Case& closed, std::span<const BodyWrench> loads) const;
  bool add_couple(const CouplingFriction& friction, Case& nothing);
  void add_nodes(Couple& couple) const;
  std::optional<double> slip_at(double ratio) const;
  std::optional<Sum> miss_at(double ratio, std::optional<std::size_t> node);
  std::optional<Sum> flow_of(const Couple& couple,
                             double ratio,
                             std::optional<std::size_t> node,
                             double pump) const;
  std::optional<Sum> drag_of(const Couple& couple);

  const Mechanism& mechanism_;
  const CaseMotions& motions_;
  const ConverterLaw& law_;
  SpeedRatioScan scan_;
  int deciding_ = 0;  ///< index into Topology::actions
  Vec3 axis_;         ///< of the converter
  bool is_able_ = false;
  double of_loads_ = 0.0;
  std::vector<double> of_actions_;  ///< for a magnitude of 1 of each other action
  double slope_ = 0.0;              ///< of the speed of the pump, per unit of slip
  std::vector<Couple> couples_;

  // Of the point that is asked for.
  std::vector<Primary> known_;  ///< motions of the closed case
  std::vector<double> values_;  ///< their magnitudes
  double largest_ = 0.0;        ///< of them, but the slip
  double first_ = 0.0;          ///< speed of the pump without slip
  Sum rest_;                    ///< what does not hang on the slip
  bool is_doubtful_ = false;
};

}  // namespace kinestat
