// The unit screws of a sweep on its tape.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mechanism/bind/rebind.hpp"
#include "studies/sweep/task/sweep_notes.hpp"
#include "studies/sweep/task/sweep_samples.hpp"

namespace kinestat {

/// By the formulas of the file, for the parameters of the notes. Empty where the geometry moves
/// otherwise, or not with the bits that it has in the samples; where a cheap test is tried
/// (NearOrigin::by_fixed_points), also if it leaves out a sample.
std::optional<TapedScrews> note_screws(const Rebinder& rebinder,
                                       NearOrigin near,
                                       const Geometry& geometry,
                                       std::span<const SweepSample> samples,
                                       SweepNotes& notes);

/// What moves as inputs, which the mechanism of a state gives.
TapedScrews take_screws(const Mechanism& mechanism,
                        const std::function<bool(const SweepInput&)>& moves,
                        SweepNotes& notes);

}  // namespace kinestat
