// What reports say of the curves of four positions, and of curves as points.
#pragma once

#include <span>

#include "expression/file_units.hpp"
#include "record/record.hpp"
#include "studies/synthesis/curves/cubic_branches.hpp"
#include "studies/synthesis/dyads/few_positions.hpp"

namespace kinestat {

/// The part of the plane in which a curve is drawn, and with how many points.
struct CurveWindow {
  Point middle;
  double radius = 1.0;  ///< [length]
  int count = 0;
};

struct BranchView {
  const CurveBranch& branch;

  /// Of a curve of circle points: those that it stems from. Each of its points has its centre
  /// beside it then.
  std::span<const PositionJets> positions = {};
};

const Record<BranchView>& branch_record();

struct CurvesView {
  const FourPositionCurves& curves;
  std::span<const PositionJets> positions;
  const CurveWindow& window;
  const FileUnits& units;  ///< of the coefficients
};

const Record<CurvesView>& curves_record();

}  // namespace kinestat
