#include "mechanism/curves/curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

std::optional<CurvePoint> Curve::point(double place) const {
  const double begin = at.front();
  const double end = at.back();
  if (period && (place < begin || place > end)) {
    place -= std::floor((place - begin) / *period) * *period;
  }
  const double rounding = kCurveEnd * (end - begin);
  const bool is_within = place >= begin - rounding && place <= end + rounding;
  return is_within ? std::optional(interpolated(at, values, slopes, std::clamp(place, begin, end)))
                   : std::nullopt;
}

}  // namespace kinestat
