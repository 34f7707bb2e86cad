#include "studies/motion/task/figures/overall_efficiency.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/extreme_tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "power/efficiency.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kOwn = "overall/";

template <class List>
void erase_part(std::size_t first, std::size_t count, List& list) {
  if (list.size() >= first + count) {
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(first);
    list.erase(at, at + static_cast<std::ptrdiff_t>(count));
  }
}

// Zero within what fewer steps make of it and, in time, what its points do.
double settled(const ColumnFigures& one) {
  const double by_steps = one.mean_by_half ? std::abs(*one.mean - *one.mean_by_half) : 0.0;
  const double by_points = one.rms ? kMeansAgree * *one.rms : 0.0;
  return zero_within_bound(*one.mean, std::max(by_steps, by_points));
}

}  // namespace

OverallEfficiency::OverallEfficiency(const Mechanism& mechanism, const MotionPlan& plan)
    : mechanism_(mechanism), plan_(plan) {
  const Case* const which =
      plan.which < 0 ? nullptr : &mechanism.cases[static_cast<std::size_t>(plan.which)];
  has_question_ = which != nullptr && which->asks_actions && which->names_both_ends() &&
                  plan.report.tells_efficiency() && (plan.schedule || !which->motions.empty());
}

bool OverallEfficiency::is_own(const MotionColumn& column) {
  return column.quantity.starts_with(kOwn);
}

void OverallEfficiency::add_readings(const CaseAnalysis& first,
                                     std::vector<MotionReading>& readings) {
  if (!has_question_) {
    return;
  }
  std::vector<std::size_t> running;
  for (std::size_t d = 0; d < plan_.drives.size(); ++d) {
    if (plan_.drives[d].from != plan_.drives[d].to) {
      running.push_back(static_cast<std::size_t>(plan_.drives[d].freedom));
    }
  }
  if (!plan_.schedule && running.size() != 1) {
    return;
  }
  if (!plan_.schedule) {
    drive_ = running.front();
  }
  which_ = first.which;
  const auto add = [&](std::string_view kind, std::size_t i, auto power_of) {
    readings.push_back(
        {.column = {.element = {},
                    .quantity = fmt::format("{}{}/{}", kOwn, kind, i),
                    .unit = std::string(kOwn)},
         .value = [this, i, power_of](const MotionPosition& at) -> std::optional<double> {
           const std::optional<double> power =
               at.solved && at.solved->power ? power_of(*at.solved, i) : std::nullopt;
           const std::optional<double> stays = power ? stay(at) : std::nullopt;
           return stays ? std::optional(*power * *stays) : std::nullopt;
         },
         .is_checked = true});
  };
  const bool has_losses = !mechanism_.lossy_meshes.empty();
  const auto actuators_of = [has_losses](const CaseAnalysis& solved) {
    const LossyState* const lossy = lossy_state_of(solved);
    return lossy != nullptr ? &lossy->actuators : has_losses ? nullptr : &solved.power->actuators;
  };
  for (std::size_t i = 0; i < mechanism_.topology.actuators.size(); ++i) {
    add("actuator", i, [actuators_of](const CaseAnalysis& solved, std::size_t a) {
      const auto* const actuators = actuators_of(solved);
      return actuators != nullptr ? std::optional((*actuators)[a]) : std::nullopt;
    });
  }
  for (std::size_t i = 0; i < which_->loads.size(); ++i) {
    add("load", i, [](const CaseAnalysis& solved, std::size_t l) {
      return l < solved.power->loads.size() ? std::optional(solved.power->loads[l]) : std::nullopt;
    });
  }
  add("all", 0, [actuators_of](const CaseAnalysis& solved, std::size_t) {
    const auto* const actuators = actuators_of(solved);
    const auto& loads = solved.power->loads;
    return actuators != nullptr ? std::optional(std::accumulate(
                                      loads.begin(),
                                      loads.end(),
                                      std::accumulate(actuators->begin(), actuators->end(), 0.0)))
                                : std::nullopt;
  });
}

// How long the motion stays at a position: in time all count alike, over the way what the drive
// takes for a piece of it.
std::optional<double> OverallEfficiency::stay(const MotionPosition& at) const {
  if (!drive_) {
    return 1.0;
  }
  const std::vector<double>* const rates =
      at.solved && at.solved->motion ? &at.solved->motion->rates : nullptr;
  const double rate = rates != nullptr && *drive_ < rates->size() ? (*rates)[*drive_] : 0.0;
  return rate != 0.0 ? std::optional(1.0 / std::abs(rate)) : std::nullopt;
}

void OverallEfficiency::finish(MotionTable& table) const {
  if (!has_question_) {
    return;
  }
  const auto own = std::ranges::find_if(table.columns, is_own);
  const auto first = static_cast<std::size_t>(own - table.columns.begin());
  tell(first, table);
  const auto count =
      static_cast<std::size_t>(std::count_if(table.columns.begin(), table.columns.end(), is_own));
  if (count == 0) {
    return;
  }
  erase_part(first, count, table.columns);
  erase_part(first, count, table.figures);
  for (MotionRow& row : table.rows) {
    erase_part(first, count, row.values);
    erase_part(first, count, row.at_rest);
  }
  for (MotionEvent& event : table.events) {
    erase_part(first, count, event.places);
    erase_part(first, count, event.before);
    erase_part(first, count, event.after);
  }
  for (MotionPlace& place : table.places) {
    erase_part(first, count, place.values);
  }
}

// Each mean has an error of its own, and what is lost is that of all powers in sum: the output has
// what is missing.
void OverallEfficiency::balance(double left,
                                std::vector<double>& actuators,
                                std::vector<double>& loads) const {
  double* greatest = nullptr;
  const auto look = [&](double& power) {
    greatest = greatest == nullptr || std::abs(power) > std::abs(*greatest) ? &power : greatest;
  };
  for (const int i : which_->outputs) {
    look(actuators[static_cast<std::size_t>(i)]);
  }
  for (const std::size_t i : which_->output_loads) {
    look(loads[i]);
  }
  if (greatest != nullptr && *greatest != 0.0) {
    *greatest += left;
  }
}

void OverallEfficiency::tell(std::size_t first, MotionTable& table) const {
  std::string& why = table.no_overall_efficiency;
  if (!table.is_whole()) {
    why = "the motion ends before its range does";
    return;
  }
  if (!which_) {
    why = "several drives run, or none, and nothing says how in time; add 'time' to 'motion'";
    return;
  }
  std::vector<double> actuators;
  std::vector<double> loads;
  double all = 0.0;
  for (std::size_t c = first; c < table.columns.size() && is_own(table.columns[c]); ++c) {
    if (!table.figures[c].mean) {
      why = "some positions have no powers, or they become infinite";
      return;
    }
    std::vector<double>& list =
        c - first < mechanism_.topology.actuators.size() ? actuators : loads;
    list.push_back(settled(table.figures[c]));
    all -= list.back();
  }
  all += 2.0 * loads.back();
  loads.pop_back();
  balance(all, actuators, loads);
  double largest = 0.0;
  for (const std::vector<double>* const list : {&actuators, &loads}) {
    for (const double one : *list) {
      largest = std::max(largest, std::abs(one));
    }
  }
  Efficiency found = find_efficiency(
      mechanism_.topology, *which_, {.actuators = actuators, .loads = loads, .largest = largest});
  table.overall_efficiency = found.value;
  why = std::move(found.reason);
}

}  // namespace kinestat
