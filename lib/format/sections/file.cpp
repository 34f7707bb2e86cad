#include "format/sections/sections.hpp"

namespace kinestat {

const Mapping<MechanismDescription>& file_sections() {
  static const Mapping<MechanismDescription> mapping("", "", "", [](auto& m) {
    m.key("motion",
          "A finite motion from the drawn position: the drives run through their ranges, "
          "everything else follows.")
        .may(&MechanismDescription::motion, motion_section().form());
  });
  return mapping;
}

}  // namespace kinestat
