// The half section of a gear train as plain geometry: strokes of wheels, pins, shafts, elements.
#pragma once

#include <vector>

#include "draw/svg.hpp"
#include "draw/train/scheme_train.hpp"

namespace kinestat {

/// A wheel in the section [px], y downwards from the main axis at 0.
struct DrawnWheel {
  int wheel = 0;      ///< index into SchemeTrain::wheels
  double left = 0.0;  ///< its width
  double right = 0.0;
  std::vector<double> discs;  ///< x of its discs, one a column
  double low = 0.0;           ///< of a planet: where it begins, as a height above the axis
  double high = 0.0;          ///< where it ends; of a wheel on the main axis its radius
};

struct DrawnPin {
  int planet = 0;
  double left = 0.0;
  double right = 0.0;
  double height = 0.0;
};

/// Part of a shaft or a carrier.
struct DrawnShaft {
  int body = 0;
  PixelPoint from;
  PixelPoint to;
};

/// Where an element stands, and in which direction it lies from the line of its body.
struct DrawnElement {
  int element = -1;  ///< index into SchemeTrain::elements; -1: a body that is fixed to the housing
  int body = 0;
  PixelPoint at;      ///< where the line of its body ends
  PixelPoint beyond;  ///< where that of the other body ends, or the housing is
};

struct SchemeLayout {
  std::vector<DrawnWheel> wheels;
  std::vector<DrawnPin> pins;
  std::vector<DrawnShaft> shafts;
  std::vector<DrawnElement> elements;
  PixelBox box;
  int crossings = 0;  ///< of shafts
};

/// Of some orders in which shafts are led the one with the fewest crossings; the same in every run.
SchemeLayout lay_out_scheme(const SchemeTrain& train);

}  // namespace kinestat
