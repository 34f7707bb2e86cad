// What a mechanism file declares, by name.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"

namespace kinestat {

/// The names of one kind of thing, in the order of the file.
class NameTable {
 public:
  /// `one` and `many` name the things in messages ("body", "bodies"); `code` is that of a reference
  /// to none of them.
  NameTable(std::string_view code, std::string_view one, std::string_view many)
      : code_(code), one_(one), many_(many) {}

  /// Reserves memory for this number of names.
  void reserve(std::size_t count) { names_.reserve(count); }

  /// Adds a name. If it was declared before, nothing is added, and the earlier place is returned.
  std::optional<SourceRange> add(const Name& name);

  /// The index, or -1.
  int find(std::string_view name) const;

  /// The place at which the name with this index was declared.
  SourceRange where(int index) const;

  bool contains(std::string_view name) const { return find(name) >= 0; }

  std::span<const std::string> names() const { return names_; }

  /// Whether the table has the name of a reference; adds an error if not. `role` begins the
  /// message: "load 'wind' acts on".
  bool check(const Name& reference, std::string_view role, Diagnostics& found) const;

  /// "did you mean 'a'? declared bodies are a, b".
  std::string hint(std::string_view name) const;

 private:
  struct Entry {
    int index = 0;
    SourceRange where;
  };

  std::string_view code_;
  std::string one_;
  std::string many_;
  std::vector<std::string> names_;
  std::map<std::string, Entry, std::less<>> entries_;
};

/// The kind of motion of an actuator; unknown if its coupling is wrong or not clear.
enum class DriveKind { unknown, turning, sliding };

struct DeclaredNames {
  NameTable bodies{"E0312", "body", "bodies"};            ///< the ground first
  NameTable couplings{"E0313", "coupling", "couplings"};  ///< with those of gears and cables
  NameTable meshes{"E0313", "mesh", "meshes"};            ///< of `gears`, and couplings of gears
  NameTable members{"E0313", "gear member", "gear members"};
  NameTable actuators{"E0313", "actuator", "actuators"};  ///< with clutches and brakes
  NameTable cases{"E0313", "case", "cases"};
  NameTable states{"E0313", "case or gear", "cases and gears"};
  NameTable parameters{"E0313", "parameter", "parameters"};
  std::vector<DriveKind> actuator_kinds;  ///< parallel to `actuators`

  /// Whether a reference names an actuator; adds an error if not, with a hint for couplings.
  bool check_actuator(const Name& reference, std::string_view role, Diagnostics& found) const;

  DriveKind kind_of_actuator(std::string_view name) const;
};

/// Collects the names of a description. Adds an error for each name that clashes with a name which
/// the file does not write itself, one that a cable makes, or that of a mesh, which is named as a
/// coupling.
DeclaredNames declare_names(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
