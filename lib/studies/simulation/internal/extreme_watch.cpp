#include "studies/simulation/internal/extreme_watch.hpp"

#include <algorithm>
#include <cmath>

#include "core/extreme_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "studies/motion/peak_search.hpp"

namespace kinestat {

namespace {

// In all, of steps in which much turns.
constexpr int kMostLooks = 20'000;

// Values of a column in a step beside those of its parts.
constexpr int kMostClimbs = 200;

bool is_more_by_far(double value, double than) {
  return value - than > kSameValue * std::max(std::abs(value), std::abs(than));
}

}  // namespace

ExtremeWatch::ExtremeWatch(const Mechanism& mechanism, const SimulationPlan& plan)
    : mechanism_(mechanism),
      readings_(wanted_readings(mechanism, plan)),
      extremes_(readings_.size()) {}

void ExtremeWatch::note(std::size_t column, double value, double time) {
  SimulationExtremes& of = extremes_[column];
  if (!of.least || is_more_by_far(of.least->value, value)) {
    of.least = SimulationExtreme{.value = value, .time = time};
  }
  if (!of.greatest || is_more_by_far(value, of.greatest->value)) {
    of.greatest = SimulationExtreme{.value = value, .time = time};
  }
  double& largest = largest_[readings_[column].kind];
  largest = std::max(largest, std::abs(value));
}

// Where values touch zero between two looks, the least of them is found but for roundings of the
// others.
std::vector<SimulationExtremes> ExtremeWatch::extremes() const {
  constexpr double kRoundings = 4.0;
  std::vector<SimulationExtremes> settled = extremes_;
  for (SimulationExtremes& of : settled) {
    if (of.least && of.greatest) {
      const double largest = std::max(std::abs(of.least->value), std::abs(of.greatest->value));
      for (SimulationExtreme* const one : {&*of.least, &*of.greatest}) {
        one->value = zero_within_bound(one->value, kRoundings * kEpsilon * largest);
      }
    }
  }
  return settled;
}

ExtremeWatch::Sample ExtremeWatch::sample_of(const SimulationRow& row, const SimulationRow& first) {
  Sample sample{.time = row.time, .values = Values(readings_.size())};
  for (std::size_t c = 0; c < readings_.size(); ++c) {
    sample.values[c] = readings_[c].value(row, first);
    if (sample.values[c]) {
      note(c, *sample.values[c], row.time);
    }
  }
  for (std::size_t f = 0; f < row.rates.size(); ++f) {
    if (mechanism_.topology.freedoms[f].is_rotation) {
      sample.turns = std::max(sample.turns, std::abs(row.rates[f].value_or(0.0)));
    }
  }
  turns_ = sample.turns;
  return sample;
}

ExtremeWatch::Sample ExtremeWatch::sample_at(double time) {
  const std::optional<SimulationRow> row = (*row_at_)(time);
  return row ? sample_of(*row, *first_) : Sample{.time = time, .values = Values(readings_.size())};
}

void ExtremeWatch::take(const SimulationRow& row, const SimulationRow& first) {
  sample_of(row, first);
}

void ExtremeWatch::take(const SimulationEvent& event) {
  for (std::size_t c = 0; c < readings_.size(); ++c) {
    const SimulationReading& reading = readings_[c];
    if (reading.freedom < 0 ||
        (reading.element != event.element && reading.actuator != event.element)) {
      continue;
    }
    const auto add = [&](const std::optional<double>& value) {
      if (value) {
        note(c, *value, event.time);
      }
    };
    if (reading.quantity == "position") {
      add(event.position);
    } else if (reading.quantity == "velocity") {
      add(event.speed);
      add(event.speed_after);
    }
  }
}

int ExtremeWatch::parts_of(const Sample& begin, const Sample& end) {
  const double turn = std::max(begin.turns, end.turns) * (end.time - begin.time);
  const double most = sees_all_ ? std::max(0, kMostLooks - looks_) : 0;
  const double parts = std::max(2.0, std::ceil(turn / kFarthestTurn));
  sees_all_ = sees_all_ && parts - 2.0 <= most;
  const int some = static_cast<int>(std::min(parts, 2.0 + most));
  looks_ += some - 2;
  return some;
}

void ExtremeWatch::climb(const std::vector<Sample>& samples, std::size_t column, double sign) {
  const SimulationExtremes& of = extremes_[column];
  const std::optional<SimulationExtreme>& known = sign > 0.0 ? of.greatest : of.least;
  if (!known) {
    return;
  }
  const double least_gain = kLeastPeak * largest_[readings_[column].kind];
  PeakSearch search(sign * known->value + least_gain, std::nullopt);
  const auto peak = [&](const Sample& one) {
    return PeakSample{.share = one.time, .value = sign * *one.values[column]};
  };
  std::vector<PeakSample> run;
  for (const Sample& one : samples) {
    if (one.values[column]) {
      run.push_back(peak(one));
    } else {
      search.add_run(run);
      run.clear();
    }
  }
  search.add_run(run);
  int climbs = 0;
  for (auto time = search.next(); time; time = search.next()) {
    if (climbs++ == kMostClimbs) {
      sees_all_ = false;
      return;
    }
    const Sample there = sample_at(*time);
    search.take(there.values[column] ? std::optional(sign * *there.values[column]) : std::nullopt);
  }
}

void ExtremeWatch::look(const Step& step, const SimulationRow& first, const RowAt& row_at) {
  if (!(step.end > step.begin)) {
    return;
  }
  row_at_ = &row_at;
  first_ = &first;
  std::vector<Sample> samples;
  if (last_ && regime_ == step.regime && last_->time == step.begin) {
    samples.push_back(*std::move(last_));
  } else {
    samples.push_back(sample_at(step.begin));
    if (last_) {
      sides_.push_back({.time = step.begin,
                        .before = std::move(last_->values),
                        .after = samples.front().values});
    }
  }
  Sample end = sample_at(step.end);
  const int parts = parts_of(samples.front(), end);
  for (int k = 1; k < parts; ++k) {
    samples.push_back(sample_at(std::lerp(step.begin, step.end, static_cast<double>(k) / parts)));
  }
  samples.push_back(std::move(end));
  for (std::size_t c = 0; c < readings_.size(); ++c) {
    if (readings_[c].has_peaks) {
      climb(samples, c, 1.0);
      climb(samples, c, -1.0);
    }
  }
  last_ = std::move(samples.back());
  regime_ = step.regime;
}

}  // namespace kinestat
