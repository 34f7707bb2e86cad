// The section of a gear train as plain geometry: strokes of wheels, pins, shafts, elements.
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
  double low = 0.0;           ///< of a planet: where it begins, as a height above the main axis
  double high = 0.0;          ///< where it ends; of a wheel on the main axis its radius

  // Of a developed section:
  double axis = 0.0;      ///< height of its axis above the main axis
  bool is_whole = false;  ///< on both sides of its axis
  double hub = 0.0;       ///< how far from its axis its disc begins: within, another shaft runs
  bool is_fixed = false;  ///< one with a shaft, not an idler
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

  // Of a developed section:
  double axis = 0.0;         ///< y of its axis
  double inwards = 9.0;      ///< how far the plates of a clutch reach from its line
  double outwards = 9.0;     ///< likewise away from the axis
  bool is_mirrored = false;  ///< also on the other side of its axis
};

/// A broken line between gears in mesh that are not drawn next to each other.
struct DrawnLink {
  int mesh = 0;
  std::vector<PixelPoint> points;
};

/// The line of an axis.
struct DrawnAxis {
  double left = 0.0;
  double right = 0.0;
  double height = 0.0;  ///< above the main axis
};

struct SchemeLayout {
  std::vector<DrawnWheel> wheels;
  std::vector<DrawnPin> pins;
  std::vector<DrawnShaft> shafts;
  std::vector<DrawnElement> elements;
  std::vector<DrawnLink> links;  ///< of a developed section
  std::vector<DrawnAxis> axes;   ///< likewise
  PixelBox box;
  int crossings = 0;        ///< of shafts
  bool is_complete = true;  ///< false: something found no way past the rest
};

/// The half section, or the developed section where shafts stand beside the main axis. Of some
/// orders in which shafts are led that with the fewest crossings; the same in every run.
SchemeLayout lay_out_scheme(const SchemeTrain& train);

}  // namespace kinestat
