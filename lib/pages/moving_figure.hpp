// A drawing that a script moves through its steps, and what a reader moves it with.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "draw/picture.hpp"
#include "pages/html.hpp"

namespace kinestat {

/// How a body is moved in the plane from where it is drawn: shift [m], then angle [rad], as
/// draw/linkage/linkage_drawing.hpp has it.
using DrawnPose = std::array<double, 3>;

struct MovingFigure {
  std::string name;     ///< of the picture on the page
  std::string section;  ///< id: charts that follow name it, and links to a step begin with it
  int number = 0;       ///< of the figure
  std::string caption;
  std::string what;                           ///< is moved, "motor"
  int drawn = -1;                             ///< the step at which it is as drawn; -1: none
  bool is_closed = false;                     ///< it goes round
  std::vector<std::string> bodies;            ///< values of data-body; none in space
  std::vector<std::string> labels;            ///< of each step
  std::vector<std::size_t> rows;              ///< of each step the point of the charts that follow
  std::string acting;                         ///< members of a JSON object: what acts; or empty
  std::vector<std::vector<DrawnPose>> steps;  ///< of each body
};

/// Adds the figure and leaves it open. With a single step it stands still.
void open_moving_figure(const Picture& picture, const MovingFigure& figure, Html& html);

}  // namespace kinestat
