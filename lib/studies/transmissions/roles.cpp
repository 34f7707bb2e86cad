#include "studies/transmissions/roles.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace kinestat {

namespace {

constexpr std::array<SetRoles, kRolesOfSet> kRoles = {
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

constexpr std::array<std::uint32_t, kMostGearSets + 1> kPowersOfSix = {1, 6, 36, 216, 1296};

}  // namespace

SetRoles set_roles(int number) {
  return kRoles.at(static_cast<std::size_t>(number));
}

int RoleChoice::roles_of(int set) const {
  return static_cast<int>(roles / kPowersOfSix.at(static_cast<std::size_t>(set)) % kRolesOfSet);
}

SetKind RoleChoice::kind_of(int set) const {
  return (double_planet >> set & 1U) != 0 ? SetKind::double_planet : SetKind::simple;
}

SetAction::SetAction(const TransmissionStructure& structure, const VertexMap& automorphism)
    : count_(structure.set_count()) {
  for (std::size_t s = 0; s < structure.sets.size(); ++s) {
    std::array<Shaft, 3> moved{};
    std::ranges::transform(
        structure.sets[s], moved.begin(), [&](Shaft shaft) { return automorphism[shaft]; });
    SetShafts image = moved;
    std::ranges::sort(image);
    sets_[s] = static_cast<int>(std::ranges::find(structure.sets, image) - structure.sets.begin());
    std::array<std::uint8_t, 3> place{};
    for (std::size_t i = 0; i < moved.size(); ++i) {
      place[i] = static_cast<std::uint8_t>(std::ranges::find(image, moved[i]) - image.begin());
    }
    for (std::size_t number = 0; number < kRoles.size(); ++number) {
      const SetRoles& from = kRoles[number];
      const SetRoles to{place[from.sun], place[from.carrier], place[from.ring]};
      roles_[s][number] = static_cast<std::uint8_t>(std::ranges::find(kRoles, to) - kRoles.begin());
    }
  }
}

RoleChoice SetAction::image(const RoleChoice& choice) const {
  RoleChoice result;
  for (int s = 0; s < count_; ++s) {
    const auto from = static_cast<std::size_t>(s);
    const auto to = static_cast<std::size_t>(sets_[from]);
    result.roles += kPowersOfSix[to] * roles_[from][static_cast<std::size_t>(choice.roles_of(s))];
    result.double_planet |= (choice.double_planet >> s & 1U) << to;
  }
  return result;
}

bool is_least(const RoleChoice& choice, const std::vector<SetAction>& automorphisms) {
  return std::ranges::none_of(automorphisms, [&](const SetAction& automorphism) {
    return automorphism.image(choice) < choice;
  });
}

std::vector<RoleChoice> least_role_choices(int sets,
                                           int double_planet,
                                           const std::vector<SetAction>& automorphisms) {
  std::vector<RoleChoice> result;
  for (std::uint32_t roles = 0; roles < kPowersOfSix.at(static_cast<std::size_t>(sets)); ++roles) {
    for (std::uint32_t kinds = 0; kinds < 1U << sets; ++kinds) {
      const RoleChoice choice{.roles = roles, .double_planet = kinds};
      if (std::popcount(kinds) == double_planet && is_least(choice, automorphisms)) {
        result.push_back(choice);
      }
    }
  }
  return result;
}

}  // namespace kinestat
