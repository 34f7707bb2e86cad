// How many choices or linkages are usable, and why the others are not.
#pragma once

#include <array>

#include "studies/synthesis/linkages/defects.hpp"
#include "studies/synthesis/selection/selection_choice.hpp"

namespace kinestat {

/// Each counts once, by the worst that speaks against its best linkage.
struct SelectionCounts {
  int samples = 0;
  int with_linkage = 0;  ///< samples that have a linkage at all
  int usable = 0;        ///< samples that have one without defect and within the limits
  std::array<int, kDefectCount> defects{};    ///< by Defect; of none, as many as are usable
  std::array<int, kMissingCount> missing{};   ///< by Missing: those without a linkage
  std::array<int, kDefectCount> one_limit{};  ///< by Defect: usable but for this one limit

  void add(const Defects& defects);
  void add(Missing missing);

  SelectionCounts& operator+=(const SelectionCounts& other);
};

}  // namespace kinestat
