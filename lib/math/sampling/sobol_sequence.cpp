#include "math/sampling/sobol_sequence.hpp"

#include <bit>
#include <boost/random/sobol.hpp>

#include "core/contract.hpp"

namespace kinestat {

static_assert(SobolSequence::kMostDimensions == boost::random::default_sobol_table::max_dimension);

// What Boost numbers n is point n + 1. Point 2^(r+1) - 1, of which the Gray code has one bit, is
// the direction number of that bit.
SobolSequence::SobolSequence(std::size_t dimensions, std::uint64_t count)
    : bits_(static_cast<std::size_t>(std::bit_width(count))), directions_(dimensions * bits_) {
  KINESTAT_EXPECTS(dimensions >= 1 && dimensions <= kMostDimensions && bits_ < 64);
  boost::random::sobol engine(dimensions);
  for (std::size_t r = 0; r < bits_; ++r) {
    engine.seed((std::uint64_t{2} << r) - 2);
    for (std::size_t d = 0; d < dimensions; ++d) {
      directions_[d * bits_ + r] = engine();
    }
  }
}

std::uint64_t SobolSequence::at(std::uint64_t index, std::size_t dimension) const {
  const std::uint64_t* directions = directions_.data() + dimension * bits_;
  std::uint64_t point = 0;
  for (std::uint64_t gray = index ^ (index >> 1U); gray != 0; gray &= gray - 1) {
    point ^= directions[std::countr_zero(gray)];
  }
  return point;
}

}  // namespace kinestat
