#include "studies/transmissions/task/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace kinestat {

namespace {

// About half a minute on one core where it is used up.
constexpr std::uint64_t kMostWork = 100'000'000;

// A requirement that may be left out, and what the task is without it.
struct Relaxation {
  std::string_view name;
  bool is_asked;
  std::function<void(TransmissionTask&)> relax;
};

bool is_asked(const ClosedRange& range) {
  return range.from > 0.0 || std::isfinite(range.to);
}

template <class Number>
Relaxation without(std::string_view name,
                   const TransmissionTask& task,
                   std::optional<Number> TransmissionLimits::*limit) {
  return {name, (task.limits.*limit).has_value(), [limit](TransmissionTask& t) {
            (t.limits.*limit).reset();
          }};
}

Relaxation without(std::string_view name,
                   const TransmissionTask& task,
                   ClosedRange LadderTask::*range) {
  return {
      name, is_asked(task.ladder.*range), [range](TransmissionTask& t) { t.ladder.*range = {}; }};
}

std::vector<Relaxation> relaxations(const TransmissionTask& task) {
  const LadderTask& ladder = task.ladder;
  using Limits = TransmissionLimits;
  std::vector<Relaxation> all = {
      without("first", task, &LadderTask::first),
      without("last", task, &LadderTask::last),
      without("spread", task, &LadderTask::spread),
      without("reverse", task, &LadderTask::reverse_ratio),
      {"direct", ladder.needs_direct, [](TransmissionTask& t) { t.ladder.needs_direct = false; }},
      {"one_change", ladder.one_change, [](TransmissionTask& t) { t.ladder.one_change = false; }},
      {"reverse_change",
       ladder.reverse_change,
       [](TransmissionTask& t) { t.ladder.reverse_change = false; }},
      {"brakes", task.brakes.has_value(), [](TransmissionTask& t) { t.brakes.reset(); }},
      {"layout",
       task.layout != SectionLayout::any && !task.limits.hollow_shafts,
       [](TransmissionTask& t) { t.layout = SectionLayout::any; }},
      without("element_torque", task, &Limits::element_torque),
      without("element_slip", task, &Limits::element_slip),
      without("shaft_speed", task, &Limits::shaft_speed),
      without("planet_speed", task, &Limits::planet_speed),
      without("efficiency", task, &Limits::efficiency),
      without("rotating_clutches", task, &Limits::rotating_clutches),
      without("hollow_shafts", task, &Limits::hollow_shafts)};
  std::erase_if(all, [](const Relaxation& one) { return !one.is_asked; });
  return all;
}

}  // namespace

std::string relaxation_text(const TransmissionTask& task,
                            const SearchStages& stages,
                            const ForEach& for_each) {
  const std::vector<Relaxation> all = relaxations(task);
  std::vector<TransmissionTask> tasks;
  for (const Relaxation& one : all) {
    one.relax(tasks.emplace_back(task));
  }
  const std::vector<TransmissionCount> counts =
      count_transmissions(tasks, stages.layouts, kMostWork, for_each);
  const bool is_of_a_part = std::ranges::any_of(counts, &TransmissionCount::is_of_a_part);
  const auto most = std::ranges::max_element(counts, {}, &TransmissionCount::found);
  if (most == counts.end() || most->found == 0) {
    return fmt::format(
        "no single requirement left out helps{}: allow other stationary ratios or steps, or take "
        "a set or an element more",
        is_of_a_part ? " as far as was tried, which is not all" : "");
  }
  return fmt::format("without '{}' there would be {}{}",
                     all[static_cast<std::size_t>(most - counts.begin())].name,
                     most->found,
                     most->is_of_a_part ? " or more; not all were tried"
                     : is_of_a_part     ? "; of others not all were tried"
                                        : "");
}

}  // namespace kinestat
