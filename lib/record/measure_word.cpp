#include "record/measure_word.hpp"

namespace kinestat {

std::string word_of(const Measure& measure) {
  if (const auto* kind = std::get_if<QuantityKind>(&measure)) {
    return std::string(name_of(*kind));
  }
  const auto* bare = std::get_if<Bare>(&measure);
  return std::string(bare != nullptr ? word_of(*bare) : word_of(std::get<ByContext>(measure)));
}

}  // namespace kinestat
