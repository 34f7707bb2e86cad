#include "studies/motion/task/figures/column_means.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

namespace {

// Of a line between two values, or of its square.
double mean_of_line(double low, double high) {
  return 0.5 * (low + high);
}

double mean_square_of_line(double low, double high) {
  return (low * low + low * high + high * high) / 3.0;
}

class MeanMaker {
 public:
  using ValueBefore = std::function<std::optional<double>(double, double, double)>;

  MeanMaker(std::span<const MeanSample> samples,
            const MeanCourse& course,
            const ValueBefore& value_before,
            SmoothIntegral& integral)
      : samples_(samples), course_(course), value_before_(value_before), integral_(integral) {}

  ColumnMeans run() {
    add_pieces();
    const MeanSample* before = nullptr;
    for (const MeanSample& one : samples_) {
      if (is_in_whole_piece(one.step)) {
        continue;
      }
      if (before != nullptr && !add_interval(*before, one)) {
        return {};
      }
      before = &one;
    }
    end_run();
    const double steps = samples_.back().step - samples_.front().step;
    if (covered_ <= kSameStep * steps) {
      return {};
    }
    return {.mean = mean_of(sum_), .mean_square = mean_of(square_)};
  }

 private:
  // With a bound of its rounding, and of jumps, which have no width but for rounding.
  struct Sum {
    double value = 0.0;
    double size = 0.0;
    double skipped = 0.0;

    void add(double weight, double of, double size_of) {
      value += weight * of;
      size += weight * size_of;
    }
  };

  double mean_of(const Sum& sum) const {
    return zero_within_bound(sum.value, kCancellation * sum.size + sum.skipped) / covered_;
  }

  void add_value(double weight, double value) {
    sum_.add(weight, value, std::abs(value));
    square_.add(weight, value * value, value * value);
  }

  void add_line(double width, double low, double high) {
    sum_.add(width, mean_of_line(low, high), mean_of_line(std::abs(low), std::abs(high)));
    const double square = mean_square_of_line(low, high);
    square_.add(
        width, square, std::max(square, mean_square_of_line(std::abs(low), std::abs(high))));
  }

  // Those in which all points have values.
  void add_pieces() {
    auto first = samples_.begin();
    for (const TimePiece& piece : course_.pieces) {
      first = std::lower_bound(first, samples_.end(), piece.begin, is_before);
      const auto end = std::lower_bound(first, samples_.end(), piece.end, is_before);
      const auto has_value = [](const MeanSample& one) { return one.weight > 0.0 && one.value; };
      if (std::count_if(first, end, has_value) != std::ssize(piece.points)) {
        continue;
      }
      for (auto one = first; one != end; ++one) {
        if (one->weight > 0.0) {
          add_value(one->weight, *one->value);
        }
      }
      covered_ += piece.end - piece.begin;
      whole_.push_back(&piece);
    }
  }

  static bool is_before(const MeanSample& one, double step) { return one.step < step; }

  static bool ends_before(const TimePiece* piece, double step) { return piece->end <= step; }

  // Its ends belong to its neighbours, too.
  bool is_in_whole_piece(double step, double margin = kSameApproach) const {
    const auto piece = std::lower_bound(whole_.begin(), whole_.end(), step, ends_before);
    return piece != whole_.end() && step > (*piece)->begin + margin &&
           step < (*piece)->end - margin;
  }

  double whole_between(double low, double high) const {
    double width = 0.0;
    for (auto piece = std::lower_bound(whole_.begin(), whole_.end(), low, ends_before);
         piece != whole_.end() && (*piece)->begin < high;
         ++piece) {
      width += std::min((*piece)->end, high) - std::max((*piece)->begin, low);
    }
    return width;
  }

  bool is_corner(double step) const {
    const auto behind = std::ranges::lower_bound(course_.corners, step - kSameApproach);
    return behind != course_.corners.end() && *behind <= step + kSameApproach;
  }

