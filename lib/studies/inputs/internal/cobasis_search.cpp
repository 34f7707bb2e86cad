#include "studies/inputs/internal/cobasis_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

CobasisSearch::CobasisSearch(const MatX& rows, std::vector<int> required, std::vector<int> allowed)
    : columns_(std::move(required)),
      required_(columns_.size()),
      height_(static_cast<std::size_t>(rows.rows())) {
  columns_.insert(columns_.end(), allowed.begin(), allowed.end());
  width_ = columns_.size();
  for (const int c : columns_) {
    // A column that is small beside the others still counts, down to the rounding of the rows.
    least_.push_back(std::max(kRankZero * rows.col(c).norm(), kCancellation));
  }
  levels_.resize(height_ + 1);
  for (std::size_t depth = 0; depth <= height_; ++depth) {
    levels_[depth].values.resize((height_ - depth) * width_);
  }
  for (std::size_t r = 0; r < height_; ++r) {
    for (std::size_t c = 0; c < width_; ++c) {
      levels_[0].values[r * width_ + c] = rows(static_cast<Eigen::Index>(r), columns_[c]);
    }
  }
  chosen_.reserve(height_);
}

bool CobasisSearch::run(std::uint64_t most_work,
                        const std::function<bool(const std::vector<int>&)>& found) {
  found_ = &found;
  most_work_ = most_work;
  chosen_.clear();
  work_ = 0;
  if (required_ > height_) {
    return true;
  }
  for (std::size_t c = 0; c < required_; ++c) {
    if (!take(c, c)) {
      return true;
    }
  }
  return extend(required_, required_);
}

bool CobasisSearch::is_zero(double value, std::size_t column) const {
  return std::abs(value) <= least_[column];
}

// Chooses a column: the row with its largest entry clears it from the others. False if it depends
// on those chosen before.
bool CobasisSearch::take(std::size_t depth, std::size_t column) {
  const std::vector<double>& from = levels_[depth].values;
  std::vector<double>& to = levels_[depth + 1].values;
  const std::size_t rows = height_ - depth;
  std::size_t pivot = 0;
  for (std::size_t r = 1; r < rows; ++r) {
    if (std::abs(from[r * width_ + column]) > std::abs(from[pivot * width_ + column])) {
      pivot = r;
    }
  }
  work_ += rows * (width_ - column);
  const double value = from[pivot * width_ + column];
  if (is_zero(value, column)) {
    return false;
  }
  chosen_.push_back(columns_[column]);
  std::size_t out = 0;
  for (std::size_t r = 0; r < rows; ++r) {
    if (r == pivot) {
      continue;
    }
    const double factor = from[r * width_ + column] / value;
    for (std::size_t c = column + 1; c < width_; ++c) {
      to[out * width_ + c] = from[r * width_ + c] - factor * from[pivot * width_ + c];
    }
    ++out;
  }
  return true;
}

// Whether every row that is left has a column left.
bool CobasisSearch::can_be_completed(std::size_t depth, std::size_t next) {
  const std::vector<double>& values = levels_[depth].values;
  for (std::size_t r = 0; r < height_ - depth; ++r) {
    bool has_entry = false;
    for (std::size_t c = next; c < width_ && !has_entry; ++c) {
      has_entry = !is_zero(values[r * width_ + c], c);
      ++work_;
    }
    if (!has_entry) {
      return false;
    }
  }
  return true;
}

bool CobasisSearch::extend(std::size_t depth, std::size_t next) {
  const std::size_t missing = height_ - depth;
  if (missing == 0) {
    return (*found_)(chosen_);
  }
  if (missing == 1) {
    const std::vector<double>& values = levels_[depth].values;
    for (std::size_t c = next; c < width_; ++c) {
      if (is_zero(values[c], c)) {
        continue;
      }
      chosen_.push_back(columns_[c]);
      const bool goes_on = (*found_)(chosen_);
      chosen_.pop_back();
      if (!goes_on) {
        return false;
      }
    }
    return true;
  }
  for (std::size_t c = next; c + missing <= width_; ++c) {
    if (!can_be_completed(depth, c)) {
      return true;
    }
    if (work_ > most_work_) {
      return false;
    }
    if (!take(depth, c)) {
      continue;
    }
    const bool goes_on = extend(depth + 1, c + 1);
    chosen_.pop_back();
    if (!goes_on) {
      return false;
    }
  }
  return true;
}

}  // namespace kinestat
