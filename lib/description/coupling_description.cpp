#include "description/coupling_description.hpp"

#include <array>

namespace kinestat {

namespace {

struct Word {
  CouplingType type;
  std::string_view word;
};

constexpr auto kWords = std::to_array<Word>({
    {CouplingType::revolute, "revolute"},
    {CouplingType::prismatic, "prismatic"},
    {CouplingType::helical, "helical"},
    {CouplingType::cylindrical, "cylindrical"},
    {CouplingType::universal, "universal"},
    {CouplingType::spherical, "spherical"},
    {CouplingType::planar, "planar"},
    {CouplingType::point_contact, "point_contact"},
    {CouplingType::cam, "cam"},
    {CouplingType::line_contact, "line_contact"},
    {CouplingType::sphere_in_tube, "sphere_in_tube"},
    {CouplingType::pin_in_slot, "pin_in_slot"},
    {CouplingType::rigid, "rigid"},
    {CouplingType::gear, "gear"},
    {CouplingType::bevel_gear, "bevel_gear"},
    {CouplingType::worm, "worm"},
    {CouplingType::rack, "rack"},
    {CouplingType::clutch, "clutch"},
    {CouplingType::brake, "brake"},
    {CouplingType::cable, "cable"},
    {CouplingType::screws, "screws"},
});

}  // namespace

std::string_view word_of(CouplingType type) {
  for (const Word& row : kWords) {
    if (row.type == type) {
      return row.word;
    }
  }
  return {};
}

std::optional<CouplingType> find_coupling_type(std::string_view word) {
  for (const Word& row : kWords) {
    if (row.word == word) {
      return row.type;
    }
  }
  return std::nullopt;
}

std::vector<std::string> coupling_type_words() {
  std::vector<std::string> words;
  for (const Word& row : kWords) {
    words.emplace_back(row.word);
  }
  return words;
}

}  // namespace kinestat
