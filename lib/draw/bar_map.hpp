// Bar maps: one quantity of many elements in several cases, as bars of one scale beside names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/picture.hpp"

namespace kinestat {

/// What an element has in each case; empty where it is not known.
struct BarRow {
  std::string name;
  std::vector<std::optional<double>> values;  ///< one a column
};

/// Rows that share a scale.
struct BarBlock {
  std::string title;  ///< "angular velocity ω_z [rad/s]"
  std::vector<BarRow> rows;
};

struct BarMap {
  std::string name;
  std::string title;      ///< "Forces in the couplings"
  std::string mechanism;  ///< whose they are: the picture is called "title: mechanism"
  std::string description;
  std::vector<std::string> columns;  ///< the cases
  std::vector<BarBlock> blocks;
  std::vector<std::string> remarks;  ///< below
};

/// More rows of a block are left to tables; those with the largest values stay.
inline constexpr std::size_t kMostBarRows = 60;

/// The whole.
Picture draw_bar_map(const BarMap& map);

/// In parts of a few cases or, of one case, of a few blocks, which stand beside each other where
/// there is room, and each of which fits a telephone. All cases have one scale.
std::vector<Picture> draw_bar_map_in_parts(const BarMap& map);

}  // namespace kinestat
