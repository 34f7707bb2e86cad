#include "draw/linkage/page_linkage.hpp"

#include <cmath>

#include "draw/text_styles.hpp"

namespace kinestat {

Picture draw_page_linkage(const Analysis& analysis, LinkageOptions options) {
  constexpr double kWidest = 380.0;  // of the places, before it is known what stands beside them
  constexpr double kNarrowest = 200.0;
  constexpr int kMostNames = 16;
  const Topology& topology = analysis.mechanism.topology;
  if (topology.body_count() + topology.coupling_count() > kMostNames) {
    options.width = kDrawingWidth;
    return draw_linkage(analysis, options);
  }
  // Words beside the places do not shrink with them.
  Picture picture;
  for (options.width = kWidest; options.width >= kNarrowest;
       options.width -= std::ceil(picture.view.width() - kShrinking)) {
    picture = draw_linkage(analysis, options);
    if (picture.view.width() <= kShrinking) {
      return picture;
    }
  }
  options.width = kWidest;
  return draw_linkage(analysis, options);
}

}  // namespace kinestat
