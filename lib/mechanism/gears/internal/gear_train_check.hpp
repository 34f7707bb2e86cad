// Whether a gear train can stand and be assembled as its teeth say.
#pragma once

#include <string>
#include <string_view>

#include "mechanism/check/section_context.hpp"
#include "mechanism/gears/gear_layout.hpp"

namespace kinestat {

/// Complains of meshes between gears on one axis and of axes without a distance from the main
/// axis. Warns of distances that differ and of bearings beside their axis (W0305), of planets that
/// cannot be spaced equally (W0306) and of planets that touch (W0307): all three may be meant, by
/// teeth with profile shift or planets at unequal angles. The numbers of `gears` must be right, its
/// meshes couplings.
void check_gear_train(const SectionContext& context);

/// "planet" of what a carrier bears that moves, else "gear".
std::string_view word_of(const GearAxis& axis, const SectionContext& context);

/// "the main axis" for -1, or "the axis of 'carrier2'", the first body that turns about it.
std::string name_of_axis(const GearTrain& train, int axis);

/// Complains of an axis of `axes` whose bodies turn about several, and of what an axis says that
/// means nothing there.
void check_declared_axes(const SectionContext& context, const GearTrain& train);

/// Complains of axes without a distance from the main axis or with two, of meshes of two planets
/// without a module, and of `count`, `centre_distance` and `side` where they mean nothing. After it
/// a layout can be found.
void check_planet_members(const SectionContext& context,
                          const GearTrain& train,
                          const GearNumbers& numbers);

/// Warns of planets with a `count` that cannot be spaced equally (W0306) or whose tip circles meet
/// (W0307): of one planet, and of planets that mesh with each other, from one set to the next. Tips
/// are one module outside the pitch circle.
void check_planet_spacing(const SectionContext& context,
                          const GearNumbers& numbers,
                          const GearLayout& layout);

}  // namespace kinestat
