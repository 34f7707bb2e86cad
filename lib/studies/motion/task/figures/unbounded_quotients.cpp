#include "studies/motion/task/figures/unbounded_quotients.hpp"

namespace kinestat {

void UnboundedQuotients::look(const std::vector<MotionReading>& readings,
                              const MotionPosition& position) {
  last_.resize(readings.size());
  is_unbounded_.resize(readings.size(), false);
  poles_.resize(readings.size());
  for (std::size_t r = 0; r < readings.size(); ++r) {
    const std::optional<QuotientParts> parts =
        readings[r].parts ? readings[r].parts(position) : std::nullopt;
    if (!parts || (parts->divisor == 0.0 && parts->dividend == 0.0)) {
      continue;
    }
    const bool turns = parts->divisor * last_[r].divisor < 0.0;
    const bool turns_alone = turns && parts->dividend * last_[r].dividend > 0.0;
    is_unbounded_[r] = is_unbounded_[r] || parts->divisor == 0.0 || turns_alone;
    if (turns_alone) {
      poles_[r].push_back(row_);
    }
    last_[r] = *parts;
  }
  ++row_;
}

void UnboundedQuotients::leave_out_unbounded(const std::vector<MotionReading>& readings,
                                             std::size_t first,
                                             MotionTable& table) const {
  for (std::size_t r = 0; r < is_unbounded_.size(); ++r) {
    if (is_unbounded_[r]) {
      ColumnFigures& figures = table.figures[first + r];
      figures = {.least = readings[r].is_size ? figures.least : std::nullopt,
                 .greatest = std::nullopt,
                 .mean = std::nullopt,
                 .rms = std::nullopt,
                 .poles = poles_[r]};
    }
  }
}

}  // namespace kinestat
