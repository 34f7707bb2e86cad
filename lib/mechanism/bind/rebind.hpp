// The numbers of a mechanism for other values of its parameters, over the same topology.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "couplings/coupling_geometry.hpp"
#include "description/mechanism_description.hpp"
#include "expression/expression_tape.hpp"
#include "expression/slots.hpp"
#include "mechanism/bind/gear_places.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Coordinates of a screw on a tape, in the order of Twist or Wrench.
using TapedScrew = std::array<TapeNumber, 6>;

/// Unit screws on a tape, parallel to those of the Geometry.
struct TapedScrews {
  std::vector<TapedScrew> motions;
  std::vector<TapedScrew> actions;
};

/// The values of a case's primaries on a tape, parallel to those of the Case; empty where a value
/// is more than a tape can do.
struct TapedPrimaries {
  std::vector<std::optional<TapeNumber>> motions;
  std::vector<std::optional<TapeNumber>> actions;
};

/// How a tape sees that the screws may stay about the world origin.
enum class NearOrigin {
  by_fixed_points,  ///< those that do not move are far enough apart for all that do: cheap, but a
                    ///< lane in which a point goes too far has no answer
  by_all_points
};

/// Evaluates again only what depends on the parameters that vary, with the same functions as bind
/// and hence the same bits. It knows mechanisms of which they move the couplings and the primaries
/// and nothing else, near the origin of the world; others are bound whole. One a thread.
class Rebinder {
 public:
  /// `mechanism` must be what bind made of the description, which must outlive it; `varies` is of
  /// each parameter, those that follow from others among them. Empty where more moves than it
  /// knows: cables, angles and distances of gears, losses, friction, loads, and screws that are
  /// given directly.
  static std::optional<Rebinder> make(const MechanismDescription& description,
                                      const Mechanism& mechanism,
                                      const std::vector<bool>& varies);

  /// Of each coupling: whether its numbers may change.
  const std::vector<bool>& moves() const { return moves_; }

  /// Of each coupling: whether the directions of its screws may change, too.
  const std::vector<bool>& turns() const { return turns_; }

  /// Unit motions and unit actions, other flanks too, for these parameters. The points, the size
  /// and the references stay those of the mechanism. False where the mechanism must be bound whole:
  /// a number has no value, or it stands too far from the origin of the world.
  bool rebind_geometry(const Slots& slots, Geometry& geometry);

  /// The primaries of the cases, which must be in the order of the description.
  bool rebind_cases(const Slots& slots, std::span<Case> cases);

  /// What rebind_geometry does, on a tape, for quantities at the slots of parameters: the same
  /// bits, and no answer for a lane where it has none. Empty where more moves than points of lines,
  /// by formulas that a tape can do, or the fixed points do not suffice. `geometry` is that of the
  /// mechanism.
  std::optional<TapedScrews> record_screws(NearOrigin near,
                                           const Geometry& geometry,
                                           std::span<const std::optional<TapeQuantity>> slots,
                                           LaneRecorder& recorder) const;

  /// What rebind_cases does, for the case of that index.
  TapedPrimaries record_primaries(std::size_t index,
                                  const Case& which,
                                  std::span<const std::optional<TapeQuantity>> slots,
                                  LaneRecorder& recorder) const;

 private:
  // A number that stands for itself, or its formula.
  struct Number {
    std::optional<SlotExpression> formula;
    double constant = 0.0;
  };

  struct MovingCoupling {
    int coupling = 0;
    CouplingGeometry drawn;            ///< what does not vary is right in it
    std::array<Number, 3> at;          ///< [m]
    std::vector<int> constraints;      ///< of each action: its constraint in the catalogue, or -1
    bool is_in_space = false;          ///< its actions, though the mechanism is planar
    bool is_bound_whole = false;       ///< more of it varies than the point
    bool is_in_gears = false;          ///< its place follows from teeth and modules:
    std::optional<int> gear_axis;      ///< on which it stands; otherwise it is a mesh
    int flank = -1;                    ///< of geometry.other_flanks
    Vec3 tangent = Vec3::Zero();       ///< of a mesh, as bound last
    bool has_turned = false;           ///< its teeth, from where they were drawn
    bool is_through_point = false;     ///< all its lines are; nothing else varies
    std::optional<std::size_t> point;  ///< of all points, if the file gives it
  };

  struct MovingPrimary {
    std::size_t which = 0;
    bool is_motion = false;
    std::size_t primary = 0;
    QuantityKind kind = QuantityKind::angular_velocity;
    SlotExpression value;
  };

  Rebinder(const MechanismDescription& description, const Mechanism& mechanism)
      : description_(&description), topology_(&mechanism.topology) {}

  bool add_couplings(const Mechanism& mechanism, const std::vector<bool>& varies);
  bool add_coupling(std::size_t e, const Mechanism& mechanism, const std::vector<bool>& varies);
  void add_numbers(const CouplingDescription& coupling,
                   const std::vector<bool>& varies,
                   MovingCoupling& moving) const;
  void add_constraints(const CouplingDescription& coupling, MovingCoupling& moving) const;
  void add_primaries(const Mechanism& mechanism, const std::vector<bool>& varies);
  bool bind_whole(const Slots& slots, MovingCoupling& moving);
  bool place(const Slots& slots, MovingCoupling& moving);
  bool place_in_gears(MovingCoupling& moving);
  const GearFrame* frame() const;
  std::optional<int> gear_axis_of(const CouplingDescription& coupling) const;
  void write_screws(const MovingCoupling& moving, Geometry& geometry) const;
  void write_flank(const MovingCoupling& moving, Geometry& geometry) const;
  void move_lines(const MovingCoupling& moving, Geometry& geometry) const;
  bool record_points(std::span<const std::optional<TapeQuantity>> slots,
                     std::vector<std::array<TapeNumber, 3>>& points,
                     LaneRecorder& recorder) const;

  const MechanismDescription* description_;
  const Topology* topology_;
  Space action_space_ = Space::spatial;
  ParameterTable table_;  ///< for couplings that are bound whole
  std::optional<GearPlaces> gears_;
  int flanks_ = 0;  ///< so many couplings so far have others
  std::vector<bool> moves_;
  std::vector<bool> turns_;
  std::vector<MovingCoupling> moving_;
  std::vector<MovingPrimary> primaries_;
  std::vector<Vec3> points_;  ///< all that bound the mechanism [m]
  std::vector<Quantity> scratch_;
};

}  // namespace kinestat
