// A mechanism whose meshes and couplings lose power, solved for many loads and speeds.
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
  VecX actions;                      ///< of each action [N·m or N]
  std::vector<double> frictions;     ///< of each friction of couplings [N·m or N]
  std::vector<double> losses;        ///< of each mesh: the couple on its driven gear [N·m]
  std::vector<bool> head_is_driven;  ///< of each mesh
};

/// The equilibrium with losses, factored once. Primaries may then be given other magnitudes, and
/// couplings and gears other speeds, as long as all motions keep the sense for which the laws were
/// made. The mechanism and the lists of `given`, except the laws, must outlive it.
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

  /// Sets the magnitudes of the known actions, in the order of the primaries [N·m or N].
  void set_primaries(std::span<const double> values);

  /// Sets the speed [rad/s or m/s] of the friction of a coupling, and its magnitude without load
  /// [N·m or N].
  void set_friction(std::size_t friction, double speed, double constant);

  /// Sets the speeds of the gears of a mesh relative to its carrier [rad/s].
  void set_mesh_speeds(std::size_t mesh, double head, double tail);

  /// Whether all frictions and losses depend on actions that equilibrium determines.
  bool is_determined() const;

  /// Solves as solve_with_losses does. Losses that depend on the tooth force are iterated until
  /// this force no longer changes. Empty if no senses agree with the actions they cause.
  std::optional<LossyMagnitudes> solve(const std::function<bool(const VecX&)>& is_accepted);

  /// The same with everything that a report says.
  LossyActions solve_whole(const std::function<bool(const VecX&)>& is_accepted);

 private:
  /// The numbers on which the loss of a mesh depends.
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
