#include "support/random_network_coupling.hpp"

#include <algorithm>
#include <numeric>

namespace kinestat {

namespace {

using enum CouplingType;

std::vector<int> first(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

std::size_t count_listed(const NetworkCoupling& coupling, std::string_view word) {
  const NetworkValue* list = coupling.find(word);
  return list == nullptr ? 0 : std::get<std::vector<NetworkScrew>>(*list).size();
}

bool is_contact(const NetworkCoupling& coupling) {
  return coupling.find("contact") != nullptr;
}

}  // namespace

const NetworkValue* NetworkCoupling::find(std::string_view word) const {
  const auto at = std::ranges::find(keys, word, &NetworkKey::word);
  return at == keys.end() ? nullptr : &at->value;
}

NetworkValue* NetworkCoupling::find(std::string_view word) {
  const auto at = std::ranges::find(keys, word, &NetworkKey::word);
  return at == keys.end() ? nullptr : &at->value;
}

bool has_place(const NetworkCoupling& coupling) {
  return std::ranges::any_of(coupling.keys, [](const NetworkKey& key) {
    const auto* listed = std::get_if<std::vector<NetworkScrew>>(&key.value);
    return std::holds_alternative<NetworkPoint>(key.value) ||
           (listed != nullptr && std::ranges::any_of(*listed, &NetworkScrew::has_line));
  });
}

bool is_complementary(const NetworkCoupling& coupling, Space space) {
  const std::size_t order = space == Space::planar ? 3 : 6;
  if (coupling.passive) {
    return false;
  }
  switch (coupling.type) {
    case gear:
      return is_contact(coupling);
    case bevel_gear:
    case worm:
    case rack:
    case clutch:
    case brake:
      return false;
    case screws: {
      const std::size_t freedoms = count_listed(coupling, "freedoms");
      const std::size_t constraints = count_listed(coupling, "constraints");
      return freedoms == 0 || constraints == 0 || freedoms + constraints == order;
    }
    default:
      return true;
  }
}

std::vector<int> own_freedoms(const NetworkCoupling& coupling, Space space) {
  const bool is_planar = space == Space::planar;
  switch (coupling.type) {
    case revolute:
    case helical:
    case planar:
    case bevel_gear:
    case worm:
    case clutch:
    case brake:
    case torque_converter:
      return first(1);
    case prismatic:
    case rack:
      return first(has_place(coupling) ? 1 : 0);
    case cylindrical:
    case universal:
    case pin_in_slot:
      return first(2);
    case line_contact:
      return first(4);
    case sphere_in_tube:
      return {3};  // the sliding after three rotations
    case point_contact:
    case cam:
      return first(is_planar ? 2 : 0);
    case gear:
      return first(!is_contact(coupling) ? 1 : is_planar ? 2 : 0);
    case cable:
      return is_planar ? first(2) : std::vector<int>{4};  // the turning about its line
    case screws:
      return first(has_place(coupling) ? count_listed(coupling, "freedoms") : 0);
    case spherical:
    case rigid:
      return {};
  }
  return {};
}

}  // namespace kinestat
