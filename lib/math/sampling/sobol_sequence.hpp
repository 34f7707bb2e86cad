// Points that fill a cube of many dimensions evenly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kinestat {

/// The sequence of Sobol with the direction numbers of Joe and Kuo 2008, in the order of Antonov
/// and Saleev 1980, its first point the origin: any point without those before it. In every
/// dimension, of 2^m points from a multiple of 2^m on, each of 2^m equal intervals has one.
class SobolSequence {
 public:
  static constexpr std::size_t kMostDimensions = 3667;

  /// The first `count` points.
  SobolSequence(std::size_t dimensions, std::uint64_t count);

  /// A coordinate as a share of 2^64.
  std::uint64_t at(std::uint64_t index, std::size_t dimension) const;

 private:
  std::size_t bits_;                       ///< of an index
  std::vector<std::uint64_t> directions_;  ///< of each dimension, a number for each of these
};

}  // namespace kinestat
