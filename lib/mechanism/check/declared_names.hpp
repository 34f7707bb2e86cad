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

  /// Makes room for so many.
  void reserve(std::size_t count) { names_.reserve(count); }

  /// Answers where the name was declared before; it then stays as it was.
  std::optional<SourceRange> add(const Name& name);

  /// The index, or -1.
  int find(std::string_view name) const;

  /// Where the name of an index was declared.
  SourceRange where(int index) const;

  bool contains(std::string_view name) const { return find(name) >= 0; }

  std::span<const std::string> names() const { return names_; }

  /// Whether a reference names one; adds an error if not. `role` begins the message: "load 'wind'
  /// acts on".
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

/// What an actuator moves; unknown where its coupling is wrong or not clear.
enum class DriveKind { unknown, turning, sliding };

struct DeclaredNames {
  NameTable bodies{"E0312", "body", "bodies"};            ///< the ground first
  NameTable couplings{"E0313", "coupling", "couplings"};  ///< meshes and what cables make too
  NameTable meshes{"E0313", "mesh", "meshes"};            ///< of `gears`, and couplings of gears
  NameTable members{"E0313", "gear member", "gear members"};
  NameTable actuators{"E0313", "actuator", "actuators"};  ///< clutches and brakes too
  NameTable cases{"E0313", "case", "cases"};
  NameTable states{"E0313", "case or gear", "cases and gears"};
  NameTable parameters{"E0313", "parameter", "parameters"};
  std::vector<DriveKind> actuator_kinds;  ///< of each of `actuators`

  /// Whether a reference names an actuator; a coupling that is none gets its own hint.
  bool check_actuator(const Name& reference, std::string_view role, Diagnostics& found) const;

  DriveKind kind_of_actuator(std::string_view name) const;
};

/// Complains of names that the file does not write itself and that clash: those which cables make,
/// and meshes, which share the names of couplings.
DeclaredNames declare_names(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
