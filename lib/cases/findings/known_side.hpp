// Text of findings about the known magnitudes of one side, motions or actions.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/findings/case_findings.hpp"

namespace kinestat {

/// The names, kinds and units of the magnitudes of one side, as a case and its file write them.
/// Holds references to its sources: use it for one finding only.
struct KnownSide {
  std::function<std::string(int)> name;
  std::function<QuantityKind(int)> kind;
  std::string_view key;                      ///< "motion" or "action"
  std::function<std::string(int)> actuator;  ///< the one to which it belongs; empty if none
  const FileUnits& units;
  bool is_typed = true;  ///< the file has the key; a gear of 'shift' has what that section says

  /// The unit of the file, in SI.
  double unit(int index) const { return units.factor(kind(index)); }
};

KnownSide motion_side(const JudgedFile& file, const Case& which);
KnownSide action_side(const JudgedFile& file, const Case& which);

std::vector<std::string> names_of(const std::vector<int>& indices, const KnownSide& side);

/// "add to 'motion:' for example drive or b.wz", with sets in braces if several are missing. Those
/// of actuators come first, as an engineer would give these. Empty if the check proposes none, or
/// if the file has no such key.
std::string completions_text(const PrimaryCheck& check, const KnownSide& side);

/// "closure of circuit a, b, c, d requires drive = 2.5 load", for each relation between primaries.
std::string circuits_text(const JudgedFile& file,
                          const KinematicSolution& motion,
                          const KnownSide& side);

/// "equilibrium of crank, rod (cut-set a, d) requires a.Rx = 2.5 b.Rx + 12 N", likewise.
std::string cutsets_text(const JudgedFile& file,
                         const StaticSolution& action,
                         const KnownSide& side);

/// "remove 'a' or 'b' from 'motion:'", with sets in braces if several must be removed.
std::string removal_text(const PrimaryCheck& check, const KnownSide& side);

/// The place in the file of the first magnitude of the first relation; `otherwise` if it has none.
SourceRange place_of_surplus(const std::vector<Primary>& primaries,
                             const PrimaryCheck& check,
                             SourceRange otherwise);

}  // namespace kinestat
