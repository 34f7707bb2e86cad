#include "studies/synthesis/dyads/dyad_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contract.hpp"
#include "studies/synthesis/curves/cubic_branches.hpp"
#include "studies/synthesis/curves/curve_point.hpp"

namespace kinestat {

DyadChoice::DyadChoice(std::vector<PositionJets> positions,
                       const ChoiceArea& area,
                       std::optional<Dyad> given,
                       std::optional<AngleFunction> function)
    : positions_(std::move(positions)),
      area_(area),
      frame_(frame_of(area.of, positions_)),
      given_(std::move(given)),
      function_(std::move(function)) {
  const int count = position_count(positions_);
  KINESTAT_EXPECTS(count == 3 || count == 4);
  if (count == 4) {
    curves_ = find_curves(positions_);
    if (curves_->status == BurmesterStatus::solved) {
      find_steps();
    }
  }
}

void DyadChoice::find_steps() {
  constexpr int kPoints = 2000;
  const Point middle = frame_.place(0.5 * (area_.from + area_.to));
  const double radius = 0.5 * std::abs(area_.to - area_.from);
  const Point half = 0.5 * (area_.to - area_.from);
  const auto is_inside = [&](const Point& fixed) {
    const Point away = unit_vector(-frame_.angle) * (fixed - middle);
    return std::abs(away.real()) <= std::abs(half.real()) &&
           std::abs(away.imag()) <= std::abs(half.imag());
  };
  double length = 0.0;
  for (const CurveBranch& branch : sample(curves_->of(area_.of), middle, radius, kPoints)) {
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      const Step step{.from = branch.points[i - 1],
                      .to = branch.points[i],
                      .before = length,
                      .length = std::abs(branch.points[i] - branch.points[i - 1])};
      if (is_inside(step.from) && is_inside(step.to)) {
        steps_.push_back(step);
        length += step.length;
      }
    }
  }
}

std::vector<SelectionRange> DyadChoice::ranges(int samples) const {
  if (curves_ && steps_.empty()) {
    return {};
  }
  const SelectionRange share{.from = 0.0, .to = 1.0};
  const SelectionRange x{.from = area_.from.real(), .to = area_.to.real()};
  const SelectionRange y{.from = area_.from.imag(), .to = area_.to.imag()};
  std::vector<SelectionRange> ranges;
  for (int dyad = 0; dyad < chosen_count(); ++dyad) {
    if (curves_) {
      ranges.push_back(share);
    } else {
      ranges.push_back(x);
      ranges.push_back(y);
    }
  }
  const int count = samples_along(samples, static_cast<double>(ranges.size()));
  for (SelectionRange& range : ranges) {
    range.count = count;
  }
  return ranges;
}

Point DyadChoice::on_curve(double share) const {
  const double at = share * (steps_.back().before + steps_.back().length);
  const auto after = std::ranges::upper_bound(steps_, at, {}, &Step::before);
  const Step& step = after == steps_.begin() ? *after : *(after - 1);
  const double part =
      step.length > 0.0 ? std::clamp((at - step.before) / step.length, 0.0, 1.0) : 0.0;
  return onto(curves_->of(area_.of), step.from + part * (step.to - step.from));
}

// In the fixed frame, at the first position.
Point DyadChoice::chosen_point(std::span<const double> numbers) const {
  return curves_ ? on_curve(numbers[0]) : frame_.place({numbers[0], numbers[1]});
}

std::optional<Dyad> DyadChoice::chosen_dyad(std::span<const double> numbers) const {
  return find_dyad(positions_, chosen_point(numbers), area_.of);
}

std::vector<Dyad> DyadChoice::dyads(std::span<const double> numbers) const {
  if (function_) {
    const auto coupler = chosen_dyad(numbers);
    return coupler ? cranks_of_couplers(*function_, {&*coupler, 1}) : std::vector<Dyad>{};
  }
  const std::size_t each = curves_ ? 1 : 2;
  const auto one = given_ ? given_ : chosen_dyad(numbers.first(each));
  const auto other = chosen_dyad(numbers.last(each));
  if (!one || !other || one->circle_point == other->circle_point) {
    return {};
  }
  return {*one, *other};
}

std::optional<LinkageCandidate> DyadChoice::candidate(std::span<const double> numbers,
                                                      const LinkageLimits& limits) const {
  std::vector<LinkageCandidate> found = rank_linkages(dyads(numbers), positions_, limits);
  return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

}  // namespace kinestat
