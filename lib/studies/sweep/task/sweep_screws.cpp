#include "studies/sweep/task/sweep_screws.hpp"

#include <algorithm>
#include <vector>

#include "studies/sweep/task/bound_numbers.hpp"

namespace kinestat {

namespace {

bool moves_as(const Geometry& geometry,
              const LaneTape& tape,
              const LaneTape::Workspace& workspace) {
  std::size_t output = 0;
  const auto is_same = [&](const auto& screw) {
    bool is_equal = true;
    for (const double coordinate : screw.coordinates()) {
      is_equal = tape.output(workspace, output++, 0) == coordinate && is_equal;
    }
    return is_equal;
  };
  return std::ranges::all_of(geometry.motions, is_same) &&
         std::ranges::all_of(geometry.actions, is_same) &&
         std::ranges::all_of(geometry.other_flanks, is_same, &OtherFlankOf<double>::screw);
}

// A tape of the screws alone gives the bits that binding gives; a cheap test is no good where it
// leaves out states.
bool moves_as_samples(const TapedScrews& taped,
                      NearOrigin near,
                      std::span<const SweepSample> samples,
                      const SweepNotes& notes) {
  std::vector<TapeNumber> outputs;
  for (const auto* screws : {&taped.motions, &taped.actions, &taped.flanks}) {
    for (const TapedScrew& screw : *screws) {
      outputs.insert(outputs.end(), screw.begin(), screw.end());
    }
  }
  const LaneTape tape = notes.recorder.make_tape(outputs);
  LaneTape::Workspace workspace = tape.make_workspace(1);
  return std::ranges::all_of(samples, [&](const SweepSample& sample) {
    for (std::size_t i = 0; i < notes.inputs.size(); ++i) {
      tape.set_input(workspace, i, 0, sample.slots.values[notes.inputs[i].index].value);
    }
    tape.play(workspace);
    return tape.is_met(workspace, 0) ? moves_as(sample.mechanism.geometry, tape, workspace)
                                     : near == NearOrigin::by_all_points;
  });
}

TapedScrew take_screw(SweepInput::From from,
                      std::size_t index,
                      const Mechanism& mechanism,
                      const std::function<bool(const SweepInput&)>& moves,
                      SweepNotes& notes) {
  TapedScrew screw;
  for (std::size_t i = 0; i < screw.size(); ++i) {
    const SweepInput input{.from = from, .index = index, .part = i, .dimension = {}};
    const double value = number_of(input, mechanism);
    screw[i] = moves(input) ? notes.take(input, value) : notes.recorder.constant(value);
  }
  return screw;
}

}  // namespace

std::optional<TapedScrews> note_screws(const Rebinder& rebinder,
                                       NearOrigin near,
                                       const Geometry& geometry,
                                       std::span<const SweepSample> samples,
                                       SweepNotes& notes) {
  auto screws = rebinder.record_screws(near, geometry, notes.slots, notes.recorder);
  return screws && moves_as_samples(*screws, near, samples, notes) ? screws : std::nullopt;
}

TapedScrews take_screws(const Mechanism& mechanism,
                        const std::function<bool(const SweepInput&)>& moves,
                        SweepNotes& notes) {
  TapedScrews screws;
  for (std::size_t f = 0; f < mechanism.geometry.motions.size(); ++f) {
    screws.motions.push_back(take_screw(SweepInput::From::motion, f, mechanism, moves, notes));
  }
  for (std::size_t a = 0; a < mechanism.geometry.actions.size(); ++a) {
    screws.actions.push_back(take_screw(SweepInput::From::action, a, mechanism, moves, notes));
  }
  for (std::size_t i = 0; i < mechanism.geometry.other_flanks.size(); ++i) {
    screws.flanks.push_back(take_screw(SweepInput::From::flank, i, mechanism, moves, notes));
  }
  return screws;
}

}  // namespace kinestat
