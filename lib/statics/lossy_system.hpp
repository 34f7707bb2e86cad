// A mechanism whose meshes and couplings lose power, for many magnitudes of what acts.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "statics/lossy_actions.hpp"

namespace kinestat {

class FrictionSystem;

/// The actions of one state.
struct LossyMagnitudes {
  LossSearch search = LossSearch::found;
  VecX actions;                      ///< of each action
  std::vector<double> frictions;     ///< of each friction of couplings [N·m or N]
  std::vector<double> losses;        ///< of each mesh: the couple on its driven gear [N·m]
  std::vector<bool> head_is_driven;  ///< of each mesh
};

/// Equilibrium is factored once. What acts may have other magnitudes then, and what moves other
/// speeds, as long as everything moves in the sense that the laws were made for. The mechanism and
/// what `given` lists but for the laws must outlive it.
class LossySystem {
 public:
  /// `frictionless` is the solution without any loss, which must have actions.
  LossySystem(const Mechanism& mechanism,
              const CoordinateBasis& basis,
              const LossyStatics& given,
              const StaticSolution& frictionless);
  LossySystem(LossySystem&&) noexcept;
  LossySystem& operator=(LossySystem&&) noexcept;
  ~LossySystem();

  /// The magnitudes of the known actions, in the order of the primaries.
  void set_primaries(std::span<const double> values);

  /// Of a friction of couplings: its speed [rad/s or m/s], and what it has without load.
  void set_friction(std::size_t friction, double speed, double constant);

  /// The speeds of the gears of a mesh in its carrier [rad/s].
  void set_mesh_speeds(std::size_t mesh, double head, double tail);

  /// Whether all frictions and losses depend on actions that equilibrium determines.
  bool is_determined() const;

  /// See solve_with_losses; losses that depend on the force of their teeth are followed until that
  /// stands still. Empty where the search finds no senses that agree with their actions.
  std::optional<LossyMagnitudes> solve(const std::function<bool(const VecX&)>& is_accepted);

  /// Likewise, with all that a report says.
  LossyActions solve_whole(const std::function<bool(const VecX&)>& is_accepted);

 private:
  /// What tells the share of a mesh.
  struct MeshShare {
    const LossyMesh* lossy = nullptr;
    double radius = 0.0;
    int planets = 1;
  };

  bool has_shares_by_law() const;
  std::optional<double> take_shares(const VecX& actions);
  template <class Search>
  LossSearch settle(std::optional<Search>& search,
                    const std::function<bool(const VecX&)>& is_accepted);

  std::size_t friction_count_ = 0;
  std::size_t mesh_count_ = 0;
  std::vector<FrictionLaw> laws_;  ///< those of couplings, then two of each mesh
  std::vector<MeshShare> shares_;  ///< of each mesh
  std::unique_ptr<FrictionSystem> system_;
};

}  // namespace kinestat
