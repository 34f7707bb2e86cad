#include "couplings/kinds.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

std::span<const CouplingKind* const> coupling_kinds() {
  return kKinds;
}

const CouplingKind& kind_of(CouplingType type) {
  const CouplingKind& kind = *kKinds.at(static_cast<std::size_t>(type));
  KINESTAT_EXPECTS(kind.type == type);
  return kind;
}

bool takes(const CouplingKind& kind, CouplingKey key) {
  return std::ranges::find(kind.keys, key, &KindKey::key) != kind.keys.end();
}

bool has_teeth(CouplingType type) {
  return kind_of(type).teeth != Teeth::none;
}

bool joins_wheels(CouplingType type) {
  return kind_of(type).teeth == Teeth::of_wheels;
}

std::string_view word_of(CouplingType type) {
  return kind_of(type).word;
}

}  // namespace kinestat
