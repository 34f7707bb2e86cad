#include "studies/sweep/task/bound_numbers.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "studies/sweep/report/sweep_column.hpp"

namespace kinestat {

namespace {

using enum SweepInput::From;

void add_all(SweepInput::From from,
             std::size_t index,
             std::size_t parts,
             std::vector<SweepInput>& all) {
  for (std::size_t part = 0; part < parts; ++part) {
    all.push_back({.from = from, .index = index, .part = part, .dimension = {}});
  }
}

std::vector<SweepInput> all_inputs(const Mechanism& mechanism) {
  std::vector<SweepInput> all;
  for (std::size_t f = 0; f < mechanism.geometry.motions.size(); ++f) {
    add_all(motion, f, 6, all);
  }
  for (std::size_t a = 0; a < mechanism.geometry.actions.size(); ++a) {
    add_all(action, a, 6, all);
  }
  for (std::size_t i = 0; i < mechanism.geometry.other_flanks.size(); ++i) {
    add_all(flank, i, 6, all);
  }
  for (std::size_t c = 0; c < mechanism.cases.size(); ++c) {
    add_all(primary_motion, c, mechanism.cases[c].motions.size(), all);
    add_all(primary_action, c, mechanism.cases[c].actions.size(), all);
  }
  for (std::size_t m = 0; m < mechanism.lossy_meshes.size(); ++m) {
    add_all(share, m, 1, all);
  }
  return all;
}

double part_of(const Vec3& first, const Vec3& second, std::size_t part) {
  return part < 3 ? first[static_cast<Eigen::Index>(part)]
                  : second[static_cast<Eigen::Index>(part - 3)];
}

double part_of(const Wrench& wrench, std::size_t part) {
  return part_of(wrench.moment, wrench.force, part);
}

}  // namespace

double number_of(const SweepInput& input, const Mechanism& mechanism) {
  const Geometry& geometry = mechanism.geometry;
  switch (input.from) {
    case motion:
      return part_of(
          geometry.motions[input.index].angular, geometry.motions[input.index].linear, input.part);
    case action:
      return part_of(geometry.actions[input.index], input.part);
    case flank:
      return part_of(geometry.other_flanks[input.index].screw, input.part);
    case primary_motion:
      return mechanism.cases[input.index].motions[input.part].value;
    case primary_action:
      return mechanism.cases[input.index].actions[input.part].value;
    case share:
      return mechanism.lossy_meshes[input.index].share;
    case axis:
    case parameter:
      break;
  }
  KINESTAT_EXPECTS(false);  // these are numbers of the plan
  return 0.0;
}

bool has_same_parts(const Mechanism& a, const Mechanism& b) {
  return has_same_magnitudes(a.topology, b.topology) &&
         a.lossy_meshes.size() == b.lossy_meshes.size() &&
         a.geometry.other_flanks.size() == b.geometry.other_flanks.size();
}

BoundNumbers::BoundNumbers(const Mechanism& recorded, std::span<const Mechanism> samples)
    : recorded_(&recorded) {
  for (const SweepInput& input : all_inputs(recorded)) {
    const double value = number_of(input, recorded);
    const bool is_kept = std::ranges::all_of(
        samples, [&](const Mechanism& one) { return number_of(input, one) == value; });
    if (is_kept) {
      kept_.push_back({.input = input, .value = value});
    } else {
      moving_.push_back(input);
    }
  }
}

bool BoundNumbers::moves(const SweepInput& input) const {
  return std::ranges::find(moving_, input) != moving_.end();
}

bool BoundNumbers::are_kept_by(const Mechanism& mechanism) const {
  const bool has_more = !mechanism.frictions.empty() || !mechanism.contacts.empty();
  return has_same_parts(mechanism, *recorded_) && !has_more &&
         std::ranges::all_of(
             kept_, [&](const Kept& one) { return number_of(one.input, mechanism) == one.value; });
}

}  // namespace kinestat
