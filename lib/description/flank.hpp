// Which flank of teeth carries their load.
#pragma once

namespace kinestat {

/// That on which the load presses, or always the same as in the source.
enum class Flank { loaded, fixed };

}  // namespace kinestat
