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

/// The coordinates of a screw on a tape, in the order of Twist or Wrench.
using TapedScrew = std::array<TapeNumber, 6>;

/// Unit screws on a tape, parallel to those of the Geometry.
struct TapedScrews {
  std::vector<TapedScrew> motions;
  std::vector<TapedScrew> actions;
  std::vector<TapedScrew> flanks;  ///< the other ones
};

/// The values of the primaries of a case on a tape, parallel to the lists of the Case. A value that
/// a tape cannot compute is empty.
struct TapedPrimaries {
  std::vector<std::optional<TapeNumber>> motions;
  std::vector<std::optional<TapeNumber>> actions;
};

/// How a tape checks that the world origin is near enough, in units of the mechanism, for screws.
enum class NearOrigin {
  by_fixed_points,  ///< that do not move: cheap, but a lane whose points go far has no answer
  by_all_points     ///< with the size of all points
};

/// Binds a mechanism again for other values of its parameters. It evaluates only what depends on
/// those that vary, with the functions of bind and hence the same bits. It can if only couplings
/// and primaries depend on them, near the origin of the world. Each thread needs its own.
class Rebinder {
 public:
  /// `mechanism` must be what bind made of the description, which must outlive the result. `varies`
  /// is of each parameter, those that depend on others included. Empty if anything else varies:
  /// cables, angles and distances of gears, losses, friction, loads, or screws given directly.
  static std::optional<Rebinder> make(const MechanismDescription& description,
                                      const Mechanism& mechanism,
                                      const std::vector<bool>& varies);

  /// For each coupling: whether its numbers may change, and whether directions of its screws may.
  const std::vector<bool>& moves() const { return moves_; }

  const std::vector<bool>& turns() const { return turns_; }

  /// Sets the unit motions, the unit actions and the other flanks to these parameters. The points,
  /// the size and the references remain those of the mechanism. False if a number has no value, or
  /// if the mechanism is too far from the origin of the world.
  bool rebind_geometry(const Slots& slots, Geometry& geometry);

  /// Sets the primaries of the cases, in the order of the description.
  bool rebind_cases(const Slots& slots, std::span<Case> cases);

  /// Records on a tape what rebind_geometry does; `slots` are the parameters on the tape. The bits
  /// are the same, and a lane for which rebind_geometry is false has no answer. Empty if more
  /// varies than the points of lines, a tape cannot do a formula, or the fixed points do not
  /// suffice. `geometry` is the mechanism's.
  std::optional<TapedScrews> record_screws(NearOrigin near,
                                           const Geometry& geometry,
                                           std::span<const std::optional<TapeQuantity>> slots,
                                           LaneRecorder& recorder) const;

  /// Records on a tape what rebind_cases does for the case of this index.
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
    CouplingGeometry drawn;         ///< what does not vary is right in it
    std::array<Number, 3> at;       ///< [m]
    std::vector<int> constraints;   ///< of each action: its constraint in the catalogue, or -1
    bool is_in_space = false;       ///< its actions, though the mechanism is planar
    bool is_bound_whole = false;    ///< more of it varies than the point
    bool is_in_gears = false;       ///< its place follows from teeth and modules:
    std::optional<int> gear_axis;   ///< on which it stands; otherwise it is a mesh
    int flank = -1;                 ///< of geometry.other_flanks
    Vec3 tangent = Vec3::Zero();    ///< of a mesh, as bound last
    bool has_turned = false;        ///< its teeth, from where they were drawn
    bool is_other_first = false;    ///< of its flanks: the one that pushes under a positive force
    bool is_through_point = false;  ///< all its lines are; nothing else varies
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
      : description_(&description), mechanism_(&mechanism) {}

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

  bool moves(const ToothRule& rule) const;

  const MechanismDescription* description_;
  const Mechanism* mechanism_;
  Space action_space_ = Space::spatial;
  ParameterTable table_;  ///< for couplings that are bound whole
  std::optional<GearPlaces> gears_;
  std::vector<bool> moves_;
  std::vector<bool> turns_;
  std::vector<MovingCoupling> moving_;
  std::vector<MovingPrimary> primaries_;
  std::vector<Vec3> points_;  ///< all that bound the mechanism [m]
  std::vector<Quantity> scratch_;
};

}  // namespace kinestat
