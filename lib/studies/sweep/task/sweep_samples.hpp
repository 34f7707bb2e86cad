// Some states of a sweep, bound as a whole, by which its tape is made and tried.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "expression/slots.hpp"
#include "mechanism/bind/rebind.hpp"

namespace kinestat {

struct SweepTask;
class SweepPlan;

struct SweepSample {
  Slots slots;
  Mechanism mechanism;
};

/// Of each parameter: whether it varies, or follows from one that does.
std::vector<bool> varying_parameters(const SweepPlan& plan);

/// The parameters of a state.
Slots slots_at(const SweepPlan& plan, std::uint64_t state);

/// Those that have a mechanism.
std::vector<SweepSample> find_samples(const SweepTask& task);

/// Whether what is rebound is what is bound, wherever anything is.
bool rebinds(Rebinder& rebinder, const SweepTask& task, std::span<const SweepSample> samples);

}  // namespace kinestat
