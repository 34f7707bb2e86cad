#include "io/synonyms.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/spelling.hpp"
#include "core/text.hpp"
#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

struct Synonym {
  std::string_view word;  ///< in lower case
  std::string_view meant;
};

// Beside those of coupling types. Where a word may mean several things, the first that is a
// candidate at the place counts.
constexpr auto kSynonyms = std::to_array<Synonym>({
    {"version", "kinestat"},
    {"format", "kinestat"},
    {"title", "name"},
    {"reference", "source"},
    {"dimension", "space"},
    {"variables", "parameters"},
    {"constants", "parameters"},
    {"frame", "ground"},
    {"base", "ground"},
    {"fixed", "ground"},
    {"links", "bodies"},
    {"parts", "bodies"},
    {"members", "bodies"},
    {"between", "bodies"},
    {"connects", "bodies"},
    {"joints", "couplings"},
    {"pairs", "couplings"},
    {"connections", "couplings"},
    {"constraints", "couplings"},
    {"motors", "actuators"},
    {"drives", "actuators"},
    {"inputs", "actuators"},
    {"inputs", "input"},
    {"outputs", "output"},
    {"in", "input"},
    {"out", "output"},
    {"forces", "loads"},
    {"ropes", "cables"},
    {"belts", "cables"},
    {"loadcases", "cases"},
    {"load_cases", "cases"},
    {"scenarios", "cases"},
    {"velocity", "motion"},
    {"velocities", "motion"},
    {"speed", "motion"},
    {"speeds", "motion"},
    {"rpm", "motion"},
    {"moment", "action"},
    {"actions", "action"},
    {"torque", "action"},
    {"force", "action"},
    {"joint", "coupling"},
    {"joint", "couplings"},
    {"kind", "type"},
    {"joint_type", "type"},
    {"position", "at"},
    {"point", "at"},
    {"location", "at"},
    {"pos", "at"},
    {"direction", "axis"},
    {"dir", "axis"},
    {"alpha", "pressure_angle"},
    {"beta", "helix_angle"},
    {"z", "teeth"},
    {"number_of_teeth", "teeth"},
    {"mu", "friction"},
    {"drag", "friction"},
    {"center_of_mass", "centre_of_mass"},
    {"cog", "centre_of_mass"},
    {"weight", "mass"},
    {"preload", "drawn"},
    {"center", "centre"},
    {"center_distance", "centre_distance"},
    {"2d", "planar"},
    {"3d", "spatial"},
    {"cw", "clockwise"},
    {"ccw", "counterclockwise"},
    {"anticlockwise", "counterclockwise"},
    {"4bar", "four_bar"},
    {"fourbar", "four_bar"},
});

}  // namespace

std::string meant_name(std::string_view word, std::span<const std::string> candidates) {
  const std::string lower = in_small_letters(word);
  for (const Synonym& row : kSynonyms) {
    if (row.word == lower && std::ranges::find(candidates, row.meant) != candidates.end()) {
      return std::string(row.meant);
    }
  }
  for (const CouplingKind* kind : coupling_kinds()) {
    const bool is_so_called = std::ranges::find(kind->others, lower) != kind->others.end();
    if (is_so_called && std::ranges::find(candidates, kind->word) != candidates.end()) {
      return std::string(kind->word);
    }
  }
  return nearest_name(word, candidates);
}

std::string did_you_mean_word(std::string_view word, std::span<const std::string> candidates) {
  const std::string guess = meant_name(word, candidates);
  return guess.empty() ? guess : fmt::format("did you mean '{}'?", guess);
}

}  // namespace kinestat
