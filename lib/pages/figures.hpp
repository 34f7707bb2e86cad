// The pictures of a page, each where it belongs.
#pragma once

#include <string>
#include <vector>

#include "draw/catalogue/catalogue.hpp"
#include "pages/html.hpp"

namespace kinestat {

/// Beside what a picture stands.
enum class PicturePlace {
  structure,  ///< the mechanism as a whole
  graphs,     ///< more of that, for those who follow the method
  motion,     ///< finite motion
  simulation,
  shift,       ///< the gears of a transmission
  duty,        ///< the points of a duty
  one_case,    ///< at the head of a case
  velocities,  ///< the tables of a case
  actions,
  power,
  compared,  ///< all cases side by side
  sweep,
  synthesis,
  charts  ///< each of its charts is a figure with its values
};

/// All pictures that the source has for a place, in the order of the catalogue. With
/// PictureSource::which they are those of that case.
std::vector<Picture> pictures_at(PicturePlace place, const PictureSource& source);

/// Whether its letters would be too small in half the width of a page.
bool is_broad(const Picture& picture);

/// "Shift matrix: NAME" without the name of the mechanism under which the picture stands.
std::string caption_of(const std::string& title, const std::string& name);

/// "Figure 3. Shift matrix" within a figure, and where a script offers to save it.
void add_caption(int number, const std::string& caption, Html& html);

/// Adds the drawing alone. Ids begin with `prefix`.
void add_picture(const Picture& picture, const std::string& prefix, Html& html);

/// Adds them with numbers and captions: their titles without `name`, that of the mechanism. Ids
/// begin with `id`; `figures` counts on.
void add_figures(const std::vector<Picture>& pictures,
                 const std::string& name,
                 const std::string& id,
                 int& figures,
                 Html& html);

}  // namespace kinestat
