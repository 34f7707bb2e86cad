// A screw given directly instead of by a type of coupling.
#pragma once

#include <optional>

#include "description/value.hpp"

namespace kinestat {

enum class ScrewWord { rotation, translation, force, couple };

/// `{rotation: [0, 0, 1], at: [0, 0, 0], pitch: 2 mm}`, `{translation: x}`, `{force: …, at: …,
/// pitch: …}` or `{couple: …}`. Rotations and forces have a line, hence `at`; a pitch is a length
/// per radian.
struct ScrewDescription {
  ScrewWord kind = ScrewWord::rotation;
  AxisDescription direction;
  std::optional<PointDescription> at;
  std::optional<Value> pitch;
  SourceRange where;
};

}  // namespace kinestat
