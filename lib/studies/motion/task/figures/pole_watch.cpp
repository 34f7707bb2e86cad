#include "studies/motion/task/figures/pole_watch.hpp"

namespace kinestat {

void PoleWatch::look(const std::vector<MotionReading>& readings, const MotionPosition& position) {
  last_.resize(readings.size(), 0.0);
  is_unbounded_.resize(readings.size(), false);
  for (std::size_t r = 0; r < readings.size(); ++r) {
    if (!readings[r].divisor) {
      continue;
    }
    if (const std::optional<double> divisor = readings[r].divisor(position)) {
      is_unbounded_[r] = is_unbounded_[r] || *divisor == 0.0 || *divisor * last_[r] < 0.0;
      last_[r] = *divisor;
    }
  }
}

void PoleWatch::leave_out_unbounded(const std::vector<MotionReading>& readings,
                                    std::size_t first,
                                    MotionTable& table) const {
  for (std::size_t r = 0; r < is_unbounded_.size(); ++r) {
    if (is_unbounded_[r]) {
      ColumnFigures& figures = table.figures[first + r];
      figures = {.least = readings[r].is_size ? figures.least : std::nullopt,
                 .greatest = std::nullopt,
                 .mean = std::nullopt,
                 .rms = std::nullopt};
    }
  }
}

}  // namespace kinestat
