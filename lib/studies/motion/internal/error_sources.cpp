#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/internal/joint_errors.hpp"

namespace kinestat {

// What one of each source moves the joints by.
void JointErrors::find_shares(bool is_singular) {
  const std::size_t unknown = closure_->unknown.size();
  const std::vector<double>& open = closure_->qr.null_vectors();
  drives_ = rows_ + 1;
  open_ = drives_ + network_.driven_rates.size();
  roots_ = open_ + (unknown == 0 ? 0 : open.size() / unknown);
  sources_ = roots_ + (is_singular ? unknown : 0);
  columns_ = sources_ + 2;
  shares_.assign(sizes_.size() * columns_, 0.0);
  std::vector<double> unit(std::max(rows_, unknown), 0.0);
  std::vector<double> answer(unknown);
  for (std::size_t r = 0; r < rows_ && unknown > 0; ++r) {
    unit[r] = 1.0;
    closure_->qr.solve(unit, answer);
    unit[r] = 0.0;
    for (std::size_t i = 0; i < unknown; ++i) {
      double* share = &shares_[at(closure_->unknown[i]) * columns_];
      share[r] = answer[i];
      share[rows_] += answer[i] * closure_->residuals[r];
      for (std::size_t s = drives_; s < open_; ++s) {
        share[s] -= answer[i] * factor(r, at(network_.driven_rates[s - drives_]));
      }
    }
  }
  for (std::size_t s = drives_; s < open_; ++s) {
    shares_[at(network_.driven_rates[s - drives_]) * columns_ + s] = 1.0;
  }
  for (std::size_t i = 0; i < unknown; ++i) {
    double* share = &shares_[at(closure_->unknown[i]) * columns_];
    for (std::size_t s = open_; s < roots_; ++s) {
      share[s] = open[(s - open_) * unknown + i];
    }
    if (is_singular) {
      share[roots_ + i] = 1.0;
    }
  }
}

void JointErrors::find_places(bool is_singular) {
  for (int order = 0; order < kOrders; ++order) {
    amounts_[at(order)].assign(sources_, 0.0);
    joints_[at(order)].assign(sizes_.size(), 0.0);
  }
  std::vector<double>& amounts = amounts_[0];
  for (std::size_t r = 0; r < rows_; ++r) {
    const RatesOfRow& row = closure_->rates_of_rows[r];
    amounts[r] =
        row.rounds * (paths_[at(row.tail_frame)].rounding + paths_[at(row.head_frame)].rounding);
    for (const int rate : row.all) {
      const double by_angle = is_turn_[at(rate)] ? row.by_angle : 0.0;
      amounts[r] += 2.0 * kEpsilon * (std::abs(factor(r, at(rate))) + by_angle) * sizes_[at(rate)];
    }
  }
  amounts[rows_] = 1.0;
  for (std::size_t s = drives_; s < open_; ++s) {
    amounts[s] = 2.0 * kEpsilon * sizes_[at(network_.driven_rates[s - drives_])];
  }
  if (is_singular) {
    std::fill(
        amounts.begin() + static_cast<std::ptrdiff_t>(roots_), amounts.end(), std::sqrt(kEpsilon));
  }
  find_joints(0, sizes_);
}

// Of the sources, and of what rounds in the values themselves.
void JointErrors::find_joints(int order, std::span<const double> values) {
  for (std::size_t rate = 0; rate < sizes_.size(); ++rate) {
    double sum = 2.0 * kEpsilon * std::abs(values[rate]);
    for (std::size_t s = 0; s < sources_; ++s) {
      sum += std::abs(shares_[rate * columns_ + s]) * amounts_[at(order)][s];
    }
    joints_[at(order)][rate] = sum;
  }
}

}  // namespace kinestat
