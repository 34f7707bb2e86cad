// What the scheme of a gear train shows, without places: wheels, planets, meshes and elements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/train/gear_scheme.hpp"

namespace kinestat {

struct SchemeWheel {
  std::string name;  ///< "sun1 30", or that of its body
  int body = 0;
  double radius = 0.0;  ///< in any one unit
  bool is_ring = false;
  int planet = -1;  ///< index into SchemeTrain::planets; -1: on its axis
  int axis = 0;     ///< about which it turns, or the carrier of its planet; 0: the main axis

  friend bool operator==(const SchemeWheel&, const SchemeWheel&) = default;
};

struct SchemePlanet {
  int body = 0;
  int carrier = 0;  ///< the body that holds its pin; 0: the housing
  int axis = 0;     ///< about which it goes round

  friend bool operator==(const SchemePlanet&, const SchemePlanet&) = default;
};

struct SchemeMesh {
  int first = 0;  ///< wheels
  int second = 0;
  double at = 0.0;        ///< along the main axis [m]
  bool is_apart = false;  ///< axes stand between its wheels: they are drawn with a broken line

  friend bool operator==(const SchemeMesh&, const SchemeMesh&) = default;
};

enum class SchemeElementKind { clutch, brake, input, output };

/// What engages, drives or is driven.
struct SchemeElement {
  std::string name;
  SchemeElementKind kind = SchemeElementKind::clutch;
  int body = 0;
  int other = 0;            ///< of a clutch: the body that it joins to `body`
  bool is_engaged = false;  ///< in the case that is shown
  int axis = 0;             ///< about which its bodies turn
  bool is_fluid = false;    ///< a torque converter, laid out as a clutch

  friend bool operator==(const SchemeElement&, const SchemeElement&) = default;
};

/// A bearing of two bodies that move, on one axis.
struct SchemeBearing {
  int first = 0;
  int second = 0;

  friend bool operator==(const SchemeBearing&, const SchemeBearing&) = default;
};

struct SchemeTrain {
  std::vector<SchemeWheel> wheels;
  std::vector<SchemePlanet> planets;
  std::vector<SchemeMesh> meshes;
  std::vector<SchemeElement> elements;
  std::vector<SchemeBearing> bearings;
  int axis_count = 1;       ///< of a half section one, of a developed section also shafts beside it
  bool has_places = false;  ///< the file places its meshes along the axis

  friend bool operator==(const SchemeTrain&, const SchemeTrain&) = default;
};

/// Empty if no gears with parallel axes mesh, or if why_no_scheme_train has a reason.
std::optional<SchemeTrain> find_scheme_train(const Analysis& analysis,
                                             const GearSchemeOptions& options);

/// The same as a half section: what turns beside the main axis is drawn as planets. Empty also
/// where several bodies turn about one such axis, or an element joins one there.
std::optional<SchemeTrain> find_half_section(const Analysis& analysis,
                                             const GearSchemeOptions& options);

/// Why the gears of the section `gears` fit in no section, half or developed; or empty: planets
/// turn about planets, or several bodies do about one planet's axis, or shafts mesh inside a ring.
std::string why_no_scheme_train(const MechanismDescription& description);

}  // namespace kinestat
