#include "run/picture_finder.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "draw/catalogue/catalogue.hpp"
#include "mechanism/bind/bind.hpp"
#include "run/analyse.hpp"
#include "run/benchmark.hpp"
#include "run/simulation.hpp"
#include "run/sweep.hpp"
#include "studies/duty/task/find_duty.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/motion/task/motion_choice.hpp"
#include "studies/simulation/report/simulation_table.hpp"
#include "studies/simulation/task/find_simulation.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"
#include "studies/transmissions/task/find_transmissions.hpp"

namespace kinestat {

namespace {

// For each side of a case.
constexpr double kTimingSeconds = 2.0;

// Their cases stand behind those of the file.
std::vector<std::size_t> gears_of(const Analysis& analysis) {
  std::vector<std::size_t> gears;
  const auto count = std::ranges::count(analysis.shift->solution.states,
                                        ShiftClass::gear,
                                        [](const NamedShiftState& one) { return one.state.kind; });
  const std::size_t end = analysis.mechanism.cases.size();
  for (std::size_t i = end - static_cast<std::size_t>(count); i < end; ++i) {
    gears.push_back(i);
  }
  return gears;
}

}  // namespace

bool PictureFinder::load(SourceFile& source, Diagnostics& found) {
  description_ = load_description(path_, options_.load, source, found);
  file_ = source;
  return description_ && apply_to_motion(found);
}

bool PictureFinder::find(PictureNeed need, Diagnostics& found) {
  std::optional<bool>& is_found = is_found_[static_cast<std::size_t>(need)];
  if (!is_found) {
    Diagnostics more;
    is_found = solve(need, more);
    add_new(more, found);
  }
  return *is_found;
}

PictureSource PictureFinder::source() const {
  return {.analysis = analysis_ ? &*analysis_ : nullptr,
          .motion = motion_ ? &motion_->table : nullptr,
          .moving = moving_ ? &*moving_ : nullptr,
          .placed = placed_ ? &*placed_ : nullptr,
          .synthesis = synthesis_ ? &*synthesis_ : nullptr,
          .transmissions = transmissions_ ? &*transmissions_ : nullptr,
          .benchmark = benchmark_ ? &*benchmark_ : nullptr,
          .simulation = simulation_ ? &*simulation_ : nullptr,
          .sweep = sweep_ ? &*sweep_ : nullptr,
          .maps = maps_ ? &*maps_ : nullptr};
}

// What the command line says of it. False iff an error was added.
bool PictureFinder::apply_to_motion(Diagnostics& found) {
  const PictureKind* const kind = find_picture_kind(choice_.picture);
  const bool has_case = kind != nullptr && is_of_motion(kind->need) && !choice_.case_label.empty();
  if (!choice_.drive && ((choice_.report.empty() && !has_case) || !description_->motion)) {
    return true;
  }
  MotionChoice choice;
  choice.report = choice_.report;
  if (has_case) {
    choice.label = choice_.case_label;
  }
  if (choice_.drive) {
    choice.drive = choice_.drive;
    choice.to = kLimitWord;  // as far as it goes
  }
  return apply(choice, *description_, found);
}

bool PictureFinder::solve(PictureNeed need, Diagnostics& found) {
  switch (need) {
    case PictureNeed::analysis:
      return find_analysis(found);
    case PictureNeed::synthesis:
      synthesis_ = find_synthesis(path_, *description_, {}, found);
      return synthesis_.has_value();
    case PictureNeed::transmissions:
      transmissions_ = find_transmissions(path_, *description_, {}, found);
      return transmissions_.has_value();
    case PictureNeed::benchmark:
      return find_benchmark(found);
    case PictureNeed::motion:
      return find_motion_of_file(found);
    case PictureNeed::moving:
      return find_moving(found);
    case PictureNeed::placed:
      return find_placed(found);
    case PictureNeed::simulation:
      return find_simulated(found);
    case PictureNeed::sweep:
      return find_sweep(found);
    case PictureNeed::maps:
      return find_maps(found);
  }
  return false;
}

std::optional<Mechanism> PictureFinder::bind_mechanism(Diagnostics& found) const {
  std::optional<Mechanism> mechanism = bind(*description_, found);
  if (!mechanism && !found.has_errors()) {
    refuse_without_mechanism(*description_, found);
  }
  return mechanism;
}

bool PictureFinder::find_analysis(Diagnostics& found) {
  std::optional<Mechanism> mechanism = bind_mechanism(found);
  if (!mechanism) {
    return false;
  }
  auto certified = analyse_mechanism(
      path_,
      {.description = *description_, .mechanism = *std::move(mechanism), .shift = std::nullopt},
      options_.accuracy,
      found);
  if (certified) {
    analysis_ = std::move(certified->analysis);
  }
  return certified.has_value();
}

bool PictureFinder::has_motion(std::string_view instead, Diagnostics& found) const {
  if (!description_->motion) {
    found.error(
        "E0303",
        {},
        "the file has no section 'motion'",
        fmt::format("add motion: {{drive: …, from: …, to: …}}{}; 'kinestat help motion' says more",
                    instead));
  }
  return description_->motion.has_value();
}

bool PictureFinder::find_placed(Diagnostics& found) {
  if (!has_motion(", or write --drive ACTUATOR", found)) {
    return false;
  }
  const std::optional<Mechanism> mechanism = bind_mechanism(found);
  if (mechanism) {
    placed_ = place_mechanism(path_,
                              *description_,
                              *mechanism,
                              {.at = choice_.at, .case_label = choice_.case_label},
                              found);
  }
  return placed_.has_value();
}

bool PictureFinder::find_motion_of_file(Diagnostics& found) {
  if (!has_motion("", found)) {
    return false;
  }
  // Also of a drawing that does not close: the motion closes it first.
  const std::optional<Mechanism> mechanism = bind_unassembled(*description_, found);
  if (!mechanism) {
    return false;
  }
  motion_ = find_motion(*description_, *mechanism, found);
  return motion_.has_value();
}

// Of a drawing that does not close a picture would show bodies that hang in no joint.
bool PictureFinder::find_moving(Diagnostics& found) {
  if (!find(PictureNeed::motion, found)) {
    return false;
  }
  const std::optional<Mechanism> mechanism = bind_mechanism(found);
  if (mechanism) {
    moving_ = moving_mechanism(path_, *description_, *mechanism, *motion_);
  }
  return mechanism.has_value();
}

// One that cannot go on is drawn as far as it goes.
bool PictureFinder::find_simulated(Diagnostics& found) {
  const std::optional<FoundSimulation> answer = find_simulation(*description_, found);
  if (answer) {
    simulation_ = simulation_table(simulation_view(path_, *description_, *answer, nullptr));
  }
  return answer.has_value();
}

bool PictureFinder::find_sweep(Diagnostics& found) {
  if (!description_->sweep) {
    found.error("E0303",
                {},
                "the file has no section 'sweep'",
                "add sweep: {vary: {…}}; 'kinestat help sweeps' says more");
    return false;
  }
  sweep_ = find_sweep_table(file_, *description_, found);
  return sweep_.has_value();
}

// Of the duty or, without one, of the gears.
bool PictureFinder::find_maps(Diagnostics& found) {
  if (const std::string why_not = why_no_maps(); !why_not.empty()) {
    found.error("E0303",
                {},
                why_not,
                "add duty: {points: [{case: …, input_motion: …, input_action: …, duration: …}]}; "
                "'kinestat help duty' says more");
    return false;
  }
  if (!find(PictureNeed::analysis, found)) {
    return false;
  }
  const Analysis& analysis = *analysis_;
  if (!analysis.description.duty) {
    maps_ = map_cases(analysis.mechanism, gears_of(analysis));
  } else if (const auto duty = find_duty(path_, "", judged_file(analysis), found)) {
    maps_ = map_duty(analysis.mechanism, duty->plan);
  }
  return maps_.has_value();
}

std::string PictureFinder::why_no_maps() const {
  if (description_->duty) {
    return "";
  }
  if (!description_->shift) {
    return "the file has no section 'duty' or 'shift'";
  }
  return description_->shift->input_action.empty()
             ? "the file has no section 'duty', and its 'shift' no 'input_action'"
             : "";
}

bool PictureFinder::find_benchmark(Diagnostics& found) {
  const std::optional<Mechanism> mechanism = bind_mechanism(found);
  if (!mechanism) {
    return false;
  }
  const BenchmarkChoice choice = {.case_label = choice_.case_label,
                                  .limits = {.seconds = kTimingSeconds}};
  benchmark_ = benchmark_cases(*mechanism, choice, clock_, found);
  return benchmark_.has_value();
}

}  // namespace kinestat
