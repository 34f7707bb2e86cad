// A seeded source of random numbers that is the same on every machine and library.
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// The engine is fixed by the standard; the distributions of the standard are not, so they are
/// written out.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double share() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

  double between(double low, double high) { return low + (high - low) * share(); }

  /// Uniform in low, …, high.
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

  bool chance(double probability) { return share() < probability; }

  /// A magnitude that is clearly not zero: between 1/2 and 3/2, with either sign.
  double magnitude() { return (chance(0.5) ? 1.0 : -1.0) * between(0.5, 1.5); }

  /// Uniform in the cube from -1 to 1.
  Vec3 vector() {
    const double x = between(-1.0, 1.0);
    const double y = between(-1.0, 1.0);
    const double z = between(-1.0, 1.0);
    return {x, y, z};
  }

  /// A direction, not normalised but neither short nor long.
  Vec3 direction() {
    Vec3 result = vector();
    while (result.norm() < 0.3) {
      result = vector();
    }
    return result;
  }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[static_cast<std::size_t>(whole(0, static_cast<int>(i) - 1))]);
    }
  }

  template <class T>
  const T& one_of(const std::vector<T>& items) {
    return items[static_cast<std::size_t>(whole(0, static_cast<int>(items.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace kinestat
