// The rows of the kinds, each in a file of its own.
#pragma once

#include <array>

#include "couplings/kind.hpp"

namespace kinestat {

extern const CouplingKind kRevolute;
extern const CouplingKind kPrismatic;
extern const CouplingKind kHelical;
extern const CouplingKind kCylindrical;
extern const CouplingKind kUniversal;
extern const CouplingKind kSpherical;
extern const CouplingKind kPlanar;
extern const CouplingKind kPointContact;
extern const CouplingKind kCam;
extern const CouplingKind kLineContact;
extern const CouplingKind kSphereInTube;
extern const CouplingKind kPinInSlot;
extern const CouplingKind kRigid;
extern const CouplingKind kGear;
extern const CouplingKind kBevelGear;
extern const CouplingKind kWorm;
extern const CouplingKind kRack;
extern const CouplingKind kClutch;
extern const CouplingKind kBrake;
extern const CouplingKind kTorqueConverter;
extern const CouplingKind kCable;
extern const CouplingKind kScrews;

/// In the order of the enumeration.
inline constexpr auto kKinds = std::to_array<const CouplingKind*>({
    &kRevolute,     &kPrismatic, &kHelical,      &kCylindrical, &kUniversal,
    &kSpherical,    &kPlanar,    &kPointContact, &kCam,         &kLineContact,
    &kSphereInTube, &kPinInSlot, &kRigid,        &kGear,        &kBevelGear,
    &kWorm,         &kRack,      &kClutch,       &kBrake,       &kTorqueConverter,
    &kCable,        &kScrews,
});

}  // namespace kinestat
