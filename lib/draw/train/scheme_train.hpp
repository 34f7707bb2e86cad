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
  int planet = -1;  ///< index into SchemeTrain::planets; -1: on the main axis
};

struct SchemePlanet {
  int body = 0;
  int carrier = 0;  ///< the body that holds its pin; 0: the housing
};

struct SchemeMesh {
  int first = 0;  ///< wheels
  int second = 0;
  double at = 0.0;  ///< along the main axis [m]
};

enum class SchemeElementKind { clutch, brake, input, output };

/// What engages, drives or is driven.
struct SchemeElement {
  std::string name;
  SchemeElementKind kind = SchemeElementKind::clutch;
  int body = 0;
  int other = 0;            ///< of a clutch: the body that it joins to `body`
  bool is_engaged = false;  ///< in the case that is shown
};

struct SchemeTrain {
  std::vector<SchemeWheel> wheels;
  std::vector<SchemePlanet> planets;
  std::vector<SchemeMesh> meshes;
  std::vector<SchemeElement> elements;
  bool has_places = false;  ///< the file places its meshes along the axis
};

/// Whether a half section can show the gears of the section `gears`, if there is one: about axes
/// beside the main axis turns one body each, and no planet.
bool is_half_section(const MechanismDescription& description);

/// Empty if no gears with parallel axes mesh, or if they are no half section.
std::optional<SchemeTrain> find_scheme_train(const Analysis& analysis,
                                             const GearSchemeOptions& options);

}  // namespace kinestat
