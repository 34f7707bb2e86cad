// How findings speak of the known magnitudes of one side, motions or actions.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/case_findings.hpp"

namespace kinestat {

/// The magnitudes of one side by the names that a case gives them, in the units of the file. Holds
/// references to what it was made from, for the time of one finding.
struct KnownSide {
  std::function<std::string(int)> name;
  std::function<QuantityKind(int)> kind;
  std::string_view key;                      ///< "motion" or "action"
  std::function<std::string(int)> actuator;  ///< that moves or bears it; empty if none does
  const FileUnits& units;

  /// SI per unit of the file.
  double unit(int index) const { return units.factor(kind(index)); }
};

KnownSide motion_side(const JudgedFile& file, const Case& which);
KnownSide action_side(const JudgedFile& file, const Case& which);

std::vector<std::string> names_of(const std::vector<int>& indices, const KnownSide& side);

/// "add to 'motion:' for example drive or b.wz", or sets in braces where several are missing; those
/// of actuators first, which are what an engineer would give. Empty if the check proposes none.
std::string completions_text(const PrimaryCheck& check, const KnownSide& side);

/// "closure of circuit a, b, c, d requires drive = 2.5 load", a part for each relation.
std::string circuits_text(const JudgedFile& file,
                          const KinematicSolution& motion,
                          const KnownSide& side);

/// "equilibrium of crank, rod (cut-set a, d) requires a.Rx = 2.5 b.Rx + 12 N".
std::string cutsets_text(const JudgedFile& file,
                         const StaticSolution& action,
                         const KnownSide& side);

/// "remove 'a' or 'b' from 'motion:'"; sets in braces where several must go.
std::string removal_text(const PrimaryCheck& check, const KnownSide& side);

/// The place of the first magnitude of the first relation.
SourceRange place_of_surplus(const std::vector<Primary>& primaries,
                             const PrimaryCheck& check,
                             SourceRange otherwise);

}  // namespace kinestat
