// Why a spring has no force in a position, in words.
#pragma once

#include <string>
#include <string_view>

#include "dynamics/spring_force.hpp"
#include "expression/file_units.hpp"

namespace kinestat {

/// "gas spring 'strut' is past its stroke: …", with the lengths in the units of the file.
std::string text_of(const SpringObstacle& obstacle, const Spring& spring, const FileUnits& units);

/// How far a gas spring is past its stroke [m]; zero of other obstacles.
double excess_of(const SpringObstacle& obstacle, const Spring& spring);

/// The limit that it passes, as the text calls it: "extended" or "compressed".
std::string_view limit_word(const SpringObstacle& obstacle, const Spring& spring);

}  // namespace kinestat
