// The screws of one coupling, in the spaces in which its mechanism is counted.
#pragma once

#include "core/diagnostic.hpp"
#include "couplings/coupling_catalogue.hpp"
#include "couplings/coupling_geometry.hpp"
#include "description/coupling_description.hpp"

namespace kinestat {

/// Whether couplings free what they free in the plane or in space, and bear what they bear there.
struct ScrewSpaces {
  Space motions = Space::spatial;
  Space actions = Space::spatial;
};

/// Keeps a reference to the coupling.
class ScrewBinder {
 public:
  ScrewBinder(const CouplingDescription& coupling, Space drawn_in, ScrewSpaces spaces)
      : coupling_(coupling), drawn_in_(drawn_in), spaces_(spaces) {}

  /// In the space of the file, where they have their names; complains of actions that would work on
  /// freedoms, measured with the size of the mechanism [m].
  CouplingScrews drawn(const CouplingGeometry& local, double length, Diagnostics& found) const;

  /// In the spaces asked for; `passive` lists all that a coupling bears, in space too.
  CouplingScrews counted(const CouplingGeometry& local, const CouplingScrews& drawn) const;

 private:
  void check_reciprocal(const CouplingScrews& screws, double length, Diagnostics& found) const;

  const CouplingDescription& coupling_;
  Space drawn_in_;
  ScrewSpaces spaces_;
};

/// Complains of stiffness of constraints that the coupling does not have.
void check_stiffness(const CouplingDescription& coupling,
                     const CouplingScrews& screws,
                     Diagnostics& found);

/// Keeps only the constraints that `passive:` names; complains about names that the coupling does
/// not have.
void keep_passive(const CouplingDescription& coupling, CouplingScrews& screws, Diagnostics& found);

}  // namespace kinestat