  // False where nothing is known of it.
  bool add_interval(const MeanSample& low, const MeanSample& high) {
    const double width = high.step - low.step - whole_between(low.step, high.step);
    if (width <= kSameStep) {
      end_run();
      sum_.skipped += width * mean_of_line(std::abs(low.value.value_or(0.0)),
                                           std::abs(high.value.value_or(0.0)));
      square_.skipped += width * mean_square_of_line(std::abs(low.value.value_or(0.0)),
                                                     std::abs(high.value.value_or(0.0)));
      return true;
    }
    if (low.value && high.value) {
      covered_ += width;
      const bool is_beside_piece = width < high.step - low.step;
      if (is_beside_piece || width < kSameApproach) {
        end_run();
        const bool is_low = is_beside_piece && is_in_whole_piece(high.step, 0.0);
        const bool is_high = is_beside_piece && is_in_whole_piece(low.step, 0.0);
        add_line(width, is_high ? *high.value : *low.value, is_low ? *low.value : *high.value);
        return true;
      }
      if (run_.empty() || run_.back() != &low) {
        end_run();
        run_.push_back(&low);
      }
      run_.push_back(&high);
      if (is_corner(high.step)) {
        end_run();
      }
      return true;
    }
    const bool is_end_of_run = course_.ends_at_limit && low.value && !run_.empty() &&
                               run_.back() == &low && &high == &samples_.back();
    if (!is_end_of_run) {
      end_run();
    }
    if (!low.value && !high.value) {
      return low.rests && high.rests;
    }
    const std::optional<double> value = width < kSameApproach ? (low.value ? low.value : high.value)
                                        : low.value ? value_before_(low.step, high.step, 0.5)
                                                    : value_before_(high.step, low.step, 0.5);
    if (value && is_end_of_run) {
      covered_ += width;
      before_limit_ = value;
      run_.push_back(&high);
    } else if (value) {
      covered_ += width;
      add_value(width, *value);
    }
    return value.has_value();
  }

  // Samples that follow each other without a corner between them. To a limit values go like the
  // root of the way that is left: they are smooth in that root, in which the weight of the last is
  // zero, whether it has a value or not.
  void end_run() {
    drop_close_to_ends();
    nodes_.clear();
    values_.clear();
    squares_.clear();
    const bool is_of_root =
        course_.ends_at_limit && !run_.empty() && run_.back() == &samples_.back();
    for (const MeanSample* one : run_) {
      const double root = is_of_root ? std::sqrt(run_.back()->step - one->step) : 0.0;
      const double weight = is_of_root ? 2.0 * root : 1.0;
      const double value = one->value.value_or(0.0);
      nodes_.push_back(is_of_root ? -root : one->step);
      values_.push_back(weight * value);
      squares_.push_back(weight * value * value);
    }
    lines_.clear();
    lines_of_squares_.clear();
    for (std::size_t i = 0; i + 1 < run_.size(); ++i) {
      const double width = run_[i + 1]->step - run_[i]->step;
      const bool has_value = run_[i + 1]->value.has_value();
      const double low = has_value ? *run_[i]->value : *before_limit_;
      const double high = has_value ? *run_[i + 1]->value : *before_limit_;
      sum_.size += width * mean_of_line(std::abs(low), std::abs(high));
      square_.size += width * mean_of_line(low * low, high * high);
      lines_.push_back(width * mean_of_line(low, high));
      lines_of_squares_.push_back(width * mean_square_of_line(low, high));
    }
    run_.clear();
    integral_.place(nodes_);
    integral_.look(values_);
    sum_.value += integral_.of(values_, lines_);
    square_.value += integral_.of(squares_, lines_of_squares_);
  }

  // A row says no more than a corner close to it.
  void drop_close_to_ends() {
    constexpr double kClose = 0.25;
    const auto gap = [this](std::size_t i) { return run_[i + 1]->step - run_[i]->step; };
    if (run_.size() > 3 && gap(0) < kClose * gap(1)) {
      run_.erase(run_.begin() + 1);
    }
    if (run_.size() > 3 && gap(run_.size() - 2) < kClose * gap(run_.size() - 3)) {
      run_.erase(run_.end() - 2);
    }
  }

  std::span<const MeanSample> samples_;
  const MeanCourse& course_;
  const ValueBefore& value_before_;
  std::vector<const TimePiece*> whole_;  // with values at all of their points
  std::vector<const MeanSample*> run_;
  std::optional<double> before_limit_;  // half a step, where the last sample has no value
  std::vector<double> nodes_;           // of the run that ends
  std::vector<double> values_;
  std::vector<double> squares_;
  std::vector<double> lines_;  // the integrals of straight lines between nodes
  std::vector<double> lines_of_squares_;
  SmoothIntegral& integral_;
  Sum sum_;
  Sum square_;
  double covered_ = 0.0;  // without rests in which it is open
};

}  // namespace

ColumnMeans means_of(
    std::span<const MeanSample> samples,
    const MeanCourse& course,
    const std::function<std::optional<double>(double from, double end, double left)>& value_before,
    SmoothIntegral& integral) {
  return samples.size() < 2 ? ColumnMeans{}
                            : MeanMaker(samples, course, value_before, integral).run();
}

}  // namespace kinestat
